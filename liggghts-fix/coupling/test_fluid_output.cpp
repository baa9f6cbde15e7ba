// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/fluid_output.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sphere_store.h"

using namespace clay;
using Row = FluidRow;

namespace {

// a fluid that moves and presses, and the spheres in it
SphereStore in_fluid(int n)
{
  SphereStore s(n);
  for (int i = 0; i < n; i++) {
    double *row = s.fluid[i];
    s.mass[i] = 2. + i;
    row[Row::DRAG] = 3. + i;
    row[Row::FRACTION] = 0.5 + 0.1 * i;
    for (int k = 0; k < 3; k++) {
      row[Row::VELOCITY + k] = 0.1 * (k + 1) + i;
      row[Row::LOAD + k] = 0.7 * k - i;
      row[Row::HYDRO + k] = 0.3 * k + 0.1;
      s.v[i][k] = 0.2 * i - 0.1 * k;
      s.f[i][k] = 5. * k - 1.;
    }
    row[Row::RELAX] = std::exp(-0.3);
  }
  return s;
}

class Kick : public RandomForce {
 public:
  void force(int i, double K, double *f) const override
  {
    for (int k = 0; k < 3; k++) f[k] = 0.01 * K * (i + 1) * (k - 1);
  }
  void couple(int, double, double *c) const override { c[0] = c[1] = c[2] = 0.; }
};

}  // namespace

// force is what was added to f; drag what is left of it without the load and the random force
TEST(FluidOutput, showsWhatASphereGot)
{
  for (bool random : {false, true}) {
    SphereStore s = in_fluid(2), before = s;
    const Kick kick;
    double all[3] = {};
    push_spheres({0, 1}, s.fluid.rows(), s.arrays(), random ? &kick : nullptr, 1e-2, false, all);
    RowStore shown(2, ShownRow::SIZE);
    show_spheres({0, 1}, s.fluid.rows(), s.arrays(), {false, nullptr, random ? &kick : nullptr}, shown.rows());
    for (int i = 0; i < 2; i++) {
      double pushed[3] = {};
      if (random) kick.force(i, s.fluid[i][Row::DRAG], pushed);
      for (int k = 0; k < 3; k++) {
        const double given = s.f[i][k] - before.f[i][k];
        EXPECT_NEAR(shown[i][ShownRow::FORCE + k], given, 1e-14);
        EXPECT_NEAR(shown[i][ShownRow::DRAG + k], given - s.fluid[i][Row::LOAD + k] - pushed[k], 1e-14);
        EXPECT_EQ(shown[i][ShownRow::VELOCITY + k], s.fluid[i][Row::VELOCITY + k]);
      }
      EXPECT_EQ(shown[i][ShownRow::FRACTION], 0.5 + 0.1 * i);
    }
  }
}

// drag is K times the slip's mean over the step, added mass or not
TEST(FluidOutput, dragLeavesOutWhatAddedMassTakes)
{
  const double dt = 0.5, added = 4.;
  SphereStore s = in_fluid(1), before = s;
  s.inertia[0][InertiaRow::ADDED] = added;
  double all[3] = {};
  push_inertial_spheres({0}, s.fluid.rows(), s.inertia.rows(), s.arrays(), nullptr, dt, false, all);
  RowStore shown(1, ShownRow::SIZE);
  show_spheres({0}, s.fluid.rows(), s.arrays(), {false, s.inertia.rows(), nullptr}, shown.rows());
  const double *row = s.fluid[0];
  const double K = row[Row::DRAG], m = s.mass[0] + added;
  for (int k = 0; k < 3; k++) {
    // m dv/dt = push + K (u - v), integrated by many small steps
    const double push = row[Row::LOAD + k] + before.f[0][k], u = row[Row::VELOCITY + k];
    double v = s.v[0][k], mean = 0.;
    const int steps = 200000;
    for (int n = 0; n < steps; n++) {
      const double a = (push + K * (u - v)) / m, half = v + 0.5 * dt / steps * a;
      mean += K * (u - half) / steps;
      v += dt / steps * (push + K * (u - half)) / m;
    }
    EXPECT_NEAR(shown[0][ShownRow::DRAG + k], mean, 1e-8);
  }
}

