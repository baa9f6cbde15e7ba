/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   Of the pairs of the neighbour list, those that touch or are about to are
   taken out, and looked at alone until any others could have come to touch.
------------------------------------------------------------------------- */

#include "contacts/pair_gran_lean.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "atom.h"
#include "force.h"
#include "modify.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "update.h"

using namespace LAMMPS_NS;

namespace {

const double STEPS = 25.0;    // aimed at between two searches
const double LEAST = 1.0e-3;  // smallest and largest margin over the radius
const double MOST = 0.2;

}

/* ----------------------------------------------------------------------
   what only gran's own loop can do is left to it
------------------------------------------------------------------------- */

bool PairGranLean::lean_step(int eflag, int vflag, int addflag) const
{
  return unfit_.empty() && !eflag && !vflag && !addflag && (listgranhistory || !model_.kind.history()) && atom->rmass &&
      computeflag() && !storeContactForces() && !store_contact_forces_stress_ && !store_multicontact_data_ &&
      !store_sum_normal_force() && !flags_read_;
}

/* ----------------------------------------------------------------------
   kept, as in most beds the next pair has the same
------------------------------------------------------------------------- */

const clay::ContactLaw &PairGranLean::law(int i, int j)
{
  const int a = atom->type[i], b = atom->type[j];
  double mi = atom->rmass[i], mj = atom->rmass[j];
  if (fr_pair()) {
    const double *body = mr_pair();
    if (body[i] > 0.0) mi = body[i];
    if (body[j] > 0.0) mj = body[j];
  }
  double moving = mi * mj / (mi + mj);
  if (atom->mask[i] & freeze_group_bit()) moving = mj;
  if (atom->mask[j] & freeze_group_bit()) moving = mi;

  const double ri = atom->radius[i], rj = atom->radius[j];
  if (a != law_types_[0] || b != law_types_[1] || ri != law_sizes_[0] || rj != law_sizes_[1] ||
      moving != law_sizes_[2]) {
    law_ = coefficients_.law(model_, a, b, ri * rj / (ri + rj), moving, force->nktv2p);
    law_types_[0] = a;
    law_types_[1] = b;
    law_sizes_[0] = ri;
    law_sizes_[1] = rj;
    law_sizes_[2] = moving;
  }
  return law_;
}

/* ----------------------------------------------------------------------
   no atom has gone half of the margin since, nor changed in size or mass
------------------------------------------------------------------------- */

bool PairGranLean::pairs_hold()
{
  const int nall = atom->nlocal + atom->nghost;
  if (!sought_ || built_ != neighbor->lastcall || inum_ != list->inum ||
      seen_mass_.size() != static_cast<std::size_t>(nall))
    return false;
  return nall == 0 ||
      (!std::memcmp(seen_radius_.data(), atom->radius, nall * sizeof(double)) &&
       !std::memcmp(seen_mass_.data(), atom->rmass, nall * sizeof(double)) &&
       clay::stayed(atom->x[0], seen_x_.data(), nall, 0.5 * margin_));
}

/* ---------------------------------------------------------------------- */

void PairGranLean::seek_pairs()
{
  if (sought_ && built_ == neighbor->lastcall && inum_ == list->inum) hand_back_history();
  double **x = atom->x, **v = atom->v;
  const double *radius = atom->radius;
  const int nall = atom->nlocal + atom->nghost;

  double fastest2 = 0.0, largest = 0.0;
  if (nall) seen_x_.assign(x[0], x[0] + static_cast<std::size_t>(3) * nall);
  seen_radius_.assign(radius, radius + nall);
  seen_mass_.assign(atom->rmass, atom->rmass + nall);
  for (int i = 0; i < nall; i++) {
    fastest2 = std::max(fastest2, v[i][0] * v[i][0] + v[i][1] * v[i][1] + v[i][2] * v[i][2]);
    largest = std::max(largest, radius[i]);
  }
  // beyond the skin the list itself is not complete
  margin_ = std::min(neighbor->skin,
                     std::min(MOST * largest, std::max(LEAST * largest, 2.0 * STEPS * update->dt * sqrt(fastest2))));

  law_types_[0] = law_types_[1] = 0;  // coefficients may have changed
  pairs_.clear();
  kept_.clear();
  flag_.clear();
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    const int *neighbours = list->firstneigh[i];
    int *flags = listgranhistory ? listgranhistory->firstneigh[i] : nullptr;
    double *history = listgranhistory ? listgranhistory->firstdouble[i] : nullptr;
    for (int jj = 0; jj < list->numneigh[i]; jj++) {
      const int j = neighbours[jj] & NEIGHMASK;
      const double dx = x[i][0] - x[j][0], dy = x[i][1] - x[j][1], dz = x[i][2] - x[j][2];
      const double reach = radius[i] + radius[j] + margin_;
      if (dx * dx + dy * dy + dz * dz >= reach * reach) continue;
      double *before = history ? &history[dnum() * jj] : nullptr;
      pairs_.add(i, j, radius[i], radius[j], law(i, j), before, false);
      if (!history) continue;
      kept_.push_back(before);
      flag_.push_back(&flags[jj]);
    }
  }
  sought_ = true;
  built_ = neighbor->lastcall;
  inum_ = list->inum;
  searches_++;
}

/* ---------------------------------------------------------------------- */

void PairGranLean::compute_force(int eflag, int vflag, int addflag)
{
  if (!lean_step(eflag, vflag, addflag)) {
    hand_back_history();
    PairGranProxy::compute_force(eflag, vflag, addflag);
    return;
  }
  ev_unset();
  if (!pairs_hold()) seek_pairs();
  if (pairs_.size() == 0) return;

  const clay::ContactSpheres spheres = {atom->x[0], atom->v[0],      atom->omega[0],
                                        atom->f[0], atom->torque[0], atom->nlocal};
  clay::contactForces(spheres, pairs_, update->dt, shearupdate());
}
