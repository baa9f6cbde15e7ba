// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file lean_model.h
/// What the lean styles can do of LIGGGHTS's contact models, and their switches.
#pragma once

#include <string>
#include <vector>

#include "contacts/contact_kernel.h"

namespace clay {

/// Whether a script wants the lean loops: it must have them, may, or never.
enum class LeanUse { must, may, never };

/// Takes `lean yes|no|auto` out of a style's words; `may` without. Throws
/// std::invalid_argument for another value.
LeanUse takeLeanUse(std::vector<char*>& words);

class LeanModel {
 public:
  LeanModel() { kind.tangential = TangentialForce::none; }

  /// hooke or hertz: stiffness from Young's modulus, damping from the restitution.
  bool modulus() const { return name_ == "hooke" || name_ == "hertz"; }
  const std::string& name() const { return name_; }  ///< of the normal model
  const std::string& tangential() const { return tangential_; }
  std::string text() const;  ///< the models, as a script says them

  bool tangentialDamping = true, absoluteDamping = false;
  bool softer = false;  ///< ktToKnUser: tangential stiffness 2/7 of the normal one
  ContactKind kind;     ///< with its other switches

  /// Takes a model or a switch with its value; false when it is neither. Throws
  /// std::invalid_argument when it is one, but not with a value that the lean styles can do.
  bool take(const std::string& name, const std::string& value);

  /// Throws std::invalid_argument when a model that must be named was not, or a switch was
  /// that the models do not have.
  void complete() const;

 private:
  std::string name_, tangential_ = "off", rolling_ = "off", cohesion_ = "off";
};

}  // namespace clay
