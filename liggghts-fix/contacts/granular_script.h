// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file granular_script.h
/// What a script has of granular contacts, of LIGGGHTS's styles and the lean ones.
#ifndef LMP_GRANULAR_SCRIPT_H
#define LMP_GRANULAR_SCRIPT_H

#include <vector>

namespace LAMMPS_NS {

class FixWallGran;
class LAMMPS;
class PairGran;

/// The pair style gran or gran/lean, also as a part of a hybrid one; null without.
PairGran *granular_pair(LAMMPS *lmp);

/// The fixes wall/gran and wall/gran/lean of primitive shape.
std::vector<FixWallGran *> primitive_walls(LAMMPS *lmp);

}

#endif
