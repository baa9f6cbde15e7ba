// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Description
    The account of momentum between particles and fluid, against a pair of one
    particle and one cell of fluid whose motion is known.
\*---------------------------------------------------------------------------*/

#include "particleAndCell.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::test;

namespace
{

const vector v0(0.3, -0.1, 0.2);

}


// K dt -> 0: the source is the drag as it stands
TEST(momentumLedger, slowDragIsTheDrag)
{
    const scalar m = 2e-6, T = 1e-3;
    for (const scalar stiffness : {1e-8, 1e-4})
    {
        particleAndCell one(m, stiffness*m/T);
        one.p.velocity = v0;
        one.exchange(T);
        one.ledger.prepare(T);
        EXPECT_NEAR
        (
            mag(one.source() - one.K[0]*v0)/mag(one.K[0]*v0), 0, stiffness
        );
        EXPECT_NEAR(one.ledger.Sp()[1]*rho*V/one.K[0], 1, stiffness);
        // and none where there is no particle
        EXPECT_EQ(one.ledger.Sp()[2], 0);
        EXPECT_EQ(mag(one.ledger.F()[2]), 0);
    }
}


// K dt -> infinity: a free particle and its fluid come to their common velocity
// in one step, and do not pass it
TEST(momentumLedger, stiffDragEndsAtTheCommonVelocity)
{
    const scalar m = 2e-6, M = rho*V, T = 1e-3;
    for (const label steps : {1, 5})
    {
        particleAndCell one(m, 1e6*m/T);
        one.p.velocity = v0;
        one.exchange(T);
        for (label k = 0; k < steps; ++k)
        {
            one.solve(T/steps);
        }
        const vector common(m*v0/(m + M));
        EXPECT_LT(mag(one.U() - common), 1e-9*mag(v0)) << steps;
    }
}


// in a fluid whose velocity is held, a free particle gets
// m (u - v) (1 - std::exp(-K T/m)), however the interval is divided
TEST(momentumLedger, givesWhatAFreeParticleTakes)
{
    const scalar m = 2e-6, T = 1e-3;
    const vector u(0.1, 0.4, -0.2);
    for (const scalar stiffness : {0.01, 1.0, 20.0})
    {
        for (const label steps : {1, 7})
        {
            particleAndCell one(m, stiffness*m/T);
            one.p.velocity = v0;
            one.exchange(T);
            vector given(Zero);
            for (label k = 0; k < steps; ++k)
            {
                one.hold(u, T/steps);
                given += T/steps*one.source();
            }
            const vector taken(m*(u - v0)*(1 - std::exp(-stiffness)));
            EXPECT_LT(mag(given + taken), 1e-12*mag(taken)) << steps;
        }
    }
}


// what particles report and what the fluid got add up to what is owed
TEST(momentumLedger, isBalanced)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<scalar> unit(-1, 1);
    const auto any = [&]()
    {
        return vector(unit(random), unit(random), unit(random));
    };
    const scalar m = 2e-6, T = 1e-3;
    particleAndCell one(m, 0.7*m/T);
    vector received(Zero), given(Zero), buoyancy(Zero);
    scalar size = 0;

    for (label exchange = 0; exchange < 50; ++exchange)
    {
        const vector uplift(1e-7*any());
        one.p.impulse = 1e-6*any();
        one.p.velocity = any();
        one.force = 1e-4*any();
        received += one.p.impulse[0];
        buoyancy += uplift;
        size += mag(one.p.impulse[0]);
        one.settle(uplift);

        // buoyancy is no reaction of the fluid
        EXPECT_LT
        (
            mag(received - buoyancy + given + one.ledger.owed()), 1e-12*size
        );
        EXPECT_LT(one.ledger.residual(received), 1e-12);
        const vector wrong(0.01*size, 0, 0);
        EXPECT_NEAR(one.ledger.residual(received + wrong), 0.01, 1e-9);

        one.exchange(T);
        for (label k = 0; k < 3; ++k)
        {
            const vector before(one.U());
            one.solve(T/3);
            given += rho*V*(one.U() - before);
        }
    }
}


// what is owed is paid in the next interval, whole, however it is divided
TEST(momentumLedger, paysWhatItOwes)
{
    const scalar T = 1e-3;
    for (const label steps : {1, 4})
    {
        particleAndCell one(2e-6, 0);
        one.p.impulse[0] = vector(1e-6, 0, -3e-6);
        one.settle();
        EXPECT_LT(mag(one.ledger.owed() + one.p.impulse[0]), 1e-18);
        one.exchange(T);
        for (label k = 0; k < steps; ++k)
        {
            one.solve(T/steps);
        }
        EXPECT_LT(mag(rho*V*one.U() + one.p.impulse[0]), 1e-17) << steps;

        one.p.impulse = Zero;
        one.settle();
        EXPECT_LT(mag(one.ledger.owed()), 1e-17) << steps;
    }
}


// the reaction to an explicit force is its opposite; of a particle with added
// mass a the share m/(m + a) of it
TEST(momentumLedger, givesTheReaction)
{
    const scalar m = 2e-6, a = 1e-6, T = 1e-3;
    for (const scalar added : {0.0, a})
    {
        particleAndCell one(m, 0, added);
        one.force[0] = vector(0, 3e-5, 1e-5);
        one.exchange(T);
        one.ledger.prepare(T);
        const vector expected(-m/(m + added)*one.force[0]);
        EXPECT_LT(mag(one.source() - expected), 1e-12*mag(expected)) << added;
    }
}


