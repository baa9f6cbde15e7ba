// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/particle_packer.h"

#include <algorithm>
#include <cmath>

namespace clay {

using Row = FluidRow;

namespace {

// what a message tells of a sphere besides the host's arrays
struct Told {
  double volume, mass, body;
  const double *impulse;
};

void pack(const SphereArrays &spheres, int i, const Told &told, bool still, int slot, Particles &message)
{
  const FieldSet &fields = message.fields();
  auto vector = [&](Field f, const double *from) {
    if (fields.has(f)) std::copy(from, from + 3, message[f] + 3 * slot);
  };
  auto number = [&](Field f, double value) {
    if (fields.has(f)) message[f][slot] = value;
  };
  const double at_rest[3] = {0., 0., 0.};
  vector(Field::position, spheres.x[i]);
  vector(Field::velocity, still ? at_rest : spheres.v[i]);
  number(Field::radius, spheres.radius[i]);
  number(Field::volume, told.volume);
  number(Field::mass, told.mass);
  number(Field::tag, spheres.tag[i]);
  number(Field::body, told.body);
  if (fields.has(Field::spin)) vector(Field::spin, spheres.omega[i]);
  if (fields.has(Field::gravity)) vector(Field::gravity, spheres.gravity->on(spheres.groups[i]).data());
  vector(Field::impulse, told.impulse);
}

}  // namespace

/* ---------------------------------------------------------------------- */

void pack_free(const std::vector<int> &list, const SphereArrays &spheres, double *const *fluid, bool still,
               Particles &message)
{
  const double third = 4. / 3. * M_PI;
  int slot = 0;
  for (int i : list) {
    const double r = spheres.radius[i];
    double *impulse = fluid[i] + Row::IMPULSE;
    fluid[i][Row::SLOT] = slot;
    pack(spheres, i, {third * r * r * r, spheres.mass[i], -1., impulse}, still, slot++, message);
    std::fill(impulse, impulse + 3, 0.);
  }
  for (Field f : {Field::dragDiameter, Field::dragFactor})
    if (message.fields().has(f)) std::fill(message[f], message[f] + slot, 0.);
}

/* ---------------------------------------------------------------------- */

std::vector<double> share_impulses(const std::vector<BodySphere> &spheres, const std::vector<BodyState> &bodies,
                                   double *const *fluid, double *const *v, bool still, double time)
{
  std::vector<double> shares(3 * spheres.size()), rest(3 * bodies.size()), weight(bodies.size(), 0.);
  for (std::size_t b = 0; b < bodies.size(); b++)
    std::copy(bodies[b].impulse.begin(), bodies[b].impulse.end(), &rest[3 * b]);

  for (std::size_t n = 0; n < spheres.size(); n++) {
    const BodySphere &s = spheres[n];
    const double *row = fluid[s.atom];
    weight[s.body] += row[Row::DRAG];
    for (int k = 0; k < 3; k++) {
      shares[3 * n + k] = time *
          (row[Row::LOAD + k] - row[Row::HYDRO + k] +
           row[Row::DRAG] * (row[Row::VELOCITY + k] - (still ? 0. : v[s.atom][k])));
      rest[3 * s.body + k] -= shares[3 * n + k];
    }
  }
  for (std::size_t n = 0; n < spheres.size(); n++) {
    const BodySphere &s = spheres[n];
    const double part = weight[s.body] > 0. ? fluid[s.atom][Row::DRAG] / weight[s.body] : s.fraction;
    for (int k = 0; k < 3; k++) shares[3 * n + k] += part * rest[3 * s.body + k];
  }
  return shares;
}

/* ---------------------------------------------------------------------- */

void pack_bodies(const std::vector<BodySphere> &list, const std::vector<BodyState> &bodies,
                 const std::vector<double> &impulses, const SphereArrays &spheres, bool still, int first,
                 Particles &message)
{
  for (std::size_t n = 0; n < list.size(); n++) {
    const BodySphere &s = list[n];
    const BodyState &b = bodies[s.body];
    pack(spheres, s.atom, {s.fraction * b.volume, s.fraction * b.mass, b.tag, &impulses[3 * n]}, still, first++,
         message);
  }
}

/* ---------------------------------------------------------------------- */

int first_astray(const Particles &message)
{
  if (!message.fields().has(Field::position) || !message.fields().has(Field::velocity)) return -1;
  const double *x = message[Field::position], *v = message[Field::velocity];
  for (int i = 0; i < 3 * message.size(); i++)
    if (!std::isfinite(x[i]) || !std::isfinite(v[i])) return i / 3;
  return -1;
}

/* ---------------------------------------------------------------------- */

void unpack(const Particles &answer, const Particles &sent, const Hydrostatics &still, int slot, double *row)
{
  row[Row::DRAG] = answer[Field::dragCoefficient][slot];
  const double *u = answer[Field::fluidVelocity] + 3 * slot;
  std::copy(u, u + 3, row + Row::VELOCITY);
  if (answer.fields().has(Field::force)) {
    const double *load = answer[Field::force] + 3 * slot;
    std::copy(load, load + 3, row + Row::LOAD);
  } else std::fill(row + Row::LOAD, row + Row::LOAD + 3, 0.);
  row[Row::FRACTION] = answer.fields().has(Field::voidFraction) ? answer[Field::voidFraction][slot] : 0.;

  const double rho = row[Row::DRAG] > 0. ? still.rho : 0.;
  const double *g = sent.fields().has(Field::gravity) ? sent[Field::gravity] + 3 * slot : still.gravity.data();
  for (int k = 0; k < 3; k++) row[Row::HYDRO + k] = rho > 0. ? sent[Field::volume][slot] * -(rho * g[k]) : 0.;
}

/* ---------------------------------------------------------------------- */

void unpack_free(const Particles &answer, const Particles &sent, const Hydrostatics &still, int n, const double *mass,
                 const int *mask, const MovingGroups &moving, double dt, double *const *fluid, double *const *inertia)
{
  const bool weighted = answer.fields().has(Field::addedMass);
  const bool turned = answer.fields().has(Field::turnCoefficient);
  for (int i = 0; i < n; i++) {
    const int slot = fluid[i][Row::SLOT];
    if (slot < 0) continue;
    const bool moves = moving.moves(mask[i]);
    unpack(answer, sent, still, slot, fluid[i]);
    fluid[i][Row::RELAX] = moves ? LAMMPS_NS::relaxation_factor(fluid[i][Row::DRAG] * dt / mass[i]) : 1.;
    if (weighted) inertia[i][InertiaRow::ADDED] = moves ? answer[Field::addedMass][slot] : 0.;
    if (turned) {
      inertia[i][InertiaRow::TURN] = moves ? answer[Field::turnCoefficient][slot] : 0.;
      const double *spin = answer[Field::fluidSpin] + 3 * slot;
      std::copy(spin, spin + 3, inertia[i] + InertiaRow::SPIN);
    }
  }
}

}  // namespace clay
