/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   The steps of fix multisphere/clump: those of fix multisphere, body by
   body over a list of its spheres. What few runs ask for (virial, heat,
   concave particles, added mass, insertion in a stream) stays with LIGGGHTS.
------------------------------------------------------------------------- */

#include "clumps/fix_multisphere_clump.h"

#include <algorithm>

#include "clumps/body_rotation.h"
#include "domain.h"
#include "modify.h"
#include "update.h"

using namespace LAMMPS_NS;

namespace {

// LIGGGHTS keeps the vectors of all bodies in one block, and a pointer to each
template <typename T, int N>
inline T *row(VectorContainer<T, N> &all, int b)
{
  return all.begin()[0] + N * b;
}

}

/* ---------------------------------------------------------------------- */

bool FixMultisphereClump::stock_features()
{
  return fix_heat_ || atom->quaternion || CAdd_ != 0. || modify->n_fixes_style("insert/stream") > 0;
}

/* ----------------------------------------------------------------------
   without ghosts there is nothing to tell anyone
------------------------------------------------------------------------- */

bool FixMultisphereClump::images() const { return comm->nprocs > 1 || atom->nghost > 0; }

/* ---------------------------------------------------------------------- */

void FixMultisphereClump::half_kick(int begin, int end)
{
  if (begin == end) return;
  const double *force = row(fcm_, 0), *torque = row(torque_, 0), half = dtf;
  const bool *moves = row(fflag_, 0), *turns = row(tflag_, 0);
  double *v = row(vcm_, 0), *L = row(angmom_, 0);
  for (int b = begin; b < end; b++) {
    const double dtfm = half / multisphere_.mass(b);
    for (int k = 3 * b; k < 3 * b + 3; k++) {
      v[k] += moves[k] ? dtfm * force[k] : 0.;
      L[k] += turns[k] ? half * torque[k] : 0.;
    }
  }
}

/* ----------------------------------------------------------------------
   a step of the rotation of bodies begin to end-1, after the half kick
------------------------------------------------------------------------- */

void FixMultisphereClump::turn(int begin, int end)
{
  const Bodies bodies = {row(quat_, 0),  row(ex_, 0),     row(ey_, 0),     row(ez_, 0),
                         row(omega_, 0), row(angmom_, 0), row(inertia_, 0)};
  turn_bodies(bodies, begin, end, dtv);
}

/* ----------------------------------------------------------------------
   spheres of a body that has moved and turned
------------------------------------------------------------------------- */

void FixMultisphereClump::place(int b)
{
  spheres_.place(b, row(ex_, b), row(ey_, b), row(ez_, b), row(xcm_, b), row(vcm_, b), row(omega_, b), atom->x[0],
                 atom->v[0], atom->omega[0]);
  if (spheres_.shifted(b))
    for (int n = spheres_.begin(b); n < spheres_.end(b); n++) {
      const tagint image = atom->image[spheres_.atom(n)];
      double *x = atom->x[spheres_.atom(n)];
      x[0] -= ((image & IMGMASK) - IMGMAX) * domain->xprd;
      x[1] -= ((image >> IMGBITS & IMGMASK) - IMGMAX) * domain->yprd;
      x[2] -= ((image >> IMG2BITS) - IMGMAX) * domain->zprd;
    }
}

/* ---------------------------------------------------------------------- */

void FixMultisphereClump::initial_integrate(int vflag)
{
  if (vflag || stock_features()) {
    FixMultisphere::initial_integrate(vflag);
    unturned_ = true;
    return;
  }
  evflag = 0;
  sort_spheres();

  const int nbody = multisphere_.n_body();
  for (int b = 0; b < nbody; b += RotationBlock::SIZE) {
    const int end = std::min(b + RotationBlock::SIZE, nbody);
    half_kick(b, end);
    double *x = row(xcm_, 0);
    const double *v = row(vcm_, 0);
    for (int k = 3 * b; k < 3 * end; k++) x[k] += dtv * v[k];
    turn(b, end);
    for (int i = b; i < end; i++) place(i);
  }

  if (images()) {
    rev_comm_flag_ = MS_COMM_REV_X_V_OMEGA;
    reverse_comm();
  }
}

