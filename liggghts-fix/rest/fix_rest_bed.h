/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   fix ID all rest/bed: steps of a bed in which nothing moves are not
   computed. Described in doc/fix_rest_bed.md.
------------------------------------------------------------------------- */

#ifdef FIX_CLASS

FixStyle(rest/bed,FixRestBed)

#else

#ifndef LMP_FIX_REST_BED_H
#define LMP_FIX_REST_BED_H

#include <string>

#include "fix.h"
#include "rest/rest_watch.h"

namespace LAMMPS_NS {

class FixRestBed : public Fix {
 public:
  FixRestBed(class LAMMPS *, int, char **);
  ~FixRestBed();

  int setmask() { return 0; }
  void init();
  void setup(int) {}
  double compute_vector(int);
  double memory_usage();
  void grow_arrays(int);
  void copy_arrays(int, int, int);
  void set_arrays(int);
  int pack_exchange(int, double *);
  int unpack_exchange(int, double *);

  void write_restart(FILE *);
  void restart(char *);
  int size_restart(int);
  int maxsize_restart();
  int pack_restart(int, double *);
  void unpack_restart(int, int);

  /// Goes on as a run that begins at this step does: what was seen of the bed is forgotten, not
  /// what was missed.
  void begin_anew();

  /// Start of a run of n steps. True when steps may be left out in it.
  bool begin(int n);
  /// Step at which the bed is looked at next.
  bigint next_look() const { return next_; }
  /// Looks at the bed; returns how many steps need not be computed now.
  bigint look();
  /// A step was left out.
  void passed() { skipped_++; }
  /// Steps are computed again before all were left out: the fluid has changed, or particles come.
  void woken();
  /// Likewise, since the processors have changed their particles.
  void recomputed();
  /// Change of the fluid's force on a particle that wakes the bed, over its weight.
  double fluid_tolerance() const { return fluid_; }

 private:
  void parse(int narg, char **arg);
  std::string why_not() const;
  void count_left_out();
  double uncounted() const;
  bigint next_window() const;
  bool find_gravity();

  double seconds_, fluid_;
  clay::RestLimits limits_;
  clay::RestWatch watch_;
  clay::RestTrack *tracks_;  // of each atom

  bool able_;                         // all of the script's fixes keep still when nothing moves
  double gravity_[3] = {0., 0., 0.};  // as last found
  double up_[3] = {0., 0., 0.};       // against it
  bigint window_, next_, begun_;      // windows are counted from begun_
  bool looked_;                       // in this run
  bigint skipped_, left_out_, wakings_;
};

}

#endif
#endif
