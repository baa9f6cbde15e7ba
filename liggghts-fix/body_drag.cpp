// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "body_drag.h"

#include <cmath>

namespace LAMMPS_NS {

using Eigen::Matrix3d;
using Eigen::Vector3d;

void BodyDrag::add_sphere(const double *r_, double K, const double *u_, const double *f_)
{
  const Eigen::Map<const Vector3d> r(r_), u(u_), f(f_);
  Matrix3d S;  // S w = r x w
  S << 0, -r[2], r[1], r[2], 0, -r[0], -r[1], r[0], 0;

  // the sphere's velocity is v + omega x r = v - S omega
  R.topLeftCorner<3, 3>().diagonal().array() += K;
  R.topRightCorner<3, 3>() -= K * S;
  R.bottomLeftCorner<3, 3>() += K * S;
  R.bottomRightCorner<3, 3>() -= K * S * S;
  drive.head<3>() += K * u;
  drive.tail<3>() += K * r.cross(u);
  load.head<3>() += f;
  load.tail<3>() += r.cross(f);
}

Vector6d drag_wrench(const BodyDrag &drag, const Vector6d &y0, const Vector6d &other,
                     const Matrix6d &mass, const Matrix6d &inverseMass, double dt)
{
  const Vector6d start = drag.drive + drag.load - drag.R * y0;
  const Matrix6d A = dt * inverseMass * drag.R;
  const Vector6d b = dt * inverseMass * (other + start);

  Vector6d change;
  // a weak drag needs no solve: the next term of the series is below 1e-10
  if (A.lpNorm<Eigen::Infinity>() < 1e-3) {
    const Vector6d Ab = A * b;
    change = b - 0.5 * Ab + A * Ab / 6.0;
  } else {
    const Matrix6d lhs = Matrix6d::Identity() + A + 0.5 * A * A;
    change = lhs.partialPivLu().solve(b + 0.5 * (A * b));
  }
  return mass * change / dt - other;
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

}  // namespace LAMMPS_NS
