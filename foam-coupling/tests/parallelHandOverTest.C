// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Description
    What goes with a particle from rank to rank, on the ranks of an mpirun:
    its numbers, its history, that it has neither come nor gone.
\*---------------------------------------------------------------------------*/

#include "cutUpMesh.H"
#include "handOver.H"
#include "particleTurnover.H"
#include "selfDisturbanceModel.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::test;


TEST(parallelHandOver, severalRanks)
{
    ASSERT_TRUE(Pstream::parRun());
    ASSERT_GT(Pstream::nProcs(), 1);
}


// every tag's numbers come to its new owner, and nothing else does
TEST(parallelHandOver, numbersAreHandedOver)
{
    const label ranks = Pstream::nProcs(), me = Pstream::myProcNo();
    const auto numbers = [](const label tag)
    {
        std::vector<scalar> x(tag % 5);
        for (size_t k = 0; k < x.size(); ++k)
        {
            x[k] = 1.0/3*tag + k;
        }
        return x;
    };
    // all from the first rank to the last, and around; none from the last
    for (const label by : {ranks - 1, label(1), label(0)})
    {
        particleNumbers given;
        DynamicList<label> wanted;
        label expected = 0;
        for (label tag = 1; tag < 200; ++tag)
        {
            const label from = by ? tag/7 % ranks : 0;
            if (from == me && tag % 11)
            {
                given[tag] = numbers(tag);
            }
            if ((from + by) % ranks == me && tag % 3)
            {
                wanted.append(tag);
                expected += tag % 11 != 0;
            }
        }
        const particleNumbers got(handOver(given, wanted));
        EXPECT_EQ(label(got.size()), expected) << by;
        for (const auto& one : got)
        {
            EXPECT_EQ(one.second, numbers(one.first));
            EXPECT_TRUE(wanted.found(one.first));
        }
    }
}


// one that goes from rank to rank has neither come nor gone
TEST(parallelHandOver, turnover)
{
    const label ranks = Pstream::nProcs(), me = Pstream::myProcNo();
    particleTurnover turnover;
    const auto see = [&](const labelList& tags, const label first)
    {
        dispersedParticles p;
        DynamicList<label> mine;
        for (const label tag : tags)
        {
            if ((tag + first) % ranks == me)
            {
                mine.append(tag);
            }
        }
        p.setSize(mine.size());
        p.clearRows();
        forAll(mine, i)
        {
            p.tag[i] = mine[i];
            p.volume[i] = 1;
            p.owned[i] = true;
            p.append(0, 1);
            p.endRow(i);
        }
        turnover.compare(p, 1);
    };
    see({1, 2, 3, 4}, 0);
    see({1, 2, 3, 4}, 1);
    EXPECT_FALSE(turnover.any());
    see({1, 2, 3, 9}, 2);
    // all ranks know that some have
    ASSERT_TRUE(turnover.any());
    EXPECT_EQ(gSum(turnover.came()), 1);
    EXPECT_EQ(gSum(turnover.gone()), 1);
    EXPECT_EQ(turnover.came()[0], (9 + 2) % ranks == me ? 1 : 0);
    EXPECT_EQ(turnover.gone()[0], (4 + 1) % ranks == me ? 1 : 0);
}


// a particle's history goes with it from rank to rank
TEST(parallelHandOver, historiesGoAlong)
{
    const scalar nu = 0.5, rho = 2, T = 0.02*sqr(0.002)/nu;
    vector result[2];
    for (const layout how : {chess, lopsided})
    {
        const meshCase c(mesh(how));
        autoPtr<selfDisturbanceModel> model
        (
            selfDisturbanceModel::New
            (
                settings("selfDisturbance latticeMemory;"),
                {c.mesh(), "exactOverlap", "mapped", nu, rho, 0, 0, true}
            )
        );
        dispersedParticles p;
        label owners = 0;
        for (label k = 0; k < 40; ++k)
        {
            p.setSize(1);
            p.radius = 4e-4;
            p.volume = 1e-12;
            p.mass = 1;
            p.tag = 7;
            // through several cells
            p.position[0] = point(3e-3 + 3e-4*k, 9e-3, 9.3e-3);
            p.locate(c.mesh());
            own(p, c.mesh());
            p.impulse = k > 0 ? vector(0, 0, -3*T) : vector::zero;
            vectorField velocity, force;
            scalarField solid;
            model->evaluate
            (
                p, T, vectorField(1, Zero), scalarField(1, 1.0),
                velocity, solid, force
            );
            model->sent(p, scalarField(1, 0.0), vectorField(1, Zero));
            owners += p.owned[0];
            result[how == lopsided] =
                returnReduce
                (
                    p.owned[0] ? velocity[0] : vector(Zero), sumOp<vector>()
                );
        }
        if (how == chess)
        {
            EXPECT_GT(owners, 5);
        }
    }
    EXPECT_GT(mag(result[1]), 0);
    EXPECT_LT(mag(result[0] - result[1]), 1e-12*mag(result[1]));
}
