/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   A sphere at a wall is a pair of the sphere and a point of no size on the
   wall: the pairs of a step go through gran/lean's kernel together.
------------------------------------------------------------------------- */

#include "fix_wall_gran_lean.h"

#include <algorithm>
#include <cstring>
#include <string>

#include "atom.h"
#include "error.h"
#include "fix_property_atom.h"
#include "force.h"
#include "modify.h"
#include "neighbor.h"
#include "primitive_wall.h"
#include "property_registry.h"
#include "update.h"

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

FixWallGranLean::FixWallGranLean(LAMMPS *lmp, int narg, char **arg) :
  FixWallGran(lmp,narg,arg),
  tangential_damping_(true), absolute_damping_(false), limit_force_(false),
  kn_(NULL), kt_(NULL), gamman_(NULL), gammat_(NULL), friction_(NULL), looked_(0), touched_(0)
{
  vector_flag = 1;
  size_vector = 2;
  global_freq = 1;
  extvector = 0;
  read_model(narg,arg);
}

/* ----------------------------------------------------------------------
   wall/gran has read them all; what this style cannot do is refused
------------------------------------------------------------------------- */

void FixWallGranLean::read_model(int narg, char **arg)
{
  struct { const char *name, *value; bool given; } models[] = {
    {"model", "hooke/stiffness", false}, {"tangential", "history", false},
    {"rolling_friction", "off", true}, {"cohesion", "off", true}, {"surface", "default", true} };
  struct { const char *name; bool *on; } switches[] = {
    {"tangential_damping", &tangential_damping_}, {"absolute_damping", &absolute_damping_},
    {"limitForce", &limit_force_} };

  for (int i = 3; i + 1 < narg; i++) {
    for (auto &m : models)
      if (!strcmp(arg[i],m.name)) {
        if (strcmp(arg[i+1],m.value))
          error->all(FLERR,(std::string("Fix wall/gran/lean: '") + m.name + " " + arg[i+1] + "' is not among what it can do: "
                            "model hooke/stiffness tangential history primitive ...; for anything else take fix wall/gran").c_str());
        m.given = true;
      }
    for (auto &s : switches)
      if (!strcmp(arg[i],s.name)) *s.on = !strcmp(arg[i+1],"on");
    for (const char *odd : {"computeElasticPotential", "computeDissipatedEnergy", "heating_tangential_history"})
      if (!strcmp(arg[i],odd) && !strcmp(arg[i+1],"on"))
        error->all(FLERR,(std::string("Fix wall/gran/lean: ") + odd + " needs fix wall/gran").c_str());
  }
  for (auto &m : models)
    if (!m.given)
      error->all(FLERR,(std::string("Fix wall/gran/lean: '") + m.name + " " + m.value + "' is missing").c_str());
  if (meshwall_ != 0)
    error->all(FLERR,"Fix wall/gran/lean: a primitive wall is needed; for a mesh take fix wall/gran");
}

/* ---------------------------------------------------------------------- */

void FixWallGranLean::init()
{
  FixWallGran::init();
  const char *who = "fix wall/gran/lean";
  force->registry.connect("k_n",kn_,who);
  force->registry.connect("k_t",kt_,who);
  force->registry.connect(absolute_damping_ ? "gamman_abs" : "gamman",gamman_,who);
  force->registry.connect(absolute_damping_ ? "gammat_abs" : "gammat",gammat_,who);
  force->registry.connect("coeffFrict",friction_,who);
}

/* ----------------------------------------------------------------------
   what only wall/gran's own loop can do is left to it
------------------------------------------------------------------------- */

bool FixWallGranLean::lean_step() const
{
  return radius_ && rmass_ && dnum_ == 3 && computeflag_ && !addflag_ && !shear_ && !store_force_ &&
         !store_force_contact_ && !store_force_contact_stress_ && !fix_store_multicontact_data_ &&
         !heattransfer_flag_ && !track_energy_ && !fix_rigid_ && !fix_sum_normal_force_ &&
         !stress_flag_ && !atom->shapetype_flag && neighbor->contactDistanceFactor == 1.0;
}

