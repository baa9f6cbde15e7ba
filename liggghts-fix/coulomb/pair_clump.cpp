/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   Bodies are small, and the cut-off is several of their sizes: so the loop
   runs over pairs of bodies, and over all spheres of the two at once, in
   contiguous arrays. No neighbour list is asked for, and the granular lists
   keep their short range; atoms of other processors within the cut-off are
   asked for through the ghost cut-off.
------------------------------------------------------------------------- */

#include "coulomb/pair_clump.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_multisphere.h"
#include "force.h"
#include "memory.h"
#include "modify.h"
#include "neighbor.h"
#include "update.h"
#include "script/values.h"
#include "simd/cell_index.h"

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

PairClump::PairClump(LAMMPS *lmp, const char *style, const char *value) :
  Pair(lmp), every_(1), hold_(false), active_(false), multisphere_(NULL), style_(style), what_(value), centred_(false),
  laid_out_(-1), nall_(-1), evaluated_(-1), evaluations_(0)
{
  no_virial_fdotr_compute = 1;
}

PairClump::~PairClump()
{
  if (allocated) {
    memory->destroy(setflag);
    memory->destroy(cutsq);
  }
}

/* ---------------------------------------------------------------------- */

void PairClump::allocate()
{
  allocated = 1;
  const int n = atom->ntypes;
  memory->create(setflag, n + 1, n + 1, "pair:setflag");
  memory->create(cutsq, n + 1, n + 1, "pair:cutsq");
  for (int i = 0; i <= n; i++)
    for (int j = 0; j <= n; j++) {
      setflag[i][j] = 0;
      cutsq[i][j] = 0.0;
    }
  value_.assign(n + 1, 0.0);
  given_.assign(n + 1, 0);
}

/* ---------------------------------------------------------------------- */

void PairClump::refuse(const std::string &words) const
{
  error->all(FLERR, ("Pair style " + style_ + ": " + words).c_str());
}

/* ---------------------------------------------------------------------- */

void PairClump::settings(int narg, char **arg)
{
  every_ = 1;
  hold_ = false;
  try {
    parse(narg, arg);
  } catch (const std::invalid_argument &e) {
    refuse(e.what());
  }
}

void PairClump::parse_every(int narg, char **arg, int &i)
{
  every_ = static_cast<int>(clay::wholeNumber("every", arg[++i], 1, INT_MAX));
  if (i + 1 < narg && (!strcmp(arg[i + 1], "impulse") || !strcmp(arg[i + 1], "hold")))
    hold_ = !strcmp(arg[++i], "hold");
}

/* ----------------------------------------------------------------------
   pair_coeff T T value: of the spheres of a type
------------------------------------------------------------------------- */

double PairClump::value_of(const char *word) const { return clay::number(what_, word); }

void PairClump::coeff(int narg, char **arg)
{
  const std::string start = "Pair coeff for " + style_ + ": ";
  if (narg != 3 || strcmp(arg[0], arg[1]) != 0)
    error->all(FLERR, (start + "a " + what_ + " belongs to one type: pair_coeff T T " + what_).c_str());
  const bool number = strspn(arg[0], "0123456789") == strlen(arg[0]);
  if (number && (atoi(arg[0]) < 1 || atoi(arg[0]) > atom->ntypes))
    error->all(FLERR,
               (start + "atom type " + arg[0] + " has a " + what_ + ", but the box has types 1 to " +
                std::to_string(atom->ntypes))
                   .c_str());
  if (!allocated) allocate();

  int lo, hi;
  force->bounds(arg[0], atom->ntypes, lo, hi);
  double value = 0.0;
  try {
    value = value_of(arg[2]);
  } catch (const std::invalid_argument &e) {
    error->all(FLERR, (start + e.what()).c_str());
  }
  for (int t = lo; t <= hi; t++) {
    value_[t] = value;
    given_[t] = 1;
  }
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) setflag[i][j] = 1;  // check() looks for what is missing
}

/* ---------------------------------------------------------------------- */

