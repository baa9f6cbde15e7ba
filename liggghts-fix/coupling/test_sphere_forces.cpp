// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/sphere_forces.h"

#include <gtest/gtest.h>

#include <cmath>

#include "clumps/body_drag.h"
#include "sphere_store.h"

using namespace clay;
using Row = FluidRow;

namespace {

double given[3];  // to all spheres

const double K = 2e-4, mass = 1e-5, u = 0.3, weight = -9.81 * mass, load = 4e-5;

// one sphere under its weight, answered K, u and a load along z
SphereStore falling(double dt)
{
  SphereStore s(1);
  s.mass[0] = mass;
  s.fluid[0][Row::DRAG] = K;
  s.fluid[0][Row::VELOCITY + 2] = u;
  s.fluid[0][Row::LOAD + 2] = load;
  s.fluid[0][Row::RELAX] = LAMMPS_NS::relaxation_factor(K * dt / mass);
  s.f[0][2] = weight;
  return s;
}

class Constant : public RandomForce {
 public:
  void force(int i, double K, double *f) const override { f[0] = (i + 1) * K; }
  void couple(int i, double C, double *t) const override { t[1] = (i + 1) * C; }
};

}  // namespace

TEST(PushSpheres, exactForAnyStep)
{
  const double v0 = -0.1, vinf = u + (weight + load) / K;
  for (double dt : {1e-6, 1e-2, 1.0, 30.0}) {
    SphereStore s = falling(dt);
    s.v[0][2] = v0;
    push_spheres({0}, s.fluid.rows(), s.arrays(), nullptr, dt, false, given);
    EXPECT_NEAR(v0 + dt / mass * s.f[0][2], vinf + (v0 - vinf) * std::exp(-K * dt / mass), 1e-12) << dt;
  }
}

TEST(PushSpheres, impulseIsTheTrapezoidOfTheForces)
{
  const double dt = 1e-3;
  SphereStore s = falling(dt);
  push_spheres({0}, s.fluid.rows(), s.arrays(), nullptr, dt, true, given);
  const double first = s.fluid[0][Row::FORCE + 2];
  EXPECT_EQ(s.fluid[0][Row::IMPULSE + 2], 0.);
  EXPECT_EQ(s.f[0][2], weight + first);

  s.f[0][2] = weight;
  s.v[0][2] = -0.2;
  push_spheres({0}, s.fluid.rows(), s.arrays(), nullptr, dt, false, given);
  const double second = s.fluid[0][Row::FORCE + 2];
  EXPECT_NE(first, second);
  EXPECT_DOUBLE_EQ(s.fluid[0][Row::IMPULSE + 2], 0.5 * dt * (first + second));

  // and all have received what each has
  double all[3] = {1., 2., 3.};
  SphereStore three(3);
  for (int i = 0; i < 3; i++) three.fluid[i][Row::LOAD + 1] = i + 1.;
  push_spheres({0, 2}, three.fluid.rows(), three.arrays(), nullptr, dt, false, all);
  push_held_spheres({1}, three.fluid.rows(), nullptr, three.arrays(), {}, {}, nullptr, dt, false, all);
  push_inertial_spheres({1}, three.fluid.rows(), three.inertia.rows(), three.arrays(), nullptr, dt, false, all);
  EXPECT_EQ(all[0], 1.);
  double sum = 2.;
  for (int i = 0; i < 3; i++) sum += three.fluid[i][Row::IMPULSE + 1];
  EXPECT_DOUBLE_EQ(all[1], sum);
}

TEST(PushSpheres, onlyTheListed)
{
  SphereStore s(3);
  for (int i = 0; i < 3; i++) s.fluid[i][Row::LOAD] = 1.;
  push_spheres({0, 2}, s.fluid.rows(), s.arrays(), nullptr, 1e-3, false, given);
  EXPECT_EQ(s.f[0][0], 1.);
  EXPECT_EQ(s.f[1][0], 0.);
  EXPECT_EQ(s.f[2][0], 1.);
}

