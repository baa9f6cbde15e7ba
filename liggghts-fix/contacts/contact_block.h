// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file contact_block.h
/// Within the contact kernel: a block of pairs and what acts in it.
#pragma once

#include "contacts/contact_kernel.h"

namespace clay {

/// Of i against j: distance and velocity; the spin of both; then the force on i and the
/// torques on both, and what rolling friction needs to know of the contact.
struct ContactBlock {
  double x[3][CONTACT_BLOCK], v[3][CONTACT_BLOCK], wi[3][CONTACT_BLOCK], wj[3][CONTACT_BLOCK];
  double f[3][CONTACT_BLOCK], ti[3][CONTACT_BLOCK], tj[3][CONTACT_BLOCK];
  double n[3][CONTACT_BLOCK];                          // from j to i
  double elastic[CONTACT_BLOCK];                       // elastic part of the normal force [N], 0 without a contact
  double grip[CONTACT_BLOCK];                          // size of the normal force that friction goes by [N]; then -1
  double kt[CONTACT_BLOCK], level[CONTACT_BLOCK];      // tangential stiffness [N/m]; arm of i over the distance
  double s[6][CONTACT_BLOCK], touched[CONTACT_BLOCK];  // at walls
};

/// The arrays of one block of pairs.
struct ContactSlice {
  const int *i, *j;
  const double *ri, *rj, *kn, *kt, *gamman, *gammat, *friction, *softness;
  const double *reach, *rolling, *cohesion;
  double *sx, *sy, *sz, *qx, *qy, *qz, *touched;
};

/// What is the same for all pairs of a step.
struct ContactStep {
  double dt = 0;      ///< by which displacements grow [s]; 0 when they stay
  double roll = 0;    ///< by which rolling torques grow [s], kept or not
  double fresh = 0;   ///< 1 when the history is kept anew, or else 0
  double least = 0;   ///< the least normal force [N]
  double reduce = 0;  ///< 1 when friction goes by the normal force with its cohesion
  double still = 0;   ///< 1 when spin about the normal has no rolling friction
  bool wall = false;
};

typedef void (*ContactAct)(ContactBlock &, const ContactSlice &, const ContactStep &, int n);

/// Forces and torques without rolling friction, of so many pairs.
ContactAct contactAct(const ContactKind &kind);

/// Adds rolling friction to the torques; null without.
ContactAct rollingAct(const ContactKind &kind);

}  // namespace clay
