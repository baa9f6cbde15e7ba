// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "body_rotation.h"

namespace LAMMPS_NS {

namespace {

typedef RotationBlock::Values Values;

/// q + h w q, brought to length 1, where w is a quaternion without scalar part.
inline void advance(const Values *q, const Values *w, double h, Values *out)
{
  const Values a = q[0] - h * (w[0] * q[1] + w[1] * q[2] + w[2] * q[3]);
  const Values b = q[1] + h * (q[0] * w[0] + w[1] * q[3] - w[2] * q[2]);
  const Values c = q[2] + h * (q[0] * w[1] + w[2] * q[1] - w[0] * q[3]);
  const Values d = q[3] + h * (q[0] * w[2] + w[0] * q[2] - w[1] * q[1]);
  const Values f = 1.0 / (a * a + b * b + c * c + d * d).sqrt();
  out[0] = f * a;
  out[1] = f * b;
  out[2] = f * c;
  out[3] = f * d;
}

/// Columns of the rotation matrix of q.
inline void axes_of(const Values *q, Values *e)
{
  const Values ss = q[0] * q[0], xx = q[1] * q[1], yy = q[2] * q[2], zz = q[3] * q[3];
  const Values xy = q[1] * q[2], xz = q[1] * q[3], yz = q[2] * q[3];
  const Values sx = q[0] * q[1], sy = q[0] * q[2], sz = q[0] * q[3];
  e[0] = ss + xx - yy - zz;
  e[1] = 2.0 * (xy + sz);
  e[2] = 2.0 * (xz - sy);
  e[3] = 2.0 * (xy - sz);
  e[4] = ss - xx + yy - zz;
  e[5] = 2.0 * (yz + sx);
  e[6] = 2.0 * (xz + sy);
  e[7] = 2.0 * (yz - sx);
  e[8] = ss - xx - yy + zz;
}

/// Spin of angular momentum L about the axes e; f is 1/I.
inline void spin_of(const Values *L, const Values *e, const Values *f, Values *w)
{
  const Values a = f[0] * (L[0] * e[0] + L[1] * e[1] + L[2] * e[2]);
  const Values b = f[1] * (L[0] * e[3] + L[1] * e[4] + L[2] * e[5]);
  const Values c = f[2] * (L[0] * e[6] + L[1] * e[7] + L[2] * e[8]);
  for (int k = 0; k < 3; k++) w[k] = a * e[k] + b * e[k + 3] + c * e[k + 6];
}

}  // namespace

void RotationBlock::turn(double dt)
{
  Values inverse[3], whole[4], half[4];
  for (int k = 0; k < 3; k++) inverse[k] = (inertia[k] != 0.0).select(inertia[k].inverse(), 0.0);

  spin_of(L, axes, inverse, w);
  advance(q, w, 0.5 * dt, whole);
  advance(q, w, 0.25 * dt, half);
  axes_of(half, axes);
  spin_of(L, axes, inverse, w);
  advance(half, w, 0.25 * dt, half);

  for (int k = 0; k < 4; k++) q[k] = 2.0 * half[k] - whole[k];
  const Values f = 1.0 / (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]).sqrt();
  for (int k = 0; k < 4; k++) q[k] *= f;
  axes_of(q, axes);
}

}  // namespace LAMMPS_NS
