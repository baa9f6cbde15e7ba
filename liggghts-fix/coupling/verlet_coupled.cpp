/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "coupling/verlet_coupled.h"

#include <algorithm>

#include "atom.h"
#include "comm.h"
#include "coupling/fix_couple_foam.h"
#include "domain.h"
#include "modify.h"
#include "update.h"

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

VerletCoupled::VerletCoupled(LAMMPS *lmp) : Verlet(lmp, 0, NULL) {}

/* ---------------------------------------------------------------------- */

FixCoupleFoam *VerletCoupled::fluid() const
{
  return dynamic_cast<FixCoupleFoam *>(modify->find_fix_style("couple/foam", 0));
}

/* ---------------------------------------------------------------------- */

void VerletCoupled::setup()
{
  Verlet::setup();
  if (FixCoupleFoam *f = fluid()) {
    f->take_held_forces();
    f->go_on_inserting();
  }
}

/* ----------------------------------------------------------------------
   interval by interval where states are saved
------------------------------------------------------------------------- */

void VerletCoupled::run(int n)
{
  const bigint end = update->ntimestep + n;
  FixCoupleFoam *f = fluid();
  if (!f || !f->saves()) {
    Verlet::run(n);
    return;
  }
  while (update->ntimestep < end) {
    const bigint due = std::min(end, f->next_exchange());
    Verlet::run(static_cast<int>(due - update->ntimestep));
    if (update->ntimestep < due) return;  // asked to quit
    save();
  }
}

/* ----------------------------------------------------------------------
   A run that goes on from the file sets itself up as every run does: so does
   this one, so that both are the same from here on, to the last bit. Forces
   are those of before: the set-up would make them of other velocities.
------------------------------------------------------------------------- */

bool VerletCoupled::save()
{
  FixCoupleFoam *f = fluid();
  if (!f || !f->save_due()) return false;
  ahead_of_saving();
  f->begins_saving();
  modify->setup_pre_exchange();  // contacts go with their atoms
  if (update->ntimestep == update->laststep) {
    f->save_last();
    return false;
  }
  domain->pbc();
  domain->reset_box();
  comm->setup();
  comm->exchange();
  if (atom->sortfreq > 0) atom->sort();
  setup_minimal(1);  // the fix writes the state ahead of the forces
  f->take_held_forces();
  f->ends_saving();
  return true;
}
