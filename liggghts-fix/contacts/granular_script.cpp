// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "contacts/granular_script.h"

#include "fix_wall_gran.h"
#include "force.h"
#include "lammps.h"
#include "modify.h"
#include "pair_gran.h"

using namespace LAMMPS_NS;

PairGran *LAMMPS_NS::granular_pair(LAMMPS *lmp)
{
  if (!lmp->force->pair) return nullptr;
  Pair *pair = lmp->force->pair_match("gran", 1);
  if (!pair) pair = lmp->force->pair_match("gran/lean", 1);
  return dynamic_cast<PairGran *>(pair);
}

std::vector<FixWallGran *> LAMMPS_NS::primitive_walls(LAMMPS *lmp)
{
  std::vector<FixWallGran *> walls;
  for (int i = 0; i < lmp->modify->nfix; i++) {
    FixWallGran *w = dynamic_cast<FixWallGran *>(lmp->modify->fix[i]);
    if (w && !w->is_mesh_wall() && w->primitiveWall()) walls.push_back(w);
  }
  return walls;
}
