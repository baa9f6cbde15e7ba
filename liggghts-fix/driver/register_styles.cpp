// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "driver/register_styles.h"

#include <map>
#include <string>

#include "contacts/lean_offer.h"
#include "fix.h"
#include "force.h"
#include "lammps.h"
#include "modify.h"
#include "pair.h"
#include "driver/styles.h"

using namespace LAMMPS_NS;

namespace {

typedef std::map<std::string, Fix *(*)(LAMMPS *, int, char **)> FixMap;

// Modify::fix_map is private. An explicit instantiation may name private
// members, so this one hands out the pointer to it: the stock library is used
// as it is, and a change of the member's type stops the build here.
FixMap *&fix_map(Modify &modify);

template <FixMap *Modify::*member>
struct Reach {
  friend FixMap *&fix_map(Modify &modify) { return modify.*member; }
};

template struct Reach<&Modify::fix_map>;

template <class Style>
Fix *create_fix(LAMMPS *lmp, int narg, char **arg)
{
  return new Style(lmp, narg, arg);
}

template <class Style>
Pair *create_pair(LAMMPS *lmp)
{
  return new Style(lmp);
}

}

void LAMMPS_NS::register_clay_styles(LAMMPS *lmp)
{
  FixMap &fixes = *fix_map(*lmp->modify);
#define FIX_CLASS
#define FixStyle(key, Class) fixes[#key] = &create_fix<Class>;
#include "driver/styles.h"
#undef FixStyle
#undef FIX_CLASS

  std::map<std::string, Force::PairCreator> &pairs = *lmp->force->pair_map;
#define PAIR_CLASS
#define PairStyle(key, Class) pairs[#key] = &create_pair<Class>;
#include "driver/styles.h"
#undef PairStyle
#undef PAIR_CLASS
}

/* ---------------------------------------------------------------------- */

void LAMMPS_NS::offer_lean_contacts(LAMMPS *lmp)
{
  (*fix_map(*lmp->modify))["wall/gran"] = &offer_wall_gran;
  (*lmp->force->pair_map)["gran"] = &offer_pair_gran;
}
