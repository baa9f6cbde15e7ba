// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "magnusForce.H"
#include "saffmanMeiForce.H"
#include "mathematicalConstants.H"
#include "testMesh.H"

#include <gtest/gtest.h>

using namespace Foam;
using forceModels::magnus;
using forceModels::saffmanMei;

namespace
{

// nu, rho and diameter of a sphere in some oil
const scalar nu = 1e-4, rho = 900, d = 1e-3, mu = nu*rho;

autoPtr<forceModel> force(const std::string& name, const std::string& more = "")
{
    return forceModel::New(name, test::settings(more));
}

template<class Type>
const Type& as(const autoPtr<forceModel>& f)
{
    return dynamic_cast<const Type&>(f());
}

// one particle
struct oneSphere
{
    dispersedParticles p;
    vectorField u{1, vector(Zero)}, vorticity{1, vector(Zero)};
    scalarField n{1, scalar(1)};

    oneSphere(const vector& velocity, const vector& spin)
    {
        p.setSize(1);
        p.velocity[0] = velocity;
        p.radius[0] = d/2;
        p.owned[0] = true;
        p.spin = vectorField(1, spin);
    }

    vector act(const forceModel& f) const
    {
        vectorField sum(1, Zero);
        const scalarField viscosity(1, nu);
        f.act(p, {u, n, vorticity, viscosity, rho}, sum);
        return sum[0];
    }
};

const vector axis[] = {vector(1, 0, 0), vector(0, 1, 0), vector(0, 0, 1)};

}


TEST(saffmanMei, isSaffmansLiftInThreePlanes)
{
    // u_i = G x_j: the vorticity is -G (e_i x e_j); a sphere that lags by s is
    // pushed along +e_j by 6.46 mu a^2 std::sqrt(G/nu) s
    const auto lift = force("saffmanMei", "saffmanMeiCoeffs { finiteRe no; }");
    EXPECT_TRUE(lift->onFluid());
    EXPECT_TRUE(lift->needsVorticity());
    EXPECT_FALSE(lift->needsSpin());

    const scalar G = 40, s = 0.02;
    const scalar size = 6.46*mu*sqr(d/2)*std::sqrt(G/nu)*s;
    for (int i = 0; i < 3; ++i)
    {
        for (int j = 0; j < 3; ++j)
        {
            if (i != j)
            {
                oneSphere sphere(-s*axis[i], Zero);
                sphere.vorticity[0] = -G*(axis[i] ^ axis[j]);
                const vector F(sphere.act(*lift));
                EXPECT_NEAR(mag(F - size*axis[j])/size, 0, 1e-12) << i << j;

                // and a sphere that leads the other way
                sphere.p.velocity[0] = s*axis[i];
                EXPECT_NEAR(mag(sphere.act(*lift) + F)/size, 0, 1e-12);
            }
        }
    }
}


TEST(saffmanMei, hasMeisFactor)
{
    // Re, b, f worked out apart
    const scalar table[][3] =
    {
        {0,   0.1,  1},
        {1,   0.1,  0.914810},
        {10,  0.05, 0.4147218},
        {10,  0.4,  0.5003692},
        {40,  0.2,  0.163808},
        {50,  0.2,  0.1657034},
        {100, 0.4,  0.3314067}
    };
    for (const auto& row : table)
    {
        EXPECT_NEAR(saffmanMei::factor(row[0], row[1]), row[2], 2e-6)
            << row[0] << ' ' << row[1];
    }
    // the two parts of the fit meet
    EXPECT_NEAR
    (
        saffmanMei::factor(40, 0.2)/saffmanMei::factor(40.0001, 0.2), 1, 0.12
    );

    const auto f = force("saffmanMei");
    const scalar s = 0.1, w = 50;
    const vector F(as<saffmanMei>(f).lift(s*axis[0], w*axis[1], d, nu, rho));
    EXPECT_NEAR
    (
        F.z(),
        1.615*rho*sqr(d)*std::sqrt(nu*w)*s
       *saffmanMei::factor(d*s/nu, d*w/(2*s)),
        1e-15
    );
}


TEST(saffmanMei, isNothingWithoutShearOrSlip)
{
    const auto lift = force("saffmanMei");
    oneSphere sphere(Zero, Zero);
    EXPECT_EQ(mag(sphere.act(*lift)), 0);
    sphere.vorticity[0] = axis[0];
    EXPECT_EQ(mag(sphere.act(*lift)), 0);
    sphere.p.velocity[0] = axis[1];
    EXPECT_GT(mag(sphere.act(*lift)), 0);
    sphere.p.owned[0] = false;
    EXPECT_EQ(mag(sphere.act(*lift)), 0);
}


TEST(magnus, isRubinowAndKellersLift)
{
    // pi a^3 rho W x v, in a fluid at rest
    const auto lift = force("magnus", "magnusCoeffs { finiteRe no; }");
    EXPECT_TRUE(lift->onFluid());
    EXPECT_TRUE(lift->needsSpin());
    const vector v(0.02, -0.01, 0.05), W(30, 100, -20);
    const oneSphere sphere(v, W);
    const vector expected(constant::mathematical::pi*pow3(d/2)*rho*(W ^ v));
    EXPECT_NEAR(mag(sphere.act(*lift) - expected)/mag(expected), 0, 1e-12);

    // a ball with topspin dips
    EXPECT_LT(oneSphere(axis[0], axis[1]).act(*lift).z(), 0);

    // a sphere that turns with the fluid has none
    oneSphere turning(v, W);
    turning.vorticity[0] = 2*W;
    EXPECT_EQ(mag(turning.act(*lift)), 0);
}


TEST(magnus, hasOesterlesCoefficient)
{
    // C = f Re_r/Re worked out apart: Re, Re_r, C
    const scalar table[][3] =
    {
        {10, 20,  1.5143458},
        {50, 100, 0.9360501},
        {100, 50, 0.4669452}
    };
    for (const auto& row : table)
    {
        EXPECT_NEAR
        (
            magnus::factor(row[0], row[1])*row[1]/row[0], row[2], 2e-6
        ) << row[0];
    }
    // Rubinow and Keller's at low Re
    EXPECT_NEAR(magnus::factor(1e-6, 1e-6), 1, 1e-3);
}


TEST(torque, isKirchhoffs)
{
    const auto t = force("torque");
    const scalar C = 8*constant::mathematical::pi*mu*pow3(d/2);
    EXPECT_NEAR(t->turnCoefficient(mu, d), C, 1e-25);
    EXPECT_TRUE(t->needsVorticity());
    EXPECT_EQ(force("magnus")->turnCoefficient(mu, d), 0);
}


TEST(addedMass, isHalfTheFluidsMass)
{
    EXPECT_EQ(force("addedMass")->addedDensity(1000), 500);
    EXPECT_EQ
    (
        force("addedMass", "addedMassCoeffs { Cm 0.8; }")->addedDensity(1000),
        800
    );
    EXPECT_EQ(force("buoyancy")->addedDensity(1000), 0);
}
