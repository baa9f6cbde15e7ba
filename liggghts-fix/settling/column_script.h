// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file column_script.h
/// What a script says of its column, and what its atoms stand for.
#ifndef LMP_COLUMN_SCRIPT_H
#define LMP_COLUMN_SCRIPT_H

namespace LAMMPS_NS {

class FixMultisphere;
class FixWallGran;
class LAMMPS;

/// Cross-section [m2] and height of the floor [m]: of its own walls, a zcylinder and the lowest
/// zplane of fix wall/gran, or without them of the simulation box.
struct ColumnSpace {
  double area, bottom;
};
ColumnSpace column_space(LAMMPS *lmp);

/// Height [m] of a primitive wall that is a plane across z; false for any other.
bool plane_height(LAMMPS *lmp, FixWallGran *wall, double &height);

/// The script's fix multisphere, null without; more than one is an error of what is named.
FixMultisphere *multisphere_of(LAMMPS *lmp, const char *asks);

/// Solid volume an atom stands for [m3]: a body's spheres share its volume.
double sphere_volume(LAMMPS *lmp, FixMultisphere *multisphere, int i);

/// Largest diameter of the atoms there are and that fixes may make [m]; on all processors.
double largest_diameter(LAMMPS *lmp);

}

#endif
