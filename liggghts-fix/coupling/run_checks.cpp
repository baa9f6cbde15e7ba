// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/run_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "atom.h"
#include "contacts/granular_script.h"
#include "fix_multisphere.h"
#include "fix_lineforce.h"
#include "fix_planeforce.h"
#include "fix_property_global.h"
#include "fix_setforce.h"
#include "clumps/fix_template_clay.h"
#include "fix_wall_gran.h"
#include "force.h"
#include "lammps.h"
#include "modify.h"
#include "coulomb/pair_coul_clump.h"
#include "coulomb/pair_dlvo_clump.h"
#include "pair_gran.h"

using namespace LAMMPS_NS;

// fixes that set forces keep to themselves which
template <int FixSetForce::*x, int FixSetForce::*y, int FixSetForce::*z, int FixSetForce::*region>
struct SetForceAxes {
  friend void set_axes(const FixSetForce &fix, clay::FixEntry &entry)
  {
    // 0 where the script says NULL
    entry.sets = (fix.*x ? 1 : 0) | (fix.*y ? 2 : 0) | (fix.*z ? 4 : 0);
    if (fix.*region >= 0) entry.odd = "acts in a region, and which particles it holds changes; give it a group instead";
  }
};
void set_axes(const FixSetForce &fix, clay::FixEntry &entry);
template struct SetForceAxes<&FixSetForce::xstyle, &FixSetForce::ystyle, &FixSetForce::zstyle, &FixSetForce::iregion>;

template <double FixPlaneForce::*x, double FixPlaneForce::*y, double FixPlaneForce::*z>
struct PlaneNormal {
  friend std::array<double, 3> direction(const FixPlaneForce &fix) { return {{fix.*x, fix.*y, fix.*z}}; }
};
std::array<double, 3> direction(const FixPlaneForce &fix);
template struct PlaneNormal<&FixPlaneForce::xdir, &FixPlaneForce::ydir, &FixPlaneForce::zdir>;

namespace {

// the axis of d is held, or all but it
void hold_along(const std::array<double, 3> &d, bool itself, clay::FixEntry &entry)
{
  int axes = 0, other = 0;
  for (int k = 0; k < 3; k++) (std::fabs(d[k]) > 1e-12 ? axes : other) |= 1 << k;
  if (axes & (axes - 1))
    entry.odd = "takes a direction between the axes, along which the drag cannot be solved; take an axis";
  entry.sets = itself ? axes : other;
}

using Eigen::Matrix3d;
using Eigen::Vector3d;

const double infinity = std::numeric_limits<double>::infinity();

}

/* ---------------------------------------------------------------------- */

ContactModel::ContactModel(LAMMPS *lmp) : lmp_(lmp)
{
  PairGran *gran = granular_pair(lmp);
  stiffness_ = gran && gran->contact_match("normal", "hooke/stiffness");
  known_ = stiffness_ || (gran && gran->contact_match("normal", "hooke"));
}

double ContactModel::global(const char *name, const char *kind, int i, int j) const
{
  const int n = lmp_->atom->ntypes;
  const std::string shape = kind;
  Fix *found = lmp_->modify->find_fix_property(name, "property/global", kind, shape == "scalar" ? 0 : n,
                                               shape == "peratomtypepair" ? n : 0, "contact check", false);
  FixPropertyGlobal *p = dynamic_cast<FixPropertyGlobal *>(found);
  if (!p) return -1.0;
  if (shape == "scalar") return p->compute_scalar();
  if (shape == "peratomtype") return p->compute_vector(i - 1);
  return p->compute_array(i - 1, j - 1);
}

clay::ContactCoefficients ContactModel::between(int i, int j, double mass, double radius) const
{
  if (stiffness_) {
    clay::ContactCoefficients c;
    c.kn = global("kn", "peratomtypepair", i, j);
    c.kt = global("kt", "peratomtypepair", i, j);
    // damping per mass, or as it is with absolute_damping on
    const double absolute = global("gamman_abs", "peratomtypepair", i, j);
    c.cn = absolute >= 0 ? absolute : mass * global("gamman", "peratomtypepair", i, j);
    c.ct = absolute >= 0 ? global("gammat_abs", "peratomtypepair", i, j)
                         : mass * global("gammat", "peratomtypepair", i, j);
    return c;
  }
  const double modulus =
      clay::effectiveModulus(global("youngsModulus", "peratomtype", i), global("poissonsRatio", "peratomtype", i),
                             global("youngsModulus", "peratomtype", j), global("poissonsRatio", "peratomtype", j));
  return clay::hookeCoefficients(radius, mass, modulus, global("characteristicVelocity", "scalar"),
                                 global("coefficientRestitution", "peratomtypepair", i, j));
}

