// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "clumps/body_resistance.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace LAMMPS_NS;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

const double place[4][3] = {{2e-3, 1e-3, 0}, {-1e-3, 0, 3e-3}, {0, -2e-3, -1e-3}, {1e-3, 1e-3, 1e-3}};
const double weight[4] = {1e-4, 3e-4, 2e-4, 1.5e-4};
const double force[4][3] = {{1e-5, 0, 2e-5}, {0, -1e-5, 0}, {3e-5, 0, 1e-5}, {0, 2e-5, 0}};

Matrix3d some_axes() { return Eigen::AngleAxisd(1.1, Vector3d(1, 2, -1).normalized()).toRotationMatrix(); }

/// The fluid of one rigid motion at the spheres, as both ways of drag see it.
struct Both {
  BodyDrag sum;
  BodyFlow flow;
  Both(const Matrix3d &axes, const Vector3d &U, const Vector3d &W, int spheres = 4)
  {
    for (int n = 0; n < spheres; n++) {
      const Vector3d r = axes * Vector3d(place[n][0], place[n][1], place[n][2]);
      const Vector3d u = U + W.cross(r);
      sum.add_sphere(place[n], weight[n], u.data(), force[n]);
      flow.add_sphere(place[n], weight[n], u.data(), force[n]);
    }
  }
};

/// Any symmetric positive matrix of a body's size, with all its couplings.
Matrix6d some_resistance()
{
  Matrix6d R;
  R << 9, 1, -1, .4, .8, -.3, 1, 7, 2, -.5, .6, .2, -1, 2, 8, .3, -.2, .7, .4, -.5, .3, 4, .5, -.6, .8, .6, -.2, .5, 5,
      .3, -.3, .2, .7, -.6, .3, 6;
  R.topRightCorner<3, 3>() *= 1e-3;
  R.bottomLeftCorner<3, 3>() *= 1e-3;
  R.bottomRightCorner<3, 3>() *= 1e-6;
  return R;
}

}  // namespace

TEST(BodyFlow, FindsTheRigidMotionOfTheFluid)
{
  const Vector3d U(0.1, -0.2, 0.3), W(20, -30, 10);
  const Both both(some_axes(), U, W);
  Vector3d u, w;
  both.flow.motion(some_axes(), u, w);
  EXPECT_LT((u - U).norm(), 1e-14);
  EXPECT_LT((w - W).norm(), 1e-12 * W.norm());
}

TEST(BodyFlow, SeesNoSpinAboutALineOfSpheresAndNoneOfOneSphere)
{
  const Vector3d U(0.1, -0.2, 0.3), W(20, -30, 10);
  const Matrix3d axes = some_axes();
  Vector3d u, w;
  const Both two(axes, U, W, 2);
  two.flow.motion(axes, u, w);
  const Vector3d line =
      (axes * (Vector3d(place[1][0], place[1][1], place[1][2]) - Vector3d(place[0][0], place[0][1], place[0][2])))
          .normalized();
  EXPECT_LT((w - (W - W.dot(line) * line)).norm(), 1e-11 * W.norm());
  const Both one(axes, U, W, 1);
  one.flow.motion(axes, u, w);
  EXPECT_EQ(w.norm(), 0);
  EXPECT_LT((u - U - W.cross(axes * Vector3d(place[0][0], place[0][1], place[0][2]))).norm(), 1e-14);
  BodyFlow().motion(axes, u, w);
  EXPECT_EQ(u.norm() + w.norm(), 0);
}

namespace {

void is_the_sum(double added)
{
  const Matrix3d axes = some_axes();
  Both both(axes, Vector3d(0.1, -0.2, 0.3), Vector3d(20, -30, 10));
  for (int n = 0; n < 4 && added > 0; n++) {
    both.sum.add_mass(place[n], (n + 1) * added);
    both.flow.add_mass(place[n], (n + 1) * added);
  }
  const double mu = 1e-3, m = 1e-4, I[3] = {1e-10, 3e-10, 2e-10};
  const Matrix6d R = both.sum.resistance() / mu;
  const Vector3d v(0.02, -0.1, 0.3), L = axes * Vector3d(5e-10, -3e-10, 20e-10);
  const double other[6] = {1e-4, -2e-4, 1e-5, 1e-7, 2e-7, -3e-7};
  for (double dt : {1e-7, 1e-3, 10.0}) {
    DragStep sum;
    sum.set(both.sum, m, I, dt);
    ResistanceStep whole;
    whole.set(both.flow, R, mu, axes, m, I, dt);
    Vector6d a, b;
    const double *ex = axes.col(0).data(), *ey = axes.col(1).data(), *ez = axes.col(2).data();
    sum.wrench(ex, ey, ez, v.data(), L.data(), I, other, other + 3, a.data(), a.data() + 3);
    whole.wrench(R, ex, ey, ez, v.data(), L.data(), I, other, other + 3, b.data(), b.data() + 3);
    EXPECT_LT((a - b).head<3>().norm(), 1e-12 * a.head<3>().norm()) << dt;
    EXPECT_LT((a - b).tail<3>().norm(), 1e-11 * a.tail<3>().norm()) << dt;
  }
}

}  // namespace

