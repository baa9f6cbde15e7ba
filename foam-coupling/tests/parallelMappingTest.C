// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Description
    Mapping, limiting and smoothing on a mesh cut up over the ranks of an
    mpirun, against the same mesh on one rank. Every rank gets every particle.

\*---------------------------------------------------------------------------*/

#include "mathematicalConstants.H"
#include "smoothingModel.H"
#include "testMesh.H"
#include "voidFractionModel.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

void sumOverRanks(std::vector<double>& values, int)
{
    scalarList all(values.size());
    std::copy(values.begin(), values.end(), all.begin());
    Pstream::listCombineGather(all, plusEqOp<scalar>());
    Pstream::listCombineScatter(all);
    std::copy(all.begin(), all.end(), values.begin());
}

// the rank with the smallest claim, the lowest of equals
void own(dispersedParticles& p, const fvMesh& mesh)
{
    List<scalarField> claims(Pstream::nProcs());
    claims[Pstream::myProcNo()] = p.claims(mesh);
    Pstream::gatherList(claims);
    Pstream::scatterList(claims);

    for (label i = 0; i < p.size(); ++i)
    {
        label best = 0;
        forAll(claims, rank)
        {
            if (claims[rank][i] < claims[best][i])
            {
                best = rank;
            }
        }
        p.owned[i] =
            best == Pstream::myProcNo() && claims[best][i] < 1e299;
    }
}

void fill(dispersedParticles& p, const label n, const bool crowd)
{
    std::mt19937 random(21);
    std::uniform_real_distribution<scalar> unit(0, 1);
    p.setSize(n);
    for (label i = 0; i < n; ++i)
    {
        p.position[i] = 0.02*point(unit(random), unit(random), unit(random));
        if (crowd)
        {
            p.position[i] = point(0.0085, 0.0085, 0.0085) + 0.1*p.position[i];
        }
        p.radius[i] = 1e-3*(0.5 + unit(random));
        p.volume[i] = 4.0/3*constant::mathematical::pi*pow3(p.radius[i]);
        p.tag[i] = i;
    }
}

enum layout
{
    slabs,
    chess,      // each cell on another rank than its neighbours
    lopsided    // all on the first rank
};

// the whole mesh, cut up
test::polyhedra mesh(const layout how)
{
    const label n = 10;
    test::polyhedra all(test::block({n, n, n}, Zero, {0.02, 0.02, 0.02}));
    all.ranks.setSize(n*n*n);
    forAll(all.ranks, c)
    {
        const label i = c % n, j = c/n % n, k = c/(n*n);
        all.ranks[c] =
            how == chess ? (i + j + k) % Pstream::nProcs()
          : how == slabs ? i*Pstream::nProcs()/n
          : 0;
    }
    return all;
}

// one value a cell of the whole mesh, known by the position of its centre
scalarField gathered(const scalarField& values, const fvMesh& mesh)
{
    scalarList all(1000, 0.0);
    forAll(values, celli)
    {
        const point x(mesh.C()[celli]/0.002);
        all[label(x.x()) + 10*label(x.y()) + 100*label(x.z())] = values[celli];
    }
    Pstream::listCombineGather(all, plusEqOp<scalar>());
    Pstream::listCombineScatter(all);
    return scalarField(all);
}

}


TEST(parallelMapping, severalRanks)
{
    ASSERT_TRUE(Pstream::parRun());
    ASSERT_GT(Pstream::nProcs(), 1);
}


TEST(parallelMapping, sameAsOnOneRank)
{
    for (const char* name : {"centre", "divided", "exactOverlap"})
    {
        std::vector<scalarField> results;

        for (const layout how : {slabs, chess, lopsided})
        {
            const test::meshCase c(mesh(how));
            auto m = voidFractionModel::New
            (
                test::settings
                (
                    std::string("voidFractionModel ") + name + ";"
                    "voidFractionMin 0.3;"
                ),
                c.mesh()
            );
            dispersedParticles p;
            volScalarField n(c.field("n"));

            fill(p, 500, false);
            p.locate(c.mesh());
            own(p, c.mesh());

            label owners = 0;
            for (const bool mine : p.owned)
            {
                owners += mine;
            }
            reduce(owners, sumOp<label>());
            EXPECT_EQ(owners, 500);

            m->map(p, sumOverRanks, n);
            const scalarField& V = c.mesh().V();
            EXPECT_NEAR
            (
                gSum(V*(1 - n.primitiveField()))/sum(p.volume), 1, 1e-12
            )   << name << how;

            results.push_back(gathered(n.primitiveField(), c.mesh()));

            // what is weighed at ranks' boundaries is weighed once
            std::vector<double> sums(p.size(), 0.0);
            for (label i = 0; i < p.size(); ++i)
            {
                for (label k = p.offset[i]; k < p.offset[i + 1]; ++k)
                {
                    sums[i] += p.weight[k];
                }
            }
            sumOverRanks(sums, 1);
            for (const double s : sums)
            {
                EXPECT_NEAR(s, 1, 1e-13);
            }
        }

        EXPECT_LT(max(mag(results[0] - results[1])), 1e-11) << name;
        EXPECT_LT(max(mag(results[0] - results[2])), 1e-11) << name;
    }
}


