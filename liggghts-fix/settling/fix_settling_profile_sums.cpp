/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   Forces act between bodies: the spheres of a clump count where its centre is.
------------------------------------------------------------------------- */

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "atom.h"
#include "clumps/to_ranks.h"
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
#include "settling/shared_clusters.h"
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
  add_clusters();
  std::vector<double> &sums = profile_->sums();
  MPI_Reduce(comm->me == 0 ? MPI_IN_PLACE : sums.data(), sums.data(), static_cast<int>(sums.size()), MPI_DOUBLE,
             MPI_SUM, 0, world);
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

/* ----------------------------------------------------------------------
   each body is known by the processor that its key names: those that have a
   sphere of another's clump, or a link to a body, ask there
------------------------------------------------------------------------- */

void FixSettlingProfile::share_bodies()
{
  std::vector<std::vector<Body>> told(comm->nprocs);
  for (const std::vector<Body> *bodies : {&clumps_, &loose_})
    for (const Body &b : *bodies) told[clay::rankNamedBy(std::lround(b.key), comm->nprocs)].push_back(b);
  named_ = clay::sendToRanks(told, world);
  named_place_.clear();
  for (std::size_t k = 0; k < named_.size(); k++) named_place_[std::lround(named_[k].key)] = static_cast<int>(k);

  seen_ = clumps_;
  place_.clear();
  for (std::size_t k = 0; k < seen_.size(); k++) place_[static_cast<int>(seen_[k].key)] = static_cast<int>(k);
  std::vector<double> others;
  std::unordered_set<int> wanted;
  for (int i = 0; multisphere_ && i < atom->nlocal + atom->nghost; i++) {
    const int tag = multisphere_->belongs_to(i);
    if (tag >= 0 && !place_.count(tag) && wanted.insert(tag).second) others.push_back(tag);
  }
  for (const Body &b : asked_for(others)) {
    place_[static_cast<int>(b.key)] = static_cast<int>(seen_.size());
    seen_.push_back(b);
  }
}

/* ----------------------------------------------------------------------
   bodies of these keys, in any order, without those that are no more
------------------------------------------------------------------------- */

std::vector<FixSettlingProfile::Body> FixSettlingProfile::asked_for(const std::vector<double> &keys)
{
  struct Asked {
    double key;
    int by;
  };
  std::vector<std::vector<Asked>> asked(comm->nprocs);
  for (double key : keys) asked[clay::rankNamedBy(std::lround(key), comm->nprocs)].push_back({key, comm->me});
  std::vector<std::vector<Body>> answers(comm->nprocs);
  for (const Asked &a : clay::sendToRanks(asked, world)) {
    const auto found = named_place_.find(std::lround(a.key));
    if (found != named_place_.end()) answers[a.by].push_back(named_[found->second]);
  }
  return clay::sendToRanks(answers, world);
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
  links_.push_back({std::min(a.key, b.key), std::max(a.key, b.key), touch, energy, comm->me});
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
   at the processor that the first body's key names: each pair of bodies, once
   for each processor that knows of it, with all of its energy
------------------------------------------------------------------------- */

std::vector<FixSettlingProfile::Link> FixSettlingProfile::pooled_links()
{
  const auto before = [](const Link &a, const Link &b) {
    return a.first != b.first ? a.first < b.first : a.second < b.second;
  };
  const auto pool = [&](std::vector<Link> &links) {
    std::stable_sort(links.begin(), links.end(), before);
    for (std::size_t from = 0, to = 0; from < links.size(); from = to) {
      Link all = links[from];
      for (to = from + 1; to < links.size() && !before(all, links[to]); to++) {
        all.touch = std::max(all.touch, links[to].touch);
        all.energy += links[to].energy;
      }
      for (std::size_t k = from; k < to; k++) {
        links[k].touch = all.touch;
        links[k].energy = all.energy;
      }
    }
  };
  const auto same = [&](const Link &a, const Link &b) { return !before(a, b) && a.by == b.by; };

  pool(links_);
  links_.erase(std::unique(links_.begin(), links_.end(), same), links_.end());
  std::vector<std::vector<Link>> told(comm->nprocs);
  for (const Link &one : links_) told[clay::rankNamedBy(std::lround(one.first), comm->nprocs)].push_back(one);
  std::vector<Link> links = clay::sendToRanks(told, world);
  pool(links);
  return links;
}

/* ----------------------------------------------------------------------
   contacts and the sizes of clusters, where the bodies' keys name
------------------------------------------------------------------------- */

void FixSettlingProfile::add_clusters()
{
  const std::vector<Link> links = pooled_links();
  std::vector<double> others;
  std::unordered_set<long> wanted;
  for (const Link &one : links)
    if (wanted.insert(std::lround(one.second)).second) others.push_back(one.second);
  std::unordered_map<long, Body> second;
  for (const Body &b : asked_for(others)) second[std::lround(b.key)] = b;

  struct Joined {
    double first, second;
    int touching;
  };
  std::vector<std::vector<Joined>> told(comm->nprocs);
  for (std::size_t k = 0; k < links.size(); k++) {
    const Link &one = links[k];
    const Body &a = named_[named_place_.at(std::lround(one.first))], &b = second.at(std::lround(one.second));
    double v2 = 0.0, apart[3];
    for (int d = 0; d < 3; d++) {
      v2 += (a.v[d] - b.v[d]) * (a.v[d] - b.v[d]);
      apart[d] = a.x[d] - b.x[d];
    }
    domain->minimum_image(apart);
    const bool held = one.energy < 0.0 && one.energy + 0.5 * v2 * a.mass * b.mass / (a.mass + b.mass) < 0.0;
    if (one.touch > 0.0 || held) told[one.by].push_back({one.first, one.second, one.touch > 0.0});
    const bool again = k > 0 && links[k - 1].first == one.first && links[k - 1].second == one.second;
    if (one.touch == 0.0 || again) continue;
    profile_->addAt(Profile::CONTACTS, a.x[2], 1.0);
    profile_->addAt(Profile::CONTACTS, b.x[2], 1.0);
    if (a.has_axis && b.has_axis) profile_->addAt(clay::meeting(a.axis, b.axis, apart), 0.5 * (a.x[2] + b.x[2]), 1.0);
  }

  // joined where they were seen, since neighbours are known there
  std::vector<std::pair<long, long>> touching, bound;
  for (const Joined &j : clay::sendToRanks(told, world)) {
    bound.push_back({std::lround(j.first), std::lround(j.second)});
    if (j.touching) touching.push_back(bound.back());
  }
  const std::unordered_map<long, int> sizes[2] = {clay::clusterSizes(touching, world),
                                                  clay::clusterSizes(bound, world)};
  const Profile::Sum sums[2] = {Profile::TOUCHING, Profile::BOUND};
  for (int kind = 0; kind < 2; kind++) {
    clusters_[kind] = 0.0;
    for (const Body &b : named_) {
      const auto found = sizes[kind].find(std::lround(b.key));
      const int size = found == sizes[kind].end() ? 1 : found->second;
      profile_->addAt(sums[kind], b.x[2], size);
      clusters_[kind] = std::max<double>(clusters_[kind], size);
    }
  }
  MPI_Allreduce(MPI_IN_PLACE, clusters_, 2, MPI_DOUBLE, MPI_MAX, world);
}
