// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file body_drag.h
/// Drag on a sphere or a rigid body, applied implicitly within one DEM step.
#ifndef LMP_BODY_DRAG_H
#define LMP_BODY_DRAG_H

#include <Eigen/Dense>

namespace LAMMPS_NS {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// Added inertia of a rigid body, summed over its spheres.
struct AddedInertia {
  Matrix6d added = Matrix6d::Zero();  ///< [kg, kg m, kg m2], body axes

  /// Adds the added mass m [kg] of a sphere at r [m] from the centre of mass, in
  /// body axes: a force -m dv/dt on it. The turning of r within a step is left out.
  void add_mass(const double *r, double m);
};

/// What the fluid does to a rigid body over a coupling interval, summed over
/// its spheres. The spheres' places are in body axes, where they do not move,
/// what the fluid does to each is in space axes.
struct BodyDrag : AddedInertia {
  double K = 0;                                     ///< sum of K [kg/s]
  Eigen::Vector3d Kr = Eigen::Vector3d::Zero();     ///< sum of K r [kg m/s], body axes
  Eigen::Matrix3d Krr = Eigen::Matrix3d::Zero();    ///< sum of K r r^T [kg m2/s], body axes
  Eigen::Vector3d push = Eigen::Vector3d::Zero();   ///< sum of p = K u + f [N], space axes
  Eigen::Matrix3d lever = Eigen::Matrix3d::Zero();  ///< sum of r p^T [N m], body by space axes

  /// Adds a sphere at r [m] from the centre of mass, in body axes: drag coefficient
  /// K [kg/s], fluid velocity u [m/s] and explicit force f [N] in space axes.
  void add_sphere(const double *r, double K, const double *u, const double *f);

  /// Resistance about the centre of mass [kg/s, kg m/s, kg m2/s] in body axes: the
  /// drag of fluid at rest on a body of velocity and spin y is -R y.
  Matrix6d resistance() const;
};

/// H of DragStep::wrench, for the resistance R about the centre of mass.
Matrix6d body_response(const Matrix6d &R, const Matrix6d &added, double mass, const double *inertia, double dt);

/// The same for a body whose motion answers to force and torque by `mobility`, the inverse of its
/// mass matrix in body axes but for what holds it: zero in held directions.
Matrix6d body_response(const Matrix6d &R, const Matrix6d &added, const Matrix6d &mobility, double dt);

/// Mobility of a free body; what has no inertia does not turn.
Matrix6d free_mobility(double mass, const double *inertia);

/// Of one that forces move along the axes of space in `moves` alone, and torques turn about those in
/// `turns`. Its axes are the columns of `axes`.
Matrix6d held_mobility(double mass, const double *inertia, const Eigen::Matrix3d &axes, const bool *moves,
                       const bool *turns);

/// Mean force and torque over a step, space axes, of a fluid whose wrench at the
/// step's start is e, body axes ex, ey, ez; H, by columns, is its response to the
/// motion that e and the other wrench make in the step.
inline void mean_wrench(const double *H, const double *e, const double *other, const double *ex, const double *ey,
                        const double *ez, double *fluidForce, double *fluidTorque)
{
  double z[6];
  for (int i = 0; i < 6; i++) z[i] = e[i];
  for (int j = 0; j < 6; j++) {
    const double *column = H + 6 * j;
    const double s = other[j] + e[j];
    for (int i = 0; i < 6; i++) z[i] += column[i] * s;
  }
  for (int i = 0; i < 3; i++) {
    fluidForce[i] = ex[i] * z[0] + ey[i] * z[1] + ez[i] * z[2];
    fluidTorque[i] = ex[i] * z[3] + ey[i] * z[4] + ez[i] * z[5];
  }
}

/// A BodyDrag made ready for many steps of one length; all of it in doubles, so
/// that it can travel with a body. Body axes, but for the push.
struct DragStep {
  double K;             ///< translational resistance [kg/s]
  double Kr[3];         ///< its first moment [kg m/s]
  double spin[6];       ///< rotational resistance, xx yy zz xy xz yz [kg m2/s]
  double push[3];       ///< force that does not depend on the motion [N], space axes
  double lever[9];      ///< row k: its moments along body axis k [N m], space axes
  double response[36];  ///< of the wrench to the motion within the step, by columns

  void set(const BodyDrag &drag, const Matrix6d &mobility, double dt);
  void set(const BodyDrag &drag, double mass, const double *inertia, double dt)
  {
    set(drag, free_mobility(mass, inertia), dt);
  }

  /// Mean force and torque of the fluid over a step, space axes. The body has
  /// axes ex, ey, ez, velocity v, angular momentum L, principal moments inertia,
  /// and is pushed by force and torque besides.
  ///
  /// Second order in dt, and L-stable: with A = dt M^-1 R the change of motion is
  /// (1 + A + A^2/2)^-1 (1 + A/2) dt M^-1 (other + e), a rational form of the exact
  /// solution; e is the fluid's wrench at the step's start. With B = dt R M^-1 its
  /// mean is e + H (other + e), H = -(1 + B + B^2/2)^-1 (B/2) (1 + B), and H does
  /// not change in body axes. Steady motion is exact for any dt.
  ///
  /// With added inertia N the change of motion is that of inertia M + N, and the
  /// fluid's mean wrench what M does not take of it: H = G - 1 with
  /// G = M (M + N)^-1 (1 + B + B^2/2)^-1 (1 + B/2), B = dt R (M + N)^-1.
  void wrench(const double *ex, const double *ey, const double *ez, const double *v, const double *L,
              const double *inertia, const double *force, const double *torque, double *fluidForce,
              double *fluidTorque) const;
};

/// Mean drag force per component over a step on a sphere of mass m [kg] that
/// moves with v and is pushed by `other`: F = K (u - v) solved exactly over dt.
double sphere_drag(double K, double u, double v, double other, double m, double dt);

/// The same with explicit force load [N] and added mass [kg]: mean of all that the
/// fluid does, load + K (u - v) - added dv/dt.
double sphere_force(double K, double u, double v, double load, double other, double m, double added, double dt);

/// The factor (1 - exp(-a))/a, accurate for small a.
double relaxation_factor(double a);

}  // namespace LAMMPS_NS

#endif
