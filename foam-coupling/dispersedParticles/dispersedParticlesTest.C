// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "cellGeometry.H"
#include "dispersedParticles.H"
#include "testMesh.H"

#include <gtest/gtest.h>

#include <numeric>

using namespace Foam;

namespace
{

void place(dispersedParticles& p, const pointField& x, const labelList& tags)
{
    p.setSize(x.size());
    p.position = x;
    p.tag = tags;
    p.radius = 1e-2;
}

pointField cloud(const label n)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<scalar> unit(0, 1);
    pointField x(n);
    for (point& p : x)
    {
        p = point(unit(random), unit(random), unit(random));
    }
    return x;
}

}


TEST(dispersedParticles, findsTheCell)
{
    const test::meshCase c(test::block({10, 10, 10}, Zero, {1, 1, 1}));
    const pointField x(cloud(1000));
    dispersedParticles p;
    place(p, x, identity(1000));
    p.locate(c.mesh());

    for (label i = 0; i < p.size(); ++i)
    {
        const label expected =
            label(10*x[i].x()) + 10*label(10*x[i].y()) + 100*label(10*x[i].z());
        EXPECT_EQ(p.cell[i], expected);
        EXPECT_TRUE(p.owned[i]);
        EXPECT_EQ(p.claims(c.mesh())[i], 0);
    }
    EXPECT_EQ(p.searches(), 1000);

    // at rest nothing is searched for, whatever the order
    p.locate(c.mesh());
    EXPECT_EQ(p.searches(), 1000);

    const labelList before(p.cell);
    pointField reversed(x);
    Foam::reverse(reversed);
    labelList tags(identity(1000));
    Foam::reverse(tags);
    place(p, reversed, tags);
    p.locate(c.mesh());
    EXPECT_EQ(p.searches(), 1000);
    EXPECT_EQ(p.cell[0], before[999]);

    // fewer and new ones
    place(p, pointField(SubList<point>(x, 200, 500)), identity(200));
    p.locate(c.mesh());
    EXPECT_EQ(p.cell[3], before[503]);
}


TEST(dispersedParticles, followsMovingParticles)
{
    for (const bool tets : {false, true})
    {
        const test::meshCase c
        (
            tets
          ? test::tetBlock({6, 6, 6}, Zero, {1, 1, 1})
          : test::block({6, 6, 6}, Zero, {1, 1, 1})
        );
        const cellGeometry& geometry = cellGeometry::New(c.mesh());
        std::mt19937 random(4);
        std::normal_distribution<scalar> step(0, 0.03);
        pointField x(cloud(300));
        dispersedParticles p;

        for (label k = 0; k < 50; ++k)
        {
            place(p, x, identity(300));
            p.locate(c.mesh());
            for (label i = 0; i < p.size(); ++i)
            {
                ASSERT_GE(p.cell[i], 0);
                EXPECT_LE(geometry.outside(p.cell[i], x[i]), 1e-12);
                for (direction axis = 0; axis < 3; ++axis)
                {
                    x[i][axis] =
                        min(max(x[i][axis] + step(random), 0.001), 0.999);
                }
            }
        }
    }
}


TEST(dispersedParticles, outsideOfTheMesh)
{
    const test::meshCase c(test::block({4, 4, 4}, Zero, {1, 1, 1}));
    pointField x(4);
    x[0] = point(0.1, 0.1, -0.006);     // less than a radius below the floor
    x[1] = point(0.1, 0.1, -0.02);      // more
    x[2] = point(1.004, 1.003, 0.9);    // beyond an edge
    x[3] = point(5, 5, 5);
    dispersedParticles p;
    place(p, x, identity(4));
    p.locate(c.mesh());

    const scalarField claims(p.claims(c.mesh()));
    EXPECT_EQ(p.cell[0], 0);
    EXPECT_NEAR(claims[0], 0.006, 1e-14);
    EXPECT_EQ(p.cell[1], -1);
    EXPECT_EQ(claims[1], 1e300);
    EXPECT_FALSE(p.owned[1]);
    EXPECT_EQ(p.cell[2], 63);
    EXPECT_NEAR(claims[2], 0.004, 1e-14);
    EXPECT_EQ(p.cell[3], -1);
}


// points of warped and of slender cells all have a home
TEST(dispersedParticles, oddCells)
{
    test::polyhedra warped(test::block({6, 6, 6}, Zero, {1, 1, 1}));
    test::shake(warped, 0.03, 5, false);
    test::polyhedra slender(test::block({3, 3, 60}, Zero, {1, 1, 1}));
    slender.move
    (
        [](const point& p)
        {
            return point(p.x(), p.y(), pow3(p.z()));
        }
    );

    for (const test::polyhedra* cells : {&warped, &slender})
    {
        const test::meshCase c(*cells);
        dispersedParticles p;
        place(p, cloud(3000), identity(3000));
        p.locate(c.mesh());
        for (label i = 0; i < p.size(); ++i)
        {
            ASSERT_GE(p.cell[i], 0) << p.position[i];
            EXPECT_LT(p.outside[i], 2e-3) << p.position[i];
        }
    }
}


TEST(cellGeometry, nearFindsAllOnce)
{
    const test::meshCase c(test::block({7, 8, 9}, Zero, {1, 1, 1}));
    const cellGeometry& geometry = cellGeometry::New(c.mesh());

    for (const point& x : cloud(200))
    {
        const scalar r = 0.2;
        DynamicList<label> found;
        geometry.near(x, r, found);
        labelHashSet set(found);
        EXPECT_EQ(set.size(), found.size());

        forAll(c.mesh().C(), celli)
        {
            scalar sqrDistance = 0;
            const vector half(1.0/14, 1.0/16, 1.0/18);
            for (direction axis = 0; axis < 3; ++axis)
            {
                const scalar beyond =
                    mag(x[axis] - c.mesh().C()[celli][axis]) - half[axis];
                sqrDistance += sqr(max(beyond, 0.0));
            }
            if (mag(sqrDistance - r*r) > 1e-6)
            {
                EXPECT_EQ(set.found(celli), sqrDistance < r*r);
            }
        }
    }
}
