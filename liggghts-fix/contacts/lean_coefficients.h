// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file lean_coefficients.h
/// A script's coefficients of the models that the lean styles can do, of pairs of
/// atom types, and the law of a contact that they make.
#ifndef LMP_LEAN_COEFFICIENTS_H
#define LMP_LEAN_COEFFICIENTS_H

#include "contacts/contact_kernel.h"
#include "contacts/lean_model.h"

class PropertyRegistry;

namespace LAMMPS_NS {

class LeanCoefficients {
 public:
  /// Asks for those of the model; `who` is named where the script lacks one.
  void connect(PropertyRegistry &registry, const clay::LeanModel &model, const char *who);

  /// Of atom types a and b; reduced radius [m] and mass [kg] of what touches, in
  /// the script's units, whose factor of pressure is nktv2p.
  clay::ContactLaw law(const clay::LeanModel &model, int a, int b, double radius, double mass, double nktv2p) const;

 private:
  double **kn_ = nullptr, **kt_ = nullptr, **gamman_ = nullptr, **gammat_ = nullptr, **friction_ = nullptr;
  double **modulus_ = nullptr, **restitution_log_ = nullptr, speed_ = 0.0;  // of model hooke
  double **rolling_ = nullptr, **cohesion_ = nullptr;
  double **shear_modulus_ = nullptr, **beta_ = nullptr;  // of model hertz
};

}

#endif
