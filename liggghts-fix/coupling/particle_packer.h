// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file particle_packer.h
/// Spheres into a message to the CFD half, and its answer back into their rows.
///
/// A message holds the free spheres first, then the spheres of the bodies owned here.
#pragma once

#include <array>
#include <vector>

#include "clumps/body_resistance.h"
#include "clumps/body_spheres.h"
#include "coupling/moving_groups.h"
#include "coupling/sphere_forces.h"
#include "exchange/fields.h"

namespace clay {

using LAMMPS_NS::BodySphere;

/// What is told of a body.
struct BodyState {
  double volume = 0, mass = 0;  ///< [m3, kg]
  double tag = 0;
  std::array<double, 3> impulse{};  ///< received since the last exchange [N s]
};

/// Puts the listed spheres into the message, numbers them in their rows, and takes
/// their impulses out of these. Spheres that are kept `still` have no velocity.
/// The message must be large enough.
void pack_free(const std::vector<int> &list, const SphereArrays &spheres, double *const *fluid, bool still,
               Particles &message);

/// Impulse [N s] of each sphere of a body, three numbers a sphere: what its own drag
/// and load gave it in `time` [s], and its part by drag coefficient (by volume where
/// there is no drag) of what is left of the body's impulse, which they add up to.
std::vector<double> share_impulses(const std::vector<BodySphere> &spheres, const std::vector<BodyState> &bodies,
                                   double *const *fluid, double *const *v, bool still, double time);

/// Puts the bodies' spheres into the message from place `first` on.
void pack_bodies(const std::vector<BodySphere> &list, const std::vector<BodyState> &bodies,
                 const std::vector<double> &impulses, const SphereArrays &spheres, bool still, int first,
                 Particles &message);

/// The first particle of a message whose place or velocity is not finite, -1 for none.
int first_astray(const Particles &message);

/// What the hydrostatic pressure of a fluid of density rho [kg/m3] has in the answers, 0
/// when it is not in them; gravity [m/s2] where the message does not tell each sphere's.
struct Hydrostatics {
  double rho = 0;
  std::array<double, 3> gravity{};
};

/// Keeps in a sphere's row what was answered to `sent` at `slot`. Without drag there is no fluid.
void unpack(const Particles &answer, const Particles &sent, const Hydrostatics &still, int slot, double *row);

/// The same for the first n spheres so far as they have a slot, with the factors of
/// a step dt [s]. inertia may be null where the answer has neither added mass nor
/// torque; what does not move does not accelerate.
void unpack_free(const Particles &answer, const Particles &sent, const Hydrostatics &still, int n, const double *mass,
                 const int *mask, const MovingGroups &moving, double dt, double *const *fluid, double *const *inertia);

/// Keeps the answers from place `first` on in the rows of the bodies' spheres, and
/// sums them up for each body; Flow is BodyDrag or BodyFlow.
template <class Flow>
std::vector<Flow> unpack_bodies(const Particles &answer, const Particles &sent, const Hydrostatics &still, int first,
                                const std::vector<BodySphere> &list, int bodies, double *const *fluid)
{
  std::vector<Flow> sums(bodies);
  const bool weighted = answer.fields().has(Field::addedMass);
  int slot = first;
  for (const BodySphere &s : list) {
    double *row = fluid[s.atom];
    unpack(answer, sent, still, slot, row);
    sums[s.body].add_sphere(s.r, row[FluidRow::DRAG], row + FluidRow::VELOCITY, row + FluidRow::LOAD);
    if (weighted) sums[s.body].add_mass(s.r, answer[Field::addedMass][slot]);
    slot++;
  }
  return sums;
}

}  // namespace clay
