// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Description
    Which particles have come and gone between two lists of them.
\*---------------------------------------------------------------------------*/

#include "particleTurnover.H"
#include "testMesh.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

const label nCells = 6;

struct ball
{
    label tag;
    scalar volume;
    label cell;             // half of it there, half in the next
};

void put(dispersedParticles& p, const std::vector<ball>& balls)
{
    p.setSize(balls.size());
    p.clearRows();
    forAll(p.tag, i)
    {
        p.tag[i] = balls[i].tag;
        p.volume[i] = balls[i].volume;
        p.owned[i] = true;
        p.append(balls[i].cell, 0.5);
        p.append(balls[i].cell + 1, 0.5);
        p.endRow(i);
    }
}

// what is compared, one list after the other
class turnover
{
    dispersedParticles p_;

public:

    particleTurnover found;

    turnover& see(const std::vector<ball>& balls)
    {
        put(p_, balls);
        found.compare(p_, nCells);
        return *this;
    }
};

}


// those of the first exchange have been there before
TEST(particleTurnover, beginsWithWhatIsThere)
{
    turnover one;
    EXPECT_FALSE(one.see({{1, 2, 0}, {2, 2, 3}}).found.any());
    EXPECT_FALSE(one.see({{1, 2, 0}, {2, 2, 3}}).found.any());
}


TEST(particleTurnover, knowsThoseThatCome)
{
    turnover one;
    one.see({{1, 2, 0}, {2, 2, 3}}).see({{2, 2, 3}, {7, 4, 4}, {1, 2, 1}});
    ASSERT_TRUE(one.found.any());
    EXPECT_EQ(one.found.came(), scalarField({0, 0, 0, 0, 2, 2}));
    EXPECT_EQ(sum(one.found.gone()), 0);
    EXPECT_TRUE(one.found.lastGone().empty());
}


// where they were last; that is remembered
TEST(particleTurnover, knowsThoseThatGo)
{
    turnover one;
    one.see({{1, 2, 0}, {2, 6, 3}}).see({{1, 2, 1}});
    EXPECT_EQ(one.found.gone(), scalarField({0, 0, 0, 3, 3, 0}));
    EXPECT_EQ(sum(one.found.came()), 0);
    one.see({{1, 2, 2}});
    EXPECT_FALSE(one.found.any());
    EXPECT_EQ(one.found.lastGone(), scalarField({0, 0, 0, 3, 3, 0}));
    one.see({{1, 2, 2}, {3, 2, 2}});
    EXPECT_EQ(one.found.lastGone(), scalarField({0, 0, 0, 3, 3, 0}));
}


// number and sum of the tags are the same
TEST(particleTurnover, seesOneInPlaceOfAnother)
{
    turnover one;
    one.see({{1, 2, 0}, {4, 2, 0}}).see({{2, 2, 4}, {3, 2, 4}});
    ASSERT_TRUE(one.found.any());
    EXPECT_EQ(one.found.came(), scalarField({0, 0, 0, 0, 2, 2}));
    EXPECT_EQ(one.found.gone(), scalarField({2, 2, 0, 0, 0, 0}));
}


TEST(particleTurnover, anEmptyListMayFillAndEmpty)
{
    turnover one;
    EXPECT_TRUE(one.see({}).see({{5, 2, 0}}).found.any());
    EXPECT_EQ(sum(one.found.came()), 2);
    EXPECT_TRUE(one.see({}).found.any());
    EXPECT_EQ(sum(one.found.gone()), 2);
}


// an exchange in which none has moved is not compared
TEST(particleTurnover, noneComesTwice)
{
    turnover one;
    one.see({{1, 2, 0}}).see({});
    one.found.rest();
    EXPECT_FALSE(one.found.any());
}


// a run that goes on from a saved state has no list from before
TEST(particleTurnover, aSavedStateHoldsWhatCameAndWent)
{
    const std::vector<ball> before{{1, 2, 0}, {2, 6, 3}, {3, 2, 0}};
    const std::vector<ball> now{{1, 2, 1}, {3, 2, 0}, {7, 4, 4}};
    const std::vector<ball> later{{1, 2, 1}, {7, 4, 3}};
    const test::meshCase box(test::block({nCells, 1, 1}, Zero, {6, 1, 1}));
    const fvMesh& mesh = box.mesh();

    turnover one;
    one.see(before).see(now);
    {
        stateWriter to(mesh, mesh.time().timePath());
        one.found.save(to);
        to.finish();
    }
    one.see(later);

    dispersedParticles p;
    particleTurnover again(mesh);
    put(p, now);
    again.compare(p, nCells);
    EXPECT_EQ(again.came(), scalarField({0, 0, 0, 0, 2, 2}));
    EXPECT_EQ(again.gone(), scalarField({0, 0, 0, 3, 3, 0}));
    EXPECT_EQ(again.lastGone(), again.gone());
    put(p, later);
    again.compare(p, nCells);
    EXPECT_EQ(again.came(), one.found.came());
    EXPECT_EQ(again.gone(), one.found.gone());

    // other particles than those of the state: nothing is known of them
    particleTurnover others(mesh);
    put(p, before);
    others.compare(p, nCells);
    EXPECT_FALSE(others.any());
    EXPECT_EQ(others.lastGone(), scalarField({0, 0, 0, 3, 3, 0}));
}


TEST(particleTurnover, aSavedStateInWhichNoneCameOrWent)
{
    const test::meshCase box(test::block({nCells, 1, 1}, Zero, {6, 1, 1}));
    const fvMesh& mesh = box.mesh();
    turnover one;
    one.see({{1, 2, 0}}).see({{1, 2, 1}});
    {
        stateWriter to(mesh, mesh.time().timePath());
        one.found.save(to);
        to.finish();
    }
    dispersedParticles p;
    put(p, {{1, 2, 1}});
    particleTurnover again(mesh);
    again.compare(p, nCells);
    EXPECT_FALSE(again.any());
    EXPECT_TRUE(again.lastGone().empty());
}
