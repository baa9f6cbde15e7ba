// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "clumps/body_drag.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

using namespace LAMMPS_NS;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

const double none[3] = {0, 0, 0};

Matrix6d mass_of(double m, const Vector3d &I)
{
  Vector6d d;
  d << m, m, m, I;
  return d.asDiagonal();
}

/// A body of fixed axes: velocity and spin under a constant wrench and the fluid.
struct Body {
  double m;
  Vector3d I;
  Matrix3d axes = Matrix3d::Identity();
  Vector6d y = Vector6d::Zero();

  Vector6d wrench(const BodyDrag &drag, const Vector6d &other, double dt) const
  {
    DragStep step;
    step.set(drag, m, I.data(), dt);
    const Vector3d L = axes * I.asDiagonal() * axes.transpose() * y.tail<3>();
    Vector6d w;
    step.wrench(axes.col(0).data(), axes.col(1).data(), axes.col(2).data(), y.data(), L.data(), I.data(), other.data(),
                other.data() + 3, w.data(), w.data() + 3);
    return w;
  }

  void march(const BodyDrag &drag, const Vector6d &other, double dt)
  {
    const Vector6d w = other + wrench(drag, other, dt);
    y.head<3>() += dt / m * w.head<3>();
    y.tail<3>() += dt * (axes * I.cwiseInverse().asDiagonal() * axes.transpose() * w.tail<3>());
  }
};

Body a_body(double m, double I) { return {m, Vector3d::Constant(I)}; }

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

TEST(SphereDrag, IsNothingWithoutDrag) { EXPECT_EQ(sphere_drag(0, 5, 1, 3, 1e-5, 1e-3), 0); }

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
  const Vector6d w = a_body(m, 1e-12).wrench(d, Vector6d::Zero(), dt);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(w[k], f[k] + sphere_drag(2e-4, u[k], 0, f[k], m, dt), 1e-12);
  EXPECT_EQ(w.tail<3>().norm(), 0);
}

TEST(BodyDrag, ResistanceIsThatOfItsSpheres)
{
  BodyDrag d;
  const double place[3][3] = {{2e-3, 1e-3, 0}, {-1e-3, 0, 3e-3}, {0, -2e-3, -1e-3}};
  const double K[3] = {1e-4, 3e-4, 2e-4};
  for (int n = 0; n < 3; ++n) d.add_sphere(place[n], K[n], none, none);
  Vector6d y;
  y << 0.1, -0.2, 0.3, 20, 40, -10;
  Vector6d expected = Vector6d::Zero();
  for (int n = 0; n < 3; ++n) {
    const Vector3d r(place[n][0], place[n][1], place[n][2]);
    const Vector3d f = -K[n] * (y.head<3>() + y.tail<3>().cross(r));
    expected.head<3>() += f;
    expected.tail<3>() += r.cross(f);
  }
  EXPECT_LT((d.resistance() * y + expected).head<3>().norm(), 1e-15 * expected.head<3>().norm() * 10);
  EXPECT_LT((d.resistance() * y + expected).tail<3>().norm(), 1e-15 * expected.tail<3>().norm() * 10);
}

