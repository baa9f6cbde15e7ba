// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
// The viscosity of the particles' law against OpenFOAM's own model, in a shear
// flow of that rate; and where a sphere in a Bingham fluid stops.

#include "viscosityLaw.H"

#include "IStringStream.H"
#include "fvc.H"
#include "mathematicalConstants.H"
#include "incompressible/viscosityModels/viscosityModel/viscosityModel.H"
#include "surfaceFields.H"
#include "testMesh.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

dictionary read(const std::string& text)
{
    IStringStream is(text);
    return dictionary(is);
}

//- OpenFOAM's, in the middle of a block under simple shear of that rate
scalar ofOpenFOAM(const dictionary& dict, const scalar rate)
{
    static test::meshCase block
    (
        test::block(Vector<label>(3, 3, 3), point(0, 0, 0), point(3, 3, 3))
    );
    block.mesh().fvSchemes::readOpt() = IOobject::MUST_READ;
    block.mesh().fvSchemes::read();
    const fvMesh& mesh = block.mesh();
    volVectorField U
    (
        IOobject("U", mesh.time().timeName(), mesh),
        mesh,
        dimensionedVector(dimVelocity, Zero),
        "zeroGradient"
    );
    forAll(U, celli)
    {
        U[celli] = vector(rate*mesh.C()[celli].z(), 0, 0);
    }
    U.correctBoundaryConditions();
    const surfaceScalarField phi("phi", fvc::flux(U));

    const autoPtr<viscosityModel> model
    (
        viscosityModel::New("nu", dict, U, phi)
    );
    return model->nu()()[13];
}

} // End namespace


class Law : public testing::TestWithParam<const char*> {};

TEST_P(Law, IsThatOfOpenFOAM)
{
    const dictionary dict(read(GetParam()));
    const viscosityLaw law(dict);
    for (const scalar rate : {1e-3, 0.1, 1.0, 30.0, 1e3})
    {
        EXPECT_NEAR(law.nu(rate)/ofOpenFOAM(dict, rate), 1, 1e-9) << rate;
    }
}

INSTANTIATE_TEST_SUITE_P
(
    Models,
    Law,
    testing::Values
    (
        "transportModel Newtonian; nu 1e-6;",
        "transportModel HerschelBulkley; HerschelBulkleyCoeffs"
        " { nu0 2; tau0 0.3; k 0.01; n 0.7; }",
        "transportModel powerLaw; powerLawCoeffs"
        " { nuMin 1e-3; nuMax 2; k 0.1; n 0.6; }",
        "transportModel CrossPowerLaw; CrossPowerLawCoeffs"
        " { nu0 1; nuInf 1e-3; m 0.4; n 0.8; }",
        "transportModel BirdCarreau; BirdCarreauCoeffs"
        " { nu0 1; nuInf 1e-3; k 2; n 0.5; a 1.5; }",
        "transportModel Casson; CassonCoeffs"
        " { m 1e-3; tau0 0.2; nuMin 1e-3; nuMax 5; }",
        "transportModel strainRateFunction; strainRateFunctionCoeffs"
        " { function polynomial ((1 0) (0.5 1)); }"
    )
);

// 3 pi nu d v is 3.5 pi d^2 tau, that is tau = 0.0477 (rhoP - rhoF) g d
TEST(ViscosityLaw, StopsASphereAtBerisYieldNumber)
{
    const scalar d = 2e-3, tau = 1e-3, pi = constant::mathematical::pi;
    const viscosityLaw law
    (
        read
        (
            "transportModel HerschelBulkley; HerschelBulkleyCoeffs"
            " { nu0 1e9; tau0 1e-3; k 0; n 1; }"
        )
    );
    for (const scalar v : {1e-6, 1e-3})
    {
        const scalar force = 3*pi*law.around(0, v, d)*d*v;
        EXPECT_NEAR(2*pi*sqr(0.5*d)*tau/force, 0.143, 1e-4);
    }
    // the fluid's own shear comes to it
    EXPECT_NEAR(law.around(10, 0, d), 1e-4, 1e-12);
}