/* ---------------------------------------------------------------------- */

std::vector<clay::FixEntry> LAMMPS_NS::script_fixes(LAMMPS *lmp)
{
  std::vector<clay::FixEntry> all;
  for (int i = 0; i < lmp->modify->nfix; i++) {
    Fix *fix = lmp->modify->fix[i];
    all.push_back({fix->id, fix->style, (fix->setmask() & FixConst::POST_FORCE) != 0, fix->groupbit, 0, ""});
    if (const FixSetForce *set = dynamic_cast<FixSetForce *>(fix)) set_axes(*set, all.back());
    else if (const FixPlaneForce *plane = dynamic_cast<FixPlaneForce *>(fix))
      hold_along(direction(*plane), true, all.back());
    else if (FixLineForce *line = dynamic_cast<FixLineForce *>(fix)) {
      std::array<double, 3> d;
      line->get_dir(d.data());
      hold_along(d, false, all.back());
    } else if (all.back().style == "enforce2d") all.back().sets = 4;
  }
  return all;
}

clay::MovingGroups LAMMPS_NS::moving_groups(LAMMPS *lmp) { return clay::moving_groups(script_fixes(lmp)); }

/* ---------------------------------------------------------------------- */

double LAMMPS_NS::resting_step_limit(LAMMPS *lmp, std::string *which)
{
  double limit = infinity;
  const ContactModel model(lmp);
  if (!model.known()) return limit;
  const std::vector<FixWallGran *> walls = primitive_walls(lmp);

  for (int f = 0; f < lmp->modify->nfix; f++) {
    const FixTemplateClay *t = dynamic_cast<FixTemplateClay *>(lmp->modify->fix[f]);
    if (!t) continue;
    std::vector<Eigen::Vector3d> centres;
    std::vector<double> radii;
    double radius = 0;
    for (const auto &s : t->clump()) {
      centres.push_back(s.x);
      radii.push_back(s.r);
      radius = std::max(radius, s.r);
    }
    const int type = t->types()[0];
    const int wall = walls.empty() ? type : walls[0]->atom_type_wall();
    const auto contacts = clay::restingContacts(centres, radii, model.between(type, wall, t->mass(), radius),
                                                model.between(type, type, 0.5 * t->mass(), 0.5 * radius));
    const double step = clay::stableStep(t->mass(), t->density() * t->geometry().inertia, contacts);
    if (step < limit) {
      limit = step;
      if (which) *which = std::string("a clump '") + t->id + "'";
    }
  }

  // of each type the lightest free sphere that moves: all else equal its limit is the lowest
  const clay::MovingGroups moving = moving_groups(lmp);
  const Atom &atom = *lmp->atom;
  FixMultisphere *ms = static_cast<FixMultisphere *>(lmp->modify->find_fix_style("multisphere", 0));
  std::vector<double> mass(atom.ntypes + 1, infinity), size(atom.ntypes + 1, infinity);
  for (int i = 0; i < atom.nlocal; i++) {
    if ((ms && ms->belongs_to(i) >= 0) || !moving.moves(atom.mask[i])) continue;
    mass[atom.type[i]] = std::min(mass[atom.type[i]], atom.rmass[i]);
    size[atom.type[i]] = std::min(size[atom.type[i]], atom.radius[i]);
  }
  MPI_Allreduce(MPI_IN_PLACE, mass.data(), mass.size(), MPI_DOUBLE, MPI_MIN, lmp->world);
  MPI_Allreduce(MPI_IN_PLACE, size.data(), size.size(), MPI_DOUBLE, MPI_MIN, lmp->world);
  for (int type = 1; type <= atom.ntypes; type++) {
    const double m = mass[type], r = size[type];
    if (m == infinity) continue;
    const int wall = walls.empty() ? type : walls[0]->atom_type_wall();
    const auto contacts = clay::restingContacts({Vector3d::Zero()}, {r}, model.between(type, wall, m, r),
                                                model.between(type, type, 0.5 * m, 0.5 * r));
    const double step = clay::stableStep(m, 0.4 * m * r * r * Matrix3d::Identity(), contacts);
    if (step < limit) {
      limit = step;
      if (which) *which = "a sphere of type " + std::to_string(type);
    }
  }
  return limit;
}

