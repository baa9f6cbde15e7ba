// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/run_checks.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "atom.h"
#include "fix_multisphere.h"
#include "fix_property_global.h"
#include "clumps/fix_template_clay.h"
#include "fix_wall_gran.h"
#include "force.h"
#include "lammps.h"
#include "modify.h"
#include "neigh_list.h"
#include "coulomb/pair_coul_clump.h"
#include "pair_gran.h"
#include "primitive_wall.h"
#include "vector_container.h"

using namespace LAMMPS_NS;

namespace {

using Eigen::Map;
using Eigen::Matrix3d;
using Eigen::Vector3d;

const double infinity = std::numeric_limits<double>::infinity();

PairGran *granular(LAMMPS *lmp)
{
  if (!lmp->force->pair) return nullptr;
  Pair *pair = lmp->force->pair_match("gran", 1);
  if (!pair) pair = lmp->force->pair_match("gran/lean", 1);
  return dynamic_cast<PairGran *>(pair);
}

}

std::vector<FixWallGran *> LAMMPS_NS::primitive_walls(LAMMPS *lmp)
{
  std::vector<FixWallGran *> walls;
  for (int i = 0; i < lmp->modify->nfix; i++) {
    FixWallGran *w = dynamic_cast<FixWallGran *>(lmp->modify->fix[i]);
    if (w && !w->is_mesh_wall() && w->primitiveWall()) walls.push_back(w);
  }
  return walls;
}

ContactModel::ContactModel(LAMMPS *lmp) : lmp_(lmp)
{
  PairGran *gran = granular(lmp);
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
  const double modulus = clay::effectiveModulus(
      global("youngsModulus", "peratomtype", i), global("poissonsRatio", "peratomtype", i),
      global("youngsModulus", "peratomtype", j), global("poissonsRatio", "peratomtype", j));
  return clay::hookeCoefficients(radius, mass, modulus, global("characteristicVelocity", "scalar"),
                                 global("coefficientRestitution", "peratomtypepair", i, j));
}

/* ---------------------------------------------------------------------- */

