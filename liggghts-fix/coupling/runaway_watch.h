// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file runaway_watch.h
/// Ends a run that goes astray, with the particle, its place and since when.
#ifndef LMP_RUNAWAY_WATCH_H
#define LMP_RUNAWAY_WATCH_H

#include <functional>
#include <string>

#include "pointers.h"

namespace LAMMPS_NS {

class RunawayWatch : protected Pointers {
 public:
  explicit RunawayWatch(class LAMMPS *lmp);
  virtual ~RunawayWatch() = default;

  /// Marks the start of a run.
  void start();
  /// To be called in every step; looks at the speeds in every tenth: none may
  /// be NaN or carry a sphere past another's diameter in a step.
  void step();
  /// Before particles change places: none may have left the box where it ends,
  /// LIGGGHTS would drop it without a word.
  /// may_leave(i): sphere i has left the fluid, it may leave the box as well.
  void places(const std::function<bool(int)> &may_leave = [](int) { return false; });
  /// At an exchange, with the largest overlap of two particles over d.
  void overlaps(double overlap, int tag1, int tag2);
  /// What is said behind the reason when it ends a run.
  void last_words(const std::string &text) { last_words_ = text; }
  /// Largest overlap with a wall, over d, that was seen at an exchange.
  double wall_overlap() const { return wall_overlap_; }

  /// Overlap over d at which a run ends: the springs do not hold the load.
  static constexpr double most_overlap = 0.4;

 protected:
  /// Ends the run with that text.
  virtual void end(const std::string &text);

 private:
  void stop(int i, const char *why, bigint since);

  bigint checked_, held_;  // last steps at which speeds and overlaps were well
  double wall_overlap_;
  std::string last_words_;
};

}  // namespace LAMMPS_NS

#endif
