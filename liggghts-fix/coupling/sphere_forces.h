// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file sphere_forces.h
/// The fluid's force on spheres between two exchanges, over plain arrays.
#pragma once

#include <vector>

#include "clumps/group_gravity.h"
#include "coupling/moving_groups.h"

namespace clay {

/// What is kept of the fluid for a sphere: a row of doubles, which moves with it.
/// From FORCE on of free spheres only, those in no body.
struct FluidRow {
  enum {
    DRAG = 0,       ///< K in F = K (u - v) [kg/s]
    VELOCITY = 1,   ///< u [m/s]
    LOAD = 4,       ///< force that does not depend on the motion [N]
    HYDRO = 7,      ///< its part that the hydrostatic pressure has [N], not the fluid's to give
    FRACTION = 10,  ///< void fraction, 0 where nobody asks for it
    FORCE = 11,     ///< of the last step, without that part [N]
    IMPULSE = 14,   ///< received since the last exchange, without that part [N s]
    SLOT = 17,      ///< place in the message, -1 for none
    RELAX = 18,     ///< mean of the slip over a step, of that at its start
    PLACE = 19,     ///< at the last exchange [m]
    SPEED = 22,     ///< velocity then [m/s]
    SEEN = 25,      ///< above 0 when it was there
    SIZE = 26
  };
};

/// And with added mass or torque.
struct InertiaRow {
  enum {
    ADDED = 0,  ///< added mass [kg]
    TURN = 1,   ///< C in T = C (w - spin) [N m s]
    SPIN = 2,   ///< w [rad/s]
    SIZE = 5
  };
};

/// The host's arrays by sphere; a vector is a row of three.
struct SphereArrays {
  double *const *x = nullptr;       ///< centre [m]
  double *const *v = nullptr;       ///< velocity [m/s]
  double *const *omega = nullptr;   ///< angular velocity [rad/s]
  double *const *f = nullptr;       ///< force [N]
  double *const *torque = nullptr;  ///< [N m]
  const double *radius = nullptr;   ///< [m]
  const double *mass = nullptr;     ///< [kg]
  const int *tag = nullptr;
  const int *groups = nullptr;  ///< bits of its groups
  const GroupGravity *gravity = nullptr;
};

/// A random force on each sphere besides.
class RandomForce {
 public:
  virtual ~RandomForce() {}
  /// Force [N] on sphere i over this step, for a drag coefficient K [kg/s].
  virtual void force(int i, double K, double *force) const = 0;
  /// Couple [N m] on it, for a resistance to turning C [N m s].
  virtual void couple(int i, double C, double *couple) const = 0;
};

/// Adds the fluid's mean force over a step dt [s] to f of the spheres listed, and to
/// the impulse they have received, and that all have, unless this is the `first` evaluation
/// of a run. A force of step n acts over [n-1/2, n+1/2], and v is that of n-1/2. `random` may
/// be null.
void push_spheres(const std::vector<int> &list, double *const *fluid, const SphereArrays &spheres,
                  const RandomForce *random, double dt, bool first, double *all);

/// The same for spheres that do not follow the forces on them, along some axis at least: along
/// that load + K (u - v), whatever dt. To f it is not added along the axes that `mute` has.
/// inertia may be null; it acts along the other axes.
void push_held_spheres(const std::vector<int> &list, double *const *fluid, double *const *inertia,
                       const SphereArrays &spheres, const MovingGroups &moving, const AxisGroups &mute,
                       const RandomForce *random, double dt, bool first, double *all);

/// The same with added mass and torque: the sphere's own inertia m gets what it
/// needs to be as fast as m + added would be under all other forces.
void push_inertial_spheres(const std::vector<int> &list, double *const *fluid, double *const *inertia,
                           const SphereArrays &spheres, const RandomForce *random, double dt, bool first, double *all);

/// The fluid's couple on one sphere, solved exactly over a step.
void turn_sphere(int i, double *const *inertia, const SphereArrays &spheres, const RandomForce *random, double dt);

/// A sphere that is kept still: its row and mass [kg].
struct StillSphere {
  const double *row;
  double mass;
};

/// Force on a sphere at rest, of its row [N]: load + K u, without the hydrostatic part.
void still_force(const double *row, double *force);

/// The fluid's forces on spheres that are kept still, from when they came to rest.
class StillForces {
 public:
  /// Marks the forces that hold from now on.
  void mark(const std::vector<StillSphere> &spheres);

  /// True when the force on any of the spheres, the same ones as were marked, differs
  /// from then by more than its mass times `limit` [m/s2], or they are not as many.
  bool changed(const std::vector<StillSphere> &spheres, double limit) const;

 private:
  std::vector<double> marked_;
};

}  // namespace clay
