// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/particle_packer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sphere_store.h"

using namespace clay;
using Row = FluidRow;

namespace {

const FieldSet state = {Field::position, Field::radius,  Field::volume, Field::velocity, Field::tag,
                        Field::body,     Field::impulse, Field::mass,   Field::spin};
const FieldSet answered = {Field::dragCoefficient, Field::fluidVelocity,   Field::force,
                           Field::addedMass,       Field::turnCoefficient, Field::fluidSpin};

// n spheres, all numbers different
SphereStore spheres(int n)
{
  SphereStore s(n);
  for (int i = 0; i < n; i++) {
    s.radius[i] = 1. + 0.1 * i;
    s.mass[i] = 2. + i;
    for (int k = 0; k < 3; k++) {
      s.x[i][k] = 10 * i + k;
      s.v[i][k] = 100 * i + k + 1;
      s.omega[i][k] = 1000 * i + k + 1;
      s.fluid[i][Row::IMPULSE + k] = i + 0.25 * k + 0.5;
    }
  }
  return s;
}

// n answers, all numbers different
Particles answer(int n, FieldSet fields = answered)
{
  Particles a(fields);
  a.resize(n);
  for (Field f : {Field::dragCoefficient, Field::fluidVelocity, Field::force, Field::addedMass, Field::turnCoefficient,
                  Field::fluidSpin})
    if (fields.has(f))
      for (int i = 0; i < components(f) * n; i++) a[f][i] = 100. * static_cast<int>(f) + i + 1;
  return a;
}

// what was sent: n spheres of volume 2, 4, ... m3
Particles sent(int n, FieldSet fields = {Field::volume})
{
  Particles s(fields);
  s.resize(n);
  for (int i = 0; i < n; i++) s[Field::volume][i] = 2. * (i + 1);
  return s;
}

const MovingGroups first_group = {1, 0};

// two bodies of two spheres and one; atoms 2, 0 and 1
const double arm[3][3] = {{1, 0, 0}, {-1, 0, 0}, {0, 0, 0}};
const std::vector<BodySphere> two_bodies = {{2, 0, arm[0], 0.75}, {0, 0, arm[1], 0.25}, {1, 1, arm[2], 1.}};

}  // namespace

TEST(PackFree, tellsOfTheListedAndTakesTheirImpulses)
{
  SphereStore s = spheres(4);
  Particles message(state);
  message.resize(2);
  pack_free({1, 3}, s.arrays(), s.fluid.rows(), false, message);

  for (int slot : {0, 1}) {
    const int i = slot ? 3 : 1;
    const double r = s.radius[i];
    EXPECT_EQ(s.fluid[i][Row::SLOT], slot);
    EXPECT_EQ(message[Field::radius][slot], r);
    EXPECT_DOUBLE_EQ(message[Field::volume][slot], M_PI / 6. * std::pow(2. * r, 3));
    EXPECT_EQ(message[Field::mass][slot], s.mass[i]);
    EXPECT_EQ(message[Field::tag][slot], i + 1);
    EXPECT_EQ(message[Field::body][slot], -1.);
    for (int k = 0; k < 3; k++) {
      EXPECT_EQ(message[Field::position][3 * slot + k], s.x[i][k]);
      EXPECT_EQ(message[Field::velocity][3 * slot + k], s.v[i][k]);
      EXPECT_EQ(message[Field::spin][3 * slot + k], s.omega[i][k]);
      EXPECT_EQ(message[Field::impulse][3 * slot + k], i + 0.25 * k + 0.5);
      EXPECT_EQ(s.fluid[i][Row::IMPULSE + k], 0.);
    }
  }
  EXPECT_EQ(s.fluid[0][Row::SLOT], -1.);
  EXPECT_EQ(s.fluid[2][Row::IMPULSE], 2.5);
}

TEST(PackFree, onlyWhatIsAskedFor)
{
  SphereStore s = spheres(1);
  Particles message({Field::position, Field::dragDiameter, Field::dragFactor});
  message.resize(1);
  message[Field::dragDiameter][0] = message[Field::dragFactor][0] = 9.;
  pack_free({0}, s.arrays(), s.fluid.rows(), false, message);
  EXPECT_EQ(message[Field::position][2], 2.);
  EXPECT_EQ(message[Field::dragDiameter][0], 0.);  // a free sphere has none
  EXPECT_EQ(message[Field::dragFactor][0], 0.);
}

TEST(PackFree, gravityByGroup)
{
  SphereStore s = spheres(2);
  s.mask[1] = 1 | 8;
  s.gravity.add(1, {{0., 0., -9.}});
  s.gravity.add(8, {{2., 0., -1.}});
  Particles message({Field::gravity});
  message.resize(2);
  pack_free({0, 1}, s.arrays(), s.fluid.rows(), false, message);
  EXPECT_EQ(message[Field::gravity][0], 0.);
  EXPECT_EQ(message[Field::gravity][2], -9.);
  EXPECT_EQ(message[Field::gravity][3], 2.);
  EXPECT_EQ(message[Field::gravity][5], -10.);
}

