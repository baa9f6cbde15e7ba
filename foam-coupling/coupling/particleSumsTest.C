// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Description
    What the particles' sums say of the coupling: its stiffness by drag and by
    pressure, and by how much of their change forces may follow.
\*---------------------------------------------------------------------------*/

#include "particleAndCell.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::test;


// K T/(rho n V), of all cells the largest
TEST(particleSums, measuresStiffness)
{
    particleAndCell one(2e-6, 3e-4);
    one.exchange(1e-3);
    EXPECT_NEAR
    (
        one.ledger.sums().stiffness(one.n(0.6), 2e-3)
       /(3e-4*2e-3/(rho*0.6*V)),
        1,
        1e-12
    );
}


// rho f^2/n over inertia and drag, of all cells the largest; 1 at most where
// added mass takes part
TEST(particleSums, measuresThePressuresStiffness)
{
    const scalar m = 0.1*rho*V, T = 1e-3, n = 0.25, f = 1 - n;
    for (const scalar k : {0.0, m/T})
    {
        particleAndCell one(m, k);
        one.exchange(T);
        const scalar expected = rho*V*f*f/n/(m + k*T);
        EXPECT_NEAR
        (
            one.ledger.sums().pressureStiffness(one.n(n), T)/expected, 1, 1e-12
        );
    }
    particleAndCell added(m, 0, m);
    added.exchange(T);
    EXPECT_EQ(added.ledger.sums().pressureStiffness(added.n(n), T), 1);
}


// heavy particles follow the fluid at once, light ones by the ratio of their
// inertia to what the fluid answers with; empty cells have none to hold back
TEST(particleSums, lightParticlesFollowByAPart)
{
    const scalar T = 1e-3, n = 0.25, f = 1 - n, Cm = 0.5;
    const scalar G = rho*f*f/n*(1 + Cm/n + Cm);
    for (const scalar m : {0.1*rho*V, 100*rho*V})
    {
        particleAndCell one(m, 0.2*m/T, m);
        one.exchange(T);
        const scalarField part(one.ledger.sums().follow(one.n(n), Cm*rho, T));
        const scalar M = 1.2*m/V + f*Cm*rho;
        EXPECT_NEAR(part[1], M < G ? M/G : 1, 1e-12);
        EXPECT_EQ(part[0], 1);
    }
}
