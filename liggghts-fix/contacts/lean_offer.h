// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file lean_offer.h
/// pair_style gran and fix wall/gran of a script that knows nothing of the lean ones: what
/// these can do they do, and the log says which loop runs. `lean yes|no|auto` among the
/// words of either chooses; a wall without the word goes with pair_style gran's.
#ifndef LMP_LEAN_OFFER_H
#define LMP_LEAN_OFFER_H

namespace LAMMPS_NS {

class Fix;
class LAMMPS;
class Pair;

Pair *offer_pair_gran(LAMMPS *lmp);
Fix *offer_wall_gran(LAMMPS *lmp, int narg, char **arg);

}

#endif
