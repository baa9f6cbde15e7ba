/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   What fix multisphere/clump keeps and gives away; its steps are in
   fix_multisphere_clump_integrate.cpp.
------------------------------------------------------------------------- */

#include "clumps/fix_multisphere_clump.h"

#include "domain.h"
#include "error.h"
#include "fix_template_multisphere.h"
#include "modify.h"
#include "update.h"
#include <cmath>

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

FixMultisphereClump::FixMultisphereClump(LAMMPS *lmp, int narg, char **arg) :
  FixMultisphere(lmp, narg, arg), xcm_(vectors("xcm")), vcm_(vectors("vcm")), fcm_(vectors("fcm")),
  torque_(vectors("torque")), dragforce_(vectors("dragforce_cm")), hdtorque_(vectors("hdtorque_cm")),
  angmom_(vectors("angmom")), omega_(vectors("omega")), inertia_(vectors("inertia")), ex_(vectors("ex_space")),
  ey_(vectors("ey_space")), ez_(vectors("ez_space")),
  quat_(*multisphere_.prop().getElementProperty<VectorContainer<double, 4>>("quat")),
  fflag_(*multisphere_.prop().getElementProperty<VectorContainer<bool, 3>>("fflag")),
  tflag_(*multisphere_.prop().getElementProperty<VectorContainer<bool, 3>>("tflag")),
  clumptype_(*multisphere_.prop().getElementProperty<ScalarContainer<int>>("clumptype")), coupled_(false), given_{},
  gravity_(lmp), unsorted_(true), unturned_(true), natoms_(0)
{
  store_ = multisphere_.prop().addElementProperty<Store>("fluid_on_body", "comm_exchange_borders", "frame_invariant",
                                                         "restart_yes");
}

/* ---------------------------------------------------------------------- */

FixMultisphereClump::Vectors &FixMultisphereClump::vectors(const char *name)
{
  return *multisphere_.prop().getElementProperty<Vectors>(name);
}

/* ----------------------------------------------------------------------
   what is kept of the fluid for a body; a body that was not there before
   finds the place of another one, or none: it starts afresh
------------------------------------------------------------------------- */

FixMultisphereClump::Fluid &FixMultisphereClump::stored(int ibody)
{
  static_assert(sizeof(Fluid) == SIZE * sizeof(double), "doubles only");
  Fluid &fluid = *reinterpret_cast<Fluid *>((*store_)(ibody));
  const double owner = multisphere_.tag(ibody) + 0.5;
  if (fluid.owner != owner) {
    fluid = Fluid();
    fluid.owner = owner;
  }
  return fluid;
}

/* ---------------------------------------------------------------------- */

void FixMultisphereClump::pre_neighbor()
{
  FixMultisphere::pre_neighbor();
  unsorted_ = true;
}

/* ---------------------------------------------------------------------- */

void FixMultisphereClump::sort_spheres()
{
  const int nall = atom->nlocal + atom->nghost, nbody = multisphere_.n_body();
  if (unsorted_ || nall != natoms_ || nbody != spheres_.bodies()) {
    const tagint none = (IMGMAX << IMG2BITS) | (IMGMAX << IMGBITS) | IMGMAX;
    spheres_.clear(nbody);
    for (int i = 0; i < nall; i++) {
      if (body_[i] < 0) continue;
      const int ibody = map(body_[i]);
      if (ibody < 0) continue;
      spheres_.add(ibody, i, displace_[i], domain->is_owned_or_first_ghost(i), atom->image[i] != none);
    }
    spheres_.sort();
    natoms_ = nall;
    unsorted_ = false;
    unturned_ = true;
  }
  if (unturned_) {
    for (int b = 0; b < nbody; b++) spheres_.turn(b, ex_(b), ey_(b), ez_(b));
    unturned_ = false;
  }
}

/* ----------------------------------------------------------------------
   plain multisphere takes spheres out here
------------------------------------------------------------------------- */

void FixMultisphereClump::pre_exchange()
{
  if (before_) before_();
  FixMultisphere::pre_exchange();
}

/* ---------------------------------------------------------------------- */

void FixMultisphereClump::init()
{
  FixMultisphere::init();
  gravity_.find();
}

/* ---------------------------------------------------------------------- */

void FixMultisphereClump::spheres(std::vector<BodySphere> &list)
{
  list.clear();
  sort_spheres();
  if (images()) fix_volumeweight_ms_->do_forward_comm();
  const double *weight = fix_volumeweight_ms_->vector_atom;

  for (int b = 0; b < multisphere_.n_body(); b++) {
    double total = 0.;
    for (int n = spheres_.begin(b); n < spheres_.counted(b); n++) total += weight[spheres_.atom(n)];
    // a stock template's weights are random estimates
    for (int n = spheres_.begin(b); n < spheres_.counted(b); n++)
      list.push_back({spheres_.atom(n), b, spheres_.body_place(n), weight[spheres_.atom(n)] / total});
  }
}

/* ---------------------------------------------------------------------- */

void FixMultisphereClump::set_drag(int ibody, const BodyDrag &drag)
{
  stored(ibody).drag.set(drag, mobility(ibody), update->dt);
}

/* ---------------------------------------------------------------------- */

void FixMultisphereClump::set_flow(int b, const BodyFlow &flow, double scale)
{
  stored(b).whole.set(flow, *resistances_[clumptype_(b)], scale, axes(b), mobility(b), update->dt);
}

/* ---------------------------------------------------------------------- */

