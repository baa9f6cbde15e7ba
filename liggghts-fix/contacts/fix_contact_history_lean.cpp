/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "contacts/fix_contact_history_lean.h"

#include "atom.h"
#include "error.h"
#include "contacts/pair_gran_lean.h"

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

FixContactHistoryLean::FixContactHistoryLean(LAMMPS *lmp, int narg, char **arg) :
  FixContactHistory(lmp, narg, arg), lean_(NULL)
{
}

/* ---------------------------------------------------------------------- */

void FixContactHistoryLean::init()
{
  if (!lean_) error->all(FLERR, "Fix contacthistory/lean is made by pair_style gran/lean, not by a script");
  if (atom->tag_enable == 0)
    error->all(FLERR, "Pair style gran/lean: atoms need IDs, for the history of their contacts");
  int dim;
  pair_gran_ = lean_;
  computeflag_ = static_cast<int *>(lean_->extract("computeflag", dim));
  allocate_pages();
}

/* ---------------------------------------------------------------------- */

void FixContactHistoryLean::pre_exchange()
{
  lean_->hand_back_history();
  FixContactHistory::pre_exchange();
}
