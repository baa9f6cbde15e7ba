/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   What fix couple/foam keeps in restart files, and how a state is saved
   within a run.
------------------------------------------------------------------------- */

#include <algorithm>
#include <cstring>
#include <vector>

#include "atom.h"
#include "clumps/fix_multisphere_clump.h"
#include "comm.h"
#include "coupling/coupling_report.h"
#include "coupling/fix_couple_foam.h"
#include "coupling/insertion_streams.h"
#include "coupling/runaway_watch.h"
#include "coupling/sound_state.h"
#include "coupling/state_saver.h"
#include "error.h"
#include "exchange/world.h"
#include "memory.h"
#include "update.h"

using namespace LAMMPS_NS;

namespace {

// ahead of what is written here: in older files it is the time, and all there is, or another mark
constexpr double MARK = -2e300, ANY_MARK = -1e299;
enum { MARKED, TIME, LAST_TIME, PAIR, GIVEN, EXCHANGES = GIVEN + 3, BEGIN, PULLS, STREAMS, STATE };

// of an atom in a restart file: how much there is, and which rows
enum { LENGTH, ROWS, HEAD };
enum { WITH_MORE = 1, WITH_KEPT = 2 };

}  // namespace

/* ----------------------------------------------------------------------
   LIGGGHTS keeps the step in its restart files, but not the time
------------------------------------------------------------------------- */

void FixCoupleFoam::write_restart(FILE *fp)
{
  double given[3];
  MPI_Reduce(given_, given, 3, MPI_DOUBLE, MPI_SUM, 0, world);
  std::vector<double> lists = mean_pull_.numbers();
  const size_t pulls = lists.size();
  const std::vector<double> streams = insertion_streams(lmp);
  if (comm->me) return;
  double state[STATE];
  state[MARKED] = MARK;
  state[TIME] = update->get_cur_time();
  state[LAST_TIME] = last_time_;
  state[PAIR] = saver_ ? saver_->number() : 0.;
  std::copy(given, given + 3, state + GIVEN);
  state[EXCHANGES] = static_cast<double>(exchanges_);
  state[BEGIN] = report_->start_time();
  state[PULLS] = static_cast<double>(pulls);
  state[STREAMS] = static_cast<double>(streams.size());
  lists.insert(lists.end(), streams.begin(), streams.end());
  const int size = sizeof state + lists.size() * sizeof(double);
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(state, sizeof(double), STATE, fp);
  fwrite(lists.data(), sizeof(double), lists.size(), fp);
}

void FixCoupleFoam::restart(char *buf)
{
  double state[STATE];
  std::memcpy(state, buf, sizeof(double));
  update->atimestep = update->ntimestep;
  if (state[MARKED] != MARK) {
    if (state[MARKED] < ANY_MARK)
      error->all(FLERR, "Fix couple/foam: the restart file is of another version of clayFoam");
    update->atime = state[MARKED];
    return;
  }
  std::memcpy(state, buf, sizeof state);
  update->atime = state[TIME];
  last_time_ = state[LAST_TIME];
  start_pair_ = state[PAIR];
  if (comm->me == 0) std::copy(state + GIVEN, state + GIVEN + 3, given_);
  exchanges_ = static_cast<long>(state[EXCHANGES]);
  std::vector<double> pulls(static_cast<size_t>(state[PULLS]));
  std::memcpy(pulls.data(), buf + sizeof state, pulls.size() * sizeof(double));
  mean_pull_.take(pulls);
  streams_.resize(static_cast<size_t>(state[STREAMS]));
  std::memcpy(streams_.data(), buf + sizeof state + pulls.size() * sizeof(double), streams_.size() * sizeof(double));
  if (start_pair_ > 0.) report_->goes_on_from(state[BEGIN]);
}

/* ---------------------------------------------------------------------- */

int FixCoupleFoam::size_restart(int)
{
  return HEAD + Row::SIZE + (more_ ? (int)More::SIZE : 0) + (holds_ ? (int)KEPT : 0);
}

int FixCoupleFoam::maxsize_restart() { return HEAD + Row::SIZE + More::SIZE + KEPT; }

int FixCoupleFoam::pack_restart(int i, double *buf)
{
  buf[LENGTH] = size_restart(i);
  buf[ROWS] = (more_ ? WITH_MORE : 0) + (holds_ ? WITH_KEPT : 0);
  double *to = std::copy(fluid_[i], fluid_[i] + Row::SIZE, buf + HEAD);
  if (more_) to = std::copy(more_[i], more_[i] + More::SIZE, to);
  if (holds_) std::copy(kept_[i], kept_[i] + KEPT, to);
  return size_restart(i);
}

