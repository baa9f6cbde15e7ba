// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/coupling_report.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <fstream>

#include "atom.h"
#include "comm.h"
#include "coupling/run_checks.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "fix_multisphere.h"
#include "force.h"
#include "modify.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "pair.h"
#include "exchange/session.h"
#include "timer.h"
#include "universe.h"
#include "update.h"

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

CouplingReport::CouplingReport(LAMMPS *lmp, const std::string &file, double seconds) :
  Pointers(lmp), file_(file), seconds_(seconds), counted_(false), running_(false), cpu_began_(0), cpu_wait_(0),
  cpu_waited_(0), cpu_(0.), began_(0.), last_line_(0.), wall_(0.), output_(0.), steps_(0), at_start_(0), before_(0),
  inserted_(0), left_(0), deleted_(0), lost_(0), inserted_before_(0), left_before_(0), start_time_(-1.), overlap_(0.)
{
}

/* ---------------------------------------------------------------------- */

void CouplingReport::warn(const std::string &text)
{
  if (comm->me == 0) error->warning(FLERR, text.c_str());
  warnings_.push_back(text);
}

/* ---------------------------------------------------------------------- */

void CouplingReport::start()
{
  began_ = last_line_ = MPI_Wtime();
  cpu_began_ = std::clock();
  cpu_waited_ = 0;
  if (!counted_) {
    at_start_ = before_ = all(atom->nlocal);
    inserted_ = 0;
  } else count();
  running_ = true;
  if (counted_) return;
  counted_ = true;
  if (start_time_ < 0.) start_time_ = update->get_cur_time();

  // a place that cannot be written to is told before the run, not after
  int bad = !comm->me && !file_.empty() && !std::ofstream(file_);
  MPI_Bcast(&bad, 1, MPI_INT, 0, world);
  if (bad) error->all(FLERR, ("Fix couple/foam: cannot write the stats file '" + file_ + "'").c_str());
}

/* ---------------------------------------------------------------------- */

long CouplingReport::all(long mine) const
{
  long sum;
  MPI_Allreduce(&mine, &sum, 1, MPI_LONG, MPI_SUM, world);
  return sum;
}

/* ----------------------------------------------------------------------
   what is missing since the last count and did not leave was deleted, by a
   fix that does so or between two runs, or it is lost
------------------------------------------------------------------------- */

void CouplingReport::count()
{
  static const char *deleting[] = {"remove", "massflow", "multisphere", "break"};
  bool may = !running_;
  for (int i = 0; i < modify->nfix; i++)
    for (const char *style : deleting) may |= !strncmp(modify->fix[i]->style, style, strlen(style));

  const long now = all(atom->nlocal), inserted = all(inserted_), left = all(left_);
  const long missing = before_ + (inserted - inserted_before_) - (left - left_before_) - now;
  (may ? deleted_ : lost_) += missing;
  before_ = now;
  inserted_before_ = inserted;
  left_before_ = left;
}

/* ---------------------------------------------------------------------- */

void CouplingReport::places()
{
  for (int i = 0; i < atom->nlocal; i++)
    for (int k = 0; k < 3; k++) {
      const double x = atom->x[i][k];
      const bool low = domain->boundary[k][0] == 1 && x < domain->boxlo[k];
      const bool high = domain->boundary[k][1] == 1 && x >= domain->boxhi[k];
      if (!low && !high) continue;
      left_++;
      break;
    }
}

/* ----------------------------------------------------------------------
   of this rank's pairs
------------------------------------------------------------------------- */

void CouplingReport::measure_overlap()
{
  Pair *gran = force->pair_match("gran", 0);
  clay::NeighbourList list;
  list.mask = NEIGHMASK;
  if (gran && gran->list) {
    list.n = gran->list->inum;
    list.spheres = gran->list->ilist;
    list.counts = gran->list->numneigh;
    list.neighbours = gran->list->firstneigh;
  }
  now_ = clay::largest_overlap(list, atom->x, atom->radius, atom->mask, moving_groups(lmp), atom->tag, now_);
}

/* ---------------------------------------------------------------------- */

