/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   Forces act between bodies: the spheres of a clump count where its centre is.
------------------------------------------------------------------------- */

#include <algorithm>
#include <cmath>

#include "atom.h"
#include "comm.h"
#include "contacts/granular_script.h"
#include "coulomb/pair_clump.h"
#include "domain.h"
#include "fix_multisphere.h"
#include "fix_wall_gran.h"
#include "fluid/coupled_fluid.h"
#include "force.h"
#include "fix_property_global.h"
#include "modify.h"
#include "primitive_wall.h"
#include "settling/column_script.h"
#include "settling/fix_settling_profile.h"
#include "settling/pair_listener.h"
#include "update.h"

using namespace LAMMPS_NS;

typedef clay::ColumnProfile Profile;

/* ---------------------------------------------------------------------- */

void FixSettlingProfile::measure()
{
  measured_ = update->ntimestep;
  profile_->clear();
  links_.clear();
  find_bodies();
  share_bodies();
  add_spheres();
  add_loads();
  add_contacts();
  add_charges();
  add_walls();
  std::vector<double> &sums = profile_->sums();
  MPI_Reduce(comm->me == 0 ? MPI_IN_PLACE : sums.data(), sums.data(), static_cast<int>(sums.size()), MPI_DOUBLE,
             MPI_SUM, 0, world);
  add_clusters();
}

/* ----------------------------------------------------------------------
   rows of all processors, on the first one or on all
------------------------------------------------------------------------- */

template <class Row>
std::vector<Row> FixSettlingProfile::gather(const std::vector<Row> &mine, bool to_all)
{
  if (comm->nprocs == 1) return mine;
  const int bytes = static_cast<int>(mine.size() * sizeof(Row));
  std::vector<int> counts(comm->nprocs), from(comm->nprocs + 1, 0);
  MPI_Allgather(&bytes, 1, MPI_INT, counts.data(), 1, MPI_INT, world);
  for (int p = 0; p < comm->nprocs; p++) from[p + 1] = from[p] + counts[p];
  std::vector<Row> all(to_all || comm->me == 0 ? from.back() / sizeof(Row) : 0);
  if (to_all) MPI_Allgatherv(mine.data(), bytes, MPI_BYTE, all.data(), counts.data(), from.data(), MPI_BYTE, world);
  else MPI_Gatherv(mine.data(), bytes, MPI_BYTE, all.data(), counts.data(), from.data(), MPI_BYTE, 0, world);
  return all;
}

/* ---------------------------------------------------------------------- */

void FixSettlingProfile::find_bodies()
{
  clumps_.clear();
  loose_.clear();
  if (multisphere_) {
    Multisphere &data = multisphere_->data();
    double **inertia = data.extract_double_vector("inertia");
    const char *names[3] = {"ex_space", "ey_space", "ez_space"};
    for (int b = 0; b < data.n_body(); b++) {
      Body body = {};
      body.key = data.tag(b);
      data.xcm(body.x, b);
      data.vcm(body.v, b);
      body.mass = data.mass(b);
      const int axis = clay::axisOf(inertia[b]);
      body.has_axis = axis >= 0;
      if (axis >= 0) std::copy_n(data.extract_double_vector(names[axis])[b], 3, body.axis);
      clumps_.push_back(body);
    }
  }
  for (int i = 0; i < atom->nlocal; i++)
    if (!multisphere_ || multisphere_->belongs_to(i) < 0) loose_.push_back(body_of(i));
}

void FixSettlingProfile::share_bodies()
{
  seen_ = gather(clumps_, true);
  place_.clear();
  for (std::size_t k = 0; k < seen_.size(); k++) place_[static_cast<int>(seen_[k].key)] = static_cast<int>(k);
}

/* ----------------------------------------------------------------------
   of an atom, which may be another processor's
------------------------------------------------------------------------- */

