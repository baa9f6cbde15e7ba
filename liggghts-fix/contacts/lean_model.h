// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file lean_model.h
/// What the lean styles can do of LIGGGHTS's contact models: hooke/stiffness or
/// hooke with tangential history, and their switches.
#pragma once

#include <string>

namespace clay {

class LeanModel {
 public:
  bool modulus() const { return modulus_; }  ///< hooke: stiffness from Young's modulus
  bool tangentialDamping = true, absoluteDamping = false, limitForce = false;
  bool softer = false;  ///< ktToKnUser: tangential stiffness 2/7 of the normal one

  /// Takes a model or a switch with its value; false when it is neither. Throws
  /// std::invalid_argument when it is one, but not with a value that the lean styles can do.
  bool take(const std::string& name, const std::string& value);

  /// Throws std::invalid_argument when a model that must be named was not.
  void complete() const;

 private:
  bool modulus_ = false, model_ = false, tangential_ = false;
};

}  // namespace clay