void PairClump::check()
{
  for (int t = 1; t <= atom->ntypes; t++)
    if (!allocated || !given_[t]) {
      const std::string type = std::to_string(t);
      refuse("atom type " + type + " has no " + what_ + ": pair_coeff " + type + " " + type + " [" + style_ +
             "] VALUE");
    }
  if (strcmp(update->unit_style, "si") != 0)
    refuse(std::string("units are '") + update->unit_style + "'; they must be si, as its constants are");
  if (force->newton_pair) refuse("newton is on; it must be off");
  if (modify->n_fixes_style("multisphere") > 1) refuse("there are several fixes multisphere; it takes at most one");
  multisphere_ = static_cast<FixMultisphere *>(modify->find_fix_style("multisphere", 0));
}

/* ---------------------------------------------------------------------- */

void PairClump::write_restart(FILE *fp)
{
  write_restart_settings(fp);
  fwrite(&value_[0], sizeof(double), atom->ntypes + 1, fp);
}

void PairClump::read_restart(FILE *fp, const int major, const int minor)
{
  read_restart_settings(fp, major, minor);
  if (!allocated) allocate();
  read_numbers(fp, &value_[0], atom->ntypes + 1);
  for (int i = 1; i <= atom->ntypes; i++) {
    given_[i] = 1;
    for (int j = i; j <= atom->ntypes; j++) setflag[i][j] = 1;
  }
}

void PairClump::read_numbers(FILE *fp, double *to, int n)
{
  if (comm->me == 0 && fread(to, sizeof(double), n, fp) != static_cast<std::size_t>(n))
    error->one(FLERR, ("Pair style " + style_ + ": the restart file ends too early").c_str());
  MPI_Bcast(to, n, MPI_DOUBLE, 0, world);
}

/* ---------------------------------------------------------------------- */

double PairClump::largest_radius() const
{
  double largest = 0.0, smallest = 0.0;
  if (!atom->radius_flag) return largest;
  modify->max_min_rad(largest, smallest);
  double mine = 0.0, all = 0.0;
  for (int i = 0; i < atom->nlocal; i++) mine = std::max(mine, atom->radius[i]);
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_MAX, world);
  return std::max(largest, all);
}

double PairClump::smallest_radius() const
{
  double largest = 0.0, smallest = 0.0;
  modify->max_min_rad(largest, smallest);
  double mine = largest > 0.0 ? smallest : HUGE_VAL, all = 0.0;
  for (int i = 0; i < atom->nlocal; i++) mine = std::min(mine, atom->radius[i]);
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_MIN, world);
  return std::isfinite(all) ? all : 0.0;
}

/* ---------------------------------------------------------------------- */

void PairClump::start(bool active)
{
  active_ = active;
  // With granular atom styles LIGGGHTS hands each processor only the ghosts
  // within half of its cut-off, which is enough for contacts. Here both
  // processors of a pair need the other's atom: twice the range is asked for.
  if (active_) {
    const double range = 2.0 * cutoff() + neighbor->skin;
    comm->cutghostuser = std::max(comm->cutghostuser, range);
  }
  // where they will be then is foreseen by their velocities, which ghosts have only on request
  const bool ghosts = comm->nprocs > 1 || domain->xperiodic || domain->yperiodic || domain->zperiodic;
  centred_ = hold_ && every_ > 1 && (comm->ghost_velocity || !ghosts);
  laid_out_ = evaluated_ = nall_ = -1;
}

/* ----------------------------------------------------------------------
   no list is used, so none is made longer
------------------------------------------------------------------------- */

double PairClump::init_one(int i, int j)
{
  if (setflag[i][j] == 0) error->all(FLERR, "All pair coeffs are not set");
  return 0.0;
}

/* ---------------------------------------------------------------------- */

double PairClump::memory_usage()
{
  return Pair::memory_usage() + order_.size() * (sizeof(int) + 11.0 * sizeof(double));
}

/* ----------------------------------------------------------------------
   groups: the spheres of one body that are this processor's, those that are
   not, and those of its periodic images; loose spheres by cells
------------------------------------------------------------------------- */

namespace {

struct Place {
  int body, cell[3];
  bool ghost;
  int atom;
  bool same_group(const Place &o) const
  {
    return body == o.body && cell[0] == o.cell[0] && cell[1] == o.cell[1] && cell[2] == o.cell[2] && ghost == o.ghost;
  }
  bool operator<(const Place &o) const
  {
    if (body != o.body) return body < o.body;
    for (int d = 0; d < 3; d++)
      if (cell[d] != o.cell[d]) return cell[d] < o.cell[d];
    return ghost != o.ghost ? o.ghost : atom < o.atom;
  }
};

}