TEST(PackFree, whatIsKeptStillHasNoVelocity)
{
  SphereStore s = spheres(1);
  Particles message(state);
  message.resize(1);
  pack_free({0}, s.arrays(), s.fluid.rows(), true, message);
  for (int k = 0; k < 3; k++) EXPECT_EQ(message[Field::velocity][k], 0.);
}

TEST(ShareImpulses, addUpToTheBodys)
{
  SphereStore s = spheres(3);
  std::vector<BodyState> bodies(2);
  bodies[0].impulse = {{5., -2., 1.}};
  bodies[1].impulse = {{1., 1., 1.}};
  const double drag[3] = {1., 7., 3.}, time = 0.5;
  for (int i = 0; i < 3; i++) {
    s.fluid[i][Row::DRAG] = drag[i];
    s.fluid[i][Row::VELOCITY] = 0.5 * i;
    s.fluid[i][Row::LOAD + 1] = i + 1.;
    s.fluid[i][Row::HYDRO + 1] = 0.5 * i;
  }
  const std::vector<double> shares = share_impulses(two_bodies, bodies, s.fluid.rows(), s.v.rows(), false, time);
  for (int k = 0; k < 3; k++) {
    EXPECT_NEAR(shares[k] + shares[3 + k], bodies[0].impulse[k], 1e-12);
    EXPECT_NEAR(shares[6 + k], 1., 1e-12);
    // each its own, and what is left by drag coefficient
    double own[2];
    for (int n : {0, 1}) {
      const int i = two_bodies[n].atom;
      own[n] = time *
          (s.fluid[i][Row::LOAD + k] - s.fluid[i][Row::HYDRO + k] +
           drag[i] * (s.fluid[i][Row::VELOCITY + k] - s.v[i][k]));
    }
    const double left = bodies[0].impulse[k] - own[0] - own[1];
    EXPECT_NEAR(shares[k], own[0] + 0.75 * left, 1e-10);
    EXPECT_NEAR(shares[3 + k], own[1] + 0.25 * left, 1e-10);
  }
  // kept still: the spheres' own velocities do not count
  const std::vector<double> still = share_impulses(two_bodies, bodies, s.fluid.rows(), s.v.rows(), true, time);
  const double own0 = time * 3. * 1., own1 = 0.;
  EXPECT_NEAR(still[0], own0 + 0.75 * (5. - own0 - own1), 1e-12);
}

TEST(ShareImpulses, byVolumeWithoutDrag)
{
  SphereStore s = spheres(3);
  std::vector<BodyState> bodies(2);
  bodies[0].impulse = {{4., 8., 0.}};
  const std::vector<double> shares = share_impulses(two_bodies, bodies, s.fluid.rows(), s.v.rows(), false, 1.);
  EXPECT_EQ(shares[0], 3.);
  EXPECT_EQ(shares[1], 6.);
  EXPECT_EQ(shares[3], 1.);
}

TEST(PackBodies, aSphereStandsForItsPartOfTheBody)
{
  SphereStore s = spheres(3);
  std::vector<BodyState> bodies(2);
  bodies[0].volume = 8.;
  bodies[0].mass = 16.;
  bodies[0].tag = 11.;
  bodies[1].tag = 12.;
  Particles message(state);
  message.resize(4);
  pack_bodies(two_bodies, bodies, {1, 2, 3, 4, 5, 6, 7, 8, 9}, s.arrays(), false, 1, message);
  EXPECT_EQ(message[Field::volume][1], 6.);
  EXPECT_EQ(message[Field::mass][2], 4.);
  EXPECT_EQ(message[Field::body][1], 11.);
  EXPECT_EQ(message[Field::body][3], 12.);
  EXPECT_EQ(message[Field::tag][1], 3.);
  EXPECT_EQ(message[Field::position][3], s.x[2][0]);
  EXPECT_EQ(message[Field::impulse][3 * 2 + 1], 5.);
  EXPECT_EQ(message[Field::tag][0], 0.);  // a free sphere's place is left alone
}

TEST(FirstAstray, placeOrVelocityThatIsNotFinite)
{
  SphereStore s = spheres(3);
  Particles message(state);
  message.resize(3);
  pack_free({0, 1, 2}, s.arrays(), s.fluid.rows(), false, message);
  EXPECT_EQ(first_astray(message), -1);
  message[Field::velocity][8] = INFINITY;
  EXPECT_EQ(first_astray(message), 2);
  message[Field::position][3] = NAN;
  EXPECT_EQ(first_astray(message), 1);
}

