// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "settling/column_script.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "atom.h"
#include "contacts/granular_script.h"
#include "domain.h"
#include "error.h"
#include "fix_multisphere.h"
#include "fix_property_atom.h"
#include "fix_wall_gran.h"
#include "lammps.h"
#include "modify.h"
#include "primitive_wall.h"

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

bool LAMMPS_NS::plane_height(LAMMPS *lmp, FixWallGran *wall, double &height)
{
  PrimitiveWall *primitive = wall->primitiveWall();
  if (wall->is_mesh_wall() || !primitive || primitive->axis() >= 0) return false;
  double middle[3], to_wall[3] = {0.0, 0.0, 0.0};
  for (int d = 0; d < 3; d++) middle[d] = 0.5 * (lmp->domain->boxlo[d] + lmp->domain->boxhi[d]);
  primitive->resolveContact(middle, 0.0, to_wall);
  height = middle[2] + to_wall[2];
  return to_wall[0] == 0.0 && to_wall[1] == 0.0;
}

/* ---------------------------------------------------------------------- */

ColumnSpace LAMMPS_NS::column_space(LAMMPS *lmp)
{
  const Domain *domain = lmp->domain;
  ColumnSpace space = {domain->xprd * domain->yprd, domain->boxlo[2]};
  double floor = domain->boxhi[2];
  for (FixWallGran *wall : primitive_walls(lmp)) {
    PrimitiveWall *primitive = wall->primitiveWall();
    double height, to_wall[3] = {0.0, 0.0, 0.0}, from_axis[3];
    if (primitive->axis() == 2) {
      double inside[3] = {domain->boxlo[0] + 0.5123 * domain->xprd, domain->boxlo[1] + 0.4871 * domain->yprd, 0.0};
      const double r = primitive->calcRadialDistance(inside, from_axis);
      const double radius = r + primitive->resolveContact(inside, 0.0, to_wall);
      space.area = M_PI * radius * radius;
    } else if (plane_height(lmp, wall, height)) floor = std::min(floor, height);
  }
  if (floor < 0.5 * (domain->boxlo[2] + domain->boxhi[2])) space.bottom = floor;
  return space;
}

/* ---------------------------------------------------------------------- */

FixMultisphere *LAMMPS_NS::multisphere_of(LAMMPS *lmp, const char *asks)
{
  if (lmp->modify->n_fixes_style("multisphere") > 1)
    lmp->error->all(FLERR, (std::string(asks) + ": at most one fix multisphere").c_str());
  return static_cast<FixMultisphere *>(lmp->modify->find_fix_style("multisphere", 0));
}

/* ---------------------------------------------------------------------- */

double LAMMPS_NS::sphere_volume(LAMMPS *lmp, FixMultisphere *ms, int i)
{
  const Atom *atom = lmp->atom;
  if (ms && ms->belongs_to(i) >= 0 && ms->get_volumeweight())
    return ms->get_volumeweight()->vector_atom[i] * atom->rmass[i] / atom->density[i];
  const double r = atom->radius[i];
  return 4.0 / 3.0 * M_PI * r * r * r;
}

/* ---------------------------------------------------------------------- */

double LAMMPS_NS::largest_diameter(LAMMPS *lmp)
{
  double largest = 0.0, smallest = 0.0, mine = 0.0, all = 0.0;
  lmp->modify->max_min_rad(largest, smallest);
  for (int i = 0; i < lmp->atom->nlocal; i++) mine = std::max(mine, lmp->atom->radius[i]);
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_MAX, lmp->world);
  return 2.0 * std::max(largest, all);
}