/* ---------------------------------------------------------------------- */

void FixMultisphereClump::final_integrate()
{
  if (evflag || stock_features()) {
    FixMultisphere::final_integrate();
    return;
  }
  sort_spheres();

  const clay::GroupGravity gravity = gravity_.now();
  const int nbody = multisphere_.n_body();
  for (int b = 0; b < nbody; b++) sum_forces(b, gravity, false);
  half_kick(0, nbody);
  for (int b = 0; b < nbody; b++) {
    spin(row(angmom_, b), row(ex_, b), row(ey_, b), row(ez_, b), row(inertia_, b), row(omega_, b));
    spheres_.set_velocity(b, row(vcm_, b), row(omega_, b), atom->v[0], atom->omega[0]);
  }

  if (images()) {
    rev_comm_flag_ = MS_COMM_REV_V_OMEGA;
    reverse_comm();
    fw_comm_flag_ = MS_COMM_FW_V_OMEGA;
    forward_comm();
  }
  if (after_) after_();
}

/* ---------------------------------------------------------------------- */

void FixMultisphereClump::calc_force(bool setupflag)
{
  const int nbody = multisphere_.n_body();
  if (stock_features()) {
    FixMultisphere::calc_force(setupflag);
    if (coupled_)
      for (int b = 0; b < nbody; b++) apply_drag(b, setupflag);
  } else {
    sort_spheres();
    const clay::GroupGravity gravity = gravity_.now();
    for (int b = 0; b < nbody; b++) sum_forces(b, gravity, setupflag);
  }
  if (after_) after_();
}

/* ---------------------------------------------------------------------- */

void FixMultisphereClump::sum_forces(int b, const clay::GroupGravity &gravity, bool setupflag)
{
  double *force = row(fcm_, b), *torque = row(torque_, b);
  spheres_.gather(b, atom->f[0], atom->torque[0], force, torque);
  const double m = multisphere_.mass(b);
  const int begin = spheres_.begin(b);
  if (begin < spheres_.end(b)) {
    const std::array<double, 3> g = gravity.on(atom->mask[spheres_.atom(begin)]);
    for (int k = 0; k < 3; k++) force[k] += m * g[k];
  }
  if (add_dragforce_)
    for (int k = 0; k < 3; k++) {
      force[k] += dragforce_(b)[k];
      torque[k] += hdtorque_(b)[k];
    }
  if (coupled_) apply_drag(b, setupflag);
}

/* ----------------------------------------------------------------------
   a force of step n acts over [n-1/2, n+1/2]: velocities are now those of
   n-1/2, and half of the force is applied now, half in the next step
------------------------------------------------------------------------- */

void FixMultisphereClump::apply_drag(int b, bool setupflag)
{
  Fluid &fluid = stored(b);
  double *force = fcm_(b), *torque = torque_(b), F[3], T[3];
  if (resistances_.empty())
    fluid.drag.wrench(ex_(b), ey_(b), ez_(b), vcm_(b), angmom_(b), inertia_(b), force, torque, F, T);
  else
    fluid.whole.wrench(*resistances_[clumptype_(b)], ex_(b), ey_(b), ez_(b), vcm_(b), angmom_(b), inertia_(b), force,
                       torque, F, T);
  const double half = 0.5 * update->dt;
  for (int k = 0; k < 3; k++) {
    force[k] += F[k];
    torque[k] += T[k];
    // this step's first half was done with the force of the step before
    const double given = F[k] - fluid.hydro[k];
    if (!setupflag) {
      const double impulse = half * (fluid.force[k] + given);
      fluid.impulse[k] += impulse;
      given_[k] += impulse;
    }
    fluid.force[k] = given;
  }
}
