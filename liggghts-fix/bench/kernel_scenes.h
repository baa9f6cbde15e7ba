// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file kernel_scenes.h
/// What the kernels are measured on: the same numbers on every machine.
#ifndef CLAY_KERNEL_SCENES_H
#define CLAY_KERNEL_SCENES_H

#include <vector>

#include "contacts/contact_kernel.h"
#include "coulomb/coul_kernel.h"
#include "exchange/packing.h"

namespace clay {

/// Spheres on a lattice a little closer than they are wide: every pair touches. Linear springs
/// with friction, or Hertz's; with rolling friction and cohesion.
struct ContactScene {
  std::vector<double> x, v, omega, f, torque;
  ContactPairs pairs;

  explicit ContactScene(int side, NormalForce normal = NormalForce::linear, bool rolling = false)
  {
    pairs.kind.normal = normal;
    pairs.kind.rolling = rolling ? RollingTorque::sprung : RollingTorque::none;
    pairs.kind.cohesion = rolling;
    const double r = 1e-3;
    const double shear[6] = {1e-8, 2e-8, -1e-8, 1e-9, 1e-9, 1e-9};
    ContactLaw law = {750, 750, 0.01, 0.01, 0.5};
    if (normal == NormalForce::hertz) law = hertzLaw(0.5 * r, 5e-6, 3e6, 7e5, -0.3);
    law.friction = 0.5;
    law.rolling = 0.1;
    law.radius = 0.5 * r;
    law.cohesion = 1000;
    const auto at = [side](int i, int j, int k) { return (i * side + j) * side + k; };
    for (int i = 0; i < side; i++)
      for (int j = 0; j < side; j++)
        for (int k = 0; k < side; k++) {
          const int n = at(i, j, k);
          for (int c : {i, j, k}) x.push_back(1.99 * r * c + 1e-6 * (n % 7));
          for (int c = 0; c < 3; c++) {
            v.push_back(1e-3 * ((n + c) % 5 - 2));
            omega.push_back(0.1 * ((n + c) % 3 - 1));
          }
          if (i) pairs.add(n, at(i - 1, j, k), r, r, law, shear, true);
          if (j) pairs.add(n, at(i, j - 1, k), r, r, law, shear, true);
          if (k) pairs.add(n, at(i, j, k - 1), r, r, law, shear, true);
        }
    f.assign(x.size(), 0.0);
    torque.assign(x.size(), 0.0);
  }

  void step()
  {
    const ContactSpheres s = {x.data(), v.data(),      omega.data(),
                              f.data(), torque.data(), static_cast<int>(x.size() / 3)};
    contactForces(s, pairs, 1e-5, true);
  }
};

/// Clumps of 14 charged spheres on a lattice.
struct CoulombScene {
  ChargeGroups groups;
  CoulombLaw law;

  explicit CoulombScene(int side)
  {
    law.cutoff = 0.012;
    for (int b = 0; b < side * side * side; b++) {
      const int layer = b / side / side;
      const double c[3] = {8e-3 * (b % side), 8e-3 * (b / side % side), 8e-3 * layer};
      for (int s = 0; s < 14; s++)
        groups.add(c[0] + 1e-3 * (s % 4), c[1] + 1e-3 * (s / 4 % 4), c[2] + 1e-3 * (s % 2), s % 2 ? 4e-10 : -4e-10);
      groups.close(b, true);
    }
  }

  void step() { groups.act(law); }
};

/// The same clumps with radii and potentials.
struct DlvoScene {
  ChargeGroups groups;
  DlvoLaw law;

  explicit DlvoScene(int side, double gap = 4e-3)
  {
    law.permittivity = 6.94e-10;
    law.debye = 3e-4;
    law.hamaker = 1e-14;
    law.contact = 2e-5;
    law.gap = gap;
    law.cutoff = 2e-3 + law.gap;  // clumps lie 5 mm apart
    groups = CoulombScene(side).groups;
    for (double& q : groups.q) q = q > 0 ? 0.02 : -0.05;
    groups.radius.assign(groups.q.size(), 1e-3);
  }

  void step() { groups.act(law); }
};

/// A message of particles taken in, and their answers packed.
struct PackingScene {
  FieldSet in{Field::position, Field::radius, Field::volume, Field::velocity, Field::tag, Field::impulse, Field::mass};
  FieldSet out{Field::dragCoefficient, Field::fluidVelocity, Field::force};
  int count;
  std::vector<double> state, message;
  Particles particles{in}, answers{out};
  std::vector<char> owned;

  explicit PackingScene(int n) :
    count(n), state(static_cast<std::size_t>(n * in.width()), 1.5), owned(static_cast<std::size_t>(n), 1)
  {
    particles.resize(n);
    answers.resize(n);
  }

  void step()
  {
    unpackFields(state.data(), in, count, particles, 0);
    packAnswers(answers, owned, out, 0, count, 2, message);
  }
};

}  // namespace clay

#endif
