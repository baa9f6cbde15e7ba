// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/runaway_watch.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "atom.h"
#include "coupling/run_checks.h"
#include "domain.h"
#include "error.h"
#include "fix_wall_gran.h"
#include "primitive_wall.h"
#include "update.h"

using namespace LAMMPS_NS;

namespace {

const int EVERY = 10;  // steps between two looks at the speeds

}

/* ---------------------------------------------------------------------- */

RunawayWatch::RunawayWatch(LAMMPS *lmp) : Pointers(lmp), checked_(0), held_(0), wall_overlap_(0.) {}

/* ---------------------------------------------------------------------- */

void RunawayWatch::start() { checked_ = held_ = update->ntimestep; }

/* ---------------------------------------------------------------------- */

void RunawayWatch::stop(int i, const char *why, bigint since)
{
  const double *x = atom->x[i], *v = atom->v[i];
  char text[512];
  snprintf(text, sizeof text,
           "Fix couple/foam: particle %d %s at step " BIGINT_FORMAT " (%g s): position (%g %g %g) m, "
           "velocity (%g %g %g) m/s; last check passed at step " BIGINT_FORMAT
           "; a smaller timestep, a stiffer contact or a shorter coupling interval may help",
           atom->tag[i], why, update->ntimestep, update->get_cur_time(), x[0], x[1], x[2], v[0], v[1], v[2], since);
  end(text + last_words_);
}

void RunawayWatch::end(const std::string &text) { error->one(FLERR, text.c_str()); }

/* ---------------------------------------------------------------------- */

void RunawayWatch::step()
{
  if (update->ntimestep % EVERY) return;
  double **v = atom->v;
  const double *radius = atom->radius;
  const double dt2 = update->dt * update->dt;
  for (int i = 0; i < atom->nlocal; i++) {
    const double far2 = (v[i][0] * v[i][0] + v[i][1] * v[i][1] + v[i][2] * v[i][2]) * dt2;
    // false for NaN, too
    if (far2 <= 4. * radius[i] * radius[i]) continue;
    stop(i, std::isfinite(far2) ? "moves more than its diameter in a step" : "is NaN", checked_);
  }
  checked_ = update->ntimestep;
}

/* ---------------------------------------------------------------------- */

void RunawayWatch::places(const std::function<bool(int)> &may_leave)
{
  const int periodic[3] = {domain->xperiodic, domain->yperiodic, domain->zperiodic};
  for (int i = 0; i < atom->nlocal; i++)
    for (int k = 0; k < 3; k++) {
      const double x = atom->x[i][k];
      if (!std::isfinite(x)) stop(i, "is NaN", checked_);
      // a border that shrink-wraps moves along
      if (periodic[k] || domain->boundary[k][0] != 1 || domain->boundary[k][1] != 1) continue;
      if ((x < domain->boxlo[k] || x >= domain->boxhi[k]) && !may_leave(i))
        stop(i, "was pushed out of the box (watch no lets particles leave it)", checked_);
    }
}

/* ---------------------------------------------------------------------- */

void RunawayWatch::overlaps(double overlap, int tag1, int tag2)
{
  if (overlap > most_overlap) {
    char text[256];
    snprintf(text, sizeof text,
             "Fix couple/foam: particles %d and %d overlap by %.2g d at step " BIGINT_FORMAT " (%g s), more than "
             "%g d: the contact is too soft for its load; take a larger stiffness",
             tag1, tag2, overlap, update->ntimestep, update->get_cur_time(), most_overlap);
    end(text + last_words_);
  }
  const clay::MovingGroups moving = moving_groups(lmp);
  for (FixWallGran *w : primitive_walls(lmp))
    for (int i = 0; i < atom->nlocal; i++) {
      if (!(atom->mask[i] & w->groupbit) || !moving.moves(atom->mask[i])) continue;
      double to_wall[3];
      const double gap = w->primitiveWall()->resolveContact(atom->x[i], atom->radius[i], to_wall);
      if (gap >= 0.) continue;
      const double deep = -0.5 * gap / atom->radius[i];
      wall_overlap_ = std::max(wall_overlap_, deep);
      if (deep > most_overlap)
        stop(i, ("is pressed " + std::to_string(deep).substr(0, 4) + " d into the wall of fix " + w->id).c_str(),
             held_);
    }
  held_ = update->ntimestep;
}
