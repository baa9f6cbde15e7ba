/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   The contact model hooke/stiffness with tangential history of fix wall/gran
   at primitive walls, in the loop of pair_style gran/lean. All else is
   wall/gran's.
------------------------------------------------------------------------- */

#ifdef FIX_CLASS

FixStyle(wall/gran/lean,FixWallGranLean)

#else

#ifndef LMP_FIX_WALL_GRAN_LEAN_H
#define LMP_FIX_WALL_GRAN_LEAN_H

#include <vector>

#include "contact_kernel.h"
#include "fix_wall_gran.h"

namespace LAMMPS_NS {

class FixWallGranLean : public FixWallGran {
 public:
  FixWallGranLean(class LAMMPS *, int, char **);
  void init();
  double compute_vector(int);
  double memory_usage();

 protected:
  void post_force_primitive(int);

 private:
  void read_model(int narg, char **arg);
  bool lean_step() const;
  void gather();
  void scatter();

  bool tangential_damping_, absolute_damping_, limit_force_;
  double **kn_, **kt_, **gamman_, **gammat_, **friction_;

  clay::ContactPairs pairs_;     // spheres that touch, each with its point of the wall
  std::vector<int> atom_;        // which they are
  std::vector<double> wall_;     // and those points
  std::vector<double> x_near_, v_near_, omega_near_, f_near_, torque_near_;
  bigint looked_, touched_;      // spheres near the wall and at it, all steps
};

}

#endif
#endif