void FixCoupleFoam::unpack_restart(int nlocal, int nth)
{
  const double *from = atom->extra[nlocal];
  for (int n = 0; n < nth; n++) from += static_cast<int>(*from);
  const int rows = static_cast<int>(from[ROWS]);
  if (from[LENGTH] != HEAD + Row::SIZE + (rows & WITH_MORE ? (int)More::SIZE : 0) + (rows & WITH_KEPT ? (int)KEPT : 0))
    error->one(FLERR, "Fix couple/foam: the restart file is of another version of clayFoam");
  from += HEAD;
  std::copy(from, from + Row::SIZE, fluid_[nlocal]);
  fluid_[nlocal][Row::SLOT] = -1;
  from += Row::SIZE;
  if (rows & WITH_MORE) {
    make_more();
    std::copy(from, from + More::SIZE, more_[nlocal]);
    from += More::SIZE;
  }
  if (rows & WITH_KEPT) {
    make_kept();
    holds_ = true;
    std::copy(from, from + KEPT, kept_[nlocal]);
  }
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::make_more()
{
  if (more_) return;
  memory->create(more_, atom->nmax, (int)More::SIZE, "couple/foam:more");
  for (int i = 0; i < atom->nmax; i++) std::fill(more_[i], more_[i] + More::SIZE, 0.);
}

void FixCoupleFoam::make_kept()
{
  if (kept_) return;
  memory->create(kept_, atom->nmax, (int)KEPT, "couple/foam:kept");
  for (int i = 0; i < atom->nmax; i++) std::fill(kept_[i], kept_[i] + KEPT, 0.);
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::hold_forces()
{
  for (int i = 0; i < atom->nlocal; i++) {
    double *to = std::copy(atom->f[i], atom->f[i] + 3, kept_[i]);
    to = std::copy(atom->torque[i], atom->torque[i] + 3, to);
    std::copy(fluid_[i] + Row::FORCE, fluid_[i] + Row::FORCE + 3, to);
  }
  if (bodies_) bodies_->hold_forces();
  holds_ = true;
}

void FixCoupleFoam::take_held_forces()
{
  if (!holds_ || idle_) return;
  for (int i = 0; i < atom->nlocal; i++) {
    std::copy(kept_[i], kept_[i] + 3, atom->f[i]);
    std::copy(kept_[i] + 3, kept_[i] + 6, atom->torque[i]);
    std::copy(kept_[i] + 6, kept_[i] + 9, fluid_[i] + Row::FORCE);
  }
  if (bodies_) bodies_->take_held_forces();
  holds_ = false;
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::go_on_inserting()
{
  go_on_with_streams(lmp, streams_);
  streams_.clear();
}

/* ---------------------------------------------------------------------- */

bigint FixCoupleFoam::next_exchange() const
{
  const bigint every = settings_.interval;
  return update->firststep + ((update->ntimestep - update->firststep) / every + 1) * every;
}

/* ----------------------------------------------------------------------
   the clock is set as the file has it: it gains no rounding by the steps
------------------------------------------------------------------------- */

void FixCoupleFoam::begins_saving()
{
  save_due_ = false;
  if (pending_) take_answer();
  update->update_time();
  if (bodies_) bodies_->take_given(given_);
  hold_forces();
  saving_ = true;
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::save()
{
  if (watch_) {
    // ahead of the exchange, where it looks as well
    report_->measure_overlap();
    watch_->overlaps(report_->overlap(), report_->first(), report_->second());
  }
  clay::SavedPair pair;
  if (!is_sound()) report_->warn("no state was saved: a particle is NaN or moves more than its diameter in a step");
  else if ((pair = saver_->write()).number == 0.) report_->warn("no state was saved: " + saver_->why());
  send(update->ntimestep == update->laststep, pair);
  take_answer();
  if (pair.number > 0.) tell_saved();
}

void FixCoupleFoam::tell_saved()
{
  saver_->look_for_it();
  clay::setLastWords(saver_->last_words());
  if (watch_) watch_->last_words(saver_->last_words());
}

/* ----------------------------------------------------------------------
   a state that has run away never takes the place of a good one
------------------------------------------------------------------------- */

bool FixCoupleFoam::is_sound() const
{
  int sound = clay::is_sound(spheres(), atom->nlocal, update->dt, kept_, KEPT), all;
  MPI_Allreduce(&sound, &all, 1, MPI_INT, MPI_MIN, world);
  return all;
}

void FixCoupleFoam::ends_saving()
{
  saving_ = false;
  if (stop_) stop(stop_);
}

void FixCoupleFoam::save_last()
{
  save();
  saving_ = holds_ = false;
}
