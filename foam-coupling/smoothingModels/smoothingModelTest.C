// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "smoothingModel.H"
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
    const scalar b,
    const label steps
)
{
    return smoothingModel::New
    (
        test::settings
        (
            "smoothingModel diffusion; diffusionCoeffs { bandwidth "
          + std::to_string(b) + "; steps " + std::to_string(steps) + "; }"
        ),
        mesh
    );
}

// largest difference from exp(-x^2/b^2)/(b sqrt(pi)) over its peak, of a unit
// dropped into the middle of a line of cells
scalar kernelError(const label steps)
{
    const label n = 201;
    const scalar b = 0.1;
    const test::meshCase c
    (
        test::block({n, 1, 1}, point(-0.5, 0, 0), point(0.5, 1, 1))
    );
    scalarField psi(n, 0.0);
    psi[n/2] = n;
    diffusion(c.mesh(), b, steps)->smooth(psi);

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


TEST(smoothing, kernelIsGaussian)
{
    const scalar one = kernelError(1);
    const scalar six = kernelError(6);
    const scalar many = kernelError(60);
    EXPECT_GT(one, 0.2);
    EXPECT_LT(six, 0.08);
    EXPECT_LT(many, 0.01);
}


TEST(smoothing, variance)
{
    const label n = 101;
    const test::meshCase c
    (
        test::block({n, 1, 1}, point(-0.5, 0, 0), point(0.5, 1, 1))
    );
    for (const label steps : {1, 6})
    {
        scalarField psi(n, 0.0);
        psi[n/2] = n;
        diffusion(c.mesh(), 0.08, steps)->smooth(psi);
        const scalarField x(c.mesh().C().primitiveField().component(0));
        EXPECT_NEAR(sum(psi*sqr(x))/n, sqr(0.08)/2, 1e-3*sqr(0.08)) << steps;
    }
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
        const auto m = diffusion(c.mesh(), 6e-3, 6);
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
    diffusion(c.mesh(), 6e-3, 6)->smooth(psi);
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


TEST(smoothing, refusals)
{
    const test::meshCase c(test::block({3, 3, 3}, Zero, {1, 1, 1}));
    for (const char* text :
        {
            "smoothingModel median;",
            "smoothingModel diffusion;",
            "smoothingModel diffusion; diffusionCoeffs { bandwidth -1; }",
            "smoothingModel diffusion;"
            " diffusionCoeffs { bandwidth 1; steps 0; }"
        })
    {
        EXPECT_THROW
        (
            smoothingModel::New(test::settings(text), c.mesh()), Foam::error
        )   << text;
    }
}
