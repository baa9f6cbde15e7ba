/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   The contact models of lean_model.h of fix wall/gran at primitive walls, in a
   loop like that of pair_style gran/lean. All else is wall/gran's.
------------------------------------------------------------------------- */

#ifdef FIX_CLASS

FixStyle(wall/gran/lean,FixWallGranLean)

#else

#ifndef LMP_FIX_WALL_GRAN_LEAN_H
#define LMP_FIX_WALL_GRAN_LEAN_H

#include <string>
#include <vector>

#include "contacts/contact_kernel.h"
#include "contacts/lean_coefficients.h"
#include "contacts/lean_model.h"
#include "fix_wall_gran.h"

namespace LAMMPS_NS {

class FixWallGranLean : public FixWallGran {
 public:
  FixWallGranLean(class LAMMPS *, int, char **);

  /// What of a fix wall/gran this one cannot do, empty when it can do all; reads the model.
  static std::string unfit(int narg, char **arg, clay::LeanModel &model);

  void init();
  double compute_vector(int);
  double memory_usage();

 protected:
  void pre_force(int vflag);
  void post_force_primitive(int);

 private:
  struct Near {
    int atom;
    double radius, mass;  // when it was listed
    double from, to;      // plane: not used, gap; cylinder: squared distances
                          // from its axis, in which it touches; none once in pairs_
  };

  void read_model(int narg, char **arg);
  void read_shape(int narg, char **arg);
  bool lean_step() const;
  void list();
  void add_touching();
  bool meets(bool &changed) const;
  clay::ContactLaw law(int i) const;

  clay::LeanModel model_;
  LeanCoefficients coefficients_;

  clay::WallShape shape_;
  std::vector<Near> near_;    // wall/gran's list of spheres near the wall
  clay::ContactPairs pairs_;  // those of them that touch, have touched or are about to
  bool listed_;
  bigint tidied_;            // step at which pairs_ was begun anew
  bigint looked_, touched_;  // spheres near the wall and at it, all steps
};

}

#endif
#endif
