// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "voidFractionModel.H"
#include "smoothingModel.H"
#include "mathematicalConstants.H"
#include "testMesh.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

const char* const schemes[] = {"centre", "divided", "exactOverlap"};

autoPtr<voidFractionModel> scheme
(
    const std::string& name,
    const fvMesh& mesh,
    const std::string& more = ""
)
{
    return voidFractionModel::New
    (
        test::settings("voidFractionModel " + name + ";" + more), mesh
    );
}

// the column of the paper's reduced case, coarser: 16 mm radius, 48 mm high
test::polyhedra column()
{
    return test::cylinder({8, 8, 6}, 16e-3, 48e-3);
}

test::polyhedra box(const label n)
{
    return test::block({n, n, n}, Zero, {0.02, 0.02, 0.02});
}

// a hexahedron beside two halves: faces of one cell in one plane
test::polyhedra uneven()
{
    test::polyhedra r;
    r.points.setSize(16);
    label m = 0;
    for (const scalar z : {0.0, 0.01, 0.02})
    {
        for (const scalar y : {0.0, 0.02})
        {
            r.points[m++] = point(0.01, y, z);
            r.points[m++] = point(0.02, y, z);
        }
    }
    r.points[m++] = point(0, 0, 0);
    r.points[m++] = point(0, 0.02, 0);
    r.points[m++] = point(0, 0, 0.02);
    r.points[m++] = point(0, 0.02, 0.02);
    // 0 1 / 2 3 at the bottom, 4 5 / 6 7, 8 9 / 10 11 at the top
    for (const label b : {0, 4})
    {
        r.cells.push_back
        ({
            face({b, b + 4, b + 6, b + 2}), face({b + 1, b + 3, b + 7, b + 5}),
            face({b, b + 1, b + 5, b + 4}), face({b + 2, b + 6, b + 7, b + 3}),
            face({b, b + 2, b + 3, b + 1}),
            face({b + 4, b + 5, b + 7, b + 6})
        });
    }
    r.cells.push_back
    ({
        face({12, 14, 15, 13}),
        face({0, 2, 6, 4}), face({4, 6, 10, 8}),
        face({12, 0, 4, 8, 14}), face({13, 15, 10, 6, 2}),
        face({12, 13, 2, 0}), face({14, 8, 10, 15})
    });
    return r;
}

struct meshEntry
{
    const char* name;
    test::polyhedra cells;
};

std::vector<meshEntry> meshes()
{
    std::vector<meshEntry> all;
    all.push_back({"cells of 4 radii", box(5)});
    all.push_back({"cells of 0.7 radii", box(28)});
    all.push_back
    ({
        "tetrahedra", test::tetBlock({5, 5, 5}, Zero, {0.02, 0.02, 0.02})
    });
    all.push_back({"warped", box(6)});
    test::shake(all.back().cells, 0.4e-3, 7, false);
    all.push_back({"warped walls", box(6)});
    test::shake(all.back().cells, 0.3e-3, 8, true);
    all.push_back({"uneven", uneven()});
    all.push_back({"column", column()});
    return all;
}

// n spheres of radius r with centres as far from the mesh's box as gap
void fill
(
    dispersedParticles& p,
    const fvMesh& mesh,
    const label n,
    const scalar r,
    const scalar gap
)
{
    std::mt19937 random(11);
    std::uniform_real_distribution<scalar> unit(0, 1);
    const boundBox& b = mesh.bounds();

    p.setSize(n);
    for (label i = 0; i < n; ++i)
    {
        for (direction axis = 0; axis < 3; ++axis)
        {
            p.position[i][axis] =
                b.min()[axis] + gap
              + unit(random)*(b.span()[axis] - 2*gap);
        }
        p.radius[i] = r*(0.7 + 0.6*unit(random));
        p.volume[i] = 4.0/3*constant::mathematical::pi*pow3(p.radius[i]);
        p.tag[i] = i;
    }
}

