// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file terms.h
/// What the halves tell each other before the first exchange, and whether it fits.
#pragma once

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "exchange/fields.h"

namespace clay {

/// Both halves must speak the same version of the wire.
constexpr int wireVersion = 11;
static_assert(fieldCount == 22, "another list of fields is another version of the wire");

/// Raised, on every rank of both halves, when the halves do not fit.
class Refusal : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What the DEM half states at the start of each run.
struct DemTerms {
  std::string program;  ///< name and version of the program
  int wire = wireVersion;
  double step = 0;                  ///< DEM time step [s]
  long interval = 0;                ///< DEM steps between two exchanges
  double startTime = 0;             ///< time at the start of this run [s]
  double endTime = 0;               ///< time at its end [s]
  std::array<double, 3> gravity{};  ///< [m/s2], zero without fix gravity
  bool hasGravity = false;          ///< fix gravity is there
  Box box;                          ///< simulation box [m]
  std::array<bool, 3> periodic{};   ///< along x, y, z
  long particles = 0;               ///< number of particles in the coupled group
  double maxRadius = 0;             ///< [m]
  double bodyDiameter = 0;          ///< of a sphere of a clump's volume, mean; 0 without [m]
  FieldSet offers;                  ///< fields it can send
  FieldSet brings;        ///< fields it sends though they are not needed; its settings ask for them
  FieldSet needs;         ///< fields it must get
  std::string clumpDrag;  ///< how the drag of clumps is found; empty without clumps
  std::string pairs;      ///< folder of the pairs of saved states; empty where none are saved
  double pair = 0;        ///< number of the pair that this half starts from; 0: none
};

/// What the CFD half states.
struct CfdTerms {
  std::string program;
  int wire = wireVersion;
  double startTime = 0;                          ///< [s]
  std::optional<double> endTime;                 ///< if its own case states one [s]
  std::optional<double> couplingInterval;        ///< if its own case states one [s]
  std::optional<std::array<double, 3>> gravity;  ///< if its own case states one [m/s2]
  double fluidDensity = 0;                       ///< [kg/m3]
  double fluidViscosity = 0;                     ///< dynamic [Pa s]
  Box box;                                       ///< bounds of the whole mesh [m]
  bool buoyancy = false;                         ///< its force holds -rho V g on each particle
  /// Length after which the mesh repeats along x, y, z [m]; 0 where it ends, below 0 where the
  /// flow does not vary. Empty if it is not known.
  std::optional<std::array<double, 3>> period;
  /// Sides of the box through which particles may leave the fluid and come back: low x, high x,
  /// low y, ... On these none is lost, it just gets no force.
  std::array<bool, 6> open{};
  bool overlap = true;  ///< both halves march at the same time
  double pair = 0;      ///< number of the pair that this half starts from; 0: none
  FieldSet needs;       ///< fields it must get
  FieldSet accepts;     ///< fields it can use when they are brought
  FieldSet offers;      ///< fields it can send
};

/// Says in one line what does not fit, naming both values; empty when all fits.
std::string disagreement(const DemTerms&, const CfdTerms&);

/// What fits but looks odd, a line each (no gravity).
std::vector<std::string> warnings(const DemTerms&, const CfdTerms&);

/// The terms as text for the wire, and back. Reading the terms of the wrong
/// half, or what is no text of terms at all, throws Refusal.
std::string encode(const DemTerms&);
std::string encode(const CfdTerms&);
DemTerms decodeDem(const std::string&);
CfdTerms decodeCfd(const std::string&);

}  // namespace clay
