// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/fields.h"

#include <climits>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace clay {

namespace {

// What values a field can have
enum class Values { any, notNegative, flag, numberOrNone, number };

struct FieldFacts {
  const char* name;
  int components;
  Values values = Values::any;
};

// in the order of enum Field
constexpr FieldFacts facts[] = {
    {"position", 3},
    {"radius", 1, Values::notNegative},
    {"volume", 1, Values::notNegative},
    {"velocity", 3},
    {"tag", 1, Values::number},
    {"body", 1, Values::numberOrNone},
    {"impulse", 3},
    {"mass", 1, Values::notNegative},
    {"spin", 3},
    {"meanVelocity", 3},
    {"otherForce", 3},
    {"touched", 1, Values::flag},
    {"gravity", 3},
    {"dragDiameter", 1, Values::notNegative},
    {"dragFactor", 1, Values::notNegative},
    {"dragCoefficient", 1, Values::notNegative},
    {"fluidVelocity", 3},
    {"force", 3},
    {"addedMass", 1, Values::notNegative},
    {"turnCoefficient", 1, Values::notNegative},
    {"fluidSpin", 3},
    {"voidFraction", 1, Values::notNegative},
};
static_assert(sizeof(facts) / sizeof(facts[0]) == fieldCount, "one line a field");

const FieldFacts& factsOf(Field f) {
  const auto i = static_cast<unsigned>(f);
  if (i >= fieldCount) throw std::logic_error("no such field: " + std::to_string(i));
  return facts[i];
}

bool canBe(double x, Values values) {
  if (values == Values::flag) return x == 0 || x == 1;
  if (values == Values::number || values == Values::numberOrNone)
    return x >= (values == Values::number ? 0 : -1) && x <= INT_MAX && x == std::floor(x);
  return possible(x) && (values == Values::any || x >= 0);
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

Astray firstAstray(const Particles& particles) {
  Astray found;
  for (unsigned i = 0; i < fieldCount; ++i) {
    const auto f = static_cast<Field>(i);
    if (!particles.fields().has(f)) continue;
    const std::ptrdiff_t width = facts[i].components;
    const double* value = particles[f];
    const auto end = width * (found.particle < 0 ? particles.size() : found.particle);
    for (std::ptrdiff_t k = 0; k < end; ++k)
      if (!canBe(value[k], facts[i].values)) {
        found = {static_cast<int>(k / width), f};
        break;
      }
  }
  return found;
}

std::string describe(const Astray& a, const Particles& values, const Particles& known) {
  const auto list = [](const Particles& from, Field f, int particle) {
    const int width = components(f);
    std::string s = width > 1 ? "(" : "";
    for (int c = 0; c < width; ++c) {
      char number[32];
      std::snprintf(number, sizeof number, c ? " %.9g" : "%.9g", from[f][width * particle + c]);
      s += number;
    }
    return width > 1 ? s + ")" : s;
  };
  std::string s = "particle ";
  s += known.fields().has(Field::tag) ? list(known, Field::tag, a.particle)
                                      : "at place " + std::to_string(a.particle);
  if (known.fields().has(Field::position))
    s += " at " + list(known, Field::position, a.particle) + " m";
  return s + ": " + name(a.field) + " is " + list(values, a.field, a.particle);
}

}  // namespace clay