TEST(PushSpheres, randomForceIsTheFluids)
{
  SphereStore s(2);
  for (int i = 0; i < 2; i++) s.fluid[i][Row::DRAG] = K;
  const Constant random;
  push_spheres({0, 1}, s.fluid.rows(), s.arrays(), &random, 1e-3, false, given);
  for (int i = 0; i < 2; i++) {
    EXPECT_EQ(s.f[i][0], (i + 1) * K);
    EXPECT_EQ(s.fluid[i][Row::IMPULSE], 0.5e-3 * (i + 1) * K);
  }
}

TEST(PushSpheres, theHydrostaticPartPushesAndIsNotTheFluidsToGive)
{
  const double dt = 0.02;
  SphereStore s = falling(dt), h = falling(dt);
  h.fluid[0][Row::HYDRO + 2] = 0.75 * load;
  for (SphereStore *one : {&s, &h}) push_spheres({0}, one->fluid.rows(), one->arrays(), nullptr, dt, false, given);
  EXPECT_EQ(h.f[0][2], s.f[0][2]);
  EXPECT_NEAR(h.fluid[0][Row::FORCE + 2], s.fluid[0][Row::FORCE + 2] - 0.75 * load, 1e-18);
  EXPECT_NEAR(h.fluid[0][Row::IMPULSE + 2], s.fluid[0][Row::IMPULSE + 2] - 0.5 * dt * 0.75 * load, 1e-18);
}

TEST(PushHeldSpheres, getTheWholeDragWhateverTheStep)
{
  for (double dt : {1e-6, 1e-2, 30.0}) {
    SphereStore s = falling(dt);
    s.v[0][2] = -0.1;
    s.fluid[0][Row::HYDRO + 2] = load;
    push_held_spheres({0}, s.fluid.rows(), nullptr, s.arrays(), {}, {}, nullptr, dt, true, given);
    EXPECT_DOUBLE_EQ(s.f[0][2], weight + load + K * (u + 0.1));
    push_held_spheres({0}, s.fluid.rows(), nullptr, s.arrays(), {}, {}, nullptr, dt, false, given);
    EXPECT_NEAR(s.fluid[0][Row::IMPULSE + 2], dt * K * (u + 0.1), 1e-12 * dt * K);
  }
}

TEST(PushHeldSpheres, whoseForcesWereTakenAwayGetNone)
{
  SphereStore s = falling(1e-3);
  s.mask[0] = 1 | 4;
  AxisGroups frozen;
  frozen.along = {4, 4, 4};
  push_held_spheres({0}, s.fluid.rows(), nullptr, s.arrays(), {}, frozen, nullptr, 1e-3, false, given);
  EXPECT_EQ(s.f[0][2], weight);
  EXPECT_GT(s.fluid[0][Row::IMPULSE + 2], 0.);
}

// along an axis whose force a fix sets all of the drag, along the others that of a free sphere
TEST(PushHeldSpheres, alongSomeAxesOnly)
{
  const double dt = 30.0, added = 0.3e-5;
  MovingGroups moving;
  moving.movers = 1;
  moving.set.along = {0, 4, 0};
  for (bool inertial : {false, true}) {
    SphereStore s = falling(dt), free = falling(dt);
    for (SphereStore *one : {&s, &free}) {
      one->mask[0] = 1 | 4;
      one->inertia[0][InertiaRow::ADDED] = added;
      for (int k = 0; k < 3; k++) one->fluid[0][Row::VELOCITY + k] = 0.1 * (k + 1);
    }
    push_held_spheres({0}, s.fluid.rows(), inertial ? s.inertia.rows() : nullptr, s.arrays(), moving, {}, nullptr, dt,
                      false, given);
    if (inertial)
      push_inertial_spheres({0}, free.fluid.rows(), free.inertia.rows(), free.arrays(), nullptr, dt, false, given);
    else push_spheres({0}, free.fluid.rows(), free.arrays(), nullptr, dt, false, given);
    EXPECT_NEAR(s.f[0][0], free.f[0][0], 1e-12 * K);
    EXPECT_NEAR(s.f[0][1], K * 0.2, 1e-12 * K);
    EXPECT_NEAR(s.f[0][2], free.f[0][2], 1e-12 * K);
    EXPECT_LT(std::fabs(free.f[0][1]), 0.5 * K * 0.2);
  }
}

