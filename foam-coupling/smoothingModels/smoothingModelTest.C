// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "diffusionSmoothing.H"
#include "mathematicalConstants.H"
#include "testMesh.H"
#include "zeroGradientFvPatchFields.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

autoPtr<smoothingModel> diffusion
(
    const fvMesh& mesh,
    const scalar b
)
{
    return smoothingModel::New
    (
        test::settings
        (
            "smoothingModel diffusion; diffusionCoeffs { bandwidth "
          + std::to_string(b) + "; }"
        ),
        mesh
    );
}

// largest difference from exp(-x^2/b^2)/(b sqrt(pi)) over its peak, of a unit
// dropped into the middle of a line of cells
scalar kernelError(const label n)
{
    const scalar b = 0.1;
    const test::meshCase c
    (
        test::block({n, 1, 1}, point(-0.5, 0, 0), point(0.5, 1, 1))
    );
    scalarField psi(n, 0.0);
    psi[n/2] = n;
    diffusion(c.mesh(), b)->smooth(psi);

    scalar worst = 0;
    const scalar peak = 1/(b*std::sqrt(constant::mathematical::pi));
    forAll(psi, i)
    {
        const scalar x = c.mesh().C()[i].x();
        worst = max(worst, mag(psi[i]/peak - std::exp(-sqr(x/b))));
    }
    return worst;
}

}


// second order in the cells' size
TEST(smoothing, kernelIsGaussian)
{
    EXPECT_LT(kernelError(51), 0.02);
    EXPECT_LT(kernelError(201), 0.02/14);
}


// in cells of a ninth to eight ninths of b, and of half as many again as b
TEST(smoothing, varianceIsThatOfTheGaussian)
{
    for (const scalar b : {0.011, 0.03, 0.088})
    {
        const label n = 101;
        const test::meshCase c
        (
            test::block({n, 1, 1}, point(-0.5, 0, 0), point(0.5, 1, 1))
        );
        scalarField psi(n, 0.0);
        psi[n/2] = n;
        diffusion(c.mesh(), b)->smooth(psi);
        const scalarField x(c.mesh().C().primitiveField().component(0));
        EXPECT_NEAR(sum(psi*sqr(x))/n, sqr(b)/2, 1e-6*sqr(b)) << b;
    }
}


// exp(-a (1 + x)) by its series, to what is left out of it
TEST(smoothing, seriesOfTheExponential)
{
    for (const scalar a : {0.0, 1e-3, 0.7, 20.0, 3000.0})
    {
        const List<scalar> c(smoothingModels::chebyshevOfExp(a, 1e-8));
        EXPECT_LE(c.size(), 6*std::sqrt(a + 1) + 4) << a;
        for (const scalar x : {-1.0, -0.999, -0.3, 0.6, 1.0})
        {
            scalar last = 1, now = x, sum = c[0];
            for (label k = 1; k < c.size(); ++k)
            {
                sum += c[k]*now;
                const scalar next = 2*x*now - last;
                last = now;
                now = next;
            }
            EXPECT_NEAR(sum, std::exp(-a*(1 + x)), 3e-8) << a << ' ' << x;
        }
    }
}


// smooth(f) g V summed is f smooth(g) V summed: on even and uneven cells
TEST(smoothing, isItsOwnAdjoint)
{
    test::polyhedra cells(test::tetBlock({5, 5, 5}, Zero, {0.02, 0.02, 0.02}));
    test::shake(cells, 5e-4, 2, false);
    const test::meshCase c(cells);
    const auto m = diffusion(c.mesh(), 6e-3);
    const scalarField& V = c.mesh().V();
    scalarField f(V.size()), g(V.size());
    forAll(f, i)
    {
        f[i] = std::sin(1.0 + i);
        g[i] = std::cos(2.0*i);
    }
    scalarField smoothF(f), smoothG(g);
    m->smooth(smoothF);
    m->smooth(smoothG);
    const scalar size = std::sqrt(sum(V*sqr(f))*sum(V*sqr(g)));
    EXPECT_NEAR(sum(V*smoothF*g)/size, sum(V*f*smoothG)/size, 1e-14);
    EXPECT_GT(mag(sum(V*smoothF*g)/size - sum(V*f*g)/size), 1e-3);
}


// a vector's components as scalars
TEST(smoothing, vectorsAsScalars)
{
    const test::meshCase c(test::block({4, 5, 6}, Zero, {4e-3, 5e-3, 6e-3}));
    const auto m = diffusion(c.mesh(), 3e-3);
    vectorField f(c.mesh().nCells(), Zero);
    f[17] = vector(1, -2, 3);
    scalarField z(f.component(2));
    m->smooth(f);
    m->smooth(z);
    EXPECT_LT(max(mag(scalarField(f.component(2)) - z)), 1e-15);
    EXPECT_LT(max(mag(scalarField(f.component(0)) - z/3)), 1e-15);
}