void FixMultisphereClump::set_loads(int ibody, const double *load, const double *hydro, double added)
{
  Fluid &fluid = stored(ibody);
  std::copy(load, load + 3, fluid.load);
  std::copy(hydro, hydro + 3, fluid.hydro);
  fluid.added = added;
}

/* ---------------------------------------------------------------------- */

void FixMultisphereClump::fluid_force(int b, double *force, double *drag)
{
  const Fluid &fluid = stored(b);
  for (int k = 0; k < 3; k++) {
    force[k] = fluid.force[k] + fluid.hydro[k];
    drag[k] = force[k] - fluid.load[k] + fluid.added * fcm_(b)[k] / multisphere_.mass(b);
  }
}

/* ----------------------------------------------------------------------
   how a body answers to forces: its template's fflag and tflag hold it
   along axes of space
------------------------------------------------------------------------- */

Matrix6d FixMultisphereClump::mobility(int b)
{
  return held_mobility(multisphere_.mass(b), inertia_(b), axes(b), fflag_(b), tflag_(b));
}

/* ---------------------------------------------------------------------- */

Eigen::Vector3d FixMultisphereClump::slip(int b) { return Eigen::Vector3d(stored(b).whole.u) - velocity(b); }

/* ---------------------------------------------------------------------- */

Eigen::Matrix3d FixMultisphereClump::axes(int b)
{
  Eigen::Matrix3d Q;
  for (int k = 0; k < 3; k++) {
    Q(k, 0) = ex_(b)[k];
    Q(k, 1) = ey_(b)[k];
    Q(k, 2) = ez_(b)[k];
  }
  return Q;
}

/* ---------------------------------------------------------------------- */

void FixMultisphereClump::couple(const std::function<void()> &before, const std::function<void()> &after)
{
  if (CAdd_ != 0.)
    error->all(FLERR,
               "Fix multisphere/clump: CAddRhoFluid gives added mass that the fluid does not know of; "
               "leave it out under fix couple/foam");
  coupled_ = true;
  before_ = before;
  after_ = after;
}

/* ---------------------------------------------------------------------- */

void FixMultisphereClump::uncouple()
{
  coupled_ = false;
  before_ = after_ = nullptr;
  resistances_.clear();
  for (int b = 0; b < multisphere_.n_body(); b++) stored(b).owner = 0.0;
}

/* ---------------------------------------------------------------------- */

void FixMultisphereClump::add_impulse(int ibody, const double *impulse)
{
  for (int k = 0; k < 3; k++) stored(ibody).impulse[k] += impulse[k];
}

/* ---------------------------------------------------------------------- */

bool FixMultisphereClump::take_motion(int ibody, double *displacement, double *change)
{
  Fluid &fluid = stored(ibody);
  const bool known = fluid.seen > 0.0;
  for (int k = 0; k < 3; k++) {
    displacement[k] = known ? xcm_(ibody)[k] - fluid.place[k] : 0.0;
    change[k] = known ? vcm_(ibody)[k] - fluid.speed[k] : 0.0;
    fluid.place[k] = xcm_(ibody)[k];
    fluid.speed[k] = vcm_(ibody)[k];
  }
  fluid.seen = 1.0;
  return known;
}

/* ---------------------------------------------------------------------- */

double FixMultisphereClump::mean_diameter()
{
  const auto diameter = [](double volume) { return std::cbrt(6. / M_PI * volume); };
  double sum[2] = {0., 0.}, all[2];
  for (int b = 0; b < multisphere_.n_body(); b++) {
    sum[0] += multisphere_.volume(b);
    sum[1] += multisphere_.volume(b) * diameter(multisphere_.volume(b));
  }
  MPI_Allreduce(sum, all, 2, MPI_DOUBLE, MPI_SUM, world);
  if (all[0] > 0.) return all[1] / all[0];

  sum[0] = sum[1] = 0.;
  for (int i = 0; i < modify->nfix; i++)
    if (FixTemplateMultisphere *t = dynamic_cast<FixTemplateMultisphere *>(modify->fix[i])) {
      sum[0] += 1.;
      sum[1] += diameter(t->volexpect());
    }
  return sum[0] > 0. ? sum[1] / sum[0] : 0.;
}

/* ---------------------------------------------------------------------- */

void FixMultisphereClump::take_given(double *impulse)
{
  for (int k = 0; k < 3; k++) {
    impulse[k] += given_[k];
    given_[k] = 0.0;
  }
}

/* ---------------------------------------------------------------------- */

void FixMultisphereClump::take_impulse(int ibody, double *impulse)
{
  Fluid &fluid = stored(ibody);
  for (int k = 0; k < 3; k++) {
    impulse[k] = fluid.impulse[k];
    fluid.impulse[k] = 0.0;
  }
}

/* ---------------------------------------------------------------------- */

void FixMultisphereClump::hold_forces()
{
  for (int b = 0; b < multisphere_.n_body(); b++) {
    Fluid &fluid = stored(b);
    std::copy(fcm_(b), fcm_(b) + 3, fluid.held);
    std::copy(torque_(b), torque_(b) + 3, fluid.held + 3);
    std::copy(fluid.force, fluid.force + 3, fluid.held + 6);
  }
}

void FixMultisphereClump::take_held_forces()
{
  for (int b = 0; b < multisphere_.n_body(); b++) {
    Fluid &fluid = stored(b);
    std::copy(fluid.held, fluid.held + 3, fcm_(b));
    std::copy(fluid.held + 3, fluid.held + 6, torque_(b));
    std::copy(fluid.held + 6, fluid.held + 9, fluid.force);
  }
}