FixSettlingProfile::Body FixSettlingProfile::body_of(int i)
{
  const int tag = multisphere_ ? multisphere_->belongs_to(i) : -1;
  if (tag >= 0) {
    const auto found = place_.find(tag);
    if (found != place_.end()) return seen_[found->second];
  }
  Body body = {};
  body.key = -1.0 - atom->tag[i];
  std::copy_n(atom->x[i], 3, body.x);
  std::copy_n(atom->v[i], 3, body.v);
  body.mass = atom->rmass[i];
  return body;
}

/* ---------------------------------------------------------------------- */

void FixSettlingProfile::add_spheres()
{
  for (int i = 0; i < atom->nlocal; i++)
    profile_->addSphere(atom->x[i][2], atom->radius[i], sphere_volume(lmp, multisphere_, i), atom->v[i][2]);
  for (const std::vector<Body> *bodies : {&clumps_, &loose_})
    for (const Body &b : *bodies) {
      profile_->addAt(Profile::BODIES, b.x[2], 1.0);
      if (b.has_axis) profile_->addAxis(b.x[2], b.axis);
    }
}

/* ----------------------------------------------------------------------
   weight less buoyancy, and what the fluid does besides
------------------------------------------------------------------------- */

void FixSettlingProfile::add_loads()
{
  gravity_.evaluate();
  const clay::GroupGravity gravity = gravity_.now();
  CoupledFluid *fluid = CoupledFluid::find(modify);
  std::vector<double> on_bodies, on_atoms;
  if (fluid) fluid->vertical_forces(on_bodies, on_atoms);

  const auto load = [&](double z, int groups, double mass, double volume, double force) {
    const double g = -gravity.on(groups)[2], lift = fluid_density_ * volume * g;
    profile_->addAbove(Profile::WEIGHT, z, mass * g - lift);
    if (fluid) profile_->addAbove(Profile::FLUID, z, force - lift);
  };
  for (std::size_t b = 0; b < clumps_.size(); b++)
    load(clumps_[b].x[2], groupbit, clumps_[b].mass, multisphere_->data().volume(static_cast<int>(b)),
         fluid ? on_bodies[b] : 0.0);
  for (int i = 0; i < atom->nlocal; i++)
    if (!multisphere_ || multisphere_->belongs_to(i) < 0)
      load(atom->x[i][2], atom->mask[i], atom->rmass[i], sphere_volume(lmp, multisphere_, i),
           fluid ? on_atoms[i] : 0.0);
}

/* ---------------------------------------------------------------------- */

void FixSettlingProfile::link(const Body &a, const Body &b, double touch, double energy)
{
  links_.push_back({std::min(a.key, b.key), std::max(a.key, b.key), touch, energy});
}

double FixSettlingProfile::friction(int itype, int jtype) const
{
  return friction_ ? friction_->compute_array(itype - 1, jtype - 1) : HUGE_VAL;
}

void FixSettlingProfile::add_contacts()
{
  PairGran *gran = granular_pair(lmp);
  if (!gran) return;
  listener_->each(gran, [this](int i, int j, const double *f) {
    const Body a = body_of(i), b = body_of(j);
    if (a.key == b.key) return;
    double apart[3], held[3];
    for (int d = 0; d < 3; d++) {
      apart[d] = atom->x[i][d] - atom->x[j][d];
      held[d] = f[d];
    }
    limit_friction(held, apart, friction(atom->type[i], atom->type[j]));
    profile_->addAcross(Profile::CONTACT, b.x[2], a.x[2], held[2]);
    link(a, b, 1.0, 0.0);
  });
}

void FixSettlingProfile::add_charges()
{
  for (const char *style : {"coul/clump", "dlvo/clump"}) {
    PairClump *pair = force->pair ? dynamic_cast<PairClump *>(force->pair_match(style, 1)) : NULL;
    if (!pair) continue;
    pair->each_pair([this](int i, int j, double share, const double *f, double energy) {
      const Body a = body_of(i), b = body_of(j);
      profile_->addAcross(Profile::COULOMB, b.x[2], a.x[2], share * f[2]);
      if (energy != 0.0) link(a, b, 0.0, share * energy);
    });
  }
}