// in an upright cylinder, round wall at R, spheres up to touching it
void fillColumn(dispersedParticles& p, const label n, const scalar r)
{
    std::mt19937 random(12);
    std::uniform_real_distribution<scalar> unit(0, 1);

    p.setSize(n);
    for (label i = 0; i < n; ++i)
    {
        // a third of them at the wall
        const scalar a = constant::mathematical::twoPi*unit(random);
        const scalar s =
            (16e-3 - r)*(i % 3 ? std::sqrt(unit(random)) : scalar(1));
        p.position[i] = point
        (
            s*std::cos(a), s*std::sin(a), r + (48e-3 - 2*r)*unit(random)
        );
        p.radius[i] = r;
        p.volume[i] = 4.0/3*constant::mathematical::pi*pow3(r);
        p.tag[i] = i;
    }
}

scalar solids(const volScalarField& n)
{
    const scalarField& V = n.mesh().V();
    return sum(V*(1 - n.primitiveField()));
}

}


TEST(voidFraction, exactTableThroughTheMesh)
{
    for (const auto& row : test::table("sphere_hex_overlap_exact.csv"))
    {
        const auto v = [&](int i) { return std::stod(row[i]); };
        const test::meshCase one
        (
            test::block
            (
                {1, 1, 1}, point(v(1), v(2), v(3)), point(v(4), v(5), v(6))
            )
        );
        dispersedParticles p;
        p.setSize(1);
        p.position[0] = point(v(7), v(8), v(9));
        p.radius[0] = v(10);
        p.locate(one.mesh());
        scheme("exactOverlap", one.mesh())->weights(p);

        const scalar found = p.weight.empty() ? 0 : p.weight[0];
        EXPECT_NEAR
        (
            found*4.0/3*constant::mathematical::pi*pow3(v(10)), v(11),
            1e-9*max(v(11), 1e-5)
        )   << row[0];
    }
}


// before they are normalised, the weights inside of any mesh sum to one
TEST(voidFraction, partitionOfUnity)
{
    for (const meshEntry& entry : meshes())
    {
        if (std::string(entry.name) == "column")
        {
            continue;
        }
        const test::meshCase c(entry.cells);
        dispersedParticles p;
        // the walls of "warped walls" stand up to 0.3 mm inwards
        fill(p, c.mesh(), 2000, 1e-3, 1.3e-3 + 0.7e-3);
        p.locate(c.mesh());
        scheme("exactOverlap", c.mesh())->weights(p);

        scalar worst = 0;
        label shared = 0;
        for (label i = 0; i < p.size(); ++i)
        {
            scalar sum = 0;
            for (label k = p.offset[i]; k < p.offset[i + 1]; ++k)
            {
                sum += p.weight[k];
            }
            worst = max(worst, mag(sum - 1));
            shared += p.offset[i + 1] - p.offset[i] > 1;
        }
        EXPECT_LT(worst, 1e-12) << entry.name;
        EXPECT_GT(shared, 300) << entry.name;
    }
}


TEST(voidFraction, volumeIsKept)
{
    for (const meshEntry& entry : meshes())
    {
        const test::meshCase c(entry.cells);
        volScalarField n(c.field("n"));
        dispersedParticles p;

        for (const bool walls : {false, true})
        {
            if (std::string(entry.name) == "column")
            {
                fillColumn(p, 1000, 1e-3);
            }
            else
            {
                // with walls: spheres half outside of them
                fill(p, c.mesh(), 300, 1e-3, walls ? 0.0 : 2e-3);
            }
            p.locate(c.mesh());

            for (const char* name : schemes)
            {
                auto m =
                    scheme(name, c.mesh(), "voidFractionMin 0.3;");
                m->map(p, nullptr, n);
                EXPECT_NEAR(solids(n)/sum(p.volume), 1, 1e-12)
                    << entry.name << ' ' << name << " walls " << walls;
                EXPECT_GE(gMin(n.primitiveField()), 0.3 - 1e-12)
                    << entry.name << ' ' << name;
                EXPECT_EQ(m->excessVolume(), 0);

                scalar worst = 0;
                for (label i = 0; i < p.size(); ++i)
                {
                    scalar s = 0;
                    for (label k = p.offset[i]; k < p.offset[i + 1]; ++k)
                    {
                        EXPECT_GE(p.weight[k], 0);
                        s += p.weight[k];
                    }
                    worst = max(worst, mag(s - 1));
                }
                EXPECT_LT(worst, 1e-13) << entry.name << ' ' << name;
            }
        }
    }
}