TEST(FluidOutput, ofASphereAtRest)
{
  SphereStore s = in_fluid(1);
  RowStore shown(1, ShownRow::SIZE);
  show_spheres({0}, s.fluid.rows(), s.arrays(), {true, nullptr, nullptr}, shown.rows());
  const double *row = s.fluid[0];
  for (int k = 0; k < 3; k++) {
    EXPECT_DOUBLE_EQ(shown[0][ShownRow::DRAG + k], row[Row::DRAG] * row[Row::VELOCITY + k]);
    EXPECT_DOUBLE_EQ(shown[0][ShownRow::FORCE + k], row[Row::LOAD + k] + row[Row::DRAG] * row[Row::VELOCITY + k]);
  }
}

// the spheres of a body add up to it; each has its own K (u - v) and a part of the rest
TEST(FluidOutput, spheresAddUpToTheirBody)
{
  SphereStore s = in_fluid(3);
  const double arm[3] = {0, 0, 0};
  const std::vector<BodySphere> list = {{2, 0, arm, 0.75}, {0, 0, arm, 0.25}, {1, 1, arm, 1.}};
  const std::vector<FluidAction> bodies = {{{1., 2., 3.}, {4., 5., 6.}}, {{7., 8., 9.}, {10., 11., 12.}}};
  RowStore shown(3, ShownRow::SIZE), rows(2, ShownBody::SIZE);
  show_body_spheres(list, bodies, s.fluid.rows(), s.v.rows(), false, shown.rows());
  show_bodies(list, bodies, s.fluid.rows(), rows.rows());
  for (int k = 0; k < 3; k++) {
    EXPECT_NEAR(shown[0][ShownRow::FORCE + k] + shown[2][ShownRow::FORCE + k], bodies[0].force[k], 1e-14);
    EXPECT_NEAR(shown[0][ShownRow::DRAG + k] + shown[2][ShownRow::DRAG + k], bodies[0].drag[k], 1e-14);
    EXPECT_NEAR(shown[1][ShownRow::FORCE + k], bodies[1].force[k], 1e-14);
    EXPECT_NEAR(shown[1][ShownRow::DRAG + k], bodies[1].drag[k], 1e-14);
    EXPECT_EQ(rows[0][ShownBody::FORCE + k], bodies[0].force[k]);
    EXPECT_EQ(rows[1][ShownBody::DRAG + k], bodies[1].drag[k]);

    const double K0 = s.fluid[0][Row::DRAG], K2 = s.fluid[2][Row::DRAG];
    const double own0 = K0 * (s.fluid[0][Row::VELOCITY + k] - s.v[0][k]);
    const double own2 = K2 * (s.fluid[2][Row::VELOCITY + k] - s.v[2][k]);
    EXPECT_NEAR(shown[0][ShownRow::DRAG + k], own0 + K0 / (K0 + K2) * (bodies[0].drag[k] - own0 - own2), 1e-14);
    EXPECT_NEAR(rows[0][ShownBody::VELOCITY + k],
                (K0 * s.fluid[0][Row::VELOCITY + k] + K2 * s.fluid[2][Row::VELOCITY + k]) / (K0 + K2), 1e-14);
  }
  EXPECT_NEAR(rows[0][ShownBody::FRACTION], 0.75 * s.fluid[2][Row::FRACTION] + 0.25 * s.fluid[0][Row::FRACTION], 1e-15);

  // without drag by volume
  for (int i : {0, 2}) s.fluid[i][Row::DRAG] = 0.;
  show_body_spheres(list, bodies, s.fluid.rows(), s.v.rows(), false, shown.rows());
  const double load = s.fluid[0][Row::LOAD] + s.fluid[2][Row::LOAD];
  EXPECT_NEAR(shown[2][ShownRow::FORCE], s.fluid[2][Row::LOAD] + 0.75 * (1. - load), 1e-14);
}
