/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   Settings and history; the forces are in pair_gran_lean_compute.cpp.
------------------------------------------------------------------------- */

#include "contacts/pair_gran_lean.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "contacts/fix_contact_history_lean.h"
#include "force.h"
#include "lammps.h"
#include "modify.h"
#include "neigh_list.h"
#include "neighbor.h"

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

PairGranLean::PairGranLean(LAMMPS *lmp, bool offered) :
  PairGranProxy(lmp), offered_(offered), use_(offered ? clay::LeanUse::may : clay::LeanUse::must), flags_read_(false),
  margin_(0.0), sought_(false), built_(-1), inum_(0), searches_(0)
{
}

/* ---------------------------------------------------------------------- */

void PairGranLean::refuse(const std::string &why) const
{
  error->all(FLERR,
             (offered_ ? "Pair style gran: lean is yes, but " + why + "; take lean auto"
                       : "Pair style gran/lean: " + why + "; for anything else take pair_style gran")
                 .c_str());
  abort();  // not reached
}

/* ----------------------------------------------------------------------
   gran's settings, as far as they are this style's
------------------------------------------------------------------------- */

void PairGranLean::settings(int narg, char **arg)
{
  std::vector<char *> words(arg, arg + narg);
  model_ = clay::LeanModel();
  odd_.clear();
  try {
    if (offered_) use_ = clay::takeLeanUse(words);
  } catch (const std::invalid_argument &e) {
    error->all(FLERR, (std::string("Pair style gran: ") + e.what()).c_str());
  }
  try {
    for (std::size_t i = 0; i < words.size(); i += 2) {
      const std::string word = words[i], value = i + 1 < words.size() ? words[i + 1] : "";
      if (!model_.take(word, value))
        throw std::invalid_argument("'" + word + " " + value + "' is not among what it can do");
    }
    model_.complete();
  } catch (const std::invalid_argument &e) {
    odd_ = e.what();
  }
  if (!odd_.empty() && use_ == clay::LeanUse::must) refuse(odd_);
  hand_back_history();
  pairs_.clear();
  pairs_.kind = model_.kind;
  PairGranProxy::settings(static_cast<int>(words.size()), words.data());
}

/* ----------------------------------------------------------------------
   why gran's own loop has to run, if it has
------------------------------------------------------------------------- */

std::string PairGranLean::unfit() const
{
  if (use_ == clay::LeanUse::never) return "the script says lean no";
  if (!odd_.empty()) return odd_;
  PairGranLean *self = const_cast<PairGranLean *>(this);
  if (!self->contact_match("normal", model_.name()) || !self->contact_match("tangential", model_.tangential()))
    return "the restart file is of another contact model";
  if (neighbor->contactDistanceFactor != 1.0) return "contact_distance_factor must be 1";
  if (force->newton_pair) return "newton must be off";
  if (!atom->sphere_flag) return "the particles must be spheres";
  for (int i = 0; i < modify->nfix; i++)
    if (modify->fix[i]->n_history_extra())
      return std::string("fix ") + modify->fix[i]->style + " adds to the contact history";
  if (fix_history && !dynamic_cast<FixContactHistoryLean *>(fix_history)) return "the history of contacts is gran's";
  return "";
}

/* ----------------------------------------------------------------------
   which loop runs, once
------------------------------------------------------------------------- */

void PairGranLean::say()
{
  std::string line = "Contacts of pair gran: ";
  if (!unfit_.empty()) line += "LIGGGHTS's own loop, as " + unfit_.substr(0, unfit_.find(": "));
  else if (flags_read_) line += "LIGGGHTS's own loop, as a fix or compute needs its lists";
  else line += "the lean loop, " + model_.text();
  line += "\n";
  if (line == said_ || comm->me) return;
  said_ = line;
  for (FILE *to : {screen, logfile})
    if (to) fputs(line.c_str(), to);
}

/* ---------------------------------------------------------------------- */

void PairGranLean::init_style()
{
  unfit_ = unfit();
  if (!unfit_.empty() && use_ == clay::LeanUse::must) refuse(unfit_);
  flags_read_ = modify->n_fixes_style("heat/gran") > 0 || modify->n_fixes_style("insert/stream/predefined") > 0 ||
      modify->n_fixes_style("relax_contacts") > 0 || modify->n_computes_style("contact/atom") > 0;
  hand_back_history();  // before the lists of the last run are gone
  if (unfit_.empty() && !fix_history && dnum_pair() > 0) make_history();
  PairGranProxy::init_style();
  if (offered_) say();
}

/* ----------------------------------------------------------------------
   as PairGran makes it, but of the kind that asks this style for its part
------------------------------------------------------------------------- */

void PairGranLean::make_history()
{
  if (modify->find_fix_style_strict("contacthistory", 0))
    error->all(FLERR, "Can not use more than one pair style that uses contact history");
  std::string words[] = {"contacthistory", "all", "contacthistory", std::to_string(dnum_pair())};
  std::vector<char *> arg;
  for (auto &w : words) arg.push_back(&w[0]);
  arg.resize(arg.size() + 2 * dnum_pair());
  history_args(&arg[4]);

  // fix contacthistory/lean, by the name that LIGGGHTS looks for
  char suffix[] = "lean";
  const int enabled = lmp->suffix_enable;
  lmp->suffix_enable = 1;
  modify->add_fix(static_cast<int>(arg.size()), &arg[0], suffix);
  lmp->suffix_enable = enabled;
  FixContactHistoryLean *made =
      dynamic_cast<FixContactHistoryLean *>(modify->find_fix_style_strict("contacthistory", 0));
  if (!made) error->all(FLERR, "Pair style gran/lean: fix contacthistory/lean was not made");
  made->serve(this);
  fix_history = made;
}

/* ---------------------------------------------------------------------- */

void PairGranLean::init_granular()
{
  PairGranProxy::init_granular();
  if (unfit_.empty()) coefficients_.connect(force->registry, model_, "pair gran/lean");
}

/* ---------------------------------------------------------------------- */

void PairGranLean::hand_back_history()
{
  if (sought_)
    for (std::size_t k = 0; k < kept_.size(); k++) {
      pairs_.tell(k, kept_[k]);
      if (pairs_.touched[k] != 0.0) *flag_[k] |= 1;
    }
  sought_ = false;
}

/* ---------------------------------------------------------------------- */

double PairGranLean::memory_usage()
{
  return PairGranProxy::memory_usage() + pairs_.size() * (4.0 * sizeof(int *) + 12.0 * sizeof(double)) +
      5.0 * seen_mass_.size() * sizeof(double);
}
