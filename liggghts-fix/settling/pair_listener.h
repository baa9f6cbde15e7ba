// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file pair_listener.h
/// The forces of contacts one by one, of LIGGGHTS's styles and the lean ones, at present.
#ifndef LMP_PAIR_LISTENER_H
#define LMP_PAIR_LISTENER_H

#include <functional>

#include "compute_pair_gran_local.h"
#include "pointers.h"

namespace LAMMPS_NS {

class FixWallGran;
class PairGran;

/// Takes the place of a compute pair/gran/local for as long as it asks. Forces, torques and the history
/// of contacts stay as they are.
class PairListener : public ComputePairGranLocal {
 public:
  /// Force f [N] on i, by j, of a pair that touches.
  typedef std::function<void(int i, int j, const double *f)> Pair;

  static PairListener *make(class LAMMPS *lmp);
  /// Visits each contact of this processor's atoms once; one with an atom of another processor
  /// is visited by one of the two.
  void each(PairGran *pair, const Pair &visit);

  void add_pair(int i, int j, double fx, double fy, double fz, double, double, double, double *, const double *const);
  void pair_finalize() {}

 private:
  PairListener(class LAMMPS *lmp, int &iarg, int narg, char **arg) : ComputePairGranLocal(lmp, iarg, narg, arg) {}
  const Pair *visit_;
};

/// Keeps friction within its coefficient. A contact that slides has a spring as long as friction lets it be; looked at
/// without a step it seems to hold, and the damping of its sliding is added. normal: of any length.
void limit_friction(double *f, const double *normal, double coefficient);

/// Visits each atom at a wall, with the force [N] that the wall puts on it.
void each_wall_force(LAMMPS *lmp, FixWallGran *wall, const std::function<void(int i, const double *f)> &visit);

}

#endif
