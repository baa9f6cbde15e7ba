/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   What fix couple/foam keeps for each sphere, and the fluid's force on those
   that are in no body.
------------------------------------------------------------------------- */

#include "coupling/fix_couple_foam.h"

#include <algorithm>

#include "atom.h"
#include "clumps/body_drag.h"
#include "thermal/fix_brownian.h"
#include "memory.h"
#include "update.h"

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

bool FixCoupleFoam::free_sphere(int i) const
{
  return (atom->mask[i] & groupbit) && !(bodies_ && bodies_->belongs_to(i) >= 0);
}

/* ----------------------------------------------------------------------
   free spheres; bodies get theirs in fix multisphere/clump.
   A force of step n acts over [n-1/2, n+1/2], and v is that of n-1/2.
------------------------------------------------------------------------- */

void FixCoupleFoam::apply(bool setupflag)
{
  const double dt = update->dt;
  double **v = atom->v;
  double **f = atom->f;

  if (listed_ != atom->nlocal) list_free();
  if (more_) {
    apply_inertia(setupflag);
    return;
  }
  for (int i : free_) {
    double *s = fluid_[i], random[3] = {0.,0.,0.};
    if (thermal_) thermal_->kick(i,s[DRAG],random);
    // sphere_drag(), its factor being the same in all steps of an answer
    const double drag = s[RELAX]*s[DRAG], rest = s[RELAX] - 1.0;
    for (int k = 0; k < 3; k++) {
      const double load = s[LOAD+k] + random[k];
      const double force = load + (drag*(s[VELOCITY+k] - v[i][k]) + rest*(f[i][k] + load));
      if (!setupflag) s[IMPULSE+k] += 0.5*dt*(s[FORCE+k] + force);
      s[FORCE+k] = force;
      f[i][k] += force;
    }
  }
}

/* ----------------------------------------------------------------------
   the same with added mass and torque: the sphere's own inertia m gets what it
   needs to be as fast as m + added would be under all other forces
------------------------------------------------------------------------- */

void FixCoupleFoam::apply_inertia(bool setupflag)
{
  const double dt = update->dt;
  for (int i : free_) {
    double *s = fluid_[i], *v = atom->v[i], *f = atom->f[i], random[3] = {0.,0.,0.};
    if (thermal_) thermal_->kick(i,s[DRAG],random);
    for (int k = 0; k < 3; k++) {
      const double force = sphere_force(s[DRAG],s[VELOCITY+k],v[k],s[LOAD+k] + random[k],f[k],
                                        atom->rmass[i],more_[i][ADDED],dt);
      if (!setupflag) s[IMPULSE+k] += 0.5*dt*(s[FORCE+k] + force);
      s[FORCE+k] = force;
      f[k] += force;
    }
    if (more_[i][TURN] > 0.) apply_turn(i);
  }
}

void FixCoupleFoam::apply_turn(int i)
{
  const double r = atom->radius[i], inertia = 0.4*atom->rmass[i]*r*r;
  double random[3] = {0.,0.,0.};
  if (thermal_) thermal_->kick(i,more_[i][TURN],random,1);
  for (int k = 0; k < 3; k++) {
    const double other = atom->torque[i][k] + random[k];
    atom->torque[i][k] = other + sphere_drag(more_[i][TURN],more_[i][SPIN+k],atom->omega[i][k],
                                             other,inertia,update->dt);
  }
}

/* ---------------------------------------------------------------------- */

bool FixCoupleFoam::moves(int i) const
{
  return atom->mask[i] & movers_;
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::list_free()
{
  free_.clear();
  listed_ = atom->nlocal;
  for (int i = 0; i < listed_; i++)
    if (free_sphere(i)) free_.push_back(i);
}

/* ---------------------------------------------------------------------- */

double FixCoupleFoam::memory_usage()
{
  return atom->nmax*(SIZE + (more_ ? (int) MORE : 0))*sizeof(double);
}

void FixCoupleFoam::grow_arrays(int nmax)
{
  memory->grow(fluid_,nmax,(int) SIZE,"couple/foam:fluid");
  if (more_) memory->grow(more_,nmax,(int) MORE,"couple/foam:more");
}

void FixCoupleFoam::copy_arrays(int i, int j, int)
{
  std::copy(fluid_[i],fluid_[i] + SIZE,fluid_[j]);
  if (more_) std::copy(more_[i],more_[i] + MORE,more_[j]);
}

void FixCoupleFoam::set_arrays(int i)
{
  std::fill(fluid_[i],fluid_[i] + SIZE,0.);
  fluid_[i][SLOT] = -1;
  fluid_[i][RELAX] = 1.;
  if (more_) std::fill(more_[i],more_[i] + MORE,0.);
}

int FixCoupleFoam::pack_exchange(int i, double *buf)
{
  std::copy(fluid_[i],fluid_[i] + SIZE,buf);
  if (!more_) return SIZE;
  std::copy(more_[i],more_[i] + MORE,buf + SIZE);
  return SIZE + MORE;
}

int FixCoupleFoam::unpack_exchange(int nlocal, double *buf)
{
  std::copy(buf,buf + SIZE,fluid_[nlocal]);
  if (!more_) return SIZE;
  std::copy(buf + SIZE,buf + SIZE + MORE,more_[nlocal]);
  return SIZE + MORE;
}
