// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file rest_watch.h
/// Decides from the places of particles, seen once in a window of time, whether a
/// bed is at rest and for how many windows it may be left alone.
#ifndef CLAY_REST_WATCH_H
#define CLAY_REST_WATCH_H

#include <vector>

namespace clay {

struct RestLimits {
  double move = 0.02;  ///< largest way of a particle in a window, over its radius
  double error = 5e-4;  ///< sum of what the mean height may have missed, over that height
  double behind = 0.5;  ///< sum of what any particle may have missed, over its radius
  int quiet = 3;        ///< windows at rest before the first is left out
  int longest = 32;     ///< windows left out in a row
};

/// What is seen of the particles in a window, over all processors.
struct RestSight {
  double farthest = 0;  ///< largest way of a particle over its radius
  double gone = 0;      ///< likewise since the rest began
  double height = 0;    ///< mean height above the lowest particle [m]
  double mean = 0;      ///< mean height, from anywhere [m]
};

/// Places of particles, to be compared with later ones.
class RestPlaces {
 public:
  void keep(const double *x, int n) { x_.assign(x, x + 3 * n); }
  void forget() { x_.clear(); }
  int size() const { return static_cast<int>(x_.size() / 3); }
  /// Largest way since of a particle, over its radius.
  double farthest(const double *x, const double *radius) const;

 private:
  std::vector<double> x_;
};

/// Counts windows at rest. In a bed at rest a window is computed now and then, after
/// 1, 2, 4 ... windows that are not. The mean height's drift over the computed
/// windows since the bed came to rest stands for those that were left out; particles
/// that rock in their places add nothing to it in the long run. So does each particle's own
/// way since, whatever its direction, for a particle that rolls on a bed at rest.
class RestWatch {
 public:
  void restart(const RestLimits &limits);
  /// After a computed window: windows to leave out now. Not `whole`: nothing is known of it.
  int windows(const RestSight &sight, bool whole);
  /// So many were left out in the end.
  void only(double windows) { out_ = windows; }
  /// The rest is over; what was left out so far is charged with its drift.
  void wake();

  bool resting() const { return quiet_ > 0; }
  double missed() const { return missed_ + here(); }  ///< estimate of what the mean height missed [m]

 private:
  RestLimits limits_;
  double here() const;

  int quiet_ = 0, row_ = 1;
  double out_ = 0;                      // windows left out before the next computed one
  double first_ = 0, mean_ = 0;         // mean height at rest's beginning, and now [m]
  double computed_ = 0, left_out_ = 0;  // windows since
  double missed_ = 0;                   // in the rests before [m]
  double gone_ = 0, behind_ = 0;        // largest way in this rest; missed of such in those before, in radii
};

}  // namespace clay

#endif