TEST(BodyDrag, IsThatOfItsSpheresHoweverItIsTurned)
{
  // in a step too short for the motion to change, and however long by the formula
  BodyDrag d;
  const double place[3][3] = {{2e-3, 1e-3, 0}, {-1e-3, 0, 3e-3}, {0, -2e-3, -1e-3}};
  const double K[3] = {1e-4, 3e-4, 2e-4};
  const double u[3][3] = {{0.1, 0, 0}, {0, 0.2, -0.1}, {0.05, 0, 0.3}};
  const double f[3][3] = {{1e-5, 0, 2e-5}, {0, -1e-5, 0}, {3e-5, 0, 1e-5}};
  for (int n = 0; n < 3; ++n) d.add_sphere(place[n], K[n], u[n], f[n]);

  Body body{1e-4, Vector3d(1e-10, 3e-10, 2e-10)};
  body.axes = Eigen::AngleAxisd(1.1, Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  body.y << 0.02, -0.1, 0.3, 5, -3, 20;
  Vector6d other, start = Vector6d::Zero();
  other << 1e-4, -2e-4, 1e-5, 1e-7, 2e-7, -3e-7;
  Matrix6d R = Matrix6d::Zero(), turn = Matrix6d::Zero();
  for (int n = 0; n < 3; ++n) {
    const Vector3d r = body.axes * Vector3d(place[n][0], place[n][1], place[n][2]);
    const Vector3d slip = Vector3d(u[n][0], u[n][1], u[n][2]) - body.y.head<3>() - body.y.tail<3>().cross(r);
    const Vector3d p = K[n] * slip + Vector3d(f[n][0], f[n][1], f[n][2]);
    start.head<3>() += p;
    start.tail<3>() += r.cross(p);
  }
  const Vector6d now = body.wrench(d, other, 1e-12);
  EXPECT_LT((now - start).head<3>().norm(), 1e-8 * start.head<3>().norm());
  EXPECT_LT((now - start).tail<3>().norm(), 1e-8 * start.tail<3>().norm());

  turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() = body.axes;
  R = turn * d.resistance() * turn.transpose();
  const Matrix6d M = turn * mass_of(body.m, body.I) * turn.transpose(), inv = M.inverse();
  for (double dt : {1e-6, 1e-3, 0.1, 10.0}) {
    const Matrix6d A = dt * inv * R, one = Matrix6d::Identity();
    const Vector6d b = dt * inv * (other + start);
    const Vector6d change = (one + A + 0.5 * A * A).fullPivLu().solve((one + 0.5 * A) * b);
    const Vector6d expected = M * change / dt - other, w = body.wrench(d, other, dt);
    EXPECT_LT((w - expected).head<3>().norm(), 1e-9 * expected.head<3>().norm()) << "dt " << dt;
    EXPECT_LT((w - expected).tail<3>().norm(), 1e-9 * expected.tail<3>().norm()) << "dt " << dt;
  }
}

TEST(BodyDrag, ReachesItsTerminalVelocityWithAnyStep)
{
  BodyDrag d;
  const double r1[3] = {1e-3, 0, 0}, r2[3] = {-1e-3, 0, 0};
  d.add_sphere(r1, 1e-4, none, none);
  d.add_sphere(r2, 1e-4, none, none);
  const double m = 2e-5;
  Vector6d weight = Vector6d::Zero();
  weight[2] = -m * 9.81;
  for (double dt : {1e-4, 1e-2, 1.0, 1e3}) {
    Body body = a_body(m, 2e-11);
    for (int n = 0; n < 40000 && n * dt < 40; ++n) body.march(d, weight, dt);
    for (int n = 0; n < 60; ++n) body.march(d, weight, dt);
    EXPECT_NEAR(body.y[2], -m * 9.81 / 2e-4, 1e-9) << "dt " << dt;
    EXPECT_NEAR(body.y.tail<3>().norm(), 0, 1e-9);
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
      Body body = a_body(6e-5, 1e-10);
      for (int n = 0; n < 2000; ++n) body.march(d, Vector6d::Zero(), 1e-2);
      const Vector3d expected = -Vector3d::Unit(i).cross(Vector3d::Unit(j));
      EXPECT_NEAR((body.y.tail<3>() - expected).norm(), 0, 1e-9) << i << j;
    }
}

TEST(BodyDrag, IsOfSecondOrderInTheStep)
{
  BodyDrag d;
  const double r[3] = {2e-3, 1e-3, 0}, u[3] = {0.2, 0, 0};
  d.add_sphere(r, 1e-4, u, none);
  d.add_sphere(none, 2e-4, none, none);
  auto run = [&](int steps) {
    Body body = a_body(1e-5, 4e-11);
    for (int n = 0; n < steps; ++n) body.march(d, Vector6d::Zero(), 0.05 / steps);
    return body.y;
  };
  const Vector6d fine = run(4096);
  const double ratio = (run(32) - fine).norm() / (run(64) - fine).norm();
  EXPECT_GT(ratio, 3.6);
  EXPECT_LT(ratio, 4.6);
}

TEST(BodyDrag, WeakDragKeepsItsDigits)
{
  // far below one part of the push
  BodyDrag d;
  d.add_sphere(none, 1e-9, none, none);
  const double m = 1e-2, dt = 1e-3, a = 1e-9 * dt / m;
  Vector6d push = Vector6d::Zero();
  push[0] = 1;
  const Vector6d w = a_body(m, 1e-8).wrench(d, push, dt);
  EXPECT_NEAR(w[0], -0.5 * a, 1e-10 * a);
}

TEST(BodyDrag, LeavesABodyWithoutInertiaUnturned)
{
  BodyDrag d;
  const double r[3] = {1e-3, 0, 0}, u[3] = {0, 0.1, 0};
  d.add_sphere(r, 1e-4, u, none);
  Body body{1e-5, Vector3d(0, 1e-11, 0)};
  const Vector6d w = body.wrench(d, Vector6d::Zero(), 1e-2);
  EXPECT_TRUE(w.allFinite());
  EXPECT_NEAR(w[1], sphere_drag(1e-4, 0.1, 0, 0, 1e-5, 1e-2), 2e-3 * w[1]);
}

TEST(SphereForce, IsExactWithAddedMassForAnyStepAndAnyDensity)
{
  // (m + a) dv/dt = load + K (u - v) + other; the fluid's part is m dv/dt - other
  const double K = 2e-4, u = 0.3, load = 5e-5, v0 = -0.1;
  for (double m : {0.0, 1e-9, 1e-7, 1e-5})
    for (double dt : {1e-7, 1e-4, 1e-2, 1.0}) {
      const double added = 2e-6, other = -9.81 * m, vinf = u + (load + other) / K;
      const double change = (vinf - v0) * -std::expm1(-K * dt / (m + added));
      const double force = sphere_force(K, u, v0, load, other, m, added, dt);
      EXPECT_NEAR(other + force, m * change / dt, 1e-12 * K) << "m " << m << " dt " << dt;
    }
}

TEST(SphereForce, WithoutAddedMassIsLoadAndDrag)
{
  EXPECT_NEAR(sphere_force(2e-4, 0.3, 0.1, 1e-5, -3e-5, 1e-6, 0, 1e-3),
              1e-5 + sphere_drag(2e-4, 0.3, 0.1, -2e-5, 1e-6, 1e-3), 1e-18);
}

TEST(BodyDrag, WithAddedMassAcceleratesAsTheSumOfTheInertias)
{
  // no drag: M dy/dt = M (M + N)^-1 (other + push), however the body is turned
  const double place[3][3] = {{2e-3, 1e-3, 0}, {-1e-3, 0, 3e-3}, {0, -2e-3, -1e-3}};
  const double a[3] = {2e-4, 4e-4, 1e-4}, f[3] = {1e-4, -3e-4, 2e-4};
  for (double m : {1e-6, 1e-4, 1e-2}) {
    BodyDrag d;
    Body body{m, m * Vector3d(1e-6, 3e-6, 2e-6)};
    body.axes = Eigen::AngleAxisd(1.1, Vector3d(1, 2, -1).normalized()).toRotationMatrix();
    Matrix6d N = Matrix6d::Zero();
    Vector6d other;
    other << 1e-4, -2e-4, 1e-5, 1e-7, 2e-7, -3e-7;
    Vector6d push = other;
    for (int n = 0; n < 3; ++n) {
      d.add_sphere(place[n], 0, none, f);
      d.add_mass(place[n], a[n]);
      const Vector3d r = body.axes * Vector3d(place[n][0], place[n][1], place[n][2]);
      Matrix3d S;
      S << 0, -r[2], r[1], r[2], 0, -r[0], -r[1], r[0], 0;
      Eigen::Matrix<double, 3, 6> J;  // of the sphere's velocity
      J << Matrix3d::Identity(), -S;
      N += a[n] * J.transpose() * J;
      push += J.transpose() * Vector3d(f[0], f[1], f[2]);
    }
    Matrix6d turn = Matrix6d::Zero();
    turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() = body.axes;
    const Matrix6d M = turn * mass_of(body.m, body.I) * turn.transpose();
    const Vector6d expected = M * (M + N).fullPivLu().solve(push) - other;
    const Vector6d w = body.wrench(d, other, 1e-4);
    EXPECT_LT((w - expected).head<3>().norm(), 1e-10 * expected.head<3>().norm()) << m;
    EXPECT_LT((w - expected).tail<3>().norm(), 1e-10 * expected.tail<3>().norm()) << m;
  }
}

TEST(BodyDrag, WithAddedMassRelaxesExactlyToSecondOrder)
{
  // a sphere as a body: v = u (1 - exp(-K t/(m + a))), also when m << a
  const double K = 1e-4, m = 1e-7, a = 5e-6, u[3] = {0.2, 0, 0};
  BodyDrag d;
  d.add_sphere(none, K, u, none);
  d.add_mass(none, a);
  const double t = 0.1;
  auto error = [&](int steps) {
    Body body = a_body(m, 1e-13);
    for (int n = 0; n < steps; ++n) body.march(d, Vector6d::Zero(), t / steps);
    return std::fabs(body.y[0] - 0.2 * -std::expm1(-K * t / (m + a)));
  };
  EXPECT_LT(error(64), 1e-4 * 0.2);
  EXPECT_NEAR(error(64) / error(128), 4, 0.3);
}

TEST(DragStep, aBodyThatIsHeldGetsTheWholeDragWhateverTheStep)
{
  const double inf = std::numeric_limits<double>::infinity(), held[3] = {inf, inf, inf}, I[3] = {1e-9, 2e-9, 3e-9};
  BodyDrag drag;
  const double r[3] = {1e-3, 0, 0}, u[3] = {0.1, 0.2, 0}, load[3] = {0, 0, 3e-5};
  drag.add_sphere(r, 2e-4, u, load);
  const double ex[3] = {1, 0, 0}, ey[3] = {0, 1, 0}, ez[3] = {0, 0, 1}, other[3] = {1, 2, 3};
  for (double dt : {1e-7, 1e-2, 10.0}) {
    DragStep step;
    step.set(drag, inf, held, dt);
    double F[3], T[3];
    step.wrench(ex, ey, ez, none, none, I, other, other, F, T);
    EXPECT_DOUBLE_EQ(F[0], 2e-5);
    EXPECT_DOUBLE_EQ(F[1], 4e-5);
    EXPECT_DOUBLE_EQ(F[2], 3e-5);
    EXPECT_DOUBLE_EQ(T[1], -3e-8);
    EXPECT_DOUBLE_EQ(T[2], 4e-8);
  }
}

// flags of a template hold it along axes of space: there all of the drag whatever the step,
// along the others that of a free body
TEST(DragStep, aBodyThatIsHeldAlongSomeAxes)
{
  const double m = 1e-6, I[3] = {1e-13, 1e-13, 1e-13}, u[3] = {0.1, 0.2, 0.3};
  BodyDrag drag;
  drag.add_sphere(none, 2e-4, u, none);
  const double turned = std::sqrt(0.5);
  Matrix3d axes;  // by 45 degrees about z
  axes << turned, -turned, 0, turned, turned, 0, 0, 0, 1;
  const double ex[3] = {turned, turned, 0}, ey[3] = {-turned, turned, 0}, ez[3] = {0, 0, 1};
  const double other[3] = {1e-4, 2e-4, 3e-4};
  for (bool turns : {true, false})
    for (double dt : {1e-5, 1.0}) {
      const bool moves[3] = {true, false, true}, spins[3] = {turns, turns, true}, always[3] = {true, true, true};
      DragStep step, free;
      step.set(drag, held_mobility(m, I, axes, moves, spins), dt);
      free.set(drag, held_mobility(m, I, axes, always, always), dt);
      double F[3], T[3], G[3];
      step.wrench(ex, ey, ez, none, none, I, other, none, F, T);
      free.wrench(ex, ey, ez, none, none, I, other, none, G, T);
      EXPECT_NEAR(F[0], G[0], 1e-12);
      EXPECT_NEAR(F[1], 2e-4 * u[1], 1e-15);
      EXPECT_NEAR(F[2], G[2], 1e-12);
      DragStep plain;
      plain.set(drag, m, I, dt);
      for (int k = 0; k < 36; k++) EXPECT_EQ(free.response[k], plain.response[k]);
    }
}
