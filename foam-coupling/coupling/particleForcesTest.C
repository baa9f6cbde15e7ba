// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Description
    The forces on one sphere in fields of the fluid that are known.
\*---------------------------------------------------------------------------*/

#include "particleForces.H"
#include "mathematicalConstants.H"
#include "testMesh.H"
#include "zeroGradientFvPatchFields.H"

#include <gtest/gtest.h>

#include <fstream>

using namespace Foam;

namespace
{

const scalar pi = constant::mathematical::pi;
const scalar rho = 900, nu = 1e-4, d = 1e-3, V = pi/6*pow3(d);
const vector gravity(0.5, 0, -9.81);

// writes constant/couplingProperties
const test::meshCase& with(const test::meshCase& c, const std::string& text)
{
    const fileName folder(c.mesh().time().path()/"constant");
    mkDir(folder);
    std::ofstream(folder/"couplingProperties")
        << "FoamFile { version 2.0; format ascii; class dictionary;"
           " object couplingProperties; }\n"
        << text << std::endl;
    return c;
}

// a box of 5 x 5 x 5 cells around the origin, with a sphere
class sphereInBox
{
    test::meshCase case_;
    couplingProperties properties_;
    autoPtr<smoothingModel> smoothing_;
    volScalarField n_, nuEff_;

    template<class Type>
    static GeometricField<Type, fvPatchField, volMesh> field
    (
        const fvMesh& mesh,
        const word& name
    )
    {
        return GeometricField<Type, fvPatchField, volMesh>
        (
            IOobject(name, mesh.time().timeName(), mesh),
            mesh,
            dimensioned<Type>(dimless, Zero),
            zeroGradientFvPatchField<Type>::typeName
        );
    }

public:

    volVectorField U, gradP;
    particleForces forces;
    dispersedParticles p;
    scalarField part;

    explicit sphereInBox
    (
        const std::string& text,
        const std::string& smoothing = ""
    )
    :
        case_
        (
            test::block
            (
                {5, 5, 5}, -5e-3*vector::one, 5e-3*vector::one
            )
        ),
        properties_(with(case_, text).mesh().time()),
        smoothing_
        (
            smoothingModel::New(test::settings(smoothing), case_.mesh())
        ),
        n_(case_.field("n")),
        nuEff_(field<scalar>(case_.mesh(), "nuEff")),
        U(field<vector>(case_.mesh(), "U")),
        gradP(field<vector>(case_.mesh(), "gradP")),
        forces
        (
            properties_,
            nullptr,
            smoothing_(),
            rho,
            {
                case_.mesh(), "centre", properties_.interpolation(), nu, rho,
                0, 0, true
            }
        ),
        part(case_.mesh().nCells(), 1)
    {
        case_.mesh().fvSchemes::readOpt() = IOobject::MUST_READ;
        case_.mesh().fvSchemes::read();
        U.dimensions().reset(dimVelocity);
        gradP.dimensions().reset(dimAcceleration);
        nuEff_.dimensions().reset(dimViscosity);
        nuEff_ == dimensionedScalar("nu", dimViscosity, nu);
        p.setSize(1);
        p.position[0] = point(1e-4, 2e-4, -1e-4);
        p.radius = d/2;
        p.volume = V;
        p.mass = 2600*V;
        p.tag = 0;
        p.spin = vectorField(1, Zero);
        p.locate(case_.mesh());
        p.append(p.cell[0], 1);
        p.endRow(0);
    }

    // a velocity field U(x)
    void set(const std::function<vector(const point&)>& at)
    {
        forAll(U, celli)
        {
            U[celli] = at(case_.mesh().C()[celli]);
        }
        U.correctBoundaryConditions();
    }

    void evaluate(const scalar n = 1)
    {
        n_ == dimensionedScalar("n", dimless, n);
        const fluidState fluid{U, gradP, nuEff_, rho, gravity};
        dictionary newtonian;
        newtonian.add("transportModel", word("Newtonian"));
        newtonian.add("nu", nu);
        forces.evaluate(p, fluid, n_, viscosityLaw(newtonian), 1e-3, part);
    }

    Time& time() { return const_cast<Time&>(case_.mesh().time()); }
};

const vector u0(0.2, -0.1, 0.4);

vector rigid(const point& x)
{
    return vector(3, -2, 5) ^ x;
}

}


