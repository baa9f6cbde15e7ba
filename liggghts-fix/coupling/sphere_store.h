// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file sphere_store.h
/// Arrays of spheres for unit tests, as a host has them.
#pragma once

#include <vector>

#include "coupling/sphere_forces.h"

/// n rows of doubles, all zero.
class RowStore {
 public:
  RowStore(int n, int size) : size_(size), all_(n * size, 0.) { point(); }
  RowStore(const RowStore &o) : size_(o.size_), all_(o.all_) { point(); }
  RowStore &operator=(const RowStore &) = delete;
  double *operator[](int i) { return rows_[i]; }
  double *const *rows() const { return rows_.data(); }

 private:
  void point()
  {
    for (std::size_t i = 0; i < all_.size(); i += size_) rows_.push_back(&all_[i]);
  }
  int size_;
  std::vector<double> all_;
  std::vector<double *> rows_;
};

/// n spheres of radius and mass 1 at the origin, at rest, with tags 1 to n; of the
/// fluid they know nothing.
struct SphereStore {
  explicit SphereStore(int n) :
    x(n, 3), v(n, 3), omega(n, 3), f(n, 3), torque(n, 3), fluid(n, clay::FluidRow::SIZE),
    inertia(n, clay::InertiaRow::SIZE), radius(n, 1.), mass(n, 1.), tag(n), mask(n, 1)
  {
    for (int i = 0; i < n; i++) {
      tag[i] = i + 1;
      fluid[i][clay::FluidRow::SLOT] = -1;
      fluid[i][clay::FluidRow::RELAX] = 1.;
    }
  }

  clay::SphereArrays arrays() const
  {
    clay::SphereArrays a;
    a.x = x.rows();
    a.v = v.rows();
    a.omega = omega.rows();
    a.f = f.rows();
    a.torque = torque.rows();
    a.radius = radius.data();
    a.mass = mass.data();
    a.tag = tag.data();
    a.groups = mask.data();
    a.gravity = &gravity;
    return a;
  }

  RowStore x, v, omega, f, torque, fluid, inertia;
  std::vector<double> radius, mass;
  std::vector<int> tag, mask;
  clay::GroupGravity gravity;
};