/* ----------------------------------------------------------------------
   a floor is what is below; all other walls carry what is above
------------------------------------------------------------------------- */

void FixSettlingProfile::add_walls()
{
  for (int k = 0; k < modify->nfix; k++) {
    FixWallGran *wall = dynamic_cast<FixWallGran *>(modify->fix[k]);
    if (!wall) continue;
    double height = 0.0;
    const bool plane = plane_height(lmp, wall, height);
    each_wall_force(lmp, wall, [&](int i, const double *f) {
      const double z = body_of(i).x[2];
      double held[3] = {f[0], f[1], f[2]}, to_wall[3] = {0.0, 0.0, 0.0};
      if (!wall->is_mesh_wall()) {
        wall->primitiveWall()->resolveContact(atom->x[i], atom->radius[i], to_wall);
        limit_friction(held, to_wall, friction(atom->type[i], wall->atom_type_wall()));
      }
      if (plane && height < z) profile_->addAcross(Profile::CONTACT, height, z, held[2]);
      else profile_->addAbove(Profile::WALL, z, held[2]);
    });
  }
}

/* ----------------------------------------------------------------------
   each pair of bodies once, with all of its energy
------------------------------------------------------------------------- */

std::vector<FixSettlingProfile::Link> FixSettlingProfile::pooled_links()
{
  const auto pool = [](std::vector<Link> links) {
    const auto before = [](const Link &a, const Link &b) {
      return a.first != b.first ? a.first < b.first : a.second < b.second;
    };
    std::stable_sort(links.begin(), links.end(), before);
    std::size_t n = 0;
    for (const Link &one : links) {
      if (n && !before(links[n - 1], one)) {
        links[n - 1].touch = std::max(links[n - 1].touch, one.touch);
        links[n - 1].energy += one.energy;
      } else links[n++] = one;
    }
    links.resize(n);
    return links;
  };
  return pool(gather(pool(links_), false));
}

/* ----------------------------------------------------------------------
   on the first processor
------------------------------------------------------------------------- */

void FixSettlingProfile::add_clusters()
{
  std::vector<Body> all = gather(loose_, false);
  const std::vector<Link> links = pooled_links();
  clusters_[0] = clusters_[1] = 0.0;
  if (comm->me != 0) return;
  all.insert(all.end(), seen_.begin(), seen_.end());
  std::unordered_map<long, int> member;
  for (std::size_t k = 0; k < all.size(); k++) member[std::lround(all[k].key)] = static_cast<int>(k);

  const int n = static_cast<int>(all.size());
  clay::Clusters touching(n), bound(n);
  for (const Link &one : links) {
    const int i = member.at(std::lround(one.first)), j = member.at(std::lround(one.second));
    const Body &a = all[i], &b = all[j];
    double v2 = 0.0, apart[3];
    for (int d = 0; d < 3; d++) {
      v2 += (a.v[d] - b.v[d]) * (a.v[d] - b.v[d]);
      apart[d] = a.x[d] - b.x[d];
    }
    domain->minimum_image(apart);
    const bool held = one.energy < 0.0 && one.energy + 0.5 * v2 * a.mass * b.mass / (a.mass + b.mass) < 0.0;
    if (one.touch > 0.0 || held) bound.join(i, j);
    if (one.touch == 0.0) continue;
    touching.join(i, j);
    profile_->addAt(Profile::CONTACTS, a.x[2], 1.0);
    profile_->addAt(Profile::CONTACTS, b.x[2], 1.0);
    if (a.has_axis && b.has_axis) profile_->addAt(clay::meeting(a.axis, b.axis, apart), 0.5 * (a.x[2] + b.x[2]), 1.0);
  }
  for (int k = 0; k < n; k++) {
    profile_->addAt(Profile::TOUCHING, all[k].x[2], touching.size(k));
    profile_->addAt(Profile::BOUND, all[k].x[2], bound.size(k));
    clusters_[0] = std::max<double>(clusters_[0], touching.size(k));
    clusters_[1] = std::max<double>(clusters_[1], bound.size(k));
  }
}
