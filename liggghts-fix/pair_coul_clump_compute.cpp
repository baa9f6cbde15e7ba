/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   Bodies are small, and the cut-off is several of their sizes: so the loop
   runs over pairs of bodies, and over all spheres of the two at once, in
   contiguous arrays. No neighbour list is asked for, and the granular lists
   keep their short range; atoms of other processors within the cut-off are
   asked for through the ghost cut-off.
------------------------------------------------------------------------- */

#include "pair_coul_clump.h"

#include <algorithm>
#include <cmath>

#include "atom.h"
#include "domain.h"
#include "fix_multisphere.h"
#include "neighbor.h"
#include "update.h"

using namespace LAMMPS_NS;

/* ----------------------------------------------------------------------
   groups: the spheres of one body; loose spheres by cells
------------------------------------------------------------------------- */

namespace {

struct Place {
  int body, cell[3], atom;
  bool same_group(const Place &o) const
  {
    return body == o.body && cell[0] == o.cell[0] && cell[1] == o.cell[1] && cell[2] == o.cell[2];
  }
  bool operator<(const Place &o) const
  {
    if (body != o.body) return body < o.body;
    for (int d = 0; d < 3; d++)
      if (cell[d] != o.cell[d]) return cell[d] < o.cell[d];
    return atom < o.atom;
  }
};

}

void PairCoulClump::lay_out()
{
  laid_out_ = neighbor->lastcall;
  nall_ = atom->nlocal + atom->nghost;
  evaluated_ = -1;

  double **x = atom->x;
  std::vector<Place> places;
  places.reserve(nall_);
  for (int i = 0; i < nall_; i++) {
    if (charge_[atom->type[i]] == 0.0) continue;
    const int body = multisphere_ ? std::max(-1, multisphere_->belongs_to(i)) : -1;
    Place p = { body, {0, 0, 0}, i };
    if (body < 0)
      for (int d = 0; d < 3; d++) p.cell[d] = static_cast<int>(floor(3.0*x[i][d]/law_.cutoff));
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
        places[k].cell[d] = static_cast<int>(lround(away/domain->prd[d]));
        periodic = true;
      }
  }
  if (periodic) std::sort(places.begin(), places.end());

  order_.clear();
  ends_.clear();
  for (std::size_t k = 0; k < places.size(); k++) {
    order_.push_back(places[k].atom);
    if (k+1 == places.size() || !places[k].same_group(places[k+1])) ends_.push_back(k+1);
  }
}

/* ---------------------------------------------------------------------- */

void PairCoulClump::gather()
{
  double **x = atom->x;
  groups_.clear();
  std::size_t k = 0;
  for (std::size_t g = 0; g < ends_.size(); g++) {
    bool owned = false;
    const int body = multisphere_ ? std::max(-1, multisphere_->belongs_to(order_[k])) : -1;
    for (; k < static_cast<std::size_t>(ends_[g]); k++) {
      const int i = order_[k];
      groups_.add(x[i][0], x[i][1], x[i][2], charge_[atom->type[i]]);
      owned = owned || i < atom->nlocal;
    }
    groups_.close(body, owned);
  }
}

/* ---------------------------------------------------------------------- */

void PairCoulClump::add_forces(double factor)
{
  double **f = atom->f;
  for (std::size_t k = 0; k < order_.size(); k++) {
    const int i = order_[k];
    if (i >= atom->nlocal) continue;
    f[i][0] += factor*groups_.fx[k];
    f[i][1] += factor*groups_.fy[k];
    f[i][2] += factor*groups_.fz[k];
  }
}

/* ----------------------------------------------------------------------
   energy and virial of this step, whether or not its forces are applied
------------------------------------------------------------------------- */

void PairCoulClump::tally()
{
  const std::vector<int> &order = order_;
  clay::eachPair(groups_, law_, [&](int a, int b, double r) {
    const double qq = groups_.q[a]*groups_.q[b];
    ev_tally(order[a], order[b], atom->nlocal, 0, 0.0, law_.energy(qq, r), law_.forceOverDistance(qq, r),
             groups_.x[a]-groups_.x[b], groups_.y[a]-groups_.y[b], groups_.z[a]-groups_.z[b]);
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
  // hold: the same force on every step, until it is N steps old
  const bigint step = update->ntimestep;
  const bool due = hold_ ? (evaluated_ < 0 || step - evaluated_ >= every_ || step < evaluated_)
                         : step % every_ == 0;
  if (due || evflag) gather();
  if (due) {
    clay::coulombForces(groups_, law_);
    evaluated_ = step;
    evaluations_++;
  }
  if (hold_) add_forces(1.0);
  else if (due) add_forces(every_);

  if (evflag) tally();
}

/* ---------------------------------------------------------------------- */

double PairCoulClump::single(int i, int j, int itype, int jtype, double rsq,
                             double, double factor_lj, double &fforce)
{
  fforce = 0.0;
  if (multisphere_ && multisphere_->belongs_to(i) >= 0 &&
      multisphere_->belongs_to(i) == multisphere_->belongs_to(j)) return 0.0;
  const double r = sqrt(rsq), qq = charge_[itype]*charge_[jtype];
  fforce = law_.forceOverDistance(qq, r);
  return law_.energy(qq, r);
}