void CouplingReport::exchange(const clay::DemSession &session, bool last)
{
  measure_overlap();
  overlap_ = std::max(overlap_, now_.depth);
  if (logfile) fflush(logfile);  // one that is ended from outside keeps its lines
  if (seconds_ <= 0.) return;
  // every rank must come to the same decision: the first rank's clock counts
  int due = last || MPI_Wtime() - last_line_ >= seconds_;
  if (comm->nprocs > 1) MPI_Bcast(&due, 1, MPI_INT, 0, world);
  if (!due) return;
  last_line_ = MPI_Wtime();
  line(session);
}

/* ---------------------------------------------------------------------- */

void CouplingReport::line(const clay::DemSession &session)
{
  double mine[2] = {overlap_, session.reported()}, worst[2];
  MPI_Allreduce(mine, worst, 2, MPI_DOUBLE, MPI_MAX, world);
  clay::Progress now;
  if (Fix *curve = modify->find_fix_style("settling/curve", 0)) now.interface = curve->compute_vector(0);
  if (comm->me) return;

  now.time = update->get_cur_time();
  now.done = double(update->ntimestep - update->firststep) / std::max<bigint>(1, update->laststep - update->firststep);
  now.spent = MPI_Wtime() - began_;
  now.overlap = worst[0];
  now.momentum = worst[1];
  const std::string text = now.line();
  if (screen) {
    fprintf(screen, "clayFoam: %s\n", text.c_str());
    fflush(screen);
  }
  if (logfile) {
    fprintf(logfile, "clayFoam: %s\n", text.c_str());
    fflush(logfile);
  }
}

/* ---------------------------------------------------------------------- */

void CouplingReport::finish(const clay::DemSession &session, int interval, double wall_overlap)
{
  wall_ += MPI_Wtime() - began_;
  cpu_ += double(std::clock() - cpu_began_ - cpu_waited_) / CLOCKS_PER_SEC;
  output_ += timer->array[TIME_OUTPUT];
  steps_ += update->ntimestep - update->firststep;

  const clay::Timing &timing = session.timing();
  double mine[7] = {wall_, timing.exchange, timing.waiting, output_, overlap_, wall_overlap, cpu_}, worst[7];
  MPI_Allreduce(mine, worst, 7, MPI_DOUBLE, MPI_MAX, world);
  count();
  running_ = false;
  const long away = all(session.away());
  double sent = timing.bytesSent, bytes;
  MPI_Allreduce(&sent, &bytes, 1, MPI_DOUBLE, MPI_SUM, world);
  FixMultisphere *ms = static_cast<FixMultisphere *>(modify->find_fix_style("multisphere", 0));
  const int clumps = ms ? ms->n_body_all() : 0;

  if (comm->me || file_.empty()) return;
  clay::RunMeasures run;
  run.program = universe->version;
  run.ranks = comm->nprocs;
  run.simulated = update->get_cur_time() - start_time_;
  run.wall = worst[0];
  run.exchange = worst[1];
  run.waiting = worst[2];
  run.output = worst[3];
  run.rankExchange = timing.exchange;
  run.rankWaiting = timing.waiting;
  run.rankOutput = output_;
  run.cpu = worst[6];
  run.steps = steps_;
  run.exchanges = timing.exchanges;
  run.bytesSent = bytes;
  if (Fix *rest = modify->find_fix_style("rest/bed", 0))
    run.rest = {{rest->compute_vector(0), rest->compute_vector(1), rest->compute_vector(2)}};
  run.particles.atStart = at_start_;
  run.particles.inserted = inserted_before_;
  run.particles.left = left_before_;
  run.particles.deleted = deleted_;
  run.particles.lost = lost_;
  run.particles.away = away;
  run.clumps = clumps;
  run.overlap = worst[4];
  run.wallOverlap = worst[5];
  run.timestep = update->dt;
  run.interval = interval;
  run.settings = settings_;
  run.warnings = warnings_;

  std::ofstream out(file_);
  out << run.json();
  if (!out) error->one(FLERR, ("Fix couple/foam: cannot write the stats file '" + file_ + "'").c_str());
}
