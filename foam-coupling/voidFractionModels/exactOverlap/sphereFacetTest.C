// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "sphereFacet.H"
#include "mathematicalConstants.H"
#include "testMesh.H"
#include "transform.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

struct facet
{
    vector normal;
    List<sphereFacet::edge> edges;
};

// of the first cell
std::vector<facet> facets(const test::polyhedra& cell)
{
    std::vector<facet> result;
    for (const face& f : cell.cells[0])
    {
        const pointField x(f.points(cell.points));
        facet plane;
        plane.normal = (x[1] - x[0]) ^ (x[2] - x[0]);
        plane.normal /= mag(plane.normal);
        plane.edges.setSize(x.size());
        forAll(x, i)
        {
            const vector along(x[(i + 1) % x.size()] - x[i]);
            sphereFacet::edge& e = plane.edges[i];
            e.start = x[i];
            e.length = mag(along);
            e.along = along/mag(along);
            e.outward = e.along ^ plane.normal;
        }
        result.push_back(plane);
    }
    return result;
}

sphereFacet against(const facet& f, const point& centre, const scalar R)
{
    return sphereFacet
    (
        f.normal & (f.edges[0].start - centre), f.edges, centre, R
    );
}

// volume of a ball in a polyhedron
scalar overlap(const test::polyhedra& cell, const point& centre, scalar R)
{
    scalar sum = 0;
    for (const facet& f : facets(cell))
    {
        sum += against(f, centre, R).volume();
    }
    return sum;
}

struct tableCase
{
    std::string name;
    point lo, hi, centre;
    scalar R, overlap;
};

std::vector<tableCase> overlaps()
{
    std::vector<tableCase> result;
    for (const auto& row : test::table("sphere_hex_overlap_exact.csv"))
    {
        const auto v = [&](int i) { return std::stod(row[i]); };
        result.push_back
        ({
            row[0],
            point(v(1), v(2), v(3)), point(v(4), v(5), v(6)),
            point(v(7), v(8), v(9)), v(10), v(11)
        });
    }
    return result;
}

}


TEST(sphereFacet, exactTable)
{
    const auto cases = overlaps();
    ASSERT_EQ(cases.size(), 15u);
    for (const tableCase& c : cases)
    {
        EXPECT_NEAR
        (
            overlap(test::block({1, 1, 1}, c.lo, c.hi), c.centre, c.R),
            c.overlap,
            1e-9*max(c.overlap, 1e-5)
        )   << c.name;
    }
}


// the quick form where no plane lies near the centre
TEST(sphereFacet, takenOff)
{
    for (const tableCase& c : overlaps())
    {
        const test::polyhedra cell(test::block({1, 1, 1}, c.lo, c.hi));
        // off all planes of the table's cells
        const point x(c.centre + 0.013*vector(1, -0.7, -0.9));
        const bool inside =
            cmptMin(x - c.lo) > 0 && cmptMin(c.hi - x) > 0;
        const scalar ball = 4.0/3*constant::mathematical::pi*pow3(c.R);

        scalar quick = inside ? ball : 0;
        for (const facet& f : facets(cell))
        {
            quick += against(f, x, c.R).takenOff();
        }
        EXPECT_NEAR(quick, overlap(cell, x, c.R), 2e-14*max(ball, 1e-2))
            << c.name;
    }
}


// the table once more, turned in space
TEST(sphereFacet, turned)
{
    const tensor turn
    (
        rotationTensor(vector(1, 0, 0), vector(1, 2, 3)/std::sqrt(14.0))
    );
    const vector shift(0.3, -0.7, 0.2);

    for (const tableCase& c : overlaps())
    {
        test::polyhedra cell(test::block({1, 1, 1}, c.lo, c.hi));
        cell.move([&](const point& p) { return (turn & p) + shift; });
        EXPECT_NEAR
        (
            overlap(cell, (turn & c.centre) + shift, c.R),
            c.overlap,
            1e-9*max(c.overlap, 1e-4)
        )   << c.name;
    }
}


// six tetrahedra make the box, wherever the ball is
TEST(sphereFacet, partsOfABox)
{
    const test::polyhedra tets(test::tetBlock({1, 1, 1}, Zero, {1, 1, 1}));
    ASSERT_EQ(tets.cells.size(), 6u);

    for (const tableCase& c : overlaps())
    {
        scalar sum = 0;
        for (const auto& faces : tets.cells)
        {
            test::polyhedra one;
            one.points = tets.points;
            one.move
            (
                [&](const point& p)
                {
                    return c.lo + cmptMultiply(p, c.hi - c.lo);
                }
            );
            one.cells.push_back(faces);
            const scalar part = overlap(one, c.centre, c.R);
            EXPECT_GT(part, -1e-15) << c.name;
            sum += part;
        }
        EXPECT_NEAR(sum, c.overlap, 1e-9*max(c.overlap, 1e-4)) << c.name;
    }
}


// no jump as the ball's centre or surface passes vertices, edges and faces
TEST(sphereFacet, continuity)
{
    const test::polyhedra cell(test::block({1, 1, 1}, Zero, {1, 1, 1}));
    const scalar R = 0.3;
    const scalar step = 1e-4;

    for
    (
        const vector& way :
        {vector(1, 1, 1), vector(1, 0, 1), vector(0, 0, 1)}
    )
    {
        // from inside, over the corner, edge or face, to outside
        scalar last = -1;
        for (label k = -6000; k <= 6000; ++k)
        {
            const point x(vector(0.5, 0.5, 0.5) + way*(0.5 + k*step));
            const scalar now = overlap(cell, x, R);
            if (last >= 0)
            {
                // no faster than the great circle sweeps, times the way
                EXPECT_LT
                (
                    mag(now - last),
                    3*constant::mathematical::pi*R*R*step*mag(way)
                )   << x;
            }
            last = now;
        }
        EXPECT_NEAR(last, 0, 1e-15);
    }
}


// half a ball beside a plane, to rounding, also at a hair's distance
TEST(sphereFacet, nearlyDegenerate)
{
    const test::polyhedra cell(test::block({1, 1, 1}, Zero, {1, 1, 1}));
    const scalar ball = 4.0/3*constant::mathematical::pi*pow3(0.3);

    for (const scalar h : {0.0, 1e-18, 1e-15, 1e-12, -1e-12, -1e-15, -1e-18})
    {
        EXPECT_NEAR
        (
            overlap(cell, point(0.5, 0.5, h), 0.3), ball/2,
            1e-14 + 0.3*mag(h)
        );
        EXPECT_NEAR
        (
            overlap(cell, point(0.5, h, h), 0.3), ball/4, 1e-14 + 0.3*mag(h)
        );
        EXPECT_NEAR
        (
            overlap(cell, point(h, h, h), 0.3), ball/8, 1e-14 + 0.3*mag(h)
        );
        EXPECT_NEAR
        (
            overlap(cell, point(h, -h, 0), 0.3), ball/8, 1e-14 + 0.3*mag(h)
        );
    }
}
