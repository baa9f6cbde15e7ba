/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   LIGGGHTS's run_style verlet, which saves the state between two steps and
   goes on from a saved one. Put in place by fix couple/foam.
------------------------------------------------------------------------- */

#ifndef LMP_VERLET_COUPLED_H
#define LMP_VERLET_COUPLED_H

#include "verlet.h"

namespace LAMMPS_NS {

class VerletCoupled : public Verlet {
 public:
  VerletCoupled(class LAMMPS *);
  void setup();
  void run(int);

  /// Saves the state if fix couple/foam wants it now. True when lists were made anew. Collective.
  bool save();

 protected:
  class FixCoupleFoam *fluid() const;
  /// What is only of this run is given up.
  virtual void ahead_of_saving() {}
};

}

#endif
