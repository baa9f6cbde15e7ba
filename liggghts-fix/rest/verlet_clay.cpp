/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "rest/verlet_clay.h"

#include <algorithm>

#include "coupling/fix_couple_foam.h"
#include "rest/fix_rest_bed.h"
#include "modify.h"
#include "neighbor.h"
#include "output.h"
#include "signal_handling.h"
#include "timer.h"
#include "update.h"

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

VerletClay::VerletClay(LAMMPS *lmp) : VerletCoupled(lmp), rest_(NULL), fluid_(NULL) {}

/* ----------------------------------------------------------------------
   window by window: computed ones by verlet, the others as the bed allows
------------------------------------------------------------------------- */

void VerletClay::run(int n)
{
  const bigint end = update->ntimestep + n;
  // at each run: 'run pre no' after 'unfix' has no init
  rest_ = dynamic_cast<FixRestBed *>(modify->find_fix_style("rest/bed", 0));
  fluid_ = dynamic_cast<FixCoupleFoam *>(modify->find_fix_style("couple/foam", 0));
  if (!rest_ || !rest_->begin(n)) {
    VerletCoupled::run(n);
    return;
  }
  while (update->ntimestep < end) {
    bigint due = std::min(end, rest_->next_look());
    if (fluid_ && fluid_->saves()) due = std::min(due, fluid_->next_exchange());
    Verlet::run(static_cast<int>(due - update->ntimestep));
    if (update->ntimestep < due) return;  // asked to quit
    if (save()) continue;
    if (due < rest_->next_look()) continue;
    const bigint still = rest_->look();
    if (still) pass(std::min(end, update->ntimestep + still));
    if (SignalHandler::request_quit && !SignalHandler::request_write_restart) return;
  }
}

/* ---------------------------------------------------------------------- */

void VerletClay::ahead_of_saving()
{
  if (!rest_) return;
  if (fluid_) fluid_->rest(false);
  rest_->begin_anew();
}

/* ---------------------------------------------------------------------- */

bool VerletClay::inserts(bigint step) const
{
  for (int i = 0; i < modify->nfix; i++)
    if (modify->fix[i]->force_reneighbor && modify->fix[i]->next_reneighbor == step) return true;
  return false;
}

/* ----------------------------------------------------------------------
   steps in which nothing moves: time, exchanges and output go on. Where
   output wants energies or stresses the step is computed.
------------------------------------------------------------------------- */

void VerletClay::pass(bigint end)
{
  if (fluid_) fluid_->rest(true);
  while (update->ntimestep < end) {
    const bigint step = update->ntimestep + 1;
    if (inserts(step)) {
      rest_->woken();
      break;
    }
    ev_set(step);
    if (eflag || vflag) {
      if (fluid_) fluid_->book_rest();
      Verlet::run(1);
      if (neighbor->lastcall < step) continue;
      rest_->recomputed();
      break;
    }
    if (fluid_ && !fluid_->rest_step(rest_->fluid_tolerance())) {
      rest_->woken();
      break;
    }
    update->ntimestep = step;
    rest_->passed();
    modify->end_of_step();
    if (step == output->next) {
      timer->stamp();
      output->write(step);
      timer->stamp(TIME_OUTPUT);
    }
    if (save()) return;
    if (SignalHandler::request_quit && !SignalHandler::request_write_restart) break;
  }
  if (fluid_) fluid_->rest(false);
}
