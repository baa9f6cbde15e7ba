// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "body_drag.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace LAMMPS_NS;
using Eigen::Vector3d;

namespace {

const double none[3] = {0, 0, 0};

Matrix6d mass_of(double m, double I)
{
  Matrix6d M = Matrix6d::Zero();
  M.topLeftCorner<3, 3>().diagonal().setConstant(m);
  M.bottomRightCorner<3, 3>().diagonal().setConstant(I);
  return M;
}

}  // namespace

TEST(SphereDrag, FollowsTheExactRelaxationForAnyStep)
{
  const double K = 2e-4, m = 1e-5, u = 0.3, g = -9.81 * m;
  const double v0 = -0.1, vinf = u + g / K;
  for (double dt : {1e-7, 1e-4, 1e-2, 1.0, 100.0}) {
    const double v = v0 + dt / m * (g + sphere_drag(K, u, v0, g, m, dt));
    EXPECT_NEAR(v, vinf + (v0 - vinf) * std::exp(-K * dt / m), 1e-12) << "dt " << dt;
  }
}

TEST(SphereDrag, IsNothingWithoutDrag)
{
  EXPECT_EQ(sphere_drag(0, 5, 1, 3, 1e-5, 1e-3), 0);
}

TEST(RelaxationFactor, IsSmoothWhereTheSeriesTakesOver)
{
  EXPECT_NEAR(relaxation_factor(0.99999e-5), relaxation_factor(1.00001e-5), 1e-10);
  EXPECT_DOUBLE_EQ(relaxation_factor(0), 1);
  EXPECT_NEAR(relaxation_factor(2), (1 - std::exp(-2)) / 2, 1e-15);
}

TEST(BodyDrag, OfOneSphereAtTheCentreIsThatOfTheSphere)
{
  BodyDrag d;
  const double u[3] = {0.1, -0.2, 0.3}, f[3] = {1e-6, 0, -1e-6};
  d.add_sphere(none, 2e-4, u, f);
  const double m = 1e-5, dt = 1e-6;
  const Matrix6d M = mass_of(m, 1e-12), inv = M.inverse();
  const Vector6d w = drag_wrench(d, Vector6d::Zero(), Vector6d::Zero(), M, inv, dt);
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(w[k], f[k] + sphere_drag(2e-4, u[k], 0, f[k], m, dt), 1e-12);
  EXPECT_EQ(w.tail<3>().norm(), 0);
}

TEST(BodyDrag, ReachesItsTerminalVelocityWithAnyStep)
{
  BodyDrag d;
  const double r1[3] = {1e-3, 0, 0}, r2[3] = {-1e-3, 0, 0};
  d.add_sphere(r1, 1e-4, none, none);
  d.add_sphere(r2, 1e-4, none, none);
  const double m = 2e-5;
  const Matrix6d M = mass_of(m, 2e-11), inv = M.inverse();
  Vector6d weight = Vector6d::Zero();
  weight[2] = -m * 9.81;
  for (double dt : {1e-5, 1e-2, 1.0, 1e3}) {
    Vector6d y = Vector6d::Zero();
    for (int n = 0; n < 400000 && n * dt < 40; ++n)
      y += dt * inv * (weight + drag_wrench(d, y, weight, M, inv, dt));
    for (int n = 0; n < 60; ++n)
      y += dt * inv * (weight + drag_wrench(d, y, weight, M, inv, dt));
    EXPECT_NEAR(y[2], -m * 9.81 / 2e-4, 1e-9) << "dt " << dt;
    EXPECT_NEAR(y.tail<3>().norm(), 0, 1e-9);
  }
}

TEST(BodyDrag, TurnsABodyWithTheShearInAllThreePlanes)
{
  // u = s x_j e_i turns a body with half the vorticity, about -(e_i x e_j)
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      if (i == j) continue;
      BodyDrag d;
      for (int k = 0; k < 3; ++k)
        for (double s : {-1e-3, 1e-3}) {
          double r[3] = {0, 0, 0}, u[3] = {0, 0, 0};
          r[k] = s;
          u[i] = 2.0 * r[j];
          d.add_sphere(r, 1e-4, u, none);
        }
      const Matrix6d M = mass_of(6e-5, 1e-10), inv = M.inverse();
      Vector6d y = Vector6d::Zero();
      for (int n = 0; n < 2000; ++n)
        y += 1e-2 * inv * drag_wrench(d, y, Vector6d::Zero(), M, inv, 1e-2);
      const Vector3d expected = -Vector3d::Unit(i).cross(Vector3d::Unit(j));
      EXPECT_NEAR((y.tail<3>() - expected).norm(), 0, 1e-9) << i << j;
    }
}

TEST(BodyDrag, IsOfSecondOrderInTheStep)
{
  BodyDrag d;
  const double r[3] = {2e-3, 1e-3, 0}, u[3] = {0.2, 0, 0};
  d.add_sphere(r, 1e-4, u, none);
  d.add_sphere(none, 2e-4, none, none);
  const Matrix6d M = mass_of(1e-5, 4e-11), inv = M.inverse();
  auto run = [&](int steps) {
    Vector6d y = Vector6d::Zero();
    const double dt = 0.05 / steps;
    for (int n = 0; n < steps; ++n)
      y += dt * inv * drag_wrench(d, y, Vector6d::Zero(), M, inv, dt);
    return y;
  };
  const Vector6d fine = run(4096);
  const double ratio = (run(32) - fine).norm() / (run(64) - fine).norm();
  EXPECT_GT(ratio, 3.6);
  EXPECT_LT(ratio, 4.6);
}

TEST(BodyDrag, SeriesAndSolveMeet)
{
  BodyDrag d;
  const double r[3] = {2e-3, 1e-3, -5e-4}, u[3] = {0.2, 0.1, 0};
  d.add_sphere(r, 1e-4, u, none);
  d.add_sphere(none, 2e-4, none, none);
  const Matrix6d M = mass_of(1e-5, 4e-11), inv = M.inverse();
  Vector6d other = Vector6d::Zero();
  other[0] = 1e-5;
  const double norm = (inv * d.R).lpNorm<Eigen::Infinity>();
  const Vector6d below = drag_wrench(d, Vector6d::Zero(), other, M, inv, 0.999999e-3 / norm);
  const Vector6d above = drag_wrench(d, Vector6d::Zero(), other, M, inv, 1.000001e-3 / norm);
  EXPECT_LT((below - above).norm(), 1e-7 * above.norm());
}
