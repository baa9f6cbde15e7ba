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
  double allowed = 1e300;  ///< windows that may be left out now (RestTrack::allowed)
  double height = 0;       ///< mean height above the lowest particle [m]
  double mean = 0;         ///< mean height, from anywhere [m]
};

/// Weights of the places that a rest has shown: 1 for the last, for each one before it less by a sixteenth. So a
/// movement that dies away is forgotten. All particles of a rest have them in common.
class RestWeights {
 public:
  void begin();  ///< one place, where the rest began
  void next();   ///< one more

  double places() const { return w_; }                     ///< sum of the weights
  double age() const { return wa_ / w_; }                  ///< mean age in computed windows
  double spread() const { return waa_ - wa_ * wa_ / w_; }  ///< of the ages about it: sum of squares

  static constexpr double KEPT = 15. / 16.;

 private:
  double w_ = 1, wa_ = 0, waa_ = 0;
};

/// The way of one particle in the last computed windows of a rest: a straight line through
/// its places (least squares) and their scatter about it. A particle that rocks in its place
/// has no slope that stands out of its scatter, one that rolls on a bed at rest has.
struct RestTrack {
  double last[3];    ///< place at the last look [m]
  double begun[3];   ///< place when the rest began [m]
  double y[3];       ///< weighted sum of the ways from there [m]
  double ay[3];      ///< likewise, each times its age
  double yy;         ///< weighted sum of their squares [m^2]
  double missed[3];  ///< estimate of what it missed in all windows left out [m]
  double known;      ///< 0 for a particle that was not there at the last look

  void create();
  /// Way since the last look, squared [m^2].
  double moved2(const double *x) const;
  /// The rest begins where it was at the last look.
  void begin();
  /// Its place after one more window of the rest.
  void see(const double *x);
  /// Its way in a window [m]: the line's slope, less twice that slope's standard error.
  void drift(const RestWeights &, double way[3]) const;
  /// Windows that may be left out before it misses a quarter of what `most` [m] leaves; no bound for one that
  /// goes less than 1e-5 of that in a window.
  double allowed(const RestWeights &, double most) const;
  /// So many windows were left out just now.
  void charge(const RestWeights &, double left_out);
};

/// Counts windows at rest. In a bed at rest a window is computed now and then, after
/// 1, 2, 4 ... windows that are not. The mean height's drift over the last computed
/// windows stands for those that are left out then; what any particle may miss is bounded
/// likewise, by RestSight::allowed.
class RestWatch {
 public:
  RestWatch() { mean_.create(); }
  void restart(const RestLimits &limits);
  /// After a computed window: windows to leave out now. Not `whole`: nothing is known of it.
  int windows(const RestSight &sight, bool whole);
  /// So many were left out in the end.
  void only(double windows) { out_ = windows; }
  /// The rest is over; what was left out last is charged with its drift.
  void wake();

  bool resting() const { return quiet_ > 0; }
  const RestWeights &weights() const { return weights_; }   ///< of the places seen in this rest
  RestWeights weights_with_next() const;                    ///< and of one more, with which a rest may begin
  double missed() const;                                    ///< estimate of what the mean height missed [m]
  double missed_way() const;                                ///< likewise, downwards < 0
  void resume(double missed) { mean_.missed[0] = missed; }  ///< of a saved state

 private:
  void charge();

  RestLimits limits_;
  int quiet_ = 0, row_ = 1;
  double out_ = 0;       // windows left out before the next computed one
  RestWeights weights_;  // of what was seen in this rest
  RestTrack mean_;       // the mean height, as if it were a particle's x
};

}  // namespace clay

#endif