// all spheres stay known when a polygonal wall cuts into the round one
TEST(voidFraction, spheresBeyondThePolygon)
{
    const test::meshCase c(test::cylinder({4, 4, 6}, 16e-3, 48e-3));
    dispersedParticles p;
    // centres up to 0.2 mm from the round wall, 1 mm outside of the polygon
    fillColumn(p, 600, 0.2e-3);
    p.radius = 1.3e-3;
    p.locate(c.mesh());

    label outside = 0;
    for (label i = 0; i < p.size(); ++i)
    {
        ASSERT_GE(p.cell[i], 0) << p.position[i];
        outside += p.outside[i] > 0;
    }
    EXPECT_GT(outside, 20);

    volScalarField n(c.field("n"));
    for (const char* name : schemes)
    {
        scheme(name, c.mesh())->map(p, nullptr, n);
        EXPECT_NEAR(solids(n)/sum(p.volume), 1, 1e-12) << name;
    }
}


// the schemes agree with the exact one as closely as their points allow
TEST(voidFraction, dividedNearsExact)
{
    const test::meshCase c(box(8));
    dispersedParticles p;
    fill(p, c.mesh(), 300, 1e-3, 1.3e-3);
    p.locate(c.mesh());

    volScalarField exact(c.field("exact"));
    volScalarField n(c.field("n"));
    scheme("exactOverlap", c.mesh())->map(p, nullptr, exact);

    scalar last = GREAT;
    for (const char* points : {"1", "29", "400"})
    {
        scheme
        (
            "divided", c.mesh(),
            std::string("dividedCoeffs { points ") + points + "; }"
        )->map(p, nullptr, n);

        const scalar error =
            std::sqrt(sum(sqr(n.primitiveField() - exact.primitiveField())));
        EXPECT_LT(error, 0.4*last) << points;
        last = error;
    }

    // one point is the centre
    volScalarField centre(c.field("centre"));
    scheme("centre", c.mesh())->map(p, nullptr, centre);
    scheme("divided", c.mesh(), "dividedCoeffs { points 1; }")
        ->map(p, nullptr, n);
    EXPECT_LT(max(mag(n.primitiveField() - centre.primitiveField())), 1e-14);
}


// a sphere on its way over faces, edges and corners: no jumps
TEST(voidFraction, exactIsSmooth)
{
    const test::meshCase c(box(10));
    auto m = scheme("exactOverlap", c.mesh());
    EXPECT_TRUE(m->smooth());
    EXPECT_FALSE(scheme("centre", c.mesh())->smooth());
    EXPECT_FALSE(scheme("divided", c.mesh())->smooth());

    dispersedParticles p;
    p.setSize(1);
    p.radius = 1e-3;
    p.volume = 4.0/3*constant::mathematical::pi*1e-9;
    volScalarField n(c.field("n")), last(c.field("last"));

    const scalar step = 2e-6;
    for (label k = 0; k < 2000; ++k)
    {
        p.position[0] = point(9e-3, 9e-3, 9e-3) + k*step*vector(1, 1, 0.5);
        p.locate(c.mesh());
        m->map(p, nullptr, n);
        if (k)
        {
            // d(V)/dx is at most the great circle: pi R^2 1.5 step/V
            EXPECT_LT
            (
                max(mag(n.primitiveField() - last.primitiveField())),
                constant::mathematical::pi*1e-6*1.5*step/8e-9
            )   << k;
        }
        last = n;
    }
}


TEST(voidFraction, smoothedVolumeIsKept)
{
    const test::meshCase c(column());
    const auto smoothing = smoothingModel::New
    (
        test::settings
        (
            "smoothingModel diffusion; diffusionCoeffs { bandwidth 6e-3; }"
        ),
        c.mesh()
    );
    dispersedParticles p;
    fillColumn(p, 1000, 1e-3);
    p.locate(c.mesh());
    volScalarField n(c.field("n"));

    for (const char* name : schemes)
    {
        scheme(name, c.mesh())->map(p, nullptr, n, &smoothing());
        EXPECT_NEAR(solids(n)/sum(p.volume), 1, 1e-12) << name;
    }
}
