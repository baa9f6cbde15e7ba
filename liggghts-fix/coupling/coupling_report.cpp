// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/coupling_report.h"

#include <algorithm>
#include <cstdio>
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
  Pointers(lmp), file_(file), seconds_(seconds), counted_(false),
  cpu_began_(0), cpu_wait_(0), cpu_waited_(0), cpu_(0.), began_(0.), last_line_(0.), wall_(0.), output_(0.), steps_(0), particles_(0),
  start_time_(0.), overlap_(0.)
{
}

/* ---------------------------------------------------------------------- */

void CouplingReport::warn(const std::string &text)
{
  if (comm->me == 0) error->warning(FLERR,text.c_str());
  warnings_.push_back(text);
}

/* ---------------------------------------------------------------------- */

void CouplingReport::start()
{
  began_ = last_line_ = MPI_Wtime();
  cpu_began_ = std::clock();
  cpu_waited_ = 0;
  bigint n = atom->nlocal, all;
  MPI_Allreduce(&n,&all,1,MPI_LMP_BIGINT,MPI_SUM,world);
  particles_ = std::max<long>(particles_,all);
  if (counted_) return;
  counted_ = true;
  start_time_ = update->get_cur_time();

  // a place that cannot be written to is told before the run, not after
  int bad = !comm->me && !file_.empty() && !std::ofstream(file_);
  MPI_Bcast(&bad,1,MPI_INT,0,world);
  if (bad)
    error->all(FLERR,("Fix couple/foam: cannot write the stats file '" + file_ + "'").c_str());
}

/* ----------------------------------------------------------------------
   of this rank's pairs
------------------------------------------------------------------------- */

void CouplingReport::measure_overlap()
{
  Pair *gran = force->pair_match("gran",0);
  clay::NeighbourList list;
  list.mask = NEIGHMASK;
  if (gran && gran->list) {
    list.n = gran->list->inum;
    list.spheres = gran->list->ilist;
    list.counts = gran->list->numneigh;
    list.neighbours = gran->list->firstneigh;
  }
  now_ = clay::largest_overlap(list,atom->x,atom->radius,atom->mask,moving_groups(lmp),atom->tag,now_);
}

/* ---------------------------------------------------------------------- */

void CouplingReport::exchange(const clay::DemSession &session, bool last)
{
  measure_overlap();
  overlap_ = std::max(overlap_,now_.depth);
  if (seconds_ <= 0.) return;
  // every rank must come to the same decision: the first rank's clock counts
  int due = last || MPI_Wtime() - last_line_ >= seconds_;
  if (comm->nprocs > 1) MPI_Bcast(&due,1,MPI_INT,0,world);
  if (!due) return;
  last_line_ = MPI_Wtime();
  line(session);
}

/* ---------------------------------------------------------------------- */

void CouplingReport::line(const clay::DemSession &session)
{
  double mine[2] = {overlap_,session.reported()}, worst[2];
  MPI_Allreduce(mine,worst,2,MPI_DOUBLE,MPI_MAX,world);
  clay::Progress now;
  if (Fix *curve = modify->find_fix_style("settling/curve",0)) now.interface = curve->compute_vector(0);
  if (comm->me) return;

  now.time = update->get_cur_time();
  now.done = double(update->ntimestep - update->firststep)
           / std::max<bigint>(1,update->laststep - update->firststep);
  now.spent = MPI_Wtime() - began_;
  now.overlap = worst[0];
  now.momentum = worst[1];
  const std::string text = now.line();
  if (screen) { fprintf(screen,"clayFoam: %s\n",text.c_str()); fflush(screen); }
  if (logfile) fprintf(logfile,"clayFoam: %s\n",text.c_str());
}

/* ---------------------------------------------------------------------- */

void CouplingReport::finish(const clay::DemSession &session, int interval, double wall_overlap)
{
  wall_ += MPI_Wtime() - began_;
  cpu_ += double(std::clock() - cpu_began_ - cpu_waited_)/CLOCKS_PER_SEC;
  output_ += timer->array[TIME_OUTPUT];
  steps_ += update->laststep - update->firststep;

  const clay::Timing &timing = session.timing();
  double mine[7] = {wall_,timing.exchange,timing.waiting,output_,overlap_,wall_overlap,cpu_}, worst[7];
  MPI_Allreduce(mine,worst,7,MPI_DOUBLE,MPI_MAX,world);
  bigint n = atom->nlocal, now;
  MPI_Allreduce(&n,&now,1,MPI_LMP_BIGINT,MPI_SUM,world);
  double sent = timing.bytesSent, bytes;
  MPI_Allreduce(&sent,&bytes,1,MPI_DOUBLE,MPI_SUM,world);
  FixMultisphere *ms = static_cast<FixMultisphere*>(modify->find_fix_style("multisphere",0));
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
  if (Fix *rest = modify->find_fix_style("rest/bed",0))
    run.rest = {{rest->compute_vector(0),rest->compute_vector(1),rest->compute_vector(2)}};
  run.particles = particles_;
  run.particlesLost = std::max(0L,particles_ - long(now));
  run.clumps = clumps;
  run.overlap = worst[4];
  run.wallOverlap = worst[5];
  run.timestep = update->dt;
  run.interval = interval;
  run.settings = settings_;
  run.warnings = warnings_;

  std::ofstream out(file_);
  out << run.json();
  if (!out)
    error->one(FLERR,("Fix couple/foam: cannot write the stats file '" + file_ + "'").c_str());
}
