/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   Bodies are small, and the cut-off is several of their sizes: so the loop
   runs over pairs of bodies, and over all spheres of the two at once, in
   contiguous arrays. No neighbour list is asked for, and the granular lists
   keep their short range; atoms of other processors within the cut-off are
   asked for through the ghost cut-off.
------------------------------------------------------------------------- */

#include "coulomb/pair_coul_clump.h"

#include <algorithm>
#include <cmath>

#include "atom.h"
#include "domain.h"
#include "fix_multisphere.h"
#include "neighbor.h"
#include "update.h"
#include "simd/cell_index.h"

using namespace LAMMPS_NS;

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

bool PairCoulClump::same_bodies() const
{
  if (atom->nghost > 0 || atom->nlocal != nall_ || !multisphere_) return false;
  std::size_t charged = 0;
  for (int i = 0; i < nall_; i++) charged += charge_[atom->type[i]] != 0.0;
  if (charged != order_.size()) return false;
  for (std::size_t g = 0; g < groups_.groups.size(); g++) {
    const clay::ChargeGroup &group = groups_.groups[g];
    if (group.loose() || !group.acted) return false;  // spheres that were ghosts are this processor's now
    for (int k = group.begin; k < group.end; k++)
      if (multisphere_->belongs_to(order_[k]) != group.body || charge_[atom->type[order_[k]]] != groups_.q[k])
        return false;
  }
  return true;
}

/* ---------------------------------------------------------------------- */

void PairCoulClump::lay_out()
{
  laid_out_ = neighbor->lastcall;
  evaluated_ = -1;  // on one processor, too, so that their number does not show
  if (same_bodies()) return;
  const int n = nall_ = atom->nlocal + atom->nghost;

  double **x = atom->x;
  std::vector<Place> places;
  places.reserve(n);
  for (int i = 0; i < n; i++) {
    if (charge_[atom->type[i]] == 0.0) continue;
    const int body = multisphere_ ? std::max(-1, multisphere_->belongs_to(i)) : -1;
    Place p = {body, {0, 0, 0}, i >= atom->nlocal, i};
    if (body < 0)
      for (int d = 0; d < 3; d++) p.cell[d] = clay::cell_number(floor(3.0 * x[i][d] / law_.cutoff));
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
    groups_.add(x[i][0], x[i][1], x[i][2], charge_[atom->type[i]]);
    if (k + 1 == places.size() || !places[k].same_group(places[k + 1])) groups_.close(places[k].body, !places[k].ghost);
  }
}

/* ----------------------------------------------------------------------
   where the spheres are some time ahead
------------------------------------------------------------------------- */

void PairCoulClump::gather(double ahead)
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

void PairCoulClump::take_forces(double factor)
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

void PairCoulClump::add_forces()
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

void PairCoulClump::tally()
{
  const std::vector<int> &order = order_;
  clay::eachPair(groups_, law_, [&](int a, int b, double r) {
    const double qq = groups_.q[a] * groups_.q[b];
    ev_tally(order[a], order[b], atom->nlocal, 0, 0.0, law_.energy(qq, r), law_.forceOverDistance(qq, r),
             groups_.x[a] - groups_.x[b], groups_.y[a] - groups_.y[b], groups_.z[a] - groups_.z[b]);
  });
}

/* ---------------------------------------------------------------------- */

void PairCoulClump::compute(int eflag, int vflag)
{
  if (eflag || vflag) ev_setup(eflag, vflag);
  else ev_unset();
  if (!charged_) return;

  if (neighbor->lastcall != laid_out_ || atom->nlocal + atom->nghost != nall_) lay_out();

  // impulse: N times the force on every N-th step, nothing between
  // hold: the same force on every step, until it is N steps old; that of the middle of these
  const bigint step = update->ntimestep;
  const bool due = hold_ ? (evaluated_ < 0 || step - evaluated_ >= every_ || step < evaluated_) : step % every_ == 0;
  if (due) {
    gather(centred_ ? 0.5 * (every_ - 1) * update->dt : 0.0);
    groups_.act(law_);
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

double PairCoulClump::single(int i, int j, int itype, int jtype, double rsq, double, double factor_lj, double &fforce)
{
  fforce = 0.0;
  if (multisphere_ && multisphere_->belongs_to(i) >= 0 && multisphere_->belongs_to(i) == multisphere_->belongs_to(j))
    return 0.0;
  const double r = sqrt(rsq), qq = charge_[itype] * charge_[jtype];
  fforce = law_.forceOverDistance(qq, r);
  return law_.energy(qq, r);
}
