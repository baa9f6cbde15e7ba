// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "contacts/lean_model.h"

#include <algorithm>
#include <map>
#include <stdexcept>

namespace clay {

namespace {

const std::map<std::string, NormalForce> normals = {{"hooke", NormalForce::linear},
                                                    {"hooke/stiffness", NormalForce::linear},
                                                    {"hertz", NormalForce::hertz},
                                                    {"hertz/stiffness", NormalForce::hertzStiffness}};
const std::map<std::string, TangentialForce> tangentials = {
    {"off", TangentialForce::none}, {"no_history", TangentialForce::damped}, {"history", TangentialForce::sprung}};

const std::map<std::string, RollingTorque> rollings = {
    {"off", RollingTorque::none}, {"cdt", RollingTorque::constant}, {"epsd2", RollingTorque::sprung}};
const std::map<std::string, bool> cohesions = {{"off", false}, {"sjkr", true}};

template <class Choice>
bool choose(const std::map<std::string, Choice>& from, const std::string& name, Choice& to)
{
  const auto found = from.find(name);
  if (found != from.end()) to = found->second;
  return found != from.end();
}

}  // namespace

LeanUse takeLeanUse(std::vector<char*>& words)
{
  LeanUse use = LeanUse::may;
  for (std::size_t i = 0; i < words.size();) {
    if (std::string(words[i]) != "lean") {
      i++;
      continue;
    }
    const std::string value = i + 1 < words.size() ? words[i + 1] : "";
    const std::map<std::string, LeanUse> uses = {
        {"yes", LeanUse::must}, {"no", LeanUse::never}, {"auto", LeanUse::may}};
    words.erase(words.begin() + i, words.begin() + std::min(i + 2, words.size()));
    if (!choose(uses, value, use)) throw std::invalid_argument("lean is '" + value + "'; it must be yes, no or auto");
  }
  return use;
}

bool LeanModel::take(const std::string& name, const std::string& value)
{
  bool can = false;
  if (name == "model") {
    can = choose(normals, value, kind.normal);
    name_ = value;
  } else if (name == "tangential") {
    can = choose(tangentials, value, kind.tangential);
    tangential_ = value;
  } else if (name == "rolling_friction") {
    can = choose(rollings, value, kind.rolling);
    rolling_ = value;
  } else if (name == "cohesion") {
    can = choose(cohesions, value, kind.cohesion);
    cohesion_ = value;
  } else if (name == "surface") can = value == "default";
  else {
    bool* on = name == "tangential_damping" ? &tangentialDamping
        : name == "absolute_damping"        ? &absoluteDamping
        : name == "limitForce"              ? &kind.limit
        : name == "ktToKnUser"              ? &softer
        : name == "torsionTorque"           ? &kind.torsion
        : name == "tangential_reduce"       ? &kind.reduce
                                            : nullptr;
    if (!on) return false;
    can = value == "on" || value == "off";
    *on = value == "on";
  }
  if (!can)
    throw std::invalid_argument("'" + name + " " + value +
                                "' is not among what it can do: "
                                "model hooke|hooke/stiffness|hertz|hertz/stiffness "
                                "tangential history|no_history|off "
                                "cohesion sjkr|off rolling_friction cdt|epsd2|off "
                                "[tangential_damping|limitForce on|off] [absolute_damping on|off with hooke/stiffness] "
                                "[ktToKnUser on|off with hooke] [torsionTorque on|off with rolling friction] "
                                "[tangential_reduce on|off with cohesion]");
  return true;
}

std::string LeanModel::text() const
{
  return "model " + name_ + " tangential " + tangential_ + (kind.cohesion ? " cohesion " + cohesion_ : "") +
      (kind.rolling == RollingTorque::none ? "" : " rolling_friction " + rolling_);
}

void LeanModel::complete() const
{
  if (name_.empty()) throw std::invalid_argument("'model' is missing");
}

}  // namespace clay