int LAMMPS_NS::moving_groups(LAMMPS *lmp)
{
  int groups = 0;
  for (int i = 0; i < lmp->modify->nfix; i++) {
    const Fix *fix = lmp->modify->fix[i];
    if (!strncmp(fix->style,"nve",3) || !strncmp(fix->style,"multisphere",11)) groups |= fix->groupbit;
  }
  return groups;
}

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
    const int type = t->types().first;
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
  const int movers = moving_groups(lmp);
  const Atom &atom = *lmp->atom;
  FixMultisphere *ms = static_cast<FixMultisphere *>(lmp->modify->find_fix_style("multisphere", 0));
  std::vector<double> mass(atom.ntypes + 1, infinity), size(atom.ntypes + 1, infinity);
  for (int i = 0; i < atom.nlocal; i++) {
    if ((ms && ms->belongs_to(i) >= 0) || !(atom.mask[i] & movers)) continue;
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

ChargedContact LAMMPS_NS::charged_contact(LAMMPS *lmp)
{
  ChargedContact worst;
  const ContactModel model(lmp);
  const PairCoulClump *coul = lmp->force->pair
    ? dynamic_cast<PairCoulClump *>(lmp->force->pair_match("coul/clump", 1)) : nullptr;
  if (!coul || !model.known()) return worst;

  const Atom &atom = *lmp->atom;
  std::vector<double> mass(atom.ntypes + 1, infinity), size(atom.ntypes + 1, infinity);
  for (int i = 0; i < atom.nlocal; i++) {
    mass[atom.type[i]] = std::min(mass[atom.type[i]], atom.rmass[i]);
    size[atom.type[i]] = std::min(size[atom.type[i]], atom.radius[i]);
  }
  MPI_Allreduce(MPI_IN_PLACE, mass.data(), mass.size(), MPI_DOUBLE, MPI_MIN, lmp->world);
  MPI_Allreduce(MPI_IN_PLACE, size.data(), size.size(), MPI_DOUBLE, MPI_MIN, lmp->world);

  for (int i = 1; i <= atom.ntypes; i++)
    for (int j = 1; j < i; j++) {
      const double qq = coul->charge(i) * coul->charge(j);
      if (size[i] == infinity || size[j] == infinity || qq >= 0) continue;
      const double d = size[i] + size[j], m = mass[i] * mass[j] / (mass[i] + mass[j]);
      const double k = model.between(i, j, m, size[i] * size[j] / d).kn;
      const double impact = std::sqrt(2 * std::fabs(coul->law().energy(qq, d)) / k) / d;
      if (impact <= worst.impact) continue;
      worst = {clay::attractedOverlap(-coul->law().k * qq, k, d), impact, k, k * impact * impact / 0.01, j, i};
    }
  return worst;
}

/* ---------------------------------------------------------------------- */

double LAMMPS_NS::present_step_limit(LAMMPS *lmp, int *contacts)
{
  const ContactModel model(lmp);
  PairGran *gran = granular(lmp);
  if (contacts) *contacts = 0;
  if (!model.known() || !gran || !gran->list) return infinity;

  Atom &atom = *lmp->atom;
  FixMultisphere *ms = static_cast<FixMultisphere *>(lmp->modify->find_fix_style("multisphere", 0));

  // of each body: centre of mass, mass, tensor of inertia in space axes; from its owner
  const int nbody = ms ? ms->tag_max_body() + 1 : 0;
  enum { CENTRE = 0, MASS = 3, LEAST = 4, INERTIA = 5, WIDTH = 14 };
  std::vector<double> body(WIDTH * nbody, 0.0);
  if (ms) {
    const auto vectors = [ms](const char *name) {
      return ms->data().prop().getElementProperty<VectorContainer<double,3> >(name)->begin();
    };
    double **moments = vectors("inertia"), **ex = vectors("ex_space"), **ey = vectors("ey_space"),
           **ez = vectors("ez_space");
    for (int b = 0; b < ms->n_body(); b++) {
      double *kept = &body[WIDTH * ms->data().tag(b)];
      ms->data().xcm(kept, b);
      kept[MASS] = ms->data().mass(b);
      kept[LEAST] = *std::min_element(moments[b], moments[b] + 3);
      Matrix3d axes;
      axes << Map<Vector3d>(ex[b]), Map<Vector3d>(ey[b]), Map<Vector3d>(ez[b]);
      Map<Matrix3d>(kept + INERTIA) = axes * Map<Vector3d>(moments[b]).asDiagonal() * axes.transpose();
    }
  }
  MPI_Allreduce(MPI_IN_PLACE, body.data(), body.size(), MPI_DOUBLE, MPI_SUM, lmp->world);

  // sums of the contacts of each body, and at once of each free sphere
  enum { K = 0, C = 1, COUNT = 2, SUMS = 3 };
  std::vector<double> sums(SUMS * nbody, 0.0), free(SUMS * atom.nlocal, 0.0);
  std::vector<clay::ContactMatrices> matrices(nbody);
  const auto add = [&](int i, const double *at, const clay::ContactCoefficients &c, bool fixed) {
    if (i >= atom.nlocal) return;
    const int b = ms ? ms->belongs_to(i) : -1;
    double arm2 = 0, m = atom.rmass[i], inertia = 0.4 * m * atom.radius[i] * atom.radius[i];
    const double *centre = atom.x[i];
    if (b >= 0) {
      centre = &body[WIDTH * b];
      m = body[WIDTH * b + MASS];
      inertia = body[WIDTH * b + LEAST];
    }
    for (int d = 0; d < 3; d++) arm2 += (at[d] - centre[d]) * (at[d] - centre[d]);
    const double share = (fixed ? 1 : 2) * (1 / m + arm2 / inertia);
    double *s = b >= 0 ? &sums[SUMS * b] : &free[SUMS * i];
    s[K] += share * std::max(c.kn, c.kt);
    s[C] += share * std::max(c.cn, c.ct);
    s[COUNT] += 1;
    if (b < 0) return;
    const Vector3d point = Map<const Vector3d>(at), normal = point - Map<const Vector3d>(atom.x[i]);
    matrices[b].add({point - Map<const Vector3d>(centre), normal.normalized(), c, fixed});
  };

  const NeighList *list = gran->list;
  for (int a = 0; a < list->inum; a++) {
    const int i = list->ilist[a];
    for (int n = 0; n < list->numneigh[i]; n++) {
      const int j = list->firstneigh[i][n] & NEIGHMASK;
      const double reach = atom.radius[i] + atom.radius[j];
      double r2 = 0, at[3];
      for (int d = 0; d < 3; d++) {
        const double apart = atom.x[j][d] - atom.x[i][d];
        r2 += apart * apart;
        at[d] = atom.x[i][d] + apart * atom.radius[i] / reach;
      }
      if (r2 >= reach * reach) continue;
      const auto c = model.between(atom.type[i], atom.type[j],
                                   atom.rmass[i] * atom.rmass[j] / (atom.rmass[i] + atom.rmass[j]),
                                   atom.radius[i] * atom.radius[j] / reach);
      add(i, at, c, false);
      add(j, at, c, false);
    }
  }
  for (FixWallGran *w : primitive_walls(lmp))
    for (int i = 0; i < atom.nlocal; i++) {
      if (!(atom.mask[i] & w->groupbit)) continue;
      double to_wall[3] = {0, 0, 0};
      if (w->primitiveWall()->resolveContact(atom.x[i], atom.radius[i], to_wall) >= 0) continue;
      double at[3];
      for (int d = 0; d < 3; d++) at[d] = atom.x[i][d] + to_wall[d];
      add(i, at, model.between(atom.type[i], w->atom_type_wall(), atom.rmass[i], atom.radius[i]), true);
    }
  MPI_Allreduce(MPI_IN_PLACE, sums.data(), sums.size(), MPI_DOUBLE, MPI_SUM, lmp->world);
  MPI_Allreduce(MPI_IN_PLACE, matrices.data(), matrices.size() * sizeof(clay::ContactMatrices) / sizeof(double),
                MPI_DOUBLE, MPI_SUM, lmp->world);

  // every processor knows all of the bodies, and its own free spheres
  struct { double step; int contacts; } mine = { infinity, 0 }, least;
  for (std::size_t s = 0; s < free.size(); s += SUMS) {
    const double step = clay::oscillatorStep(free[s + K], free[s + C]);
    if (step < mine.step) { mine.step = step; mine.contacts = static_cast<int>(free[s + COUNT]); }
  }
  // the cheap bounds first: once they are above the best, so are all that follow
  std::vector<std::pair<double, int>> order;
  for (int b = 0; b < nbody; b++)
    if (sums[SUMS * b + COUNT] > 0)
      order.emplace_back(clay::oscillatorStep(sums[SUMS * b + K], sums[SUMS * b + C]), b);
  std::sort(order.begin(), order.end());
  for (const auto &next : order) {
    if (next.first >= mine.step) break;
    const int b = next.second;
    const double *kept = &body[WIDTH * b];
    const double step = matrices[b].step(kept[MASS], Map<const Matrix3d>(kept + INERTIA));
    if (step < mine.step) { mine.step = step; mine.contacts = static_cast<int>(sums[SUMS * b + COUNT]); }
  }
  MPI_Allreduce(&mine, &least, 1, MPI_DOUBLE_INT, MPI_MINLOC, lmp->world);
  if (contacts) *contacts = least.contacts;
  return least.step;
}
