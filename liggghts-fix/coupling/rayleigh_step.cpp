// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "atom.h"
#include "clumps/fix_template_clay.h"
#include "contacts/granular_script.h"
#include "coupling/run_checks.h"
#include "fix_property_global.h"
#include "lammps.h"
#include "modify.h"
#include "pair_gran.h"

using namespace LAMMPS_NS;

namespace {

const double infinity = std::numeric_limits<double>::infinity();

// a property of the script's materials; below 0 when there is none
double property(LAMMPS *lmp, const char *name, int i, int j = 0)
{
  const int n = lmp->atom->ntypes;
  Fix *found = lmp->modify->find_fix_property(name, "property/global", j ? "peratomtypepair" : "peratomtype", n,
                                              j ? n : 0, "contact check", false);
  FixPropertyGlobal *p = dynamic_cast<FixPropertyGlobal *>(found);
  if (!p) return -1.0;
  return j ? p->compute_array(i - 1, j - 1) : p->compute_vector(i - 1);
}

}  // namespace

/* ---------------------------------------------------------------------- */

double LAMMPS_NS::rayleigh_step(LAMMPS *lmp, std::string *which)
{
  PairGran *gran = granular_pair(lmp);
  const bool stiffness = gran && gran->contact_match("normal", "hertz/stiffness");
  if (!stiffness && !(gran && gran->contact_match("normal", "hertz"))) return infinity;

  // of each type the least r sqrt(density), to which the time is in proportion
  const Atom &atom = *lmp->atom;
  const clay::MovingGroups moving = moving_groups(lmp);
  std::vector<double> least(atom.ntypes + 1, infinity);
  for (int i = 0; i < atom.nlocal; i++)
    if (moving.moves(atom.mask[i]))
      least[atom.type[i]] = std::min(least[atom.type[i]], atom.radius[i] * std::sqrt(atom.density[i]));
  MPI_Allreduce(MPI_IN_PLACE, least.data(), least.size(), MPI_DOUBLE, MPI_MIN, lmp->world);
  for (int f = 0; f < lmp->modify->nfix; f++)
    if (const FixTemplateClay *t = dynamic_cast<FixTemplateClay *>(lmp->modify->fix[f]))
      for (std::size_t i = 0; i < t->clump().size(); i++) {
        double &of_type = least[t->types()[i]];
        of_type = std::min(of_type, t->clump()[i].r * std::sqrt(t->density()));
      }

  // with the stiffest partner among the script's materials, walls among them
  double step = infinity;
  for (int i = 1; i <= atom.ntypes; i++) {
    if (least[i] == infinity) continue;
    double modulus = 0, poisson = 0.25;
    for (int j = 1; j <= atom.ntypes; j++) {
      double pair = 0.75 * property(lmp, "kn", i, j);
      if (!stiffness) {
        poisson = property(lmp, "poissonsRatio", i);
        pair = clay::effectiveModulus(property(lmp, "youngsModulus", i), poisson, property(lmp, "youngsModulus", j),
                                      property(lmp, "poissonsRatio", j));
      }
      modulus = std::max(modulus, pair);
    }
    const double time = clay::rayleighTime(least[i], modulus, poisson);
    if (time >= step) continue;
    step = time;
    if (which) *which = "spheres of type " + std::to_string(i);
  }
  return step;
}
