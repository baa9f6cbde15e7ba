// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file body_rotation.h
/// Rotation of rigid bodies: spin from angular momentum, orientation from spin.
#ifndef LMP_BODY_ROTATION_H
#define LMP_BODY_ROTATION_H

namespace LAMMPS_NS {

/// Some bodies that are turned together, one in each place of the arrays, so that
/// the machine does several at a time.
struct RotationBlock {
  enum { SIZE = 8 };
  typedef double Values __attribute__((vector_size(8 * SIZE)));
  Values q[4];        ///< orientation (s, x, y, z), of length 1
  Values L[3];        ///< angular momentum [kg m2/s], space axes
  Values inertia[3];  ///< principal moments [kg m2]
  Values axes[9];     ///< ex, ey, ez in space
  Values w[3];        ///< spin [1/s], space axes; from L and axes

  /// Turns all bodies over a step dt [s] with constant L, by Richardson's
  /// extrapolation of one whole step and two half ones. Axes and q become those
  /// at the end, w the spin at the middle. Unused places do no harm.
  void turn(double dt);
};

/// Bodies as a program keeps them: four numbers q a body, three of each other kind.
struct Bodies {
  double *q, *ex, *ey, *ez, *w;
  const double *L, *inertia;
};

/// RotationBlock::turn() for bodies begin to end-1.
void turn_bodies(const Bodies &bodies, int begin, int end, double dt);

/// Spin w [1/s] of angular momentum L, all in space axes; a principal moment of 0
/// stands for no rotation about that axis.
inline void spin(const double *L, const double *ex, const double *ey, const double *ez, const double *inertia,
                 double *w)
{
  const double *axes[3] = {ex, ey, ez};
  double sum[3] = {0., 0., 0.};
  for (int k = 0; k < 3; k++) {
    const double *e = axes[k], about = L[0] * e[0] + L[1] * e[1] + L[2] * e[2];
    const double s = inertia[k] != 0. ? about / inertia[k] : 0.;
    for (int j = 0; j < 3; j++) sum[j] += s * e[j];
  }
  for (int j = 0; j < 3; j++) w[j] = sum[j];
}

}  // namespace LAMMPS_NS

#endif
