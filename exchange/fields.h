// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file fields.h
/// What a message can hold: the per-particle fields of either direction.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

namespace clay {

/// A per-particle field on the wire. All values are doubles, in SI units.
enum class Field : unsigned {
  // DEM to CFD
  position,      ///< centre [m], 3
  radius,        ///< geometric radius [m], 1
  volume,        ///< solid volume it stands for [m3], 1
  velocity,      ///< velocity of the centre [m/s], 3
  tag,           ///< the DEM half's particle number, 1
  body,          ///< number of the clump it belongs to, -1 for none, 1
  impulse,       ///< received from the fluid since the last exchange, without buoyancy [N s], 3
  mass,          ///< mass it stands for [kg], 1
  spin,          ///< angular velocity [rad/s], 3
  meanVelocity,  ///< displacement over time since the last exchange [m/s], 3
  otherForce,    ///< mean of all forces but the fluid's since the last exchange [N], 3
  touched,       ///< 1 when more than gravity was among them, else 0, 1
  gravity,       ///< on it, when that changes or is not the same for all [m/s2], 3
  dragDiameter,  ///< diameter in the drag law, of its clump [m], 1
  dragFactor,    ///< its clump's drag alone over Stokes' with that diameter, 0 for a free sphere, 1
  // CFD to DEM
  dragCoefficient,  ///< K in F = K (u - v) [kg/s], 1
  fluidVelocity,    ///< u in F = K (u - v) [m/s], 3
  force,            ///< explicit force (pressure gradient, viscous, buoyancy) [N], 3
  addedMass,        ///< m_a in F = -m_a dv/dt [kg], 1
  turnCoefficient,  ///< C in T = C (w - spin) [N m s], 1
  fluidSpin,        ///< w in T = C (w - spin) [rad/s], 3
  voidFraction,     ///< at the particle, as its drag law takes it, 1
  count
};

constexpr unsigned fieldCount = static_cast<unsigned>(Field::count);

/// True for what the CFD half answers, false for what the DEM half sends.
constexpr bool isAnswer(Field f) { return f >= Field::dragCoefficient; }

/// Number of doubles a particle has of a field.
int components(Field f);

/// The field's name, as it stands in the handshake.
const char* name(Field f);

/// A set of fields.
class FieldSet {
 public:
  FieldSet() = default;
  FieldSet(std::initializer_list<Field> fields) {
    for (auto f : fields) add(f);
  }
  void add(Field f) { bits_ |= 1u << static_cast<unsigned>(f); }
  bool has(Field f) const { return bits_ >> static_cast<unsigned>(f) & 1u; }
  bool operator==(const FieldSet& o) const { return bits_ == o.bits_; }
  /// The fields of this set that the other lacks.
  FieldSet without(const FieldSet& o) const {
    FieldSet s;
    s.bits_ = bits_ & ~o.bits_;
    return s;
  }
  bool empty() const { return bits_ == 0; }
  /// Doubles a particle has in a message of these fields.
  int width() const;
  std::vector<std::string> names() const;
  static FieldSet fromNames(const std::vector<std::string>&);

 private:
  std::uint32_t bits_ = 0;
};

/// Particles as one array a field: field f of particle i stands at
/// components(f)*i. Fields that are not in the set are empty.
class Particles {
 public:
  explicit Particles(FieldSet fields = {}) : fields_(fields) {}
  const FieldSet& fields() const { return fields_; }
  int size() const { return size_; }
  /// Makes room for n particles; what was there stays.
  void resize(int n);
  /// Forgets the particles, keeps the memory.
  void clear() { resize(0); }
  double* operator[](Field f) { return data_[static_cast<unsigned>(f)].data(); }
  const double* operator[](Field f) const { return data_[static_cast<unsigned>(f)].data(); }

 private:
  FieldSet fields_;
  int size_ = 0;
  std::array<std::vector<double>, fieldCount> data_;
};

/// Larger numbers than this, and what is no number, mean that a computation went wrong.
constexpr double largestNumber = 1e100;
inline bool possible(double x) { return x > -largestNumber && x < largestNumber; }

/// Pairs of saved states are numbered from 1, in doubles; 0 stands for none.
constexpr double largestPairNumber = 9007199254740991;

/// Where a value stands that its field cannot have.
struct Astray {
  int particle = -1;  ///< index of the particle, -1 when all values are possible
  Field field = Field::count;
};

/// The first particle that has a value which is no number or none that the field can
/// have: a size or a coefficient below 0, a particle's or clump's number that is not whole.
Astray firstAstray(const Particles&);

/// In words: the particle's number, where it is, the field and its values.
/// \param known  the particles themselves, where the values are an answer to them
std::string describe(const Astray&, const Particles& values, const Particles& known);

/// An axis-parallel box [m].
struct Box {
  std::array<double, 3> lo{{1e300, 1e300, 1e300}}, hi{{-1e300, -1e300, -1e300}};
  /// True when a sphere of radius r at x touches the box.
  bool reaches(const double* x, double r) const {
    for (int i = 0; i < 3; ++i)
      if (x[i] + r < lo[i] || x[i] - r > hi[i]) return false;
    return true;
  }
};

/// Where spheres concern a CFD rank: its part of the mesh, and the same moved by
/// periods where it takes parts of spheres that reach through periodic sides.
using RankBoxes = std::vector<Box>;

}  // namespace clay