TEST(UnpackFree, byTheirSlots)
{
  SphereStore s = spheres(3);
  const double dt = 1e-2;
  s.fluid[0][Row::SLOT] = 1;
  s.fluid[2][Row::SLOT] = 0;
  s.mask[2] = 2;
  const Particles a = answer(2);
  unpack_free(a, sent(2), {}, 3, s.mass.data(), s.mask.data(), first_group, dt, s.fluid.rows(), s.inertia.rows());
  for (int i : {0, 2}) {
    const int slot = i ? 0 : 1;
    EXPECT_EQ(s.fluid[i][Row::DRAG], a[Field::dragCoefficient][slot]);
    for (int k = 0; k < 3; k++) {
      EXPECT_EQ(s.fluid[i][Row::VELOCITY + k], a[Field::fluidVelocity][3 * slot + k]);
      EXPECT_EQ(s.fluid[i][Row::LOAD + k], a[Field::force][3 * slot + k]);
      EXPECT_EQ(s.inertia[i][InertiaRow::SPIN + k], a[Field::fluidSpin][3 * slot + k]);
    }
    // what no fix moves has neither
    EXPECT_EQ(s.inertia[i][InertiaRow::ADDED], i ? 0. : a[Field::addedMass][slot]);
    EXPECT_EQ(s.inertia[i][InertiaRow::TURN], i ? 0. : a[Field::turnCoefficient][slot]);
  }
  const double n = a[Field::dragCoefficient][1] * dt / s.mass[0];
  EXPECT_NEAR(s.fluid[0][Row::RELAX], (1. - std::exp(-n)) / n, 1e-12);
  EXPECT_EQ(s.fluid[2][Row::RELAX], 1.);
  EXPECT_EQ(s.fluid[1][Row::DRAG], 0.);
}

TEST(UnpackFree, hydrostaticPartOfTheLoad)
{
  SphereStore s = spheres(2);
  s.fluid[0][Row::SLOT] = 1;
  s.fluid[1][Row::SLOT] = 0;
  Particles a = answer(2);
  const Hydrostatics water = {1000., {{0., 0.5, -9.}}};
  auto take = [&](const Particles &told, const Hydrostatics &still) {
    unpack_free(a, told, still, 2, s.mass.data(), s.mask.data(), first_group, 1e-3, s.fluid.rows(), s.inertia.rows());
  };
  take(sent(2), water);
  EXPECT_EQ(s.fluid[0][Row::HYDRO + 1], -4. * 500.);
  EXPECT_EQ(s.fluid[0][Row::HYDRO + 2], 4. * 9000.);
  EXPECT_EQ(s.fluid[1][Row::HYDRO + 2], 2. * 9000.);

  // by each sphere's own gravity
  Particles told = sent(2, {Field::volume, Field::gravity});
  told[Field::gravity][3] = 7.;
  take(told, water);
  EXPECT_EQ(s.fluid[0][Row::HYDRO], -4. * 7000.);
  EXPECT_EQ(s.fluid[0][Row::HYDRO + 2], 0.);

  // none without buoyancy, nor where no fluid is
  take(sent(2), {});
  EXPECT_EQ(s.fluid[0][Row::HYDRO + 2], 0.);
  a[Field::dragCoefficient][1] = 0.;
  take(sent(2), water);
  EXPECT_EQ(s.fluid[0][Row::HYDRO + 2], 0.);
  EXPECT_EQ(s.fluid[1][Row::HYDRO + 2], 2. * 9000.);
}

TEST(UnpackFree, withoutALoadThereIsNone)
{
  SphereStore s = spheres(1);
  s.fluid[0][Row::SLOT] = 0;
  s.fluid[0][Row::LOAD + 1] = 5.;
  unpack_free(answer(1, {Field::dragCoefficient, Field::fluidVelocity}), sent(1), {}, 1, s.mass.data(), s.mask.data(),
              first_group, 1e-3, s.fluid.rows(), nullptr);
  EXPECT_EQ(s.fluid[0][Row::LOAD + 1], 0.);
}

TEST(UnpackBodies, sumsOverTheirSpheres)
{
  SphereStore s = spheres(3);
  const Particles a = answer(4);
  const auto sums =
      unpack_bodies<LAMMPS_NS::BodyDrag>(a, sent(4), {10., {{0., 0., -3.}}}, 1, two_bodies, 2, s.fluid.rows());
  const double *K = a[Field::dragCoefficient];
  ASSERT_EQ(sums.size(), 2u);
  EXPECT_EQ(sums[0].K, K[1] + K[2]);
  EXPECT_EQ(sums[0].Kr[0], K[1] - K[2]);
  EXPECT_EQ(sums[1].K, K[3]);
  EXPECT_EQ(sums[0].added(0, 0), a[Field::addedMass][1] + a[Field::addedMass][2]);
  for (int k = 0; k < 3; k++)
    EXPECT_EQ(sums[1].push[k], K[3] * a[Field::fluidVelocity][9 + k] + a[Field::force][9 + k]);
  EXPECT_EQ(s.fluid[2][Row::DRAG], K[1]);
  EXPECT_EQ(s.fluid[0][Row::LOAD + 2], a[Field::force][8]);
  EXPECT_EQ(s.fluid[0][Row::HYDRO + 2], 6. * 30.);
}