TEST(PushInertialSpheres, movesAsItsMassAndTheAddedOne)
{
  const double added = 0.5e-5, dt = 0.02, v0 = -0.1, vinf = u + (weight + load) / K;
  SphereStore s = falling(dt);
  s.inertia[0][InertiaRow::ADDED] = added;
  s.v[0][2] = v0;
  push_inertial_spheres({0}, s.fluid.rows(), s.inertia.rows(), s.arrays(), nullptr, dt, false, given);
  EXPECT_NEAR(v0 + dt / mass * s.f[0][2], vinf + (v0 - vinf) * std::exp(-K * dt / (mass + added)), 1e-12);
  EXPECT_DOUBLE_EQ(s.fluid[0][Row::IMPULSE + 2], 0.5 * dt * (s.f[0][2] - weight));
  EXPECT_EQ(s.torque[0][1], 0.);

  SphereStore h = falling(dt);
  h.inertia[0][InertiaRow::ADDED] = added;
  h.v[0][2] = v0;
  h.fluid[0][Row::HYDRO + 2] = load;
  push_inertial_spheres({0}, h.fluid.rows(), h.inertia.rows(), h.arrays(), nullptr, dt, false, given);
  EXPECT_EQ(h.f[0][2], s.f[0][2]);
  EXPECT_NEAR(h.fluid[0][Row::IMPULSE + 2], 0.5 * dt * (s.f[0][2] - weight - load), 1e-18);
}

TEST(PushInertialSpheres, spinRelaxesExactly)
{
  const double C = 3e-12, w = 40., w0 = 5., other = 2e-11, dt = 0.3;
  SphereStore s = falling(dt);
  s.radius[0] = 1e-3;
  s.inertia[0][InertiaRow::TURN] = C;
  s.inertia[0][InertiaRow::SPIN + 1] = w;
  s.omega[0][1] = w0;
  s.torque[0][1] = other;
  push_inertial_spheres({0}, s.fluid.rows(), s.inertia.rows(), s.arrays(), nullptr, dt, false, given);
  const double inertia = 0.4 * mass * 1e-6, last = w + other / C;
  EXPECT_NEAR(w0 + dt / inertia * s.torque[0][1], last + (w0 - last) * std::exp(-C * dt / inertia), 1e-9);

  // and is driven by the random couple
  SphereStore r = falling(dt);
  r.radius[0] = 1e-3;
  r.inertia[0][InertiaRow::TURN] = 1e-20;
  const Constant random;
  push_inertial_spheres({0}, r.fluid.rows(), r.inertia.rows(), r.arrays(), &random, dt, false, given);
  EXPECT_NEAR(r.torque[0][1], 1e-20, 1e-26);
}

TEST(StillForces, whatTheFluidGivesASphereAtRest)
{
  SphereStore s = falling(1e-3);
  s.v[0][2] = 7.;  // it is kept still
  double force[3];
  still_force(s.fluid[0], force);
  EXPECT_EQ(force[0], 0.);
  EXPECT_DOUBLE_EQ(force[2], load + K * u);
  s.fluid[0][Row::HYDRO + 2] = load;
  still_force(s.fluid[0], force);
  EXPECT_NEAR(force[2], K * u, 1e-18);
}

TEST(StillForces, changedByMoreThanALimit)
{
  SphereStore s(2);
  s.mass[1] = 2.;
  const std::vector<StillSphere> spheres = {{s.fluid[0], 1.}, {s.fluid[1], 2.}};
  StillForces forces;
  forces.mark(spheres);
  EXPECT_FALSE(forces.changed(spheres, 0.));
  s.fluid[1][Row::LOAD] = 3.;
  s.fluid[1][Row::LOAD + 1] = 4.;  // 2.5 m/s2
  EXPECT_FALSE(forces.changed(spheres, 2.51));
  EXPECT_TRUE(forces.changed(spheres, 2.49));
  EXPECT_TRUE(forces.changed({{s.fluid[0], 1.}}, 1e9));
}
