// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/fluid_output.h"

#include <algorithm>

namespace clay {

using Row = FluidRow;

namespace {

// each sphere's part of what has no place of its own on the body
std::vector<double> parts(const std::vector<BodySphere> &list, int bodies, double *const *fluid)
{
  std::vector<double> sum(bodies, 0.), part;
  for (const BodySphere &s : list) sum[s.body] += fluid[s.atom][Row::DRAG];
  for (const BodySphere &s : list)
    part.push_back(sum[s.body] > 0. ? fluid[s.atom][Row::DRAG] / sum[s.body] : s.fraction);
  return part;
}

// what does not depend on what the particle did
void copy_fluid(const double *row, double *shown)
{
  std::copy(row + Row::VELOCITY, row + Row::VELOCITY + 3, shown + ShownRow::VELOCITY);
  shown[ShownRow::FRACTION] = row[Row::FRACTION];
}

}  // namespace

/* ---------------------------------------------------------------------- */

FluidAction still_action(const double *row)
{
  FluidAction a;
  for (int k = 0; k < 3; k++) {
    a.drag[k] = row[Row::DRAG] * row[Row::VELOCITY + k];
    a.force[k] = row[Row::LOAD + k] + a.drag[k];
  }
  return a;
}

/* ---------------------------------------------------------------------- */

FluidAction sphere_action(int i, double *const *fluid, const SphereArrays &spheres, const StepState &step)
{
  const double *row = fluid[i];
  if (step.still) return still_action(row);
  double kick[3] = {0., 0., 0.};
  if (step.random) step.random->force(i, row[Row::DRAG], kick);
  // -m_a dv/dt is in the force
  const double added = step.inertia ? step.inertia[i][InertiaRow::ADDED] / spheres.mass[i] : 0.;
  const int held = step.moving ? step.moving->held(spheres.groups[i]) : 0;
  FluidAction a;
  for (int k = 0; k < 3; k++) {
    a.force[k] = row[Row::FORCE + k] + row[Row::HYDRO + k];
    a.drag[k] = a.force[k] - row[Row::LOAD + k] - kick[k] + (held >> k & 1 ? 0. : added * spheres.f[i][k]);
  }
  return a;
}

/* ---------------------------------------------------------------------- */

void show_spheres(const std::vector<int> &list, double *const *fluid, const SphereArrays &spheres,
                  const StepState &step, double *const *shown)
{
  for (int i : list) {
    const FluidAction a = sphere_action(i, fluid, spheres, step);
    std::copy(a.force, a.force + 3, shown[i] + ShownRow::FORCE);
    std::copy(a.drag, a.drag + 3, shown[i] + ShownRow::DRAG);
    copy_fluid(fluid[i], shown[i]);
  }
}

/* ---------------------------------------------------------------------- */

void show_body_spheres(const std::vector<BodySphere> &list, const std::vector<FluidAction> &bodies,
                       double *const *fluid, double *const *v, bool still, double *const *shown)
{
  std::vector<FluidAction> rest = bodies;
  for (const BodySphere &s : list) {
    const double *row = fluid[s.atom];
    double *out = shown[s.atom];
    copy_fluid(row, out);
    for (int k = 0; k < 3; k++) {
      out[ShownRow::DRAG + k] = row[Row::DRAG] * (row[Row::VELOCITY + k] - (still ? 0. : v[s.atom][k]));
      out[ShownRow::FORCE + k] = row[Row::LOAD + k] + out[ShownRow::DRAG + k];
      rest[s.body].drag[k] -= out[ShownRow::DRAG + k];
      rest[s.body].force[k] -= out[ShownRow::FORCE + k];
    }
  }
  const std::vector<double> part = parts(list, bodies.size(), fluid);
  for (std::size_t n = 0; n < list.size(); n++)
    for (int k = 0; k < 3; k++) {
      shown[list[n].atom][ShownRow::DRAG + k] += part[n] * rest[list[n].body].drag[k];
      shown[list[n].atom][ShownRow::FORCE + k] += part[n] * rest[list[n].body].force[k];
    }
}

/* ---------------------------------------------------------------------- */

void show_bodies(const std::vector<BodySphere> &list, const std::vector<FluidAction> &bodies, double *const *fluid,
                 double *const *shown)
{
  for (std::size_t b = 0; b < bodies.size(); b++) {
    std::copy(bodies[b].force, bodies[b].force + 3, shown[b] + ShownBody::FORCE);
    std::copy(bodies[b].drag, bodies[b].drag + 3, shown[b] + ShownBody::DRAG);
    std::fill(shown[b] + ShownBody::VELOCITY, shown[b] + ShownBody::SIZE, 0.);
  }
  const std::vector<double> part = parts(list, bodies.size(), fluid);
  for (std::size_t n = 0; n < list.size(); n++) {
    double *out = shown[list[n].body];
    const double *row = fluid[list[n].atom];
    for (int k = 0; k < 3; k++) out[ShownBody::VELOCITY + k] += part[n] * row[Row::VELOCITY + k];
    out[ShownBody::FRACTION] += list[n].fraction * row[Row::FRACTION];
  }
}

}  // namespace clay
