// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Description
    Mapping, limiting and smoothing on a mesh cut up over the ranks of an
    mpirun, against the same mesh on one rank. Every rank gets every particle.

\*---------------------------------------------------------------------------*/

#include "handOver.H"
#include "keptMapping.H"
#include "mathematicalConstants.H"
#include "particleTurnover.H"
#include "selfDisturbanceModel.H"
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


// what one rank has kept and another maps anew is what both map anew, also of
// spheres that reach out of the mesh
TEST(parallelMapping, keptOnSomeRanks)
{
    const test::meshCase c(mesh(chess));
    for (const char* name : {"centre", "divided", "exactOverlap"})
    {
        auto m = voidFractionModel::New
        (
            test::settings(std::string("voidFractionModel ") + name + ";"),
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


// every tag's numbers come to its new owner, and nothing else does
TEST(parallelMapping, numbersAreHandedOver)
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
TEST(parallelMapping, turnover)
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
TEST(parallelMapping, historiesGoAlong)
{
    const scalar nu = 0.5, rho = 2, T = 0.02*sqr(0.002)/nu;
    vector result[2];
    for (const layout how : {chess, lopsided})
    {
        const test::meshCase c(mesh(how));
        autoPtr<selfDisturbanceModel> model
        (
            selfDisturbanceModel::New
            (
                test::settings("selfDisturbance latticeMemory;"),
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
