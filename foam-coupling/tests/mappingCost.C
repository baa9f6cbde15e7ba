// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Description
    Prints what locating and mapping cost a particle: the median over repeated
    passes, in ns, for spheres of 1 mm radius in cells of 4, 2 and 1 radii and
    in tetrahedra, moved a little between passes.

Usage
    mappingCost

\*---------------------------------------------------------------------------*/

#include "mathematicalConstants.H"
#include "smoothingModel.H"
#include "testMesh.H"
#include "voidFractionModel.H"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <gtest/gtest.h>

using namespace Foam;

namespace
{

// of this thread's own time, whatever else the machine does
double seconds()
{
    timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return t.tv_sec + 1e-9*t.tv_nsec;
}

double median(std::vector<double> v)
{
    std::nth_element(v.begin(), v.begin() + v.size()/2, v.end());
    return v[v.size()/2];
}

void measure(const char* title, const test::polyhedra& cells)
{
    const test::meshCase c(cells);
    std::mt19937 random(1);
    std::uniform_real_distribution<scalar> unit(0, 1);
    std::normal_distribution<scalar> step(0, 2e-5);

    const label n = 2000;
    pointField x(n);
    for (point& p : x)
    {
        p = point(0.001, 0.001, 0.001)
          + 0.038*vector(unit(random), unit(random), unit(random));
    }

    std::printf("%s, %d cells\n", title, int(c.mesh().nCells()));
    volScalarField voids(c.field("n"));

    for (const char* name : {"centre", "divided", "exactOverlap"})
    {
        auto m = voidFractionModel::New
        (
            test::settings(std::string("voidFractionModel ") + name + ";"),
            c.mesh()
        );
        dispersedParticles p;
        std::vector<double> locating, weighing, mapping;

        for (label pass = 0; pass < 40; ++pass)
        {
            p.setSize(n);
            p.position = x;
            p.radius = 1e-3;
            p.volume = 4.0/3*constant::mathematical::pi*1e-9;
            p.tag = identity(n);

            const double t0 = seconds();
            p.locate(c.mesh());
            const double t1 = seconds();
            m->weights(p);
            const double t2 = seconds();
            m->map(p, nullptr, voids);
            const double t3 = seconds();
            if (pass > 4)
            {
                locating.push_back(t1 - t0);
                weighing.push_back(t2 - t1);
                mapping.push_back(t3 - t2);
            }
            for (point& q : x)
            {
                q += vector(step(random), step(random), step(random));
            }
        }
        std::printf
        (
            "  %-13s locate %6.0f  weights %6.0f  map %6.0f ns,"
            " %.2f cells a particle\n",
            name, 1e9*median(locating)/n, 1e9*median(weighing)/n,
            1e9*median(mapping)/n, p.weight.size()/double(n)
        );
    }
}

}


TEST(mappingCost, smoothing)
{
    const test::meshCase c
    (
        test::block({20, 20, 20}, Zero, {0.04, 0.04, 0.04})
    );
    scalarField psi(c.mesh().nCells(), 0.0);
    psi[4210] = 1;

    for (const char* b : {"4e-3", "6e-3", "12e-3"})
    {
        const auto m = smoothingModel::New
        (
            test::settings
            (
                std::string("smoothingModel diffusion; diffusionCoeffs")
              + "{ bandwidth " + b + "; }"
            ),
            c.mesh()
        );
        std::vector<double> times, ofVectors;
        for (label pass = 0; pass < 15; ++pass)
        {
            scalarField values(psi);
            double t = seconds();
            m->smooth(values);
            times.push_back(seconds() - t);
            vectorField vectors(psi*vector(1, 2, 3));
            t = seconds();
            m->smooth(vectors);
            ofVectors.push_back(seconds() - t);
        }
        std::printf
        (
            "smoothing, 8000 cells of 2e-3, b %s: %.0f ns a cell, vectors"
            " %.0f\n",
            b, 1e9*median(times)/psi.size(), 1e9*median(ofVectors)/psi.size()
        );
    }
}


// for counting instructions (validation/cost/instructions)
void onePass(const char* scheme)
{
    const test::meshCase c(test::block({20, 20, 20}, Zero, {0.04, 0.04, 0.04}));
    const auto m = voidFractionModel::New
    (
        test::settings(std::string("voidFractionModel ") + scheme + ";"),
        c.mesh()
    );
    const label n = 1000;
    dispersedParticles p;
    p.setSize(n);
    scalar fraction[3] = {0.1, 0.2, 0.3};
    for (label i = 0; i < n; ++i)
    {
        for (direction d = 0; d < 3; ++d)
        {
            // evenly spread, the same on every machine
            const scalar step[3] = {0.754877666, 0.569840291, 0.430159709};
            fraction[d] += step[d] - (fraction[d] + step[d] >= 1);
            p.position[i][d] = 0.002 + 0.036*fraction[d];
        }
    }
    p.radius = 1e-3;
    p.volume = 4.0/3*constant::mathematical::pi*1e-9;
    p.tag = identity(n);
    p.locate(c.mesh());
    m->weights(p);
    EXPECT_GT(p.weight.size(), n);
}

TEST(mappingCost, onePass) { onePass("exactOverlap"); }
TEST(mappingCost, onePassDivided) { onePass("divided"); }


TEST(mappingCost, schemes)
{
    const auto box = [](const label n)
    {
        return test::block({n, n, n}, Zero, {0.04, 0.04, 0.04});
    };
    measure("cells of 4 radii", box(10));
    measure("cells of 2 radii", box(20));
    measure("cells of 1 radius", box(40));
    test::polyhedra warped(box(10));
    test::shake(warped, 4e-4, 1, false);
    measure("warped cells of 4 radii", warped);
    measure("tetrahedra", test::tetBlock({8, 8, 8}, Zero, {0.04, 0.04, 0.04}));
}
