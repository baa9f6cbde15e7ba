// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/fields.h"

#include <cmath>
#include <stdexcept>

namespace clay {

namespace {

struct FieldFacts {
  const char* name;
  int components;
};

// in the order of enum Field
constexpr FieldFacts facts[] = {
    {"position", 3},      {"radius", 1},       {"volume", 1},     {"velocity", 3},
    {"tag", 1},           {"body", 1},         {"impulse", 3},    {"mass", 1},
    {"spin", 3},          {"meanVelocity", 3}, {"otherForce", 3}, {"touched", 1},
    {"gravity", 3},       {"dragDiameter", 1}, {"dragFactor", 1}, {"dragCoefficient", 1},
    {"fluidVelocity", 3}, {"force", 3},        {"addedMass", 1},  {"turnCoefficient", 1},
    {"fluidSpin", 3},
};
static_assert(sizeof(facts) / sizeof(facts[0]) == fieldCount, "one line a field");

const FieldFacts& factsOf(Field f) {
  const auto i = static_cast<unsigned>(f);
  if (i >= fieldCount) throw std::logic_error("no such field: " + std::to_string(i));
  return facts[i];
}

}  // namespace

int components(Field f) { return factsOf(f).components; }

const char* name(Field f) { return factsOf(f).name; }

int FieldSet::width() const {
  int doubles = 0;
  for (unsigned i = 0; i < fieldCount; ++i)
    if (has(static_cast<Field>(i))) doubles += facts[i].components;
  return doubles;
}

std::vector<std::string> FieldSet::names() const {
  std::vector<std::string> list;
  for (unsigned i = 0; i < fieldCount; ++i)
    if (has(static_cast<Field>(i))) list.emplace_back(facts[i].name);
  return list;
}

FieldSet FieldSet::fromNames(const std::vector<std::string>& list) {
  FieldSet set;
  for (const auto& wanted : list) {
    unsigned i = 0;
    while (i < fieldCount && wanted != facts[i].name) ++i;
    if (i == fieldCount) throw std::invalid_argument("no such field: " + wanted);
    set.add(static_cast<Field>(i));
  }
  return set;
}

void Particles::resize(int n) {
  for (unsigned i = 0; i < fieldCount; ++i)
    if (fields_.has(static_cast<Field>(i)))
      data_[i].resize(static_cast<std::size_t>(n) * facts[i].components);
  size_ = n;
}

NonFinite firstNonFinite(const Particles& particles) {
  NonFinite found;
  for (unsigned i = 0; i < fieldCount; ++i) {
    const auto f = static_cast<Field>(i);
    if (!particles.fields().has(f)) continue;
    const int width = facts[i].components;
    const double* value = particles[f];
    for (int p = 0; p < particles.size(); ++p) {
      if (found.particle >= 0 && p >= found.particle) break;
      for (int c = 0; c < width; ++c)
        if (!std::isfinite(value[width * p + c])) {
          found = {p, f};
          break;
        }
    }
  }
  return found;
}

}  // namespace clay