// K = 3 pi mu d alone, and the velocity of the fluid at the sphere
TEST(particleForces, stokesDrag)
{
    sphereInBox one("dragModel Stokes; forceModels (buoyancy);");
    one.set([](const point&) { return u0; });
    one.p.velocity[0] = vector(0.1, 0, 0);
    one.evaluate();
    EXPECT_NEAR(one.forces.K[0]/(3*pi*nu*rho*d), 1, 1e-12);
    EXPECT_LT(mag(one.forces.u[0] - u0), 1e-15);
    EXPECT_NEAR
    (
        one.forces.reynoldsMax()/(d*mag(u0 - one.p.velocity[0])/nu), 1, 1e-12
    );
    // what is not owned here is not answered here
    one.p.owned[0] = false;
    one.evaluate();
    EXPECT_EQ(one.forces.K[0], 0);
}


// model B carries the pressure's force in the drag: K/n
TEST(particleForces, modelBDividesByTheVoidFraction)
{
    const scalar n = 0.7;
    scalar K[2];
    label k = 0;
    for (const char* model : {"A", "B"})
    {
        sphereInBox one
        (
            std::string("model ") + model
          + "; dragModel DiFelice; forceModels (buoyancy);"
        );
        one.set([](const point&) { return u0; });
        one.evaluate(n);
        K[k++] = one.forces.K[0];
    }
    EXPECT_NEAR(K[0]/K[1], n, 1e-12);
}


// -V grad p, of which the fluid gets the reaction; -rho V g, of which it does
// not
TEST(particleForces, pressureAndBuoyancy)
{
    sphereInBox one("forceModels (pressureGradient buoyancy);");
    const vector slope(3, -7, 11);
    one.gradP == dimensionedVector("slope", dimAcceleration, slope);
    one.evaluate();
    EXPECT_LT
    (
        mag(one.forces.reacting[0] + rho*V*slope), 1e-12*rho*V*mag(slope)
    );
    EXPECT_LT
    (
        mag(one.forces.hydrostatic[0] + rho*V*gravity), 1e-12*rho*V*mag(gravity)
    );
    EXPECT_EQ(one.forces.addedMass.size(), 0);
    EXPECT_EQ(one.forces.turn.size(), 0);
}


// gravity that is each particle's own, as the DEM half may send it
TEST(particleForces, buoyancyOfEachParticlesGravity)
{
    sphereInBox one("forceModels (buoyancy);");
    const vector other(1, 2, 3);
    one.p.gravity = vectorField(1, other);
    one.evaluate();
    EXPECT_LT
    (
        mag(one.forces.hydrostatic[0] + rho*V*other), 1e-12*rho*V*mag(other)
    );
}


// a body's sphere has the body's diameter and its factor
TEST(particleForces, dragOfABody)
{
    sphereInBox one("dragModel Stokes; forceModels (buoyancy);");
    one.set([](const point&) { return u0; });
    one.p.dragFactor = scalarField(1, 0.4);
    one.p.dragDiameter = scalarField(1, 3*d);
    one.evaluate();
    const scalar stokes = 18*nu*rho/sqr(3*d);
    EXPECT_NEAR(one.forces.K[0]/(0.4*stokes*V), 1, 1e-12);
    EXPECT_NEAR(one.forces.reynoldsMax()/(3*d*mag(u0)/nu), 1, 1e-12);
}


// late in the interval: velocity and pressure's force anew, drag as it was
TEST(particleForces, velocityAndPressureAnew)
{
    sphereInBox one("dragModel DiFelice; forceModels (pressureGradient);");
    one.set([](const point&) { return u0; });
    one.evaluate();
    const scalar K = one.forces.K[0];
    one.set([](const point&) { return 2*u0; });
    one.forces.velocity(one.p, one.U);
    EXPECT_LT(mag(one.forces.u[0] - 2*u0), 1e-15);
    EXPECT_EQ(one.forces.K[0], K);
    const vector slope(3, -7, 11);
    one.gradP == dimensionedVector("slope", dimAcceleration, slope);
    const vectorField force(one.forces.pressureForce(one.p, one.gradP, rho));
    EXPECT_LT(mag(force[0] + rho*V*slope), 1e-12*rho*V*mag(slope));

    sphereInBox without("forceModels (buoyancy);");
    EXPECT_EQ
    (
        mag(without.forces.pressureForce(without.p, one.gradP, rho)()[0]), 0
    );
}


// Cm rho V; and explicit forces that follow by a part of their change
TEST(particleForces, addedMassAndWhatFollows)
{
    sphereInBox one
    (
        "forceModels (pressureGradient buoyancy addedMass);"
        "addedMassCoeffs { Cm 0.7; }"
    );
    one.evaluate();
    ASSERT_EQ(one.forces.addedMass.size(), 1);
    EXPECT_NEAR(one.forces.addedMass[0]/(0.7*rho*V), 1, 1e-12);
    EXPECT_NEAR(one.forces.addedDensity()/(0.7*rho), 1, 1e-12);

    const vector slope(3, -7, 11);
    one.gradP == dimensionedVector("slope", dimAcceleration, slope);
    one.part = 0.25;
    one.evaluate();
    EXPECT_LT
    (
        mag(one.forces.reacting[0] + 0.25*rho*V*slope), 1e-12*rho*V*mag(slope)
    );
    one.evaluate();
    EXPECT_LT
    (
        mag(one.forces.reacting[0] + 0.4375*rho*V*slope),
        1e-12*rho*V*mag(slope)
    );
}


