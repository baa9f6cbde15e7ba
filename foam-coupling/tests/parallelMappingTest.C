// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Description
    Mapping, limiting and smoothing on a mesh cut up over the ranks of an
    mpirun, against the same mesh on one rank. Every rank gets every particle.

\*---------------------------------------------------------------------------*/

#include "cutUpMesh.H"
#include "keptMapping.H"
#include "mathematicalConstants.H"
#include "smoothingModel.H"
#include "voidFractionModel.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::test;

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
            const meshCase c(mesh(how));
            auto m = voidFractionModel::New
            (
                settings
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
        polyhedra all(mesh(how));
        shake(all, 3e-4, 9, false);
        const meshCase c(all);
        auto m = voidFractionModel::New
        (
            settings("voidFractionModel exactOverlap;"), c.mesh()
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
        const meshCase c(mesh(how));
        auto m = voidFractionModel::New
        (
            settings("voidFractionModel exactOverlap;"), c.mesh()
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
        const meshCase c(mesh(how));
        const auto m = smoothingModel::New
        (
            settings
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


// what one rank has kept and another maps anew is what both map anew, also of
// spheres that reach out of the mesh
TEST(parallelMapping, keptOnSomeRanks)
{
    const meshCase c(mesh(chess));
    for (const char* name : {"centre", "divided", "exactOverlap"})
    {
        auto m = voidFractionModel::New
        (
            settings(std::string("voidFractionModel ") + name + ";"),
            c.mesh()
        );
        volScalarField n(c.field("n")), full(c.field("full"));
        autoPtr<keptMapping> kept(new keptMapping(1e-12));
        for (const bool again : {false, true})
        {
            dispersedParticles p;
            fill(p, 300, false);
            if (again && Pstream::myProcNo() > 0)
            {
                // this rank's list was another one
                kept.reset(new keptMapping(1e-12));
            }
            kept->restore(p);
            EXPECT_EQ
            (
                kept->moved().size(),
                again && Pstream::myProcNo() == 0 ? 0 : 300
            );
            p.locate(c.mesh());
            own(p, c.mesh());
            m->map
            (
                p, sumOverRanks, again ? n : full, nullptr,
                kept->allMoved(p) ? nullptr : &kept->moved()
            );
            kept->keep(p);
        }
        EXPECT_LT
        (
            gMax(mag(n.primitiveField() - full.primitiveField())()), 1e-13
        )   << name;
    }
}