TEST(ResistanceStep, WithTheResistanceOfTheSumIsTheSum) { is_the_sum(0); }

TEST(ResistanceStep, TakesAddedMassAsTheSumDoes) { is_the_sum(3e-5); }

TEST(ResistanceStep, EndsAtTheMotionWhereAllIsInBalanceForAnyStep)
{
  const Matrix3d axes = some_axes();
  const Vector3d U(0.1, -0.2, 0.3), W(2, -3, 1);
  BodyFlow flow;
  const double none[3] = {0, 0, 0};
  for (int n = 0; n < 4; n++) {
    const Vector3d u = U + W.cross(axes * Vector3d(place[n][0], place[n][1], place[n][2]));
    flow.add_sphere(place[n], weight[n], u.data(), none);
  }
  const Matrix6d R = some_resistance();
  const double mu = 1e-3, m = 1e-5, I[3] = {1e-10, 3e-10, 2e-10};
  Vector6d other;
  other << 1e-4, -2e-4, 1e-5, 1e-8, 2e-8, -3e-8;
  Matrix6d Q = Matrix6d::Zero();
  Q.topLeftCorner<3, 3>() = Q.bottomRightCorner<3, 3>() = axes;
  Vector6d expected = (mu * Q * R * Q.transpose()).ldlt().solve(other);
  expected.head<3>() += U;
  expected.tail<3>() += W;
  for (double dt : {1e-3, 1.0, 100.0}) {
    ResistanceStep step;
    step.set(flow, R, mu, axes, m, I, dt);
    Vector6d y = Vector6d::Zero();  // axes held in place
    const Matrix3d J = axes * Vector3d(I[0], I[1], I[2]).asDiagonal() * axes.transpose();
    for (int n = 0; n < 4000; n++) {
      Vector6d w;
      const Vector3d L = J * y.tail<3>();
      step.wrench(R, axes.col(0).data(), axes.col(1).data(), axes.col(2).data(), y.data(), L.data(), I, other.data(),
                  other.data() + 3, w.data(), w.data() + 3);
      w += other;
      y.head<3>() += dt / m * w.head<3>();
      y.tail<3>() += dt * (J.inverse() * w.tail<3>());
    }
    EXPECT_LT((y - expected).norm(), 1e-9 * expected.norm()) << dt;
  }
}

TEST(ResistanceStep, IsSecondOrderInTheStep)
{
  // against the exact solution of M dy/dt = -mu R y + other, axes held in place
  const Matrix6d R = some_resistance();
  const double mu = 1e-3, m = 1e-3, I[3] = {1e-9, 3e-9, 2e-9}, T = 0.1;
  Vector6d other, inertia;
  other << 1e-3, -2e-3, 1e-3, 1e-7, 2e-7, -3e-7;
  inertia << m, m, m, I[0], I[1], I[2];
  const Vector6d root = inertia.cwiseSqrt();
  const Matrix6d A = root.cwiseInverse().asDiagonal() * (mu * R) * root.cwiseInverse().asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Matrix6d> eigen(A);
  Vector6d z = eigen.eigenvectors().transpose() * root.cwiseInverse().cwiseProduct(other);
  for (int k = 0; k < 6; k++) z[k] *= -std::expm1(-eigen.eigenvalues()[k] * T) / eigen.eigenvalues()[k];
  const Vector6d exact = root.cwiseInverse().cwiseProduct(eigen.eigenvectors() * z);

  const Matrix3d axes = Matrix3d::Identity();
  double before = 0;
  for (int steps : {50, 100, 200}) {
    ResistanceStep step;
    step.set(BodyFlow(), R, mu, axes, m, I, T / steps);
    Vector6d y = Vector6d::Zero();
    for (int n = 0; n < steps; n++) {
      Vector6d w;
      const Vector3d L = Vector3d(I[0], I[1], I[2]).cwiseProduct(y.tail<3>());
      step.wrench(R, axes.col(0).data(), axes.col(1).data(), axes.col(2).data(), y.data(), L.data(), I, other.data(),
                  other.data() + 3, w.data(), w.data() + 3);
      y += T / steps * inertia.cwiseInverse().cwiseProduct(w + other);
    }
    const double error = ((y - exact).cwiseQuotient(exact)).norm();
    if (before > 0) { EXPECT_NEAR(before / error, 4, 0.5) << steps; }
    before = error;
  }
  EXPECT_LT(before, 1e-3);
}