/* ----------------------------------------------------------------------
   the same bodies and charges as before, all of this processor
------------------------------------------------------------------------- */

bool PairClump::same_bodies() const
{
  if (atom->nghost > 0 || atom->nlocal != nall_ || !multisphere_) return false;
  std::size_t charged = 0;
  for (int i = 0; i < nall_; i++) charged += takes_part(atom->type[i]);
  if (charged != order_.size()) return false;
  for (std::size_t g = 0; g < groups_.groups.size(); g++) {
    const clay::ChargeGroup &group = groups_.groups[g];
    if (group.loose() || !group.acted) return false;  // spheres that were ghosts are this processor's now
    for (int k = group.begin; k < group.end; k++)
      if (multisphere_->belongs_to(order_[k]) != group.body || strength(order_[k]) != groups_.q[k]) return false;
  }
  return true;
}

/* ---------------------------------------------------------------------- */

void PairClump::lay_out()
{
  laid_out_ = neighbor->lastcall;
  evaluated_ = -1;  // on one processor, too, so that their number does not show
  if (same_bodies()) return;
  const int n = nall_ = atom->nlocal + atom->nghost;

  double **x = atom->x;
  std::vector<Place> places;
  places.reserve(n);
  for (int i = 0; i < n; i++) {
    if (!takes_part(atom->type[i])) continue;
    const int body = multisphere_ ? std::max(-1, multisphere_->belongs_to(i)) : -1;
    Place p = {body, {0, 0, 0}, i >= atom->nlocal, i};
    if (body < 0)
      for (int d = 0; d < 3; d++) p.cell[d] = clay::cell_number(floor(3.0 * x[i][d] / cutoff()));
    places.push_back(p);
  }
  std::sort(places.begin(), places.end());

  // periodic images of a body are groups of their own
  std::size_t first = 0;
  bool periodic = false;
  for (std::size_t k = 0; k < places.size(); k++) {
    if (places[k].body < 0) continue;
    if (places[k].body != places[first].body) first = k;
    for (int d = 0; d < 3; d++)
      if (domain->periodicity[d]) {
        const double away = x[places[k].atom][d] - x[places[first].atom][d];
        places[k].cell[d] = clay::cell_number(std::round(away / domain->prd[d]));
        periodic = true;
      }
  }
  if (periodic) std::sort(places.begin(), places.end());

  order_.clear();
  groups_.clear();
  for (std::size_t k = 0; k < places.size(); k++) {
    const int i = places[k].atom;
    order_.push_back(i);
    groups_.add(x[i][0], x[i][1], x[i][2], strength(i));
    if (with_radii()) groups_.radius.push_back(atom->radius[i]);
    if (k + 1 == places.size() || !places[k].same_group(places[k + 1])) groups_.close(places[k].body, !places[k].ghost);
  }
}

/* ----------------------------------------------------------------------
   where the spheres are some time ahead
------------------------------------------------------------------------- */

void PairClump::gather(double ahead)
{
  double **x = atom->x, **v = atom->v;
  for (std::size_t k = 0; k < order_.size(); k++) {
    const double *xi = x[order_[k]], *vi = v[order_[k]];
    groups_.x[k] = xi[0] + ahead * vi[0];
    groups_.y[k] = xi[1] + ahead * vi[1];
    groups_.z[k] = xi[2] + ahead * vi[2];
  }
  groups_.moved();
}

/* ----------------------------------------------------------------------
   what acts on a body is given to one of its spheres, with the torque about
   that sphere: the body takes them up as it does those on all spheres
------------------------------------------------------------------------- */

void PairClump::take_forces(double factor)
{
  held_.clear();
  for (std::size_t g = 0; g < groups_.groups.size(); g++) {
    const clay::ChargeGroup &group = groups_.groups[g];
    if (!group.acted) continue;
    if (group.loose()) {
      for (int k = group.begin; k < group.end; k++) {
        const Held one = {
            order_[k], {factor * groups_.fx[k], factor * groups_.fy[k], factor * groups_.fz[k]}, {0., 0., 0.}};
        held_.push_back(one);
      }
      continue;
    }
    const clay::Wrench &w = groups_.wrenches[g];
    const int k = group.begin;
    const double r[3] = {group.x - groups_.x[k], group.y - groups_.y[k], group.z - groups_.z[k]};
    Held one = {order_[k], {0., 0., 0.}, {0., 0., 0.}};
    for (int d = 0; d < 3; d++) {
      const int e = (d + 1) % 3, f = (d + 2) % 3;
      one.f[d] = factor * w.f[d];
      one.torque[d] = factor * (w.t[d] + r[e] * w.f[f] - r[f] * w.f[e]);
    }
    held_.push_back(one);
  }
}

