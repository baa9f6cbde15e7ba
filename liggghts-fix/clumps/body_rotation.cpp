// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "clumps/body_rotation.h"

#include <algorithm>
#include <cstring>

#include "simd/clones.h"
#include "simd/inv_sqrt.h"

namespace LAMMPS_NS {

namespace {

typedef RotationBlock::Values Values;

struct Vector {
  Values x, y, z;
};
struct Quaternion {
  Values s, x, y, z;
};
struct Axes {
  Vector x, y, z;
};

/// Brings q to length 1.
CLAY_INLINE void norm(Quaternion &q)
{
  Values f = q.s * q.s + q.x * q.x + q.y * q.y + q.z * q.z;
#pragma omp simd simdlen(8)
  for (int i = 0; i < RotationBlock::SIZE; i++) f[i] = clay::invSqrt(f[i]);
  q.s *= f;
  q.x *= f;
  q.y *= f;
  q.z *= f;
}

/// q + h w q, where w is a quaternion without scalar part.
CLAY_INLINE void advance(const Quaternion &q, const Vector &w, double h, Quaternion &to)
{
  to.s = q.s - h * (w.x * q.x + w.y * q.y + w.z * q.z);
  to.x = q.x + h * (q.s * w.x + w.y * q.z - w.z * q.y);
  to.y = q.y + h * (q.s * w.y + w.z * q.x - w.x * q.z);
  to.z = q.z + h * (q.s * w.z + w.x * q.y - w.y * q.x);
  norm(to);
}

/// Columns of the rotation matrix of q.
CLAY_INLINE void axes_of(const Quaternion &q, Axes &e)
{
  const Values ss = q.s * q.s, xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z;
  const Values xy = q.x * q.y, xz = q.x * q.z, yz = q.y * q.z;
  const Values sx = q.s * q.x, sy = q.s * q.y, sz = q.s * q.z;
  e.x.x = ss + xx - yy - zz;
  e.x.y = 2.0 * (xy + sz);
  e.x.z = 2.0 * (xz - sy);
  e.y.x = 2.0 * (xy - sz);
  e.y.y = ss - xx + yy - zz;
  e.y.z = 2.0 * (yz + sx);
  e.z.x = 2.0 * (xz + sy);
  e.z.y = 2.0 * (yz - sx);
  e.z.z = ss - xx - yy + zz;
}

/// L along e, over the moment of inertia of which f is the inverse.
CLAY_INLINE void about(const Vector &L, const Vector &e, const Values &f, Values &to)
{
  to = f * (L.x * e.x + L.y * e.y + L.z * e.z);
}

/// Spin of angular momentum L about the axes e; f is 1/I.
CLAY_INLINE void spin_of(const Vector &L, const Axes &e, const Vector &f, Vector &w)
{
  Values a, b, c;
  about(L, e.x, f.x, a);
  about(L, e.y, f.y, b);
  about(L, e.z, f.z, c);
  w.x = a * e.x.x + b * e.y.x + c * e.z.x;
  w.y = a * e.x.y + b * e.y.y + c * e.z.y;
  w.z = a * e.x.z + b * e.y.z + c * e.z.z;
}

CLAY_INLINE void turn_all(RotationBlock &b, double dt)
{
  const Values none = {};
  Vector inverse, w;
  inverse.x = b.inertia[0] != 0.0 ? 1.0 / b.inertia[0] : none;
  inverse.y = b.inertia[1] != 0.0 ? 1.0 / b.inertia[1] : none;
  inverse.z = b.inertia[2] != 0.0 ? 1.0 / b.inertia[2] : none;
  const Vector L = {b.L[0], b.L[1], b.L[2]};
  Quaternion q = {b.q[0], b.q[1], b.q[2], b.q[3]}, whole, half, end;
  Axes e = {{b.axes[0], b.axes[1], b.axes[2]}, {b.axes[3], b.axes[4], b.axes[5]}, {b.axes[6], b.axes[7], b.axes[8]}};

  spin_of(L, e, inverse, w);
  advance(q, w, 0.5 * dt, whole);
  advance(q, w, 0.25 * dt, half);
  axes_of(half, e);
  spin_of(L, e, inverse, w);
  advance(half, w, 0.25 * dt, end);

  end.s = 2.0 * end.s - whole.s;
  end.x = 2.0 * end.x - whole.x;
  end.y = 2.0 * end.y - whole.y;
  end.z = 2.0 * end.z - whole.z;
  norm(end);
  axes_of(end, e);
  std::memcpy(b.q, &end, sizeof end);
  std::memcpy(b.axes, &e, sizeof e);
  std::memcpy(b.w, &w, sizeof w);
}

CLAY_CLONES void turn_block(RotationBlock &b, double dt) { turn_all(b, dt); }

/// N numbers of each of SIZE bodies, from or into N rows.
template <int N>
CLAY_INLINE void take(const double *from, Values *rows)
{
  double a[N][RotationBlock::SIZE];
#pragma omp simd simdlen(8)
  for (int i = 0; i < RotationBlock::SIZE; i++)
    for (int k = 0; k < N; k++) a[k][i] = from[N * i + k];
  std::memcpy(rows, a, sizeof a);
}

template <int N>
CLAY_INLINE void give(const Values *rows, double *to)
{
  double a[N][RotationBlock::SIZE];
  std::memcpy(a, rows, sizeof a);
#pragma omp simd simdlen(8)
  for (int i = 0; i < RotationBlock::SIZE; i++)
    for (int k = 0; k < N; k++) to[N * i + k] = a[k][i];
}

CLAY_CLONES void turn_eight(const Bodies &b, double dt)
{
  RotationBlock block;
  take<4>(b.q, block.q);
  take<3>(b.L, block.L);
  take<3>(b.inertia, block.inertia);
  take<3>(b.ex, block.axes);
  take<3>(b.ey, block.axes + 3);
  take<3>(b.ez, block.axes + 6);
  turn_all(block, dt);
  give<4>(block.q, b.q);
  give<3>(block.axes, b.ex);
  give<3>(block.axes + 3, b.ey);
  give<3>(block.axes + 6, b.ez);
  give<3>(block.w, b.w);
}

}  // namespace

void RotationBlock::turn(double dt) { turn_block(*this, dt); }

void turn_bodies(const Bodies &all, int begin, int end, double dt)
{
  enum { SIZE = RotationBlock::SIZE };
  const Bodies b = {all.q + 4 * begin, all.ex + 3 * begin, all.ey + 3 * begin,     all.ez + 3 * begin,
                    all.w + 3 * begin, all.L + 3 * begin,  all.inertia + 3 * begin};
  const int n = end - begin;
  if (n >= SIZE) {
    turn_eight(b, dt);
    if (n > SIZE) turn_bodies(all, begin + SIZE, end, dt);
  } else if (n > 0) {
    // too few: with places that stand for none
    double q[4 * SIZE] = {}, ex[3 * SIZE] = {}, ey[3 * SIZE] = {}, ez[3 * SIZE] = {}, w[3 * SIZE], L[3 * SIZE] = {},
                 inertia[3 * SIZE] = {};
    for (int i = n; i < SIZE; i++) q[4 * i] = ex[3 * i] = ey[3 * i + 1] = ez[3 * i + 2] = 1;
    std::copy(b.q, b.q + 4 * n, q);
    std::copy(b.ex, b.ex + 3 * n, ex);
    std::copy(b.ey, b.ey + 3 * n, ey);
    std::copy(b.ez, b.ez + 3 * n, ez);
    std::copy(b.L, b.L + 3 * n, L);
    std::copy(b.inertia, b.inertia + 3 * n, inertia);
    turn_eight({q, ex, ey, ez, w, L, inertia}, dt);
    std::copy(q, q + 4 * n, b.q);
    std::copy(ex, ex + 3 * n, b.ex);
    std::copy(ey, ey + 3 * n, b.ey);
    std::copy(ez, ez + 3 * n, b.ez);
    std::copy(w, w + 3 * n, b.w);
  }
}

}  // namespace LAMMPS_NS
