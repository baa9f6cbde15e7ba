// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "clumps/body_resistance.h"

namespace LAMMPS_NS {

using Eigen::Map;
using Eigen::Matrix3d;
using Eigen::Vector3d;

void BodyFlow::add_sphere(const double *r_, double K_, const double *u_, const double *f_)
{
  const Vector3d r(r_[0], r_[1], r_[2]), u(u_[0], u_[1], u_[2]), f(f_[0], f_[1], f_[2]);
  const Vector3d weighted = K_ * r;
  K += K_;
  Kr += weighted;
  Krr += weighted * r.transpose();
  Ku += K_ * u;
  Kru += weighted * u.transpose();
  push += f;
  lever += r * f.transpose();
}

void BodyFlow::motion(const Matrix3d &axes, Vector3d &u, Vector3d &w) const
{
  u.setZero();
  w.setZero();
  if (!(K > 0)) return;
  // about the spheres' weighted centre c, body axes
  const Vector3d c = Kr / K, mean = axes.transpose() * Ku / K;
  const Matrix3d N = Kru * axes - Kr * mean.transpose();
  const Vector3d swirl(N(1, 2) - N(2, 1), N(2, 0) - N(0, 2), N(0, 1) - N(1, 0));
  const Matrix3d S = Krr - Kr * c.transpose();
  const Matrix3d J = S.trace() * Matrix3d::Identity() - S;
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(J);
  const double least = 1e-9 * solver.eigenvalues()[2];
  for (int k = 0; k < 3; k++) {
    const double size = solver.eigenvalues()[k];
    const Vector3d axis = solver.eigenvectors().col(k);
    if (size > least && size > 0) w += axis.dot(swirl) / size * axis;
  }
  u = axes * (mean - w.cross(c));
  w = axes * w;
}

void ResistanceStep::set(const BodyFlow &flow, const Matrix6d &R, double scale_, const Matrix3d &axes,
                         const Matrix6d &mobility, double dt)
{
  scale = scale_;
  Vector3d velocity, spin;
  flow.motion(axes, velocity, spin);
  for (int k = 0; k < 3; k++) {
    u[k] = velocity[k];
    w[k] = spin[k];
    push[k] = flow.push[k];
    for (int j = 0; j < 3; j++) lever[3 * k + j] = flow.lever(k, j);
  }

  Map<Matrix6d> H(response);
  H = body_response(scale * R, flow.added, mobility, dt);
}

void ResistanceStep::wrench(const Matrix6d &R, const double *ex, const double *ey, const double *ez, const double *v,
                            const double *L, const double *inertia, const double *force, const double *torque,
                            double *fluidForce, double *fluidTorque) const
{
  const double *axis[3] = {ex, ey, ez};
  const double slip[3] = {u[0] - v[0], u[1] - v[1], u[2] - v[2]};
  double y[6], m[3][3], e[6], other[6];

  // into body axes
  for (int k = 0; k < 3; k++) {
    const double *a = axis[k];
    const double Lk = a[0] * L[0] + a[1] * L[1] + a[2] * L[2];
    y[k] = a[0] * slip[0] + a[1] * slip[1] + a[2] * slip[2];
    y[k + 3] = a[0] * w[0] + a[1] * w[1] + a[2] * w[2] - (inertia[k] > 0 ? Lk / inertia[k] : 0.0);
    e[k] = a[0] * push[0] + a[1] * push[1] + a[2] * push[2];
    other[k] = a[0] * force[0] + a[1] * force[1] + a[2] * force[2];
    other[k + 3] = a[0] * torque[0] + a[1] * torque[1] + a[2] * torque[2];
    for (int j = 0; j < 3; j++) m[j][k] = a[0] * lever[3 * j] + a[1] * lever[3 * j + 1] + a[2] * lever[3 * j + 2];
  }
  e[3] = m[1][2] - m[2][1];
  e[4] = m[2][0] - m[0][2];
  e[5] = m[0][1] - m[1][0];

  // the fluid's wrench at the start of the step
  for (int j = 0; j < 6; j++) {
    const double *column = R.data() + 6 * j;
    const double s = scale * y[j];
    for (int i = 0; i < 6; i++) e[i] += column[i] * s;
  }
  mean_wrench(response, e, other, ex, ey, ez, fluidForce, fluidTorque);
}

}  // namespace LAMMPS_NS
