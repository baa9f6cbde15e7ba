/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   A sphere at a wall is a pair of the sphere and a point of no size on the
   wall. Pairs are kept with what their law says, so that a step has only to
   see whether another sphere has come to touch.
------------------------------------------------------------------------- */

#include "contacts/fix_wall_gran_lean.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
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

namespace {

const double ROUNDING = 1.0e-12;
const double AHEAD = 0.02;  // spheres this close, over the radius, are made pairs with those that touch
enum { MANY = 32, SELDOM = 100 };

}

/* ---------------------------------------------------------------------- */

FixWallGranLean::FixWallGranLean(LAMMPS *lmp, int narg, char **arg) :
  FixWallGran(lmp, narg, arg), listed_(false), tidied_(0), looked_(0), touched_(0)
{
  vector_flag = 1;
  size_vector = 2;
  global_freq = 1;
  extvector = 0;
  read_model(narg, arg);
  read_shape(narg, arg);
}

/* ----------------------------------------------------------------------
   wall/gran has words of its own; a switch that is on and not known here is a model's
------------------------------------------------------------------------- */

std::string FixWallGranLean::unfit(int narg, char **arg, clay::LeanModel &model)
{
  int shape = 0;
  try {
    for (int i = 3; i + 1 < narg; i++) {
      if (!model.take(arg[i], arg[i + 1]) && !strcmp(arg[i + 1], "on"))
        return std::string("it cannot do '") + arg[i] + " on'";
      if (!strcmp(arg[i], "primitive")) shape = i + 3;
    }
    model.complete();
  } catch (const std::invalid_argument &e) {
    return e.what();
  }
  if (!shape) return "a primitive wall is needed";
  const std::string name = shape < narg ? arg[shape] : "";
  const std::string kind = name.empty() ? "" : name.substr(1);
  if ((kind != "plane" && kind != "cylinder") || name[0] < 'x' || name[0] > 'z')
    return "'" + name + "' is neither a plane nor a cylinder";
  return "";
}

/* ---------------------------------------------------------------------- */

void FixWallGranLean::read_model(int narg, char **arg)
{
  const std::string why = unfit(narg, arg, model_);
  if (!why.empty())
    error->all(FLERR, ("Fix wall/gran/lean: " + why + "; for anything else take fix wall/gran").c_str());
  pairs_.kind = model_.kind;
}

/* ----------------------------------------------------------------------
   as wall/gran has read it: primitive type T shape numbers
------------------------------------------------------------------------- */

void FixWallGranLean::read_shape(int narg, char **arg)
{
  int i = 3;
  while (i < narg && strcmp(arg[i], "primitive")) i++;
  const char *name = arg[i + 3];
  shape_.axis = name[0] - 'x';
  shape_.cylinder = !strcmp(name + 1, "cylinder");
  shape_.at = atof(arg[i + 4]);
  for (int k = 0; shape_.cylinder && k < 2; k++) shape_.centre[k] = atof(arg[i + 5 + k]);
}

/* ---------------------------------------------------------------------- */

void FixWallGranLean::init()
{
  FixWallGran::init();
  coefficients_.connect(force->registry, model_, "fix wall/gran/lean");
  listed_ = false;
}

/* ----------------------------------------------------------------------
   what only wall/gran's own loop can do is left to it
------------------------------------------------------------------------- */

bool FixWallGranLean::lean_step() const
{
  return atom->sphere_flag && radius_ && rmass_ && dnum_ == model_.kind.history() && computeflag_ && !addflag_ &&
      !shear_ && !store_force_ && !store_force_contact_ && !store_force_contact_stress_ &&
      !fix_store_multicontact_data_ && !heattransfer_flag_ && !track_energy_ && !fix_sum_normal_force_ &&
      !stress_flag_ && !atom->shapetype_flag && neighbor->contactDistanceFactor == 1.0;
}

/* ---------------------------------------------------------------------- */

clay::ContactLaw FixWallGranLean::law(int i) const
{
  const double mass = fix_rigid_ && body_[i] >= 0 ? masstotal_[body_[i]] : rmass_[i];
  return coefficients_.law(model_, atom->type[i], atom_type_wall_, radius_[i], mass, force->nktv2p);
}

