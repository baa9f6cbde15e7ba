// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/coupling_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

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
  start_time_(0.), overlap_(0.), now_(0.), pair_{0,0}
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
   largest overlap of two spheres of different bodies, over the smaller
   one's diameter; this rank's pairs only, not of two that no fix moves
------------------------------------------------------------------------- */

double CouplingReport::max_overlap()
{
  Pair *gran = force->pair_match("gran",0);
  if (!gran || !gran->list) return 0.;
  const NeighList *list = gran->list;
  double **x = atom->x;
  const double *radius = atom->radius;
  const int *mask = atom->mask, movers = moving_groups(lmp);

  double worst = 0.;
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    const int *neighbours = list->firstneigh[i];
    for (int jj = 0; jj < list->numneigh[i]; jj++) {
      const int j = neighbours[jj] & NEIGHMASK;
      const double dx = x[i][0]-x[j][0], dy = x[i][1]-x[j][1], dz = x[i][2]-x[j][2];
      const double sum = radius[i] + radius[j], r2 = dx*dx + dy*dy + dz*dz;
      if (r2 >= sum*sum || !((mask[i] | mask[j]) & movers)) continue;
      const double overlap = 0.5*(sum - sqrt(r2))/std::min(radius[i],radius[j]);
      if (overlap <= worst) continue;
      worst = overlap;
      pair_[0] = atom->tag[i];
      pair_[1] = atom->tag[j];
    }
  }
  return worst;
}

/* ---------------------------------------------------------------------- */

void CouplingReport::exchange(const clay::DemSession &session, bool last)
{
  now_ = max_overlap();
  overlap_ = std::max(overlap_,now_);
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
  Fix *curve = modify->find_fix_style("settling/curve",0);
  const double interface = curve ? curve->compute_vector(0) : 0.;
  if (comm->me) return;

  const double done = double(update->ntimestep - update->firststep)
                    / std::max<bigint>(1,update->laststep - update->firststep);
  const double spent = MPI_Wtime() - began_;
  const long eta = done > 0. ? lround(spent*(1. - done)/done) : 0;

  char text[256];
  int n = snprintf(text,sizeof text,"t = %.4f s  %5.1f %%  ETA %ld:%02ld",
                   update->get_cur_time(),100.*done,eta/60,eta%60);
  if (curve) n += snprintf(text+n,sizeof text-n,"  interface %.4f m",interface);
  snprintf(text+n,sizeof text-n,"  overlap/d %.2e  momentum %.1e",worst[0],worst[1]);
  if (screen) { fprintf(screen,"clayFoam: %s\n",text); fflush(screen); }
  if (logfile) fprintf(logfile,"clayFoam: %s\n",text);
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
  nlohmann::ordered_json j;
  j["program"] = universe->version;
  j["ranks"] = comm->nprocs;
  j["simulated_s"] = update->get_cur_time() - start_time_;
  j["wall_s"] = worst[0];
  j["dem_s"] = worst[0] - timing.exchange - timing.waiting - output_;
  j["exchange_s"] = worst[1];
  j["waiting_s"] = worst[2];
  j["output_s"] = worst[3];
  j["dem_cpu_s"] = worst[6];
  j["dem_steps"] = steps_;
  if (Fix *rest = modify->find_fix_style("rest/bed",0)) {
    j["dem_steps_left_out"] = rest->compute_vector(0);
    j["rest_height_missed_m"] = rest->compute_vector(1);
    j["rest_wakings"] = rest->compute_vector(2);
  }
  j["exchanges"] = timing.exchanges;
  j["bytes_sent"] = bytes;
  j["particles"] = particles_;
  j["particles_lost"] = std::max(0L,particles_ - long(now));
  j["clumps"] = clumps;
  j["max_overlap_over_d"] = worst[4];
  j["max_wall_overlap_over_d"] = worst[5];
  j["settings"] = {{"timestep_s",update->dt}, {"coupling_interval_steps",interval},
                   {"coupling_interval_s",update->dt*interval}};
  for (const auto &s : settings_) j["settings"][s.first] = s.second;
  j["warnings"] = warnings_;

  std::ofstream out(file_);
  out << j.dump(2) << '\n';
  if (!out)
    error->one(FLERR,("Fix couple/foam: cannot write the stats file '" + file_ + "'").c_str());
}
