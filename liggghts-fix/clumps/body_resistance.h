// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file body_resistance.h
/// Drag on a rigid body by its own 6 x 6 resistance, applied implicitly within
/// one DEM step.
#ifndef LMP_BODY_RESISTANCE_H
#define LMP_BODY_RESISTANCE_H

#include "clumps/body_drag.h"

namespace LAMMPS_NS {

/// What a body's spheres see of the fluid and its explicit forces over a
/// coupling interval. The spheres' places are in body axes, the rest in space axes.
struct BodyFlow : AddedInertia {
  double K = 0;                                     ///< sum of K [kg/s]
  Eigen::Vector3d Kr = Eigen::Vector3d::Zero();     ///< sum of K r [kg m/s]
  Eigen::Matrix3d Krr = Eigen::Matrix3d::Zero();    ///< sum of K r r^T [kg m2/s]
  Eigen::Vector3d Ku = Eigen::Vector3d::Zero();     ///< sum of K u [N]
  Eigen::Matrix3d Kru = Eigen::Matrix3d::Zero();    ///< sum of K r u^T [N m]
  Eigen::Vector3d push = Eigen::Vector3d::Zero();   ///< sum of f [N]
  Eigen::Matrix3d lever = Eigen::Matrix3d::Zero();  ///< sum of r f^T [N m]

  /// Adds a sphere at r [m] from the centre of mass, with the weight K [kg/s],
  /// fluid velocity u [m/s] and explicit force f [N].
  void add_sphere(const double *r, double K, const double *u, const double *f);

  /// The rigid motion nearest to the fluid's at the spheres, by weighted least
  /// squares: velocity u of the centre of mass and spin w, space axes; the body's
  /// axes are the columns of `axes`. A spin that moves no sphere's centre is none.
  void motion(const Eigen::Matrix3d &axes, Eigen::Vector3d &u, Eigen::Vector3d &w) const;
};

/// The fluid's action on a body of known resistance, made ready for many steps of
/// one length; all of it in doubles, so that it can travel with a body.
struct ResistanceStep {
  double scale;         ///< factor of the resistance for unit viscosity [Pa s]
  double u[3], w[3];    ///< the fluid's velocity and spin, space axes [m/s, 1/s]
  double push[3];       ///< force that does not depend on the motion [N], space axes
  double lever[9];      ///< row k: its moments along body axis k [N m], space axes
  double response[36];  ///< of the wrench to the motion within the step, by columns

  /// R is for unit viscosity, about the centre of mass, in body axes.
  void set(const BodyFlow &flow, const Matrix6d &R, double scale, const Eigen::Matrix3d &axes, const Matrix6d &mobility,
           double dt);
  void set(const BodyFlow &flow, const Matrix6d &R, double scale, const Eigen::Matrix3d &axes, double mass,
           const double *inertia, double dt)
  {
    set(flow, R, scale, axes, free_mobility(mass, inertia), dt);
  }

  /// Mean force and torque of the fluid over a step, as DragStep::wrench.
  void wrench(const Matrix6d &R, const double *ex, const double *ey, const double *ez, const double *v, const double *L,
              const double *inertia, const double *force, const double *torque, double *fluidForce,
              double *fluidTorque) const;
};

}  // namespace LAMMPS_NS

#endif