/* ---------------------------------------------------------------------- */

void FixWallGranLean::pre_force(int vflag)
{
  if (rebuildPrimitiveNeighlist_) listed_ = false;
  FixWallGran::pre_force(vflag);
}

/* ---------------------------------------------------------------------- */

void FixWallGranLean::list()
{
  int *spheres;
  const int n = primitiveWall_->getNeighbors(spheres);
  const int width = model_.kind.history();
  double **history = width ? fix_history_primitive_->array_atom : NULL;
  near_.clear();
  pairs_.clear();
  for (int k = 0; k < n; k++) {
    const int i = spheres[k];
    if (!(atom->mask[i] & groupbit)) continue;
    const double r = radius_[i], inner = std::max(0.0, shape_.at - r), outer = shape_.at + r;
    if (shape_.cylinder)
      near_.push_back({i, r, rmass_[i], (1.0 - ROUNDING) * inner * inner, (1.0 + ROUNDING) * outer * outer});
    else near_.push_back({i, r, rmass_[i], 0.0, (1.0 + ROUNDING) * r});
    if (history && shape_.gap(x_[i]) > r) std::fill_n(history[i], width, 0.0);
  }
  add_touching();
  listed_ = true;
  tidied_ = update->ntimestep;
}

/* ---------------------------------------------------------------------- */

void FixWallGranLean::add_touching()
{
  const double none[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  for (Near &s : near_) {
    if (s.to < 0.0 || shape_.gap(x_[s.atom]) > (1.0 + AHEAD) * s.radius) continue;
    pairs_.add(s.atom, s.atom, s.radius, 0.0, law(s.atom), none, false);
    s.from = HUGE_VAL;
    s.to = -1.0;
  }
}

/* ----------------------------------------------------------------------
   whether a sphere that is not among the pairs touches; changed is set where
   one is not the one it was
------------------------------------------------------------------------- */

bool FixWallGranLean::meets(bool &changed) const
{
  int meet = 0, other = 0;
  const int a = shape_.axis, b = (a + 1) % 3, c = (a + 2) % 3;
  const double *x = x_[0], at = shape_.at, cb = shape_.centre[0], cc = shape_.centre[1];
  if (shape_.cylinder)
    for (const Near &s : near_) {
      const double *p = x + 3 * s.atom, db = p[b] - cb, dc = p[c] - cc, d2 = db * db + dc * dc;
      meet |= (d2 >= s.from) & (d2 <= s.to);
      other |= (radius_[s.atom] != s.radius) | (rmass_[s.atom] != s.mass);
    }
  else
    for (const Near &s : near_) {
      meet |= fabs(x[3 * s.atom + a] - at) <= s.to;
      other |= (radius_[s.atom] != s.radius) | (rmass_[s.atom] != s.mass);
    }
  changed = other;
  return meet;
}

/* ---------------------------------------------------------------------- */

void FixWallGranLean::post_force_primitive(int vflag)
{
  if (!lean_step()) {
    FixWallGran::post_force_primitive(vflag);
    listed_ = false;
    return;
  }
  bool changed = false;
  if (listed_ && meets(changed)) add_touching();
  if (!listed_ || changed) list();
  looked_ += near_.size();
  if (pairs_.size() == 0) return;

  const clay::ContactSpheres spheres = {atom->x[0], atom->v[0],      atom->omega[0],
                                        atom->f[0], atom->torque[0], atom->nlocal};
  double *history = model_.kind.history() ? fix_history_primitive_->array_atom[0] : NULL;
  const int touching = clay::wallForces(spheres, pairs_, shape_, history, update->dt, shearupdate_);
  touched_ += touching;
  // many that have left
  if (pairs_.size() > 2 * touching + MANY && update->ntimestep > tidied_ + SELDOM) listed_ = false;
}

/* ----------------------------------------------------------------------
   spheres looked at, spheres in contact, of all steps on this processor
------------------------------------------------------------------------- */

double FixWallGranLean::compute_vector(int n) { return n == 0 ? double(looked_) : double(touched_); }

double FixWallGranLean::memory_usage()
{
  return FixWallGran::memory_usage() + pairs_.size() * 13.0 * sizeof(double) + near_.size() * sizeof(Near);
}
