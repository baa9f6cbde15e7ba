// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/sound_state.h"

#include <cmath>

namespace clay {

bool is_sound(const SphereArrays &spheres, int n, double dt, double *const *kept, int columns)
{
  for (int i = 0; i < n; i++) {
    const double *x = spheres.x[i], *v = spheres.v[i], *omega = spheres.omega[i];
    const double step = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) * dt;
    double sum = x[0] + x[1] + x[2] + omega[0] + omega[1] + omega[2];
    for (int k = 0; k < columns; k++) sum += kept[i][k];
    // false for NaN, too
    if (!(step <= 2. * spheres.radius[i]) || !std::isfinite(sum)) return false;
  }
  return true;
}

}  // namespace clay
