// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file fluid_output.h
/// What fix couple/foam shows of the fluid: rows of each sphere and of each body,
/// over plain arrays.
#pragma once

#include <vector>

#include "clumps/body_spheres.h"
#include "coupling/sphere_forces.h"

namespace clay {

using LAMMPS_NS::BodySphere;

/// Columns of a sphere, those of the fix's per-atom array.
struct ShownRow {
  enum {
    FORCE = 0,     ///< all that the fluid does, the mean over the step [N]
    DRAG = 3,      ///< K (u - v) alone, likewise [N]
    VELOCITY = 6,  ///< of the fluid at the sphere [m/s]
    FRACTION = 9,  ///< void fraction there
    SIZE = 10
  };
};

/// Columns of a body, those of the fix's local array.
struct ShownBody {
  enum {
    TAG = 0,
    FORCE = 1,      ///< [N]
    DRAG = 4,       ///< [N]
    VELOCITY = 7,   ///< of the fluid, the mean over its spheres by drag coefficient [m/s]
    FRACTION = 10,  ///< void fraction, the mean over its spheres by volume
    SIZE = 11
  };
};

/// Force and drag in a step [N].
struct FluidAction {
  double force[3], drag[3];
};

/// How the last step was done.
struct StepState {
  bool still = false;                    ///< particles were kept still: all of it is load + K u
  double *const *inertia = nullptr;      ///< rows of InertiaRow; null without
  const RandomForce *random = nullptr;   ///< a random force counts as force, not as drag
  const MovingGroups *moving = nullptr;  ///< added mass acts along the axes that are not held; null: all
};

/// Of a sphere in no body, after the fluid's force was added to f. With added mass f must
/// hold all forces there are.
FluidAction sphere_action(int i, double *const *fluid, const SphereArrays &spheres, const StepState &step);

/// Of a sphere of a body that keeps still.
FluidAction still_action(const double *row);

/// Fills the rows of the spheres listed, which are in no body.
void show_spheres(const std::vector<int> &list, double *const *fluid, const SphereArrays &spheres,
                  const StepState &step, double *const *shown);

/// Shares each body's force and drag among its spheres, whose rows then add up to them:
/// what a sphere's own load and K (u - v) are, and its part by K (by volume where there is
/// no drag) of what is left.
void show_body_spheres(const std::vector<BodySphere> &list, const std::vector<FluidAction> &bodies,
                       double *const *fluid, double *const *v, bool still, double *const *shown);

/// Fills the rows of bodies but for their tags.
void show_bodies(const std::vector<BodySphere> &list, const std::vector<FluidAction> &bodies, double *const *fluid,
                 double *const *shown);

}  // namespace clay
