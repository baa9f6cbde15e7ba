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


namespace
{

// a particle of volume 1 in the first cell, in parts of equal size
struct parts
{
    label tag;
    label owner;
    labelList others;       // that hold a part, too
};

// what a turnover sees; ranks are taken round
void see(particleTurnover& turnover, const std::vector<parts>& all)
{
    const label ranks = Pstream::nProcs(), me = Pstream::myProcNo();
    dispersedParticles p;
    std::vector<parts> mine;
    for (const parts& one : all)
    {
        for (const label rank : one.others)
        {
            ASSERT_NE(rank % ranks, one.owner % ranks);
        }
        if (one.owner % ranks == me || one.others.found(me))
        {
            mine.push_back(one);
        }
    }
    p.setSize(mine.size());
    p.clearRows();
    forAll(p.tag, i)
    {
        p.tag[i] = mine[i].tag;
        p.volume[i] = 1;
        p.owned[i] = mine[i].owner % ranks == me;
        p.append(0, 1.0/(1 + mine[i].others.size()));
        p.endRow(i);
    }
    turnover.compare(p, 1);
}

}


// each rank that holds a part of one knows that it has come or gone; another
// owner and other holders are neither
TEST(parallelHandOver, turnoverOfSharedParticles)
{
    const label me = Pstream::myProcNo(), last = Pstream::nProcs() - 1;
    const auto half = [&](const label a, const label b)
    {
        return me == a || me == b ? 0.5 : 0.0;
    };
    // the rank that the tag names is one of these, and is not
    for (const label tag : {6*8, 6*8 + 1, 6*8 + 2})
    {
        particleTurnover turnover;
        see(turnover, {{1, 0, {}}});
        see(turnover, {{1, 0, {}}, {tag, 0, {last}}});
        ASSERT_TRUE(turnover.any());
        EXPECT_EQ(turnover.came()[0], half(0, last));
        EXPECT_EQ(turnover.gone()[0], 0);

        // the other of its holders owns it now; one comes that all see
        see(turnover, {{1, 0, {}}, {tag, last, {0}}, {3, 1, {}}});
        ASSERT_TRUE(turnover.any());
        EXPECT_EQ(turnover.came()[0], me == 1);
        EXPECT_EQ(turnover.gone()[0], 0);

        // a rank holds it that has not, one no longer
        see(turnover, {{1, 0, {}}, {tag, last, {last - 1}}, {2, 1, {}}});
        EXPECT_EQ(turnover.came()[0], me == 1);
        EXPECT_EQ(turnover.gone()[0], me == 1);
        EXPECT_EQ(gSum(turnover.came()), 1);

        see(turnover, {{1, 0, {}}, {2, 1, {}}});
        ASSERT_TRUE(turnover.any());
        EXPECT_EQ(turnover.came()[0], 0);
        EXPECT_EQ(turnover.gone()[0], half(last, last - 1));
        EXPECT_EQ(turnover.lastGone()[0], half(last, last - 1));
    }
}


// what goes over the wire goes with what has changed
TEST(parallelHandOver, turnoverTellsOfWhatHasChangedAlone)
{
    std::vector<parts> many;
    for (label tag = 1; tag <= 1000; ++tag)
    {
        many.push_back({tag, tag/9, {}});
    }
    particleTurnover turnover;
    see(turnover, many);
    many.push_back({2001, 0, {1}});
    see(turnover, many);
    ASSERT_TRUE(turnover.any());
    // by its owner and by the other rank that holds it, once told, once heard
    EXPECT_EQ(returnReduce(turnover.told(), sumOp<label>()), 4);

    // one goes to another rank besides
    many[500].owner += 1;
    many.pop_back();
    see(turnover, many);
    EXPECT_EQ(returnReduce(turnover.told(), sumOp<label>()), 8);
    EXPECT_EQ(gSum(turnover.gone()), 1);
    EXPECT_EQ(gSum(turnover.came()), 0);
}


// one that goes from rank to rank has neither come nor gone
TEST(parallelHandOver, turnover)
{
    const label ranks = Pstream::nProcs(), me = Pstream::myProcNo();
    particleTurnover turnover;
    const auto seen = [&](const labelList& tags, const label first)
    {
        std::vector<parts> all;
        for (const label tag : tags)
        {
            all.push_back({tag, tag + first, {}});
        }
        see(turnover, all);
    };
    seen({1, 2, 3, 4}, 0);
    seen({1, 2, 3, 4}, 1);
    EXPECT_FALSE(turnover.any());
    seen({1, 2, 3, 9}, 2);
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
