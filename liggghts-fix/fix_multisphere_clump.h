/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   fix ID group multisphere/clump: LIGGGHTS's multisphere bodies, with the
   fluid's drag on each body applied implicitly in velocity and spin.
------------------------------------------------------------------------- */

#ifdef FIX_CLASS

FixStyle(multisphere/clump,FixMultisphereClump)

#else

#ifndef LMP_FIX_MULTISPHERE_CLUMP_H
#define LMP_FIX_MULTISPHERE_CLUMP_H

#include <vector>

#include "body_drag.h"
#include "fix_multisphere.h"

namespace LAMMPS_NS {

class FixMultisphereClump : public FixMultisphere {
 public:
  /// A sphere of a body that this processor owns.
  struct Sphere {
    int atom;         ///< local or ghost index
    int body;         ///< local index of the body
    double r[3];      ///< from the body's centre of mass, space axes [m]
    double fraction;  ///< share of the body's volume it stands for
  };

  FixMultisphereClump(class LAMMPS *, int, char **);

  void calc_force(bool setupflag);

  /// All spheres of this processor's bodies, ghosts among them.
  void spheres(std::vector<Sphere> &list);

  /// Takes the fluid's action on a body, until it is given anew.
  void set_drag(int ibody, const BodyDrag &drag);

  /// Impulse [N s] the fluid gave to a body since the last call.
  void take_impulse(int ibody, double *impulse);

  /// Switches the fluid on; without it this is plain multisphere.
  void couple();

  /// Switches it off and forgets it.
  void uncouple();

  /// Solid volume [m3] and mass [kg] of a body.
  double body_volume(int ibody) { return multisphere_.volume(ibody); }
  double body_mass(int ibody) { return multisphere_.mass(ibody); }

 private:
  // what is kept of the fluid, per body: it moves with the body
  enum { RESISTANCE = 0, DRIVE = 21, LOAD = 27, FORCE = 33, IMPULSE = 36, OWNER = 39, SIZE = 40 };
  typedef VectorContainer<double,SIZE> Store;

  void apply_drag(bool setupflag);
  double *stored(int ibody);

  Store *store_;
  bool coupled_;
};

}

#endif
#endif
