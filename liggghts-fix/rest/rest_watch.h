// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file rest_watch.h
/// Decides from the places of particles, seen once in a window of time, whether a
/// bed is at rest and for how many windows it may be left alone.
#ifndef CLAY_REST_WATCH_H
#define CLAY_REST_WATCH_H

namespace clay {

struct RestLimits {
  double move = 0.02;   ///< largest way of a particle in a window, over its radius
  double error = 5e-4;  ///< what the mean height may have missed in all, over that height
  double behind = 0.5;  ///< what any particle may have missed in all, over its radius
  int quiet = 3;        ///< windows at rest before the first is left out
  int longest = 32;     ///< windows left out in a row
};

/// What is seen of the particles in a window, over all processors.
struct RestSight {
  double farthest = 0;     ///< largest way of a particle over its radius
  double allowed = 1e300;  ///< windows that may be left out in this rest (RestTrack::allowed)
  double height = 0;       ///< mean height above the lowest particle [m]
  double mean = 0;         ///< mean height, from anywhere [m]
};

/// The way of one particle over the computed windows of a rest: a straight line through
/// its places (least squares) and their scatter about it. A particle that rocks in its place
/// has no slope that stands out of its scatter, one that rolls on a bed at rest has.
struct RestTrack {
  double last[3];    ///< place at the last look [m]
  double begun[3];   ///< place when the rest began [m]
  double y[3];       ///< sum of the ways from there [m]
  double ty[3];      ///< likewise, each times its number
  double yy;         ///< sum of their squares [m^2]
  double missed[3];  ///< estimate of what it missed in the rests before [m]
  double known;      ///< 0 for a particle that was not there at the last look

  void create();
  /// Way since the last look, squared [m^2].
  double moved2(const double *x) const;
  /// The rest begins where it was at the last look.
  void begin();
  /// Its place after the nth window of the rest, n from 1.
  void see(const double *x, int n);
  /// Its way in a window after n of them [m]: the line's slope, less twice that slope's standard error.
  void drift(int n, double way[3]) const;
  /// Windows that may be left out before it misses a quarter of what `most` [m] leaves; no bound for one that
  /// goes less than 1e-5 of that in a window.
  double allowed(int n, double most) const;
  /// What it has missed in all when so many were left out in this rest, of which n were computed [m].
  void missed_with(int n, double left_out, double all[3]) const;
  /// So many were left out in this rest, of which n were computed.
  void charge(int n, double left_out);
};

/// Counts windows at rest. In a bed at rest a window is computed now and then, after
/// 1, 2, 4 ... windows that are not. The mean height's drift over the computed
/// windows since the bed came to rest stands for those that were left out; what any particle
/// may miss is bounded likewise, by RestSight::allowed.
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
  int computed() const { return computed_; }            ///< windows of this rest
  double left_out() const { return left_out_ + out_; }  ///< likewise
  double missed() const;                                ///< estimate of what the mean height missed [m]
  double missed_way() const;                            ///< likewise, downwards < 0
  void resume(double missed) { missed_ = missed; }      ///< of a saved state

 private:
  double here() const;

  RestLimits limits_;
  int quiet_ = 0, row_ = 1, computed_ = 0;
  double out_ = 0;               // windows left out before the next computed one
  double first_ = 0, mean_ = 0;  // mean height at rest's beginning, and now [m]
  double left_out_ = 0;          // windows since
  double missed_ = 0;            // in the rests before, downwards < 0 [m]
};

}  // namespace clay

#endif
