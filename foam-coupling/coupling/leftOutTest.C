// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Description
    What is left out gives the same answer: mappings that are kept, intervals
    of a quiet fluid.
\*---------------------------------------------------------------------------*/

#include "fixedValueFvPatchFields.H"
#include "keptMapping.H"
#include "quietFluid.H"
#include "testMesh.H"
#include "voidFractionModel.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

const label many = 400;

void fill(dispersedParticles& p, const pointField& x)
{
    p.setSize(x.size());
    p.position = x;
    p.radius = 1e-3;
    p.volume = 4e-9;
    p.tag = identity(x.size());
}

pointField cloud()
{
    std::mt19937 random(7);
    std::uniform_real_distribution<scalar> unit(0, 1);
    pointField x(many);
    for (point& p : x)
    {
        p = point(0.001, 0.001, 0.001)
          + 0.038*vector(unit(random), unit(random), unit(random));
    }
    return x;
}

}


TEST(keptMapping, renewsOnlyWhatHasMoved)
{
    const test::meshCase c(test::block({15, 15, 15}, Zero, {0.04, 0.04, 0.04}));
    for (const char* name : {"centre", "divided", "exactOverlap"})
    {
        auto model = voidFractionModel::New
        (
            test::settings(std::string("voidFractionModel ") + name + ";"),
            c.mesh()
        );
        pointField x(cloud());
        volScalarField n(c.field("n")), full(c.field("full"));
        keptMapping kept(1e-3);
        dispersedParticles p, q;

        fill(p, x);
        kept.restore(p);
        EXPECT_TRUE(kept.allMoved(p));
        p.locate(c.mesh());
        model->map(p, nullptr, n);
        kept.keep(p);

        // every tenth particle goes to the next cell, the others tremble
        for (label i = 0; i < many; ++i)
        {
            x[i].x() += i % 10 ? 5e-10 : (x[i].x() < 0.02 ? 3e-3 : -3e-3);
        }
        fill(p, x);
        kept.restore(p);
        ASSERT_EQ(kept.moved().size(), many/10) << name;
        p.locate(c.mesh());
        model->map(p, nullptr, n, nullptr, &kept.moved());
        kept.keep(p);

        fill(q, x);
        q.locate(c.mesh());
        model->map(q, nullptr, full);

        const scalarField& V = c.mesh().V();
        const scalar solid = gSum((1 - n.primitiveField())*V);
        EXPECT_NEAR(solid/(many*4e-9), 1, 1e-12) << name;
        EXPECT_LT(gMax(mag(n.primitiveField() - full.primitiveField())()), 1e-5)
            << name;
        EXPECT_EQ(p.offset, q.offset) << name;
        EXPECT_EQ(p.cellIndex.size(), q.cellIndex.size()) << name;

        // nothing moves: all is kept
        fill(p, x);
        kept.restore(p);
        EXPECT_EQ(kept.moved().size(), 0) << name;
        EXPECT_EQ(p.weight.size(), q.weight.size()) << name;
    }
}


// steps within the slack that the model states change no weight
TEST(keptMapping, slackOfDividedIsExact)
{
    const test::polyhedra meshes[] =
    {
        test::block({15, 15, 15}, Zero, {0.04, 0.04, 0.04}),
        test::tetBlock({8, 8, 8}, Zero, {0.04, 0.04, 0.04})
    };
    for (const test::polyhedra& cells : meshes)
    {
        const test::meshCase c(cells);
        auto model = voidFractionModel::New
        (
            test::settings("voidFractionModel divided;"), c.mesh()
        );
        std::mt19937 random(3);
        std::normal_distribution<scalar> step(0, 3e-6);
        pointField x(cloud());
        volScalarField n(c.field("n")), full(c.field("full"));
        keptMapping kept(1e-12);
        dispersedParticles p;
        label renewed = 0;
        const label passes = 60;

        for (label pass = 0; pass < passes; ++pass)
        {
            fill(p, x);
            kept.restore(p);
            renewed += kept.moved().size();
            p.locate(c.mesh());
            model->map
            (
                p, nullptr, n, nullptr,
                kept.allMoved(p) ? nullptr : &kept.moved()
            );
            kept.keep(p);

            dispersedParticles q;
            fill(q, x);
            q.locate(c.mesh());
            model->map(q, nullptr, full);

            ASSERT_EQ(p.cell, q.cell) << pass;
            ASSERT_LT
            (
                gMax(mag(n.primitiveField() - full.primitiveField())()), 1e-13
            )   << pass;
            for (point& y : x)
            {
                y += vector(step(random), step(random), step(random));
            }
        }
        EXPECT_LT(renewed, many*passes/2);
        EXPECT_GT(renewed, many + passes);
    }
}


