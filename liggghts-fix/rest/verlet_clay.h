/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   LIGGGHTS's run_style verlet, which lets the time of a resting bed pass
   without computing its steps. Put in place by fix rest/bed.
------------------------------------------------------------------------- */

#ifndef LMP_VERLET_CLAY_H
#define LMP_VERLET_CLAY_H

#include "coupling/verlet_coupled.h"

namespace LAMMPS_NS {

class VerletClay : public VerletCoupled {
 public:
  VerletClay(class LAMMPS *);
  void run(int);

 protected:
  void ahead_of_saving();

 private:
  void pass(bigint end);
  bool inserts(bigint step) const;

  class FixRestBed *rest_;      // null: plain verlet
  class FixCoupleFoam *fluid_;  // null without a fluid
};

}

#endif