/* ---------------------------------------------------------------------- */

void PairClump::add_forces()
{
  double **f = atom->f, **torque = atom->torque_flag ? atom->torque : NULL;
  for (std::size_t k = 0; k < held_.size(); k++) {
    const Held &one = held_[k];
    for (int d = 0; d < 3; d++) f[one.atom][d] += one.f[d];
    if (torque)
      for (int d = 0; d < 3; d++) torque[one.atom][d] += one.torque[d];
  }
}

/* ----------------------------------------------------------------------
   energy and virial of this step, whether or not its forces are applied
------------------------------------------------------------------------- */

void PairClump::tally()
{
  const std::vector<int> &order = order_;
  clay::eachPair(groups_, cutoff(), [&](int a, int b, double r) {
    double f = 0.0;
    const double e = between(a, b, r, f);
    ev_tally(order[a], order[b], atom->nlocal, 0, 0.0, e, f, groups_.x[a] - groups_.x[b], groups_.y[a] - groups_.y[b],
             groups_.z[a] - groups_.z[b]);
  });
}

/* ----------------------------------------------------------------------
   pairs of bodies as one, others sphere by sphere
------------------------------------------------------------------------- */

void PairClump::each_pair(const PairVisit &visit)
{
  if (!active_) return;
  if (neighbor->lastcall != laid_out_ || atom->nlocal + atom->nghost != nall_) lay_out();
  gather(0.0);
  const double reach2 = cutoff() * cutoff();
  for (const auto &p : clay::pairsInReach(groups_, cutoff())) {
    const clay::ChargeGroup &A = groups_.groups[p.first], &B = groups_.groups[p.second];
    const bool whole = !A.loose() && !B.loose();
    double f[3] = {0.0, 0.0, 0.0}, energy = 0.0;
    for (int a = A.begin; a < A.end; a++)
      for (int b = B.begin; b < (p.first == p.second ? a : B.end); b++) {
        const double d[3] = {groups_.x[a] - groups_.x[b], groups_.y[a] - groups_.y[b], groups_.z[a] - groups_.z[b]};
        const double r2 = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
        if (r2 >= reach2) continue;
        double per_r = 0.0;
        const double e = between(a, b, sqrt(r2), per_r);
        energy = whole ? energy + e : e;
        for (int k = 0; k < 3; k++) f[k] = whole ? f[k] + per_r * d[k] : per_r * d[k];
        if (!whole) visit(order_[a], order_[b], share(order_[a], order_[b]), f, energy);
      }
    if (whole) visit(order_[A.begin], order_[B.begin], A.acted && B.acted ? 1.0 : 0.5, f, energy);
  }
}

double PairClump::share(int i, int j) const { return 0.5 * (i < atom->nlocal) + 0.5 * (j < atom->nlocal); }

/* ---------------------------------------------------------------------- */

void PairClump::compute(int eflag, int vflag)
{
  if (eflag || vflag) ev_setup(eflag, vflag);
  else ev_unset();
  if (!active_) return;

  if (neighbor->lastcall != laid_out_ || atom->nlocal + atom->nghost != nall_) lay_out();

  // impulse: N times the force on every N-th step, nothing between
  // hold: the same force on every step, until it is N steps old; that of the middle of these
  const bigint step = update->ntimestep;
  const bool due = hold_ ? (evaluated_ < 0 || step - evaluated_ >= every_ || step < evaluated_) : step % every_ == 0;
  if (due) {
    gather(centred_ ? 0.5 * (every_ - 1) * update->dt : 0.0);
    evaluate();
    take_forces(hold_ ? 1.0 : every_);
    evaluated_ = step;
    evaluations_++;
  }
  if (due || hold_) add_forces();

  if (evflag) {
    gather(0.0);
    tally();
  }
}

/* ---------------------------------------------------------------------- */

bool PairClump::one_body(int i, int j) const
{
  return multisphere_ && multisphere_->belongs_to(i) >= 0 && multisphere_->belongs_to(i) == multisphere_->belongs_to(j);
}
