// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/told_drag.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace clay;
using Eigen::Vector3d;

namespace {

const double a = 1e-3, rho = 1000., mu = 1e-3;

// two spheres in touch, with a resistance that is 1.2 of one sphere's along x, 1.4 across
ClumpDrag dumbbell()
{
  Matrix6d R = Matrix6d::Identity();
  R(0, 0) = 1.2 * 6 * M_PI * a;
  R(1, 1) = R(2, 2) = 1.4 * 6 * M_PI * a;
  return ClumpDrag({{Vector3d(-a, 0, 0), a}, {Vector3d(a, 0, 0), a}}, R, ShapeLaw::tranCong);
}

// drag coefficient that the CFD half makes of all that it is told of a clump
double answer(const ToldDrag &told, const ClumpDrag &d, double volume, double hindrance)
{
  return told.factor * volume * 18 * mu / (d.diameter() * d.diameter()) * hindrance;
}

}  // namespace

TEST(ToldDrag, isTheClumpsOwnAlongItsSlip)
{
  const ClumpDrag d = dumbbell();
  const double volume = 3e-9;  // whatever the DEM half reckons with
  EXPECT_NEAR(answer(told_drag(d, Vector3d(0.1, 0, 0), -1, volume), d, volume, 1), mu * 1.2 * 6 * M_PI * a, 1e-15);
  EXPECT_NEAR(answer(told_drag(d, Vector3d(0, 0, -2), -1, volume), d, volume, 1), mu * 1.4 * 6 * M_PI * a, 1e-15);
}

TEST(ToldDrag, growsWithTheReynoldsNumber)
{
  const ClumpDrag d = dumbbell();
  const Vector3d slip(0.1, 0, 0);
  const double Re = clump_reynolds(d, slip, rho, mu), volume = 3e-9;
  EXPECT_NEAR(Re, 2 * a * std::cbrt(2.) * 0.1 * rho / mu, 1e-9);
  const ToldDrag creeping = told_drag(d, slip, -1, volume), told = told_drag(d, slip, Re, volume);
  EXPECT_EQ(creeping.growth, 1.);
  EXPECT_GT(told.growth, 2.);
  EXPECT_DOUBLE_EQ(told.growth, d.growth(slip, Re));
  EXPECT_DOUBLE_EQ(told.factor, creeping.factor * told.growth);
}

TEST(ToldDrag, anAnswerWithoutHindranceIsTheViscosity)
{
  const ClumpDrag d = dumbbell();
  const double volume = 3e-9;
  const Vector3d before(0.1, 0, 0), now(0, 0.02, 0);
  for (double hindrance : {1., 3.5}) {
    // in creeping flow, and with another slip than the one that was told of
    ToldDrag told = told_drag(d, before, -1, volume);
    EXPECT_NEAR(answered_scale(d, told, volume, answer(told, d, volume, hindrance), before, 0), mu * hindrance, 1e-15);
    told = told_drag(d, before, clump_reynolds(d, before, rho, mu), volume);
    const double Re = clump_reynolds(d, now, rho, mu);
    EXPECT_NEAR(answered_scale(d, told, volume, answer(told, d, volume, hindrance), now, Re),
                mu * hindrance * d.growth(now, Re), 1e-14);
  }
}
