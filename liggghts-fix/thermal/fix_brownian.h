/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   fix ID group brownian temperature T seed N [viscosity MU]: random forces
   of the fluid's molecules. Described in doc/fix_brownian.md.
------------------------------------------------------------------------- */

#ifdef FIX_CLASS

FixStyle(brownian,FixBrownian)

#else

#ifndef LMP_FIX_BROWNIAN_H
#define LMP_FIX_BROWNIAN_H

#include "fix.h"

namespace LAMMPS_NS {

class FixBrownian : public Fix {
 public:
  FixBrownian(class LAMMPS *, int, char **);
  int setmask();
  void init();
  void setup(int);
  void post_force(int);

  /// Random force [N] on atom i over this step, for a drag coefficient K [kg/s]; zero outside the group.
  /// With stream 1, another one: the couple [N m] for a resistance K [kg m2/s] to turning.
  void kick(int i, double K, double *force, int stream = 0) const;

 private:
  void parse(int, char **);
  void relax(int i, double mass, bool turns);

  double temperature_;  // [K]
  double viscosity_;    // without a coupling [Pa s]; 0 with one
  long seed_;
  class CoupledFluid *fluid_;
  class FixMultisphere *bodies_;
};

}

#endif
#endif
