/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   Steps in which fix rest/bed keeps the particles still: the fluid goes on,
   and is given what a particle at rest received from it.
------------------------------------------------------------------------- */

#include "coupling/fix_couple_foam.h"

#include <algorithm>
#include <cmath>

#include "atom.h"
#include "fix_gravity.h"
#include "modify.h"
#include "update.h"

using namespace LAMMPS_NS;

/* ----------------------------------------------------------------------
   free spheres of this rank, then the bodies' spheres: K u + f of each
------------------------------------------------------------------------- */

void FixCoupleFoam::still_forces(std::vector<double> &forces) const
{
  forces.clear();
  auto put = [&](const double *s) {
    for (int k = 0; k < 3; k++) forces.push_back(s[LOAD+k] + s[DRAG]*s[VELOCITY+k]);
  };
  for (int i : free_) put(fluid_[i]);
  for (const auto &s : spheres_) put(fluid_[s.atom]);
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::rest(bool still)
{
  if (still == still_) return;
  if (still) {
    if (pending_) take_answer();
    if (listed_ != atom->nlocal) list_free();
    still_forces(still_force_);
    unseen_ = false;
  } else book_rest();
  still_ = still;
}

/* ----------------------------------------------------------------------
   the contacts take up what the fluid gives to a particle at rest
------------------------------------------------------------------------- */

void FixCoupleFoam::book_rest()
{
  if (still_steps_ == 0) return;
  const double time = still_steps_*update->dt;
  std::vector<double> forces;
  still_forces(forces);
  const double *f = forces.data();
  for (int i : free_)
    for (int k = 0; k < 3; k++) fluid_[i][IMPULSE+k] += time*(*f++);
  for (const auto &s : spheres_) {
    const double impulse[3] = {time*f[0],time*f[1],time*f[2]};
    bodies_->add_impulse(s.body,impulse);
    f += 3;
  }
  still_steps_ = 0;
}

/* ---------------------------------------------------------------------- */

bool FixCoupleFoam::rest_step(double tolerance)
{
  if (pending_) take_answer();
  if (unseen_) {
    unseen_ = false;
    double g[3] = {0.,0.,0.};
    FixGravity *gravity = static_cast<FixGravity*>(modify->find_fix_style("gravity",0));
    if (gravity) gravity->get_gravity(g);
    const double limit = tolerance*std::sqrt(g[0]*g[0] + g[1]*g[1] + g[2]*g[2]);

    std::vector<double> forces;
    still_forces(forces);
    int changed = forces.size() != still_force_.size(), any;
    size_t n = 0;
    auto look = [&](double mass) {
      double d2 = 0.;
      for (int k = 0; k < 3; k++) d2 += std::pow(forces[3*n+k] - still_force_[3*n+k],2);
      changed |= d2 > limit*limit*mass*mass;
      n++;
    };
    if (!changed) {
      for (int i : free_) look(atom->rmass[i]);
      for (const auto &s : spheres_) look(s.fraction*bodies_->body_mass(s.body));
    }
    MPI_Allreduce(&changed,&any,1,MPI_INT,MPI_MAX,world);
    if (any) return false;
  }
  still_steps_++;
  return true;
}
