// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "contacts/lean_model.h"

#include <stdexcept>

namespace clay {

bool LeanModel::take(const std::string& name, const std::string& value)
{
  bool can = false;
  if (name == "model") {
    modulus_ = value == "hooke";
    can = model_ = modulus_ || value == "hooke/stiffness";
  } else if (name == "tangential") can = tangential_ = value == "history";
  else if (name == "rolling_friction" || name == "cohesion") can = value == "off";
  else if (name == "surface") can = value == "default";
  else {
    bool* on = name == "tangential_damping" ? &tangentialDamping
        : name == "absolute_damping"        ? &absoluteDamping
        : name == "limitForce"              ? &limitForce
        : name == "ktToKnUser"              ? &softer
                                            : nullptr;
    if (!on) return false;
    can = value == "on" || value == "off";
    *on = value == "on";
  }
  if (!can)
    throw std::invalid_argument(
        "'" + name + " " + value +
        "' is not among what it can do: "
        "model hooke/stiffness tangential history [tangential_damping|absolute_damping|limitForce on|off], "
        "model hooke tangential history [tangential_damping|limitForce|ktToKnUser on|off]");
  return true;
}

void LeanModel::complete() const
{
  if (!model_) throw std::invalid_argument("'model hooke/stiffness' is missing");
  if (!tangential_) throw std::invalid_argument("'tangential history' is missing");
}

}  // namespace clay