/* ---------------------------------------------------------------------- */

namespace {

template <class Style>
const Style *pair_of(LAMMPS *lmp, const char *name)
{
  return lmp->force->pair ? dynamic_cast<Style *>(lmp->force->pair_match(name, 1)) : nullptr;
}

/// What pulls two spheres of two types together over a distance: charges, double layers, van der Waals forces.
class Pull {
 public:
  explicit Pull(LAMMPS *lmp) :
    coul_(pair_of<PairCoulClump>(lmp, "coul/clump")), dlvo_(pair_of<PairDlvoClump>(lmp, "dlvo/clump"))
  {
  }

  bool any() const { return coul_ || dlvo_; }
  std::string name() const { return dlvo_ ? coul_ ? "charges and dlvo/clump" : "dlvo/clump" : "the charges"; }

  void between(int i, int j, double ri, double rj)
  {
    ri_ = ri, rj_ = rj;
    qq_ = coul_ ? coul_->charge(i) * coul_->law().weight(ri) * coul_->charge(j) * coul_->law().weight(rj) : 0;
    yy_ = dlvo_ ? dlvo_->effective(i) * dlvo_->effective(j) : 0;
  }
  /// Force [N] that pulls at a distance of centres [m].
  double force(double r) const
  {
    double f = coul_ ? -coul_->law().forceOverDistance(qq_, r) * r : 0;
    if (dlvo_) f -= dlvo_->law().force(yy_, ri_ * rj_ / (ri_ + rj_), r - ri_ - rj_);
    return f;
  }
  /// Energy [J] it has given to two from afar when they touch.
  double work() const
  {
    double e = coul_ ? -coul_->law().energy(qq_, ri_ + rj_) : 0;
    if (dlvo_) e -= dlvo_->law().energy(yy_, ri_ * rj_ / (ri_ + rj_), 0);
    return e;
  }

 private:
  const PairCoulClump *coul_;
  const PairDlvoClump *dlvo_;
  double ri_ = 0, rj_ = 0, qq_ = 0, yy_ = 0;
};

}

ChargedContact LAMMPS_NS::charged_contact(LAMMPS *lmp)
{
  ChargedContact worst;
  const ContactModel model(lmp);
  Pull pull(lmp);
  if (!pull.any() || !model.known()) return worst;

  const Atom &atom = *lmp->atom;
  std::vector<double> mass(atom.ntypes + 1, infinity), size(atom.ntypes + 1, infinity);
  for (int i = 0; i < atom.nlocal; i++) {
    mass[atom.type[i]] = std::min(mass[atom.type[i]], atom.rmass[i]);
    size[atom.type[i]] = std::min(size[atom.type[i]], atom.radius[i]);
  }
  MPI_Allreduce(MPI_IN_PLACE, mass.data(), mass.size(), MPI_DOUBLE, MPI_MIN, lmp->world);
  MPI_Allreduce(MPI_IN_PLACE, size.data(), size.size(), MPI_DOUBLE, MPI_MIN, lmp->world);

  for (int i = 1; i <= atom.ntypes; i++)
    for (int j = 1; j <= i; j++) {
      if (size[i] == infinity || size[j] == infinity) continue;
      pull.between(i, j, size[i], size[j]);
      if (pull.force(size[i] + size[j]) <= 0 || pull.work() <= 0) continue;
      const double d = size[i] + size[j], m = mass[i] * mass[j] / (mass[i] + mass[j]);
      const double k = model.between(i, j, m, size[i] * size[j] / d).kn;
      const double impact = std::sqrt(2 * pull.work() / k) / d;
      if (impact <= worst.impact) continue;
      worst = {clay::attractedOverlap([&](double r) { return pull.force(r); }, k, d),
               impact,
               k,
               k * impact * impact / 0.01,
               j,
               i,
               pull.name()};
    }
  return worst;
}
