/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   Of the pairs of the neighbour list, those that touch or are about to are
   taken out, and looked at alone until any others could have come to touch.
------------------------------------------------------------------------- */

#include "pair_gran_lean.h"

#include <algorithm>
#include <cmath>

#include "atom.h"
#include "force.h"
#include "modify.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "update.h"

using namespace LAMMPS_NS;

namespace {

enum { SEEN = 5 };              // numbers of an atom that are compared
const double STEPS = 25.0;      // aimed at between two searches
const double LEAST = 1.0e-3;    // smallest and largest margin over the radius
const double MOST = 0.2;

}

/* ----------------------------------------------------------------------
   what only gran's own loop can do is left to it
------------------------------------------------------------------------- */

bool PairGranLean::lean_step(int eflag, int vflag, int addflag) const
{
  return !eflag && !vflag && !addflag && listgranhistory && atom->rmass && computeflag() && !fr_pair() &&
         !storeContactForces() && !store_contact_forces_stress_ && !store_multicontact_data_ &&
         !store_sum_normal_force() && !flags_read_;
}

/* ---------------------------------------------------------------------- */

clay::ContactLaw PairGranLean::law(int i, int j) const
{
  const int a = atom->type[i], b = atom->type[j];
  const double mi = atom->rmass[i], mj = atom->rmass[j];
  double moving = mi*mj/(mi + mj);
  if (atom->mask[i] & freeze_group_bit()) moving = mj;
  if (atom->mask[j] & freeze_group_bit()) moving = mi;

  clay::ContactLaw law;
  law.friction = friction_[a][b];
  if (modulus_given_) {
    // 16/15 sqrt(R) Y (15 m v^2/(16 sqrt(R) Y))^(1/5), as gran has it; the
    // damping that gives the coefficient of restitution
    const double ri = atom->radius[i], rj = atom->radius[j];
    const double hard = sqrt(ri*rj/(ri + rj))*modulus_[a][b];
    const double k = 16.0/15.0*hard*pow(15.0*moving*speed_*speed_/(16.0*hard),0.2);
    const double e2 = restitution_log_[a][b]*restitution_log_[a][b];
    law.kn = k/force->nktv2p;
    law.kt = softer_ ? 0.285714286*law.kn : law.kn;
    law.gamman = sqrt(4.0*moving*k*e2/(e2 + M_PI*M_PI));
    law.gammat = tangential_damping_ ? law.gamman : 0.0;
    return law;
  }
  if (absolute_damping_) moving = 1.0;
  law.kn = kn_[a][b]/force->nktv2p;
  law.kt = kt_[a][b]/force->nktv2p;
  law.gamman = moving*gamman_[a][b];
  law.gammat = tangential_damping_ ? moving*gammat_[a][b] : 0.0;
  return law;
}

/* ----------------------------------------------------------------------
   no atom has gone half of the margin since, nor changed in size or mass
------------------------------------------------------------------------- */

bool PairGranLean::pairs_hold()
{
  const int nall = atom->nlocal + atom->nghost;
  if (!sought_ || built_ != neighbor->lastcall || inum_ != list->inum ||
      seen_.size() != static_cast<std::size_t>(SEEN)*nall) return false;
  const double far2 = 0.25*margin_*margin_;
  double largest = 0.0;
  bool changed = false;
  for (int i = 0; i < nall; i++) {
    const double *x = atom->x[i], *s = &seen_[static_cast<std::size_t>(SEEN)*i];
    const double dx = x[0] - s[0], dy = x[1] - s[1], dz = x[2] - s[2];
    largest = std::max(largest,dx*dx + dy*dy + dz*dz);
    changed |= (atom->radius[i] != s[3]) | (atom->rmass[i] != s[4]);
  }
  return largest < far2 && !changed;
}

/* ---------------------------------------------------------------------- */

void PairGranLean::seek_pairs()
{
  if (sought_ && built_ == neighbor->lastcall && inum_ == list->inum) hand_back_history();
  double **x = atom->x, **v = atom->v;
  const double *radius = atom->radius;
  const int nall = atom->nlocal + atom->nghost;

  double fastest2 = 0.0, largest = 0.0;
  seen_.resize(static_cast<std::size_t>(SEEN)*nall);
  for (int i = 0; i < nall; i++) {
    const double state[SEEN] = { x[i][0], x[i][1], x[i][2], radius[i], atom->rmass[i] };
    std::copy(state,state+SEEN,&seen_[static_cast<std::size_t>(SEEN)*i]);
    fastest2 = std::max(fastest2,v[i][0]*v[i][0] + v[i][1]*v[i][1] + v[i][2]*v[i][2]);
    largest = std::max(largest,radius[i]);
  }
  // beyond the skin the list itself is not complete
  margin_ = std::min(neighbor->skin,std::min(MOST*largest,
                     std::max(LEAST*largest,2.0*STEPS*update->dt*sqrt(fastest2))));

  pairs_.clear();
  kept_.clear();
  flag_.clear();
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    const int *neighbours = list->firstneigh[i];
    int *flags = listgranhistory->firstneigh[i];
    double *history = listgranhistory->firstdouble[i];
    for (int jj = 0; jj < list->numneigh[i]; jj++) {
      const int j = neighbours[jj] & NEIGHMASK;
      const double dx = x[i][0]-x[j][0], dy = x[i][1]-x[j][1], dz = x[i][2]-x[j][2];
      const double reach = radius[i] + radius[j] + margin_;
      if (dx*dx + dy*dy + dz*dz >= reach*reach) continue;
      double *shear = &history[dnum()*jj];
      pairs_.add(i,j,radius[i],radius[j],law(i,j),shear,false);
      kept_.push_back(shear);
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
  if (!lean_step(eflag,vflag,addflag)) {
    hand_back_history();
    PairGranProxy::compute_force(eflag,vflag,addflag);
    return;
  }
  ev_unset();
  if (!pairs_hold()) seek_pairs();
  if (pairs_.size() == 0) return;

  const clay::ContactSpheres spheres = { atom->x[0], atom->v[0], atom->omega[0],
                                         atom->f[0], atom->torque[0], atom->nlocal };
  clay::contactForces(spheres,pairs_,update->dt,shearupdate(),limit_force_);
}
