// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file sound_state.h
/// Whether a state is worth saving.
#pragma once

#include "coupling/sphere_forces.h"

namespace clay {

/// True when none of n spheres is NaN or infinite in its place, velocities and the `columns` numbers
/// kept of it, nor moves more than its diameter in a step of dt [s].
bool is_sound(const SphereArrays &spheres, int n, double dt, double *const *kept, int columns);

}  // namespace clay
