// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "contacts/lean_offer.h"

#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "comm.h"
#include "contacts/fix_wall_gran_lean.h"
#include "contacts/granular_script.h"
#include "contacts/pair_gran_lean.h"
#include "error.h"
#include "lammps.h"

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

Pair *LAMMPS_NS::offer_pair_gran(LAMMPS *lmp) { return new PairGranLean(lmp, true); }

/* ----------------------------------------------------------------------
   the fix that can do what the words say
------------------------------------------------------------------------- */

Fix *LAMMPS_NS::offer_wall_gran(LAMMPS *lmp, int narg, char **arg)
{
  std::vector<char *> words(arg, arg + narg);
  const std::string fix = std::string("fix ") + arg[0] + " wall/gran";
  clay::LeanUse use = clay::LeanUse::may;
  try {
    use = clay::takeLeanUse(words);
  } catch (const std::invalid_argument &e) {
    lmp->error->all(FLERR, ("F" + fix.substr(1) + ": " + e.what()).c_str());
  }
  const PairGranLean *pair = dynamic_cast<PairGranLean *>(granular_pair(lmp));
  if (use == clay::LeanUse::may && pair && pair->use() == clay::LeanUse::never) use = clay::LeanUse::never;

  const int n = static_cast<int>(words.size());
  if (use == clay::LeanUse::never) return new FixWallGran(lmp, n, words.data());
  clay::LeanModel model;
  const std::string why = FixWallGranLean::unfit(n, words.data(), model);
  if (why.empty()) return new FixWallGranLean(lmp, n, words.data());
  if (use == clay::LeanUse::must)
    lmp->error->all(FLERR, ("F" + fix.substr(1) + ": lean is yes, but " + why + "; take lean auto").c_str());
  if (lmp->comm->me == 0)
    for (FILE *to : {lmp->screen, lmp->logfile})
      if (to)
        fprintf(to, "Contacts of %s: LIGGGHTS's own loop, as %s\n", fix.c_str(), why.substr(0, why.find(": ")).c_str());
  return new FixWallGran(lmp, n, words.data());
}