TEST(keptMapping, smallStepsAddUp)
{
    keptMapping kept(1e-3);
    dispersedParticles p;
    pointField x(1, point(0, 0, 0));
    fill(p, x);
    kept.restore(p);
    p.offset[1] = 1;
    p.cellIndex.append(0);
    p.weight.append(1);
    kept.keep(p);

    label renewed = 0;
    for (label k = 1; k <= 40; ++k)
    {
        x[0].x() = k*1e-7;
        fill(p, x);
        kept.restore(p);
        renewed += kept.moved().size();
        p.offset[1] = 1;
        if (p.weight.empty())
        {
            p.cellIndex.append(0);
            p.weight.append(1);
        }
        kept.keep(p);
    }
    EXPECT_GE(renewed, 3);
    EXPECT_LE(renewed, 4);
}


TEST(keptMapping, distanceZeroKeepsNothing)
{
    keptMapping kept(0);
    dispersedParticles p;
    fill(p, cloud());
    kept.restore(p);
    kept.keep(p);
    fill(p, cloud());
    kept.restore(p);
    EXPECT_TRUE(kept.allMoved(p));
}


TEST(quietFluid, endsWithAnyChange)
{
    const test::meshCase c(test::block({3, 3, 3}, Zero, {1, 1, 1}));
    const fvMesh& mesh = c.mesh();
    const auto scalars = [&](const word& name, const scalar value)
    {
        volScalarField f(c.field(name));
        f.primitiveFieldRef() = value;
        return f;
    };
    volVectorField U
    (
        IOobject("U", mesh.time().timeName(), mesh),
        mesh,
        dimensionedVector("U", dimVelocity, vector(1, 0, 0)),
        fixedValueFvPatchVectorField::typeName
    );
    volVectorField F("F", 0*U);
    const volScalarField n(scalars("n", 0.5)), Sp(scalars("Sp", 0));
    volScalarField ddtN(scalars("ddtN", 0));

    volScalarField p
    (
        IOobject("p", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar("p", sqr(dimVelocity), 0),
        fixedValueFvPatchScalarField::typeName
    );

    quietFluid quiet(1e-3);
    const auto holds =
        [&]() { return quiet.holds(U, p, n, ddtN, Sp, F, 0.1); };
    const auto solved = [&](const vectorField& before)
    {
        quiet.solved(before, U, p, Sp, F, 0.1);
    };
    const vectorField same(U.primitiveField());

    EXPECT_FALSE(holds());                  // nothing solved as yet
    F[4].y() = 3;                           // what acts always changes nothing
    solved(same);
    EXPECT_TRUE(holds());

    F[4].y() += 1e-3;                       // 0.2 s of it are 4e-4 m/s
    EXPECT_TRUE(holds());
    F[4].y() += 0.1;
    EXPECT_FALSE(holds());
    F[4].y() = 3;
    EXPECT_TRUE(holds());

    ddtN[2] = 1e-3;
    EXPECT_FALSE(holds());
    ddtN[2] = 0;

    U.boundaryFieldRef()[0] == vector(1.1, 0, 0);
    EXPECT_FALSE(holds());
    U.boundaryFieldRef()[0] == vector(1, 0, 0);

    p.boundaryFieldRef()[0] == 0.1;
    EXPECT_FALSE(holds());
    p.boundaryFieldRef()[0] == 0;
    EXPECT_TRUE(holds());
    EXPECT_NEAR(quiet.late(), 0.4, 1e-12);

    // two intervals of this change too much
    vectorField before(same);
    before[0].x() -= 0.6e-3;
    solved(before);
    EXPECT_EQ(quiet.late(), 0);
    EXPECT_FALSE(holds());

    // no change at all: still it is looked after
    solved(same);
    label left = 0;
    while (holds())
    {
        ++left;
    }
    EXPECT_EQ(left, 1000);
}


// a flow that decays slowly keeps its rate: steps over what was left out
TEST(quietFluid, slowChangesAreNotSlowedDown)
{
    const test::meshCase c(test::block({3, 3, 3}, Zero, {1, 1, 1}));
    const fvMesh& mesh = c.mesh();
    volVectorField U
    (
        IOobject("U", mesh.time().timeName(), mesh),
        mesh,
        dimensionedVector("U", dimVelocity, vector(1, 0, 0)),
        fixedValueFvPatchVectorField::typeName
    );
    const volVectorField F("F", 0*U);
    volScalarField n(c.field("n")), zero(c.field("zero")), p(c.field("p"));
    n.primitiveFieldRef() = 1;
    zero.primitiveFieldRef() = 0;

    const scalar e = 1e-3, rate = 1e-3, interval = 0.1;
    quietFluid quiet(e);
    label left = 0;
    scalar error = 0;
    const label intervals = 50000;
    for (label k = 1; k <= intervals; ++k)
    {
        if (k > 1 && quiet.holds(U, p, n, zero, zero, F, interval))
        {
            ++left;
            continue;
        }
        const scalar time = quiet.late() + interval;
        const vectorField before(U.primitiveField());
        U.primitiveFieldRef() /= 1 + rate*time;
        quiet.solved(before, U, p, zero, F, time);
        error = max(error, mag(U[0].x() - std::exp(-rate*k*interval)));
    }
    EXPECT_GT(left, 0.95*intervals);
    EXPECT_LE(error, e/2);
    EXPECT_GT(error, e/20);
}
