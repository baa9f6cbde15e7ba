// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file thermal_kick.h
/// Normal random numbers that depend on seed, particle and step alone.
#ifndef LMP_THERMAL_KICK_H
#define LMP_THERMAL_KICK_H

#include <Random123/philox.h>

#include <cmath>
#include <cstdint>

namespace clay {

/// Boltzmann's constant [J/K], exact in the SI.
constexpr double boltzmann = 1.380649e-23;

/// Four independent standard normal numbers of a particle at a step: the same on any number
/// of processors and in any order. `stream` gives a particle more than four. Philox 4x64
/// (Salmon, Moraes, Dror and Shaw 2011) of the counter (tag, step, stream), then Box and Muller.
inline void normals(std::uint64_t seed, std::uint64_t tag, std::uint64_t step, std::uint64_t stream, double *four)
{
  const auto bits = r123::Philox4x64()({{tag, step, stream, 0}}, {{seed, 0}});
  for (int p = 0; p < 2; p++) {
    // 53 bits each: in (0,1] and in [0,1)
    const double u = ((bits[2 * p] >> 11) + 1) * 0x1p-53, v = (bits[2 * p + 1] >> 11) * 0x1p-53;
    const double r = std::sqrt(-2 * std::log(u));
    four[2 * p] = r * std::cos(2 * M_PI * v);
    four[2 * p + 1] = r * std::sin(2 * M_PI * v);
  }
}

/// Deviation of the random force per component [N] that, held over a step dt [s] on a particle
/// of drag coefficient K [kg/s] at temperature T [K], gives diffusion at kT/K whatever dt.
inline double thermal_force(double K, double T, double dt) { return std::sqrt(2 * boltzmann * T * K / dt); }

}  // namespace clay

#endif