// raw weights of spheres inside of the mesh sum to one over the ranks
TEST(parallelMapping, partitionOfUnity)
{
    for (const layout how : {slabs, chess, lopsided})
    {
        test::polyhedra all(mesh(how));
        test::shake(all, 3e-4, 9, false);
        const test::meshCase c(all);
        auto m = voidFractionModel::New
        (
            test::settings("voidFractionModel exactOverlap;"), c.mesh()
        );
        dispersedParticles p;
        fill(p, 500, false);
        p.position = 0.1*point(0.02, 0.02, 0.02) + 0.8*p.position;
        p.locate(c.mesh());
        own(p, c.mesh());
        m->weights(p);

        std::vector<double> sums(p.size(), 0.0);
        for (label i = 0; i < p.size(); ++i)
        {
            for (label k = p.offset[i]; k < p.offset[i + 1]; ++k)
            {
                sums[i] += p.weight[k];
            }
        }
        sumOverRanks(sums, 1);
        for (label i = 0; i < p.size(); ++i)
        {
            EXPECT_NEAR(sums[i], 1, 1e-12) << p.position[i];
        }
    }
}


TEST(parallelMapping, limitAcrossRanks)
{
    std::vector<scalarField> results;
    for (const layout how : {slabs, chess, lopsided})
    {
        const test::meshCase c(mesh(how));
        auto m = voidFractionModel::New
        (
            test::settings("voidFractionModel exactOverlap;"), c.mesh()
        );
        dispersedParticles p;
        volScalarField n(c.field("n"));
        fill(p, 60, true);
        p.locate(c.mesh());
        own(p, c.mesh());
        m->map(p, sumOverRanks, n);

        const scalarField& V = c.mesh().V();
        EXPECT_NEAR
        (
            gSum(V*(1 - n.primitiveField()))/sum(p.volume), 1, 1e-12
        );
        EXPECT_GE(gMin(n.primitiveField()), 0.2 - 1e-12);
        EXPECT_GT(m->clippedVolume(), 0.1*sum(p.volume));
        EXPECT_EQ(m->excessVolume(), 0);
        results.push_back(gathered(n.primitiveField(), c.mesh()));
    }
    EXPECT_LT(max(mag(results[0] - results[1])), 1e-10);
    EXPECT_LT(max(mag(results[0] - results[2])), 1e-10);
}


TEST(parallelMapping, smoothingAcrossRanks)
{
    std::vector<scalarField> results;
    for (const layout how : {slabs, chess, lopsided})
    {
        const test::meshCase c(mesh(how));
        const auto m = smoothingModel::New
        (
            test::settings
            (
                "smoothingModel diffusion;"
                "diffusionCoeffs { bandwidth 5e-3; }"
            ),
            c.mesh()
        );
        scalarField psi(c.mesh().nCells(), 0.0);
        forAll(psi, celli)
        {
            psi[celli] =
                mag(c.mesh().C()[celli] - point(0.009, 0.009, 0.009)) < 2e-4;
        }
        const scalarField& V = c.mesh().V();
        const scalar before = gSum(V*psi);
        ASSERT_GT(before, 0);
        m->smooth(psi);
        EXPECT_NEAR(gSum(V*psi)/before, 1, 1e-12);
        results.push_back(gathered(psi, c.mesh()));
    }
    EXPECT_LT(max(mag(results[0] - results[1])), 1e-9);
    EXPECT_LT(max(mag(results[0] - results[2])), 1e-9);
    EXPECT_GT(max(results[0]), 1e-3);
}