// added mass makes a free particle follow more slowly: K/(m + a)
TEST(momentumLedger, addedMassSlowsTheAnswer)
{
    const scalar m = 2e-6, a = 1e-6, T = 1e-3, k = 3*m/T;
    particleAndCell one(m, k, a);
    one.p.velocity = v0;
    one.exchange(T);
    one.ledger.prepare(T);
    const vector expected(m*v0*(1 - std::exp(-k*T/(m + a)))/T);
    EXPECT_LT(mag(one.source() - expected), 1e-10*mag(expected));
}


// a rank without particles of a run with added mass
TEST(momentumLedger, withoutParticlesGivesNothing)
{
    const meshCase c(row());
    const auto smoothing = smoothingModel::New
    (
        settings
        (
            "smoothingModel diffusion; diffusionCoeffs { bandwidth 2e-3; }"
        ),
        c.mesh()
    );
    momentumLedger ledger(c.mesh(), rho, true);
    dispersedParticles p;
    p.setSize(0);
    ledger.settle(p, vectorField(), smoothing(), false);
    ledger.sums().set
    (
        p, vectorField(), scalarField(), vectorField(), scalarField(),
        smoothing()
    );
    ledger.begin(1e-3);
    ledger.prepare(1e-3);
    EXPECT_EQ(max(mag(ledger.Sp().primitiveField())), 0);
    EXPECT_EQ(max(mag(ledger.F().primitiveField())), 0);
    EXPECT_EQ(ledger.residual(Zero), 0);
}


// in a step that makes up for intervals left out, drag and reaction keep the
// time of their own interval; what is owed is paid over all of it
TEST(momentumLedger, lateStepsGiveNoMoreDrag)
{
    const scalar m = 2e-6, T = 1e-3, late = 9*T, k = 0.5*m/T;
    particleAndCell one(m, k);
    one.p.velocity = v0;
    one.force[0] = vector(0, 3e-5, 1e-5);
    one.p.impulse[0] = vector(2e-6, 0, 0);
    one.settle();
    one.exchange(T);
    one.ledger.prepare(T + late);
    const vector given((T + late)*one.source());
    const vector expected
    (
        m*v0*(1 - std::exp(-k*T/m)) - T*one.force[0] - one.p.impulse[0]
    );
    EXPECT_LT(mag(given - expected), 1e-12*mag(expected));
}


// what particles received before they went is owed where they were
TEST(momentumLedger, settlesForThoseThatAreGone)
{
    particleAndCell one(2e-6, 0);
    const vector J(1e-6, 0, -2e-6);
    scalarField gone(4, Zero);
    gone[1] = 0.1*V;
    gone[2] = 0.3*V;
    one.settleGone(J, gone);
    EXPECT_LT(mag(one.ledger.owed() + J), 1e-12*mag(J));
    one.exchange(1e-3);
    one.ledger.prepare(1e-3);
    EXPECT_LT(mag(one.source() + 0.25*J/1e-3), 1e-12*mag(J)/1e-3);
    // and nothing where none has gone
    one.settleGone(J, scalarField(4, Zero));
    EXPECT_LT(mag(one.ledger.owed() + J), 1e-12*mag(J));
}


// with the answer foreseen the reaction is the whole of the force, added mass
// or not
TEST(momentumLedger, givesTheWholeReactionAnew)
{
    const scalar m = 2e-6;
    particleAndCell one(m, 0, m);
    one.exchange(1e-3);
    one.force[0] = vector(0, 3e-5, 1e-5);
    one.setReaction();
    one.ledger.prepare(1e-3);
    EXPECT_LT(mag(one.source() + one.force[0]), 1e-12*mag(one.force[0]));
}


// with smoothing, fluid whose velocity goes up and down from cell to cell, of
// which particles see nothing, is damped: what damped it is not asked back, and
// no momentum is lost by that
TEST(momentumLedger, whatParticlesDoNotSeeIsDamped)
{
    const label n = 16;
    const meshCase c
    (
        block({n, 1, 1}, Zero, {n*1e-3, 1e-3, 1e-3})
    );
    const fvMesh& mesh = c.mesh();
    const auto smoothing = smoothingModel::New
    (
        settings
        (
            "smoothingModel diffusion; diffusionCoeffs { bandwidth 3e-3; }"
        ),
        mesh
    );
    volVectorField U
    (
        IOobject("U", mesh.time().timeName(), mesh),
        mesh,
        dimensionedVector(dimVelocity, Zero),
        calculatedFvPatchVectorField::typeName
    );

    // one particle in each cell, at rest
    dispersedParticles p;
    p.setSize(n);
    p.mass = 2e-6;
    p.volume = 0.1*V;
    p.owned = true;
    for (label i = 0; i < n; ++i)
    {
        p.append(i, 1);
        p.endRow(i);
    }
    const scalar T = 1e-3, k = 1e-5;
    const scalarField none;
    momentumLedger ledger(mesh, rho, false);
    ledger.sums().set
    (
        p, p.velocity, scalarField(n, k), vectorField(n, Zero), none,
        smoothing()
    );
    ledger.begin(T);
    ledger.prepare(T);
    forAll(U, i)
    {
        U[i] = vector(i % 2 ? 0.1 : -0.1, 0, 0);
    }
    ledger.record(U, T);

    // they have received nothing, and nothing is owed but at the ends
    ledger.settle(p, vectorField(n, Zero), smoothing(), true);
    const scalar given = 0.1*k*T;
    ledger.begin(T);
    ledger.sums().set
    (
        p, p.velocity, scalarField(n, Zero), vectorField(n, Zero), none,
        smoothing()
    );
    ledger.prepare(T);
    const scalarField owed
    (
        ledger.F().primitiveField().component(0)()*rho*V*T
    );
    EXPECT_LT(mag(owed[7]), 0.03*given);
    EXPECT_LT(mag(owed[8]), 0.03*given);
    EXPECT_LT(ledger.residual(Zero), 1e-12);
    EXPECT_LT(mag(ledger.owed()), 1e-12*given);
}
