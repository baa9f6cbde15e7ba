// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "clumps/body_spheres.h"

#include <algorithm>
#include <cstring>

#include "simd/clones.h"

namespace LAMMPS_NS {

namespace {

// x, y, z of something, worked on at once, and a fourth number that says nothing
typedef double Vector __attribute__((vector_size(32)));
typedef double Two __attribute__((vector_size(16)));

CLAY_INLINE void get(const double *p, Vector &a) { a = Vector{p[0], p[1], p[2], p[2]}; }

CLAY_INLINE void put(double *p, const Vector &a)
{
  const Two xy = {a[0], a[1]};
  std::memcpy(p, &xy, sizeof xy);
  p[2] = a[2];
}

// y, z, x
CLAY_INLINE void next(const Vector &a, Vector &to)
{
  typedef long long Places __attribute__((vector_size(32)));
  to = __builtin_shuffle(a, Places{1, 2, 0, 3});
}

// a x b
CLAY_INLINE void cross(const Vector &a, const Vector &b, Vector &to)
{
  Vector a2, b2;
  next(a, a2);
  next(b, b2);
  next(a * b2 - a2 * b, to);
}

struct Axes {
  Vector x, y, z;
};

CLAY_INLINE void combine(const Axes &e, const double *d, Vector &to) { to = e.x * d[0] + e.y * d[1] + e.z * d[2]; }

CLAY_CLONES void turn_spheres(const double *const *axes, const double *d, double *r, int n)
{
  Axes e;
  get(axes[0], e.x);
  get(axes[1], e.y);
  get(axes[2], e.z);
  for (int k = 0; k < n; k++) {
    Vector a;
    combine(e, d + 3 * k, a);
    std::memcpy(r + 4 * k, &a, sizeof a);
  }
}

CLAY_CLONES void place_spheres(const double *const *axes, const double *centre, const double *speed, const double *spin,
                               const double *d, double *r, const int *atom, int n, double *x, double *v, double *omega)
{
  Axes e, moved;  // moved: how fast a sphere at the end of each axis turns
  Vector c, u, w;
  get(axes[0], e.x);
  get(axes[1], e.y);
  get(axes[2], e.z);
  get(centre, c);
  get(speed, u);
  get(spin, w);
  cross(w, e.x, moved.x);
  cross(w, e.y, moved.y);
  cross(w, e.z, moved.z);
  for (int k = 0; k < n; k++) {
    const std::size_t i = 3 * static_cast<std::size_t>(atom[k]);
    Vector a, b;
    combine(e, d + 3 * k, a);
    combine(moved, d + 3 * k, b);
    std::memcpy(r + 4 * k, &a, sizeof a);
    put(x + i, a + c);
    put(v + i, b + u);
    put(omega + i, w);
  }
}

CLAY_CLONES void move_spheres(const double *speed, const double *spin, const double *r, const int *atom, int n,
                              double *v, double *omega)
{
  Vector u, w;
  get(speed, u);
  get(spin, w);
  for (int k = 0; k < n; k++) {
    const std::size_t i = 3 * static_cast<std::size_t>(atom[k]);
    Vector a, b;
    std::memcpy(&a, r + 4 * k, sizeof a);
    cross(w, a, b);
    put(v + i, b + u);
    put(omega + i, w);
  }
}

CLAY_CLONES void sum_spheres(const double *r, const int *atom, int n, const double *f, const double *torque,
                             double *force, double *couple)
{
  Vector F, T, plus = {}, minus = {};  // the moments' two parts, in the order z, x, y
  get(force, F);
  get(couple, T);
  for (int k = 0; k < n; k++) {
    const std::size_t i = 3 * static_cast<std::size_t>(atom[k]);
    Vector a, a2, p, p2, t;
    std::memcpy(&a, r + 4 * k, sizeof a);
    get(f + i, p);
    get(torque + i, t);
    next(a, a2);
    next(p, p2);
    F += p;
    T += t;
    plus += a * p2;
    minus += a2 * p;
  }
  Vector moment;
  next(plus - minus, moment);
  put(force, F);
  put(couple, T + moment);
}

}  // namespace

void BodySpheres::clear(int nbody)
{
  added_.clear();
  first_.assign(nbody + 1, 0);
  counted_.assign(nbody, 0);
  shifted_.assign(nbody, 0);
}

void BodySpheres::add(int b, int atom, const double *d, bool counts, bool shifted)
{
  added_.push_back({b, atom, {d[0], d[1], d[2]}, counts, shifted});
  first_[b + 1]++;
  if (counts) counted_[b]++;
  if (shifted) shifted_[b] = 1;
}

void BodySpheres::sort()
{
  const int nbody = bodies();
  for (int b = 0; b < nbody; b++) first_[b + 1] += first_[b];
  std::vector<int> next(first_.begin(), first_.end() - 1), image(nbody);
  for (int b = 0; b < nbody; b++) image[b] = counted_[b] += first_[b];

  atom_.resize(added_.size());
  d_.resize(3 * added_.size());
  r_.resize(4 * added_.size());
  for (const Added &a : added_) {
    const int n = a.counts ? next[a.body]++ : image[a.body]++;
    atom_[n] = a.atom;
    std::copy(a.d, a.d + 3, &d_[3 * n]);
  }
}

void BodySpheres::turn(int b, const double *ex, const double *ey, const double *ez)
{
  const double *const axes[3] = {ex, ey, ez};
  turn_spheres(axes, &d_[3 * begin(b)], &r_[4 * begin(b)], end(b) - begin(b));
}

void BodySpheres::gather(int b, const double *f, const double *torque, double *force, double *couple) const
{
  sum_spheres(&r_[4 * begin(b)], &atom_[begin(b)], counted(b) - begin(b), f, torque, force, couple);
}

void BodySpheres::set_velocity(int b, const double *v_, const double *w_, double *v, double *omega) const
{
  move_spheres(v_, w_, &r_[4 * begin(b)], &atom_[begin(b)], end(b) - begin(b), v, omega);
}

void BodySpheres::place(int b, const double *ex, const double *ey, const double *ez, const double *centre,
                        const double *v_, const double *w_, double *x, double *v, double *omega)
{
  const double *const axes[3] = {ex, ey, ez};
  place_spheres(axes, centre, v_, w_, &d_[3 * begin(b)], &r_[4 * begin(b)], &atom_[begin(b)], end(b) - begin(b), x, v,
                omega);
}

}  // namespace LAMMPS_NS
