// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "clumps/body_drag.h"

#include <cmath>

namespace LAMMPS_NS {

using Eigen::Map;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

// S w = r x w
Matrix3d cross_matrix(const Vector3d &r)
{
  Matrix3d S;
  S << 0, -r[2], r[1], r[2], 0, -r[0], -r[1], r[0], 0;
  return S;
}

// of spheres whose velocity is v + omega x r, from the moments of their coefficients
Matrix6d of_moments(double K, const Vector3d &Kr, const Matrix3d &Krr)
{
  Matrix6d R;
  R.topLeftCorner<3, 3>() = K * Matrix3d::Identity();
  R.bottomLeftCorner<3, 3>() = cross_matrix(Kr);
  R.topRightCorner<3, 3>() = -cross_matrix(Kr);
  R.bottomRightCorner<3, 3>() = Krr.trace() * Matrix3d::Identity() - Krr;
  return R;
}

}  // namespace

void BodyDrag::add_sphere(const double *r_, double K_, const double *u, const double *f)
{
  const Vector3d r(r_[0], r_[1], r_[2]);
  const Vector3d p(K_ * u[0] + f[0], K_ * u[1] + f[1], K_ * u[2] + f[2]);
  const Vector3d weighted = K_ * r;
  K += K_;
  Kr += weighted;
  Krr += weighted * r.transpose();
  push += p;
  lever += r * p.transpose();
}

void AddedInertia::add_mass(const double *r_, double m)
{
  const Vector3d r(r_[0], r_[1], r_[2]);
  added += of_moments(m, m * r, m * r * r.transpose());
}

Matrix6d BodyDrag::resistance() const { return of_moments(K, Kr, Krr); }

Matrix6d free_mobility(double mass, const double *inertia)
{
  Vector6d inverse;
  inverse.head<3>().setConstant(1.0 / mass);
  for (int k = 0; k < 3; k++) inverse[k + 3] = inertia[k] > 0 ? 1.0 / inertia[k] : 0.0;
  return inverse.asDiagonal();
}

Matrix6d held_mobility(double mass, const double *inertia, const Matrix3d &axes, const bool *moves, const bool *turns)
{
  Matrix6d free = free_mobility(mass, inertia), mask = Matrix6d::Identity();
  const auto of = [&](const bool *flags) {
    return Matrix3d(axes.transpose() * Vector3d(flags[0], flags[1], flags[2]).asDiagonal() * axes);
  };
  if (!(moves[0] && moves[1] && moves[2])) mask.topLeftCorner<3, 3>() = of(moves);
  if (!(turns[0] && turns[1] && turns[2])) mask.bottomRightCorner<3, 3>() = of(turns);
  return free * mask;
}

Matrix6d body_response(const Matrix6d &R, const Matrix6d &added, double mass, const double *inertia, double dt)
{
  return body_response(R, added, free_mobility(mass, inertia), dt);
}

Matrix6d body_response(const Matrix6d &R, const Matrix6d &added, const Matrix6d &mobility, double dt)
{
  const Matrix6d one = Matrix6d::Identity();

  if (!added.isZero(0)) {
    // M (M + N)^-1 = (1 + N M^-1)^-1, which also holds for what does not turn
    const Matrix6d share = (one + added * mobility).inverse();
    const Matrix6d B = dt * R * mobility * share;
    return share * (one + B + 0.5 * B * B).partialPivLu().solve(one + 0.5 * B) - one;
  }

  const Matrix6d B = dt * R * mobility;
  const Matrix6d B2 = B * B;
  return (one + B + 0.5 * B2).partialPivLu().solve(-0.5 * (B + B2));
}

void DragStep::set(const BodyDrag &drag, const Matrix6d &mobility, double dt)
{
  const Matrix6d R = drag.resistance();
  K = drag.K;
  for (int k = 0; k < 3; k++) spin[k] = R(k + 3, k + 3);
  spin[3] = R(3, 4);
  spin[4] = R(3, 5);
  spin[5] = R(4, 5);
  for (int k = 0; k < 3; k++) {
    Kr[k] = drag.Kr[k];
    push[k] = drag.push[k];
    for (int j = 0; j < 3; j++) lever[3 * k + j] = drag.lever(k, j);
  }
  Map<Matrix6d> H(response);
  H = body_response(R, drag.added, mobility, dt);
}

void DragStep::wrench(const double *ex, const double *ey, const double *ez, const double *v, const double *L,
                      const double *inertia, const double *force, const double *torque, double *fluidForce,
                      double *fluidTorque) const
{
  const double *axis[3] = {ex, ey, ez};
  double motion[3], w[3], p[3], other[6], m[3][3], e[6];

  // into body axes
  for (int k = 0; k < 3; k++) {
    const double *a = axis[k];
    motion[k] = a[0] * v[0] + a[1] * v[1] + a[2] * v[2];
    w[k] = a[0] * L[0] + a[1] * L[1] + a[2] * L[2];
    w[k] = inertia[k] > 0 ? w[k] / inertia[k] : 0.0;
    p[k] = a[0] * push[0] + a[1] * push[1] + a[2] * push[2];
    other[k] = a[0] * force[0] + a[1] * force[1] + a[2] * force[2];
    other[k + 3] = a[0] * torque[0] + a[1] * torque[1] + a[2] * torque[2];
    for (int j = 0; j < 3; j++) m[j][k] = a[0] * lever[3 * j] + a[1] * lever[3 * j + 1] + a[2] * lever[3 * j + 2];
  }

  // the fluid's wrench at the start of the step
  e[0] = p[0] - K * motion[0] - (w[1] * Kr[2] - w[2] * Kr[1]);
  e[1] = p[1] - K * motion[1] - (w[2] * Kr[0] - w[0] * Kr[2]);
  e[2] = p[2] - K * motion[2] - (w[0] * Kr[1] - w[1] * Kr[0]);
  e[3] =
      m[1][2] - m[2][1] - (Kr[1] * motion[2] - Kr[2] * motion[1]) - (spin[0] * w[0] + spin[3] * w[1] + spin[4] * w[2]);
  e[4] =
      m[2][0] - m[0][2] - (Kr[2] * motion[0] - Kr[0] * motion[2]) - (spin[3] * w[0] + spin[1] * w[1] + spin[5] * w[2]);
  e[5] =
      m[0][1] - m[1][0] - (Kr[0] * motion[1] - Kr[1] * motion[0]) - (spin[4] * w[0] + spin[5] * w[1] + spin[2] * w[2]);

  mean_wrench(response, e, other, ex, ey, ez, fluidForce, fluidTorque);
}

double relaxation_factor(double a)
{
  if (std::fabs(a) < 1e-5) return 1.0 - 0.5 * a + a * a / 6.0;
  return -std::expm1(-a) / a;
}

double sphere_drag(double K, double u, double v, double other, double m, double dt)
{
  const double a = K * dt / m;
  const double phi = relaxation_factor(a);
  return phi * K * (u - v) + (phi - 1.0) * other;
}

double sphere_force(double K, double u, double v, double load, double other, double m, double added, double dt)
{
  const double push = load + other;
  return m / (m + added) * (push + sphere_drag(K, u, v, push, m + added, dt)) - other;
}

}  // namespace LAMMPS_NS
