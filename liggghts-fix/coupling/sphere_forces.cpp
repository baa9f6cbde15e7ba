// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/sphere_forces.h"

#include <cmath>

#include "clumps/body_drag.h"

namespace clay {

using LAMMPS_NS::sphere_drag;
using LAMMPS_NS::sphere_force;
using Row = FluidRow;

// a component of what the fluid gives a sphere, and its impulse since the step before
static inline void book(double *s, int k, double given, double dt, bool first, double *all)
{
  if (!first) {
    const double impulse = 0.5 * dt * (s[Row::FORCE + k] + given);
    s[Row::IMPULSE + k] += impulse;
    all[k] += impulse;
  }
  s[Row::FORCE + k] = given;
}

/* ---------------------------------------------------------------------- */

void push_spheres(const std::vector<int> &list, double *const *fluid, const SphereArrays &spheres,
                  const RandomForce *random, double dt, bool first, double *all)
{
  double *const *v = spheres.v;
  double *const *f = spheres.f;
  for (int i : list) {
    double *s = fluid[i], kick[3] = {0., 0., 0.};
    if (random) random->force(i, s[Row::DRAG], kick);
    // sphere_drag(), its factor being the same in all steps of an answer
    const double drag = s[Row::RELAX] * s[Row::DRAG], rest = s[Row::RELAX] - 1.0;
    for (int k = 0; k < 3; k++) {
      const double load = s[Row::LOAD + k] + kick[k];
      const double force = load + (drag * (s[Row::VELOCITY + k] - v[i][k]) + rest * (f[i][k] + load));
      book(s, k, force - s[Row::HYDRO + k], dt, first, all);
      f[i][k] += force;
    }
  }
}

/* ---------------------------------------------------------------------- */

void push_held_spheres(const std::vector<int> &list, double *const *fluid, double *const *inertia,
                       const SphereArrays &spheres, const MovingGroups &moving, const AxisGroups &mute,
                       const RandomForce *random, double dt, bool first, double *all)
{
  for (int i : list) {
    double *s = fluid[i], kick[3] = {0., 0., 0.};
    const int held = moving.held(spheres.groups[i]), muted = mute.axes(spheres.groups[i]);
    const double added = inertia ? inertia[i][InertiaRow::ADDED] : 0.;
    if (random) random->force(i, s[Row::DRAG], kick);
    for (int k = 0; k < 3; k++) {
      const double load = s[Row::LOAD + k] + kick[k], v = spheres.v[i][k];
      const double force = held >> k & 1
          ? load + s[Row::DRAG] * (s[Row::VELOCITY + k] - v)
          : sphere_force(s[Row::DRAG], s[Row::VELOCITY + k], v, load, spheres.f[i][k], spheres.mass[i], added, dt);
      book(s, k, force - s[Row::HYDRO + k], dt, first, all);
      if (!(muted >> k & 1)) spheres.f[i][k] += force;
    }
  }
}

/* ---------------------------------------------------------------------- */

void push_inertial_spheres(const std::vector<int> &list, double *const *fluid, double *const *inertia,
                           const SphereArrays &spheres, const RandomForce *random, double dt, bool first, double *all)
{
  for (int i : list) {
    double *s = fluid[i], *v = spheres.v[i], *f = spheres.f[i], kick[3] = {0., 0., 0.};
    if (random) random->force(i, s[Row::DRAG], kick);
    for (int k = 0; k < 3; k++) {
      const double force = sphere_force(s[Row::DRAG], s[Row::VELOCITY + k], v[k], s[Row::LOAD + k] + kick[k], f[k],
                                        spheres.mass[i], inertia[i][InertiaRow::ADDED], dt);
      book(s, k, force - s[Row::HYDRO + k], dt, first, all);
      f[k] += force;
    }
    if (inertia[i][InertiaRow::TURN] > 0.) turn_sphere(i, inertia, spheres, random, dt);
  }
}

/* ---------------------------------------------------------------------- */

void turn_sphere(int i, double *const *inertia, const SphereArrays &spheres, const RandomForce *random, double dt)
{
  const double r = spheres.radius[i], own = 0.4 * spheres.mass[i] * r * r;
  const double *row = inertia[i];
  double kick[3] = {0., 0., 0.};
  if (random) random->couple(i, row[InertiaRow::TURN], kick);
  for (int k = 0; k < 3; k++) {
    const double other = spheres.torque[i][k] + kick[k];
    spheres.torque[i][k] =
        other + sphere_drag(row[InertiaRow::TURN], row[InertiaRow::SPIN + k], spheres.omega[i][k], other, own, dt);
  }
}

/* ---------------------------------------------------------------------- */

void still_force(const double *row, double *force)
{
  for (int k = 0; k < 3; k++)
    force[k] = row[Row::LOAD + k] - row[Row::HYDRO + k] + row[Row::DRAG] * row[Row::VELOCITY + k];
}

/* ---------------------------------------------------------------------- */

void StillForces::mark(const std::vector<StillSphere> &spheres)
{
  marked_.resize(3 * spheres.size());
  for (std::size_t n = 0; n < spheres.size(); n++) still_force(spheres[n].row, &marked_[3 * n]);
}

bool StillForces::changed(const std::vector<StillSphere> &spheres, double limit) const
{
  if (marked_.size() != 3 * spheres.size()) return true;
  for (std::size_t n = 0; n < spheres.size(); n++) {
    double force[3], d2 = 0.;
    still_force(spheres[n].row, force);
    for (int k = 0; k < 3; k++) d2 += std::pow(force[k] - marked_[3 * n + k], 2);
    const double most = limit * spheres[n].mass;
    if (d2 > most * most) return true;
  }
  return false;
}

}  // namespace clay