// Cm rho V DU/Dt of a fluid that is sped up as a whole
TEST(particleForces, addedMassFeelsTheFluidsAcceleration)
{
    sphereInBox one("forceModels (buoyancy addedMass);");
    one.evaluate();
    one.set([](const point&) { return u0; });
    one.time().setTime(0.02, 1);
    one.evaluate();
    const vector expected(0.5*rho*V*u0/0.02);
    EXPECT_LT(mag(one.forces.reacting[0] - expected), 1e-9*mag(expected));
}


// a fluid that turns as a rigid body turns the sphere to its own spin, with
// Kirchhoff's pi mu d^3
TEST(particleForces, torqueTurnsWithTheFluid)
{
    sphereInBox one("forceModels (buoyancy torque);");
    one.set(rigid);
    one.evaluate();
    ASSERT_EQ(one.forces.turn.size(), 1);
    EXPECT_NEAR(one.forces.turn[0]/(pi*nu*rho*pow3(d)), 1, 1e-12);
    EXPECT_LT(mag(one.forces.fluidSpin[0] - vector(3, -2, 5)), 1e-9);
    EXPECT_TRUE(one.forces.turns());
}


// Rubinow and Keller's pi/8 rho d^3 s x w, by the spin in excess of the fluid's
TEST(particleForces, spinIsRelativeToTheFluids)
{
    sphereInBox one
    (
        "forceModels (buoyancy magnus); magnusCoeffs { finiteRe no; }"
    );
    one.set(rigid);
    one.p.spin[0] = vector(3, -2, 5);
    one.p.velocity[0] = u0;
    one.evaluate();
    EXPECT_TRUE(one.forces.needsSpin());
    EXPECT_LT(mag(one.forces.reacting[0]), 1e-12*rho*pow3(d));
    const vector excess(0, 40, 0);
    one.p.spin[0] += excess;
    one.evaluate();
    const vector expected
    (
        pi/8*rho*pow3(d)*((one.forces.u[0] - u0) ^ excess)
    );
    EXPECT_LT(mag(one.forces.reacting[0] - expected), 1e-9*mag(expected));
}


// of a linear field: mapped, the mean over the cells by the sphere's parts;
// cellPoint, the value at its centre; cell, that of its cell
TEST(particleForces, fieldsAreTakenByTheScheme)
{
    const auto linear = [](const point& x)
    {
        return vector(2*x.x() + x.z(), 3*x.y(), x.x() - x.y());
    };
    for (const char* scheme : {"mapped", "cell", "cellPoint"})
    {
        sphereInBox one(std::string("interpolation ") + scheme + ";");
        one.set(linear);
        // half of it in the next cell
        const point here(Zero), next(2e-3, 0, 0);
        one.p.clearRows();
        one.p.append(62, 0.5);
        one.p.append(63, 0.5);
        one.p.endRow(0);
        one.evaluate();
        const vector expected
        (
            word(scheme) == "mapped" ? 0.5*(linear(here) + linear(next))
          : word(scheme) == "cell" ? linear(here)
          : linear(one.p.position[0])
        );
        EXPECT_LT(mag(one.forces.u[0] - expected), 1e-12) << scheme;
    }
}


// with smoothing the sphere sees what it would give: the mean of a field by
// where a unit of its own would go, adjoint
TEST(particleForces, smoothingActsBothWays)
{
    const std::string wide
    (
        "smoothingModel diffusion; diffusionCoeffs { bandwidth 4e-3; }"
    );
    sphereInBox one("dragModel Stokes;", wide);
    const auto waves = [](const point& x)
    {
        return vector(std::sin(2e3*x.x()), std::cos(1e3*x.y()), 1e3*x.z());
    };
    one.set(waves);
    one.evaluate();

    const fvMesh& mesh = one.U.mesh();
    scalarField given(mesh.nCells(), Zero);
    given[one.p.cell[0]] = 1/mesh.V()[one.p.cell[0]];
    smoothingModel::New(test::settings(wide), mesh)->smooth(given);
    const vector seen(sum(given*mesh.V()*one.U.primitiveField()));

    EXPECT_LT(mag(one.forces.u[0] - seen), 1e-12);
    EXPECT_GT(mag(seen - one.U[one.p.cell[0]]), 0.1);
}
