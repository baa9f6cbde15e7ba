// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file body_drag.h
/// Drag on a sphere or a rigid body, applied implicitly within one DEM step.
#ifndef LMP_BODY_DRAG_H
#define LMP_BODY_DRAG_H

#include <Eigen/Dense>

namespace LAMMPS_NS {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// What the fluid does to a rigid body over a coupling interval, about its
/// centre of mass and in space axes; force in rows 0-2, torque in rows 3-5.
///
/// The wrench on a body that moves with y = (v, omega) is drive + load - R y.
struct BodyDrag {
  Matrix6d R = Matrix6d::Zero();     ///< resistance [kg/s, kg m/s, kg m2/s]
  Vector6d drive = Vector6d::Zero(); ///< R times the fluid's motion [N, N m]
  Vector6d load = Vector6d::Zero();  ///< forces that do not depend on y [N, N m]

  /// Adds a sphere at r [m] from the centre of mass: drag coefficient K [kg/s],
  /// fluid velocity u [m/s], explicit force f [N].
  void add_sphere(const double *r, double K, const double *u, const double *f);
};

/// Mean wrench of the fluid over a step of length dt on a body that starts
/// with y0 and is pushed by the wrench `other` as well. inverseMass is the
/// inverse of the 6 x 6 mass matrix in space axes.
///
/// Second order in dt, and L-stable: with A = dt M^-1 R the change of motion is
/// (1 + A + A^2/2)^-1 (1 + A/2) dt M^-1 (other + load + drive - R y0), a rational
/// form of the exact solution. Steady motion is exact for any dt.
Vector6d drag_wrench(const BodyDrag &drag, const Vector6d &y0, const Vector6d &other,
                     const Matrix6d &mass, const Matrix6d &inverseMass, double dt);

/// Mean drag force per component over a step on a sphere of mass m [kg] that
/// moves with v and is pushed by `other`: F = K (u - v) solved exactly over dt.
double sphere_drag(double K, double u, double v, double other, double m, double dt);

/// The factor (1 - exp(-a))/a, accurate for small a.
double relaxation_factor(double a);

}  // namespace LAMMPS_NS

#endif
