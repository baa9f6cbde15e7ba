/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "fix_multisphere_clump.h"

#include <algorithm>

#include "domain.h"
#include "error.h"
#include "force.h"
#include "update.h"

using namespace LAMMPS_NS;
using Eigen::Map;
using Eigen::Matrix3d;
using Eigen::Vector3d;

/* ---------------------------------------------------------------------- */

FixMultisphereClump::FixMultisphereClump(LAMMPS *lmp, int narg, char **arg) :
  FixMultisphere(lmp, narg, arg),
  coupled_(false)
{
  store_ = multisphere_.prop().addElementProperty<Store>(
    "fluid_on_body","comm_exchange_borders","frame_invariant","restart_no");
}

/* ----------------------------------------------------------------------
   what is kept of the fluid for a body; a body that was not there before
   finds the place of another one, or none: it starts afresh
------------------------------------------------------------------------- */

double *FixMultisphereClump::stored(int ibody)
{
  double *s = (*store_)(ibody);
  const double owner = multisphere_.tag(ibody) + 0.5;
  if (s[OWNER] != owner) {
    std::fill(s,s + SIZE,0.0);
    s[OWNER] = owner;
  }
  return s;
}

/* ---------------------------------------------------------------------- */

void FixMultisphereClump::calc_force(bool setupflag)
{
  FixMultisphere::calc_force(setupflag);
  if (coupled_) apply_drag(setupflag);
}

/* ----------------------------------------------------------------------
   a force of step n acts over [n-1/2, n+1/2]: velocities are now those of
   n-1/2, and half of the force is applied now, half in the next step
------------------------------------------------------------------------- */

void FixMultisphereClump::apply_drag(bool setupflag)
{
  const double dt = update->dt;
  const int nbody = multisphere_.n_body();

  VectorContainer<double,3> &fcm =
    *multisphere_.prop().getElementProperty<VectorContainer<double,3> >("fcm");
  VectorContainer<double,3> &torquecm =
    *multisphere_.prop().getElementProperty<VectorContainer<double,3> >("torque");
  VectorContainer<double,3> &inertia =
    *multisphere_.prop().getElementProperty<VectorContainer<double,3> >("inertia");
  VectorContainer<double,3> &ex =
    *multisphere_.prop().getElementProperty<VectorContainer<double,3> >("ex_space");
  VectorContainer<double,3> &ey =
    *multisphere_.prop().getElementProperty<VectorContainer<double,3> >("ey_space");
  VectorContainer<double,3> &ez =
    *multisphere_.prop().getElementProperty<VectorContainer<double,3> >("ez_space");

  BodyDrag drag;
  Matrix6d mass = Matrix6d::Zero(), inverse = Matrix6d::Zero();

  for (int ibody = 0; ibody < nbody; ibody++) {
    double *s = stored(ibody);

    const double *packed = s + RESISTANCE;
    for (int i = 0; i < 6; i++)
      for (int j = i; j < 6; j++) drag.R(i,j) = drag.R(j,i) = *packed++;
    drag.drive = Map<Vector6d>(s + DRIVE);
    drag.load = Map<Vector6d>(s + LOAD);

    const double m = multisphere_.mass(ibody);
    Matrix3d axes;
    axes.col(0) = Map<Vector3d>(ex(ibody));
    axes.col(1) = Map<Vector3d>(ey(ibody));
    axes.col(2) = Map<Vector3d>(ez(ibody));
    const Vector3d I = Map<Vector3d>(inertia(ibody));
    mass.topLeftCorner<3,3>().diagonal().setConstant(m);
    mass.bottomRightCorner<3,3>() = axes * I.asDiagonal() * axes.transpose();
    inverse.topLeftCorner<3,3>().diagonal().setConstant(1.0/m);
    inverse.bottomRightCorner<3,3>() =
      axes * I.cwiseInverse().asDiagonal() * axes.transpose();

    Vector6d y0, other;
    double v[3], L[3];
    multisphere_.vcm(v,ibody);
    multisphere_.angmom(L,ibody);
    y0.head<3>() = Map<Vector3d>(v);
    y0.tail<3>() = inverse.bottomRightCorner<3,3>() * Map<Vector3d>(L);
    other.head<3>() = Map<Vector3d>(fcm(ibody));
    other.tail<3>() = Map<Vector3d>(torquecm(ibody));

    const Vector6d w = drag_wrench(drag,y0,other,mass,inverse,dt);

    for (int k = 0; k < 3; k++) {
      fcm(ibody)[k] += w[k];
      torquecm(ibody)[k] += w[k+3];
      // this step's first half was done with the force of the step before
      if (!setupflag) s[IMPULSE+k] += 0.5*dt*(s[FORCE+k] + w[k]);
      s[FORCE+k] = w[k];
    }
  }
}

/* ---------------------------------------------------------------------- */

void FixMultisphereClump::spheres(std::vector<Sphere> &list)
{
  list.clear();
  VectorContainer<double,3> &ex =
    *multisphere_.prop().getElementProperty<VectorContainer<double,3> >("ex_space");
  VectorContainer<double,3> &ey =
    *multisphere_.prop().getElementProperty<VectorContainer<double,3> >("ey_space");
  VectorContainer<double,3> &ez =
    *multisphere_.prop().getElementProperty<VectorContainer<double,3> >("ez_space");
  if (atom->nghost) fix_volumeweight_ms_->do_forward_comm();
  const double *weight = fix_volumeweight_ms_->vector_atom;
  std::vector<double> total(multisphere_.n_body(),0.);

  const int nall = atom->nlocal + atom->nghost;
  for (int i = 0; i < nall; i++) {
    if (body_[i] < 0) continue;
    const int ibody = map(body_[i]);
    if (ibody < 0 || !domain->is_owned_or_first_ghost(i)) continue;
    Sphere s;
    s.atom = i;
    s.body = ibody;
    s.fraction = weight[i];
    MathExtra::matvec(ex(ibody),ey(ibody),ez(ibody),displace_[i],s.r);
    total[ibody] += s.fraction;
    list.push_back(s);
  }
  // a stock template's weights are random estimates
  for (size_t n = 0; n < list.size(); n++) list[n].fraction /= total[list[n].body];
}

/* ---------------------------------------------------------------------- */

void FixMultisphereClump::set_drag(int ibody, const BodyDrag &drag)
{
  double *s = stored(ibody);
  double *packed = s + RESISTANCE;
  for (int i = 0; i < 6; i++)
    for (int j = i; j < 6; j++) *packed++ = drag.R(i,j);
  Map<Vector6d>(s + DRIVE) = drag.drive;
  Map<Vector6d>(s + LOAD) = drag.load;
}

/* ---------------------------------------------------------------------- */

void FixMultisphereClump::couple()
{
  if (CAdd_ != 0.)
    error->all(FLERR,"Fix multisphere/clump: CAddRhoFluid gives added mass that the fluid does not know of; "
                     "leave it out under fix couple/foam");
  coupled_ = true;
}

/* ---------------------------------------------------------------------- */

void FixMultisphereClump::uncouple()
{
  coupled_ = false;
  for (int b = 0; b < multisphere_.n_body(); b++) stored(b)[OWNER] = 0.0;
}

/* ---------------------------------------------------------------------- */

void FixMultisphereClump::take_impulse(int ibody, double *impulse)
{
  double *s = stored(ibody);
  for (int k = 0; k < 3; k++) {
    impulse[k] = s[IMPULSE+k];
    s[IMPULSE+k] = 0.0;
  }
}
