// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file motion_record.h
/// What particles did since the last exchange, from which the CFD half foresees
/// how they will answer to the fluid: as free ones, or as something holds them.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "clumps/body_spheres.h"
#include "coupling/sphere_forces.h"
#include "exchange/fields.h"

namespace clay {

using LAMMPS_NS::BodySphere;

/// The time between two exchanges.
struct Interval {
  double time = 0;                     ///< [s]
  std::array<double, 3> gravity{};     ///< where the message does not tell each sphere's [m/s2]
  const GroupGravity *mean = nullptr;  ///< its mean over the interval, where it changes within it
  /// Takes whole periods of the box off a displacement [m]; may be empty.
  std::function<void(double *)> nearest;
};

/// What a body did in it.
struct BodyMotion {
  bool known = false;                    ///< it was there at the last exchange
  std::array<double, 3> displacement{};  ///< of its centre of mass [m]
  std::array<double, 3> change{};        ///< of that one's velocity [m/s]
  std::array<double, 3> velocity{};      ///< of it now [m/s]
  std::array<double, 3> lift{};          ///< of the hydrostatic pressure, by its mass [m/s2]
  int groups = 1;                        ///< bits of the groups by which gravity acts on it
  int spheres = 1;                       ///< that it has, on all processors
};

/// Puts mean velocity, other forces than the fluid's and whether anything but gravity
/// was among these into the message, for spheres that are in it with velocity, mass
/// and impulse, and keeps place and velocity in their rows for the next time. A sphere
/// that is new is taken to have had its velocity, and to be free.
void tell_motion(const std::vector<int> &list, const SphereArrays &spheres, double *const *fluid,
                 const Interval &interval, Particles &message);

/// The same for the spheres of bodies, which stand in the message from place `first`
/// on: they move with the centre of mass and turn as they do now, and what touches the
/// body touches each. Where a body has several, each is held by the others, in whose
/// cells the fluid may move otherwise: it counts as touched, whatever touches the body.
void tell_body_motion(const std::vector<BodySphere> &list, const std::vector<BodyMotion> &bodies,
                      const Interval &interval, int first, Particles &message);

}  // namespace clay
