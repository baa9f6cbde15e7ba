// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Description
    After which length meshes repeat, and where they are open.
\*---------------------------------------------------------------------------*/

#include "meshPeriod.H"
#include "testMesh.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

typedef std::array<double, 3> lengths;
typedef std::array<bool, 6> sides;

// 1 by 2 by 3 m, not at the origin
test::meshCase box(const std::vector<std::string>& kinds)
{
    return test::meshCase
    (
        test::block({2, 2, 3}, point(5, -1, 0), point(6, 1, 3)), kinds
    );
}

}


TEST(meshPeriod, wallsDoNotRepeatAndAreClosed)
{
    const test::meshCase c(box({}));
    EXPECT_EQ(meshPeriod(c.mesh()), (lengths{0, 0, 0}));
    EXPECT_EQ(openSides(c.mesh()), (sides{}));
}


TEST(meshPeriod, isTheDistanceOfAPairOfPatches)
{
    const test::meshCase c
    (
        box({"wall", "wall", "cyclic", "cyclic", "wall", "patch"})
    );
    const lengths found(meshPeriod(c.mesh()));
    EXPECT_EQ(found[0], 0);
    EXPECT_NEAR(found[1], 2, 1e-12);
    EXPECT_EQ(found[2], 0);
    EXPECT_EQ(openSides(c.mesh()), (sides{0, 0, 0, 0, 0, 1}));
}


TEST(meshPeriod, knowsSeveralPairs)
{
    const test::meshCase c(box(std::vector<std::string>(6, "cyclic")));
    const lengths found(meshPeriod(c.mesh()));
    for (int k = 0; k < 3; ++k)
    {
        EXPECT_NEAR(found[k], k + 1, 1e-12);
    }
    EXPECT_EQ(openSides(c.mesh()), (sides{}));
}


// nothing moves across a mesh of one cell between empty patches
TEST(meshPeriod, isNoneAcrossAPlaneCase)
{
    const test::meshCase c
    (
        test::meshCase
        (
            test::block({2, 1, 3}, Zero, point(1, 1, 3)),
            {"patch", "symmetryPlane", "empty", "empty", "wall", "wall"}
        )
    );
    EXPECT_EQ(meshPeriod(c.mesh()), (lengths{0, -1, 0}));
    EXPECT_EQ(openSides(c.mesh()), (sides{1, 0, 0, 0, 0, 0}));
}