/* ---------------------------------------------------------------------- */

void FixWallGranLean::post_force_primitive(int vflag)
{
  if (!lean_step()) {
    FixWallGran::post_force_primitive(vflag);
    return;
  }
  gather();
  const int n = pairs_.size();
  touched_ += n;
  if (n == 0) return;
  const clay::ContactSpheres spheres = { x_near_.data(), v_near_.data(), omega_near_.data(),
                                         f_near_.data(), torque_near_.data(), n };
  clay::contactForces(spheres,pairs_,update->dt,shearupdate_,limit_force_);
  scatter();
}

/* ----------------------------------------------------------------------
   spheres that touch come first, the points of the wall after them
------------------------------------------------------------------------- */

void FixWallGranLean::gather()
{
  int *near;
  const int nnear = primitiveWall_->getNeighbors(near);
  looked_ += nnear;
  double **history = fix_history_primitive_->array_atom, **v = atom->v, **omega = atom->omega;

  atom_.resize(nnear);
  wall_.resize(3*nnear);
  int n = 0;
  for (int k = 0; k < nnear; k++) {
    const int i = near[k];
    if (!(atom->mask[i] & groupbit)) continue;
    double *delta = &wall_[3*n];
    if (primitiveWall_->resolveContact(x_[i],radius_[i],delta) > 0.) {
      history[i][0] = history[i][1] = history[i][2] = 0.;
      continue;
    }
    for (int d = 0; d < 3; d++) delta[d] += x_[i][d];
    atom_[n++] = i;
  }

  pairs_.resize(n);
  for (auto *a : {&x_near_, &v_near_, &omega_near_}) a->resize(6*n);
  for (int k = 0; k < n; k++) {
    const int i = atom_[k], a = atom->type[i], b = atom_type_wall_;
    const double moving = absolute_damping_ ? 1.0 : rmass_[i], kt = kt_[a][b]/force->nktv2p;
    pairs_.i[k] = k;
    pairs_.j[k] = n + k;
    pairs_.ri[k] = radius_[i];
    pairs_.rj[k] = 0.;
    pairs_.kn[k] = kn_[a][b]/force->nktv2p;
    pairs_.kt[k] = kt;
    pairs_.softness[k] = 1./kt;
    pairs_.gamman[k] = moving*gamman_[a][b];
    pairs_.gammat[k] = tangential_damping_ ? moving*gammat_[a][b] : 0.;
    pairs_.friction[k] = friction_[a][b];
    pairs_.sx[k] = history[i][0];
    pairs_.sy[k] = history[i][1];
    pairs_.sz[k] = history[i][2];
    pairs_.touched[k] = 1.;
    for (int d = 0; d < 3; d++) {
      x_near_[3*k+d] = x_[i][d];
      v_near_[3*k+d] = v[i][d];
      omega_near_[3*k+d] = omega[i][d];
      x_near_[3*(n+k)+d] = wall_[3*k+d];
      v_near_[3*(n+k)+d] = omega_near_[3*(n+k)+d] = 0.;
    }
  }
  f_near_.assign(3*n,0.);
  torque_near_.assign(3*n,0.);
}

/* ---------------------------------------------------------------------- */

void FixWallGranLean::scatter()
{
  double **history = fix_history_primitive_->array_atom;
  for (int k = 0; k < pairs_.size(); k++) {
    const int i = atom_[k];
    for (int d = 0; d < 3; d++) {
      atom->f[i][d] += f_near_[3*k+d];
      atom->torque[i][d] += torque_near_[3*k+d];
    }
    history[i][0] = pairs_.sx[k];
    history[i][1] = pairs_.sy[k];
    history[i][2] = pairs_.sz[k];
  }
}

/* ----------------------------------------------------------------------
   spheres looked at, spheres in contact, of all steps on this processor
------------------------------------------------------------------------- */

double FixWallGranLean::compute_vector(int n)
{
  return n == 0 ? double(looked_) : double(touched_);
}

double FixWallGranLean::memory_usage()
{
  return FixWallGran::memory_usage() + pairs_.size()*33.0*sizeof(double);
}