TEST(smoothing, integralIsKept)
{
    std::vector<test::polyhedra> meshes
    {
        test::cylinder({8, 8, 10}, 16e-3, 48e-3),
        test::tetBlock({5, 5, 5}, Zero, {0.02, 0.02, 0.02})
    };
    test::shake(meshes[1], 5e-4, 2, false);

    for (const auto& cells : meshes)
    {
        const test::meshCase c(cells);
        const auto m = diffusion(c.mesh(), 6e-3);
        EXPECT_TRUE(m->active());
        const scalarField& V = c.mesh().V();

        // one full cell at the wall
        volScalarField s(c.field("s"));
        s.primitiveFieldRef() = 0;
        s.primitiveFieldRef()[0] = 1;
        const scalar before = V[0];
        m->smooth(s);
        EXPECT_NEAR(sum(V*s.primitiveField())/before, 1, 1e-12);
        EXPECT_LT(s[0], 0.6);
        EXPECT_GE(gMin(s.primitiveField()), -1e-12);

        // a source of both signs
        volVectorField f
        (
            IOobject("f", c.mesh().time().timeName(), c.mesh()),
            c.mesh(), dimensionedVector(dimless, Zero),
            zeroGradientFvPatchVectorField::typeName
        );
        f.primitiveFieldRef()[3] = vector(2, -1, 0);
        f.primitiveFieldRef()[40] = vector(-1, 3, 1);
        const vector total = sum(V*f.primitiveField());
        const scalar size = sum(V*mag(f.primitiveField()));
        m->smooth(f);
        EXPECT_LT(mag(sum(V*f.primitiveField()) - total)/size, 1e-12);
        EXPECT_EQ(f.boundaryField()[0].size(), c.mesh().boundary()[0].size());
    }
}


TEST(smoothing, uniformStays)
{
    const test::meshCase c(test::cylinder({8, 8, 10}, 16e-3, 48e-3));
    scalarField psi(c.mesh().nCells(), 0.3);
    diffusion(c.mesh(), 6e-3)->smooth(psi);
    EXPECT_LT(max(mag(psi - 0.3)), 1e-13);
}


TEST(smoothing, none)
{
    const test::meshCase c(test::block({3, 3, 3}, Zero, {1, 1, 1}));
    const auto m = smoothingModel::New(dictionary(), c.mesh());
    EXPECT_FALSE(m->active());
    volScalarField s(c.field("s"));
    s.primitiveFieldRef()[4] = 7;
    m->smooth(s);
    EXPECT_EQ(s[4], 7);
    EXPECT_EQ(s[5], 1);
}


// 3.5 diameters of the bodies, or two cells of 1 x 1 x 0.2
TEST(smoothing, bandwidthOfBodiesAndCells)
{
    const test::meshCase c(test::block({3, 3, 5}, Zero, {3, 3, 1}));
    for (const char* text :
        {
            "smoothingModel diffusion;",
            "smoothingModel diffusion; diffusionCoeffs { bandwidth auto; }"
        })
    {
        auto m = smoothingModel::New(test::settings(text), c.mesh());
        ASSERT_TRUE(m->fits());
        // before it is known nothing is smoothed
        scalarField psi(c.mesh().nCells(), 0.0);
        psi[4] = 7;
        m->smooth(psi);
        EXPECT_EQ(psi[4], 7);
        m->fit(0.4);
        EXPECT_NEAR(m->bandwidth(), 1.4, 1e-12);
        EXPECT_NEAR(m->spread(), 0.49, 1e-12);
        m->smooth(psi);
        EXPECT_LT(psi[4], 3);
        m->fit(0.1);
        EXPECT_NEAR(m->bandwidth(), 0.4, 1e-12);
        // to four digits
        m->fit(0.33335001);
        EXPECT_NEAR(m->bandwidth(), 1.167, 1e-12);
    }
    EXPECT_FALSE(diffusion(c.mesh(), 0.5)->fits());
    const scalarField sides(smoothingModel::length(c.mesh()));
    EXPECT_NEAR(min(sides), 1, 1e-12);
    EXPECT_NEAR(max(sides), 1, 1e-12);
}


TEST(smoothing, refusals)
{
    const test::meshCase c(test::block({3, 3, 3}, Zero, {1, 1, 1}));
    for (const char* text :
        {
            "smoothingModel median;",
            "smoothingModel diffusion; diffusionCoeffs { bandwidth -1; }",
            "smoothingModel diffusion; diffusionCoeffs { bandwidth wide; }",
            "smoothingModel diffusion;"
            " diffusionCoeffs { bandwidth 1; steps 6; }"
        })
    {
        EXPECT_THROW
        (
            smoothingModel::New(test::settings(text), c.mesh()), Foam::error
        )   << text;
    }
}
