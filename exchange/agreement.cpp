// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file agreement.cpp
/// Whether the terms of the two halves fit. Both halves evaluate the same
/// functions on the same terms, so that they come to the same verdict.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "exchange/terms.h"

namespace clay {

namespace {

std::string text(double x) {
  char s[32];
  std::snprintf(s, sizeof s, "%.10g", x);
  return s;
}

std::string text(const std::array<double, 3>& x) {
  return "(" + text(x[0]) + " " + text(x[1]) + " " + text(x[2]) + ")";
}

std::string text(const Box& b) { return text(b.lo) + " to " + text(b.hi); }

std::string list(const FieldSet& fields) {
  std::string s;
  for (const auto& n : fields.names()) s += (s.empty() ? "" : ", ") + n;
  return s;
}

bool stated(const Box& b) {
  for (int i = 0; i < 3; ++i)
    if (!(b.lo[i] <= b.hi[i])) return false;
  return true;
}

double extent(const Box& b) {
  double longest = 0;
  for (int i = 0; i < 3; ++i) longest = std::max(longest, b.hi[i] - b.lo[i]);
  return longest;
}

bool apart(const Box& a, const Box& b) {
  for (int i = 0; i < 3; ++i)
    if (a.hi[i] < b.lo[i] || b.hi[i] < a.lo[i]) return true;
  return false;
}

// True, too, when a value is no number
bool differ(double a, double b, double tolerance) { return !(std::fabs(a - b) <= tolerance); }

// Hint at a length unit that was left out
std::string unitHint(const Box& dem, const Box& mesh) {
  const double ratio = extent(mesh) / extent(dem);
  if (ratio > 300 && ratio < 3000) return "; is the mesh in millimetres?";
  if (ratio > 1 / 3000. && ratio < 1 / 300.) return "; is the DEM box in millimetres?";
  return "";
}

bool allPossible(const std::array<double, 3>& x) {
  return clay::possible(x[0]) && clay::possible(x[1]) && clay::possible(x[2]);
}

// A box of numbers, or none at all
bool sound(const Box& b) {
  const Box none;
  return (b.lo == none.lo && b.hi == none.hi) ||
         (allPossible(b.lo) && allPossible(b.hi) && stated(b));
}

// What is no number, or too large for one of physics
std::string noNumbers(const DemTerms& dem, const CfdTerms& cfd) {
  const auto odd = [](const char* half, const char* what, const std::string& value) {
    return std::string("the ") + half + " half's " + what + " is " + value;
  };
  for (double t : {dem.startTime, dem.endTime})
    if (!possible(t)) return odd("DEM", "time", text(t) + " s");
  if (!allPossible(dem.gravity)) return odd("DEM", "gravity", text(dem.gravity) + " m/s2");
  if (!sound(dem.box)) return odd("DEM", "box", text(dem.box) + " m");
  if (!possible(dem.maxRadius) || dem.maxRadius < 0)
    return odd("DEM", "largest radius", text(dem.maxRadius) + " m");
  if (!possible(dem.bodyDiameter) || dem.bodyDiameter < 0)
    return odd("DEM", "diameter of the clumps", text(dem.bodyDiameter) + " m");
  for (double t : {cfd.startTime, cfd.endTime.value_or(0), cfd.couplingInterval.value_or(0)})
    if (!possible(t)) return odd("CFD", "time", text(t) + " s");
  if (cfd.gravity && !allPossible(*cfd.gravity))
    return odd("CFD", "gravity", text(*cfd.gravity) + " m/s2");
  if (!sound(cfd.box)) return odd("CFD", "mesh", text(cfd.box) + " m");
  if (cfd.period && !allPossible(*cfd.period))
    return odd("CFD", "period", text(*cfd.period) + " m");
  for (double x : {dem.step, cfd.fluidDensity, cfd.fluidViscosity})
    if (!possible(x)) return "a time step, density or viscosity is " + text(x);
  return "";
}

// Each half sends and needs its own kind
std::string directions(const DemTerms& dem, const CfdTerms& cfd) {
  FieldSet states, answers;
  for (unsigned i = 0; i < fieldCount; ++i) {
    const auto f = static_cast<Field>(i);
    (isAnswer(f) ? answers : states).add(f);
  }
  const auto odd = [](const char* who, const FieldSet& strange) {
    return strange.empty() ? ""
                           : std::string(who) + " " + list(strange) + ", which goes the other way";
  };
  for (const auto& line : {odd("the DEM half offers", dem.offers.without(states)),
                           odd("the DEM half brings", dem.brings.without(states)),
                           odd("the DEM half needs", dem.needs.without(answers)),
                           odd("the CFD half needs", cfd.needs.without(states)),
                           odd("the CFD half accepts", cfd.accepts.without(states)),
                           odd("the CFD half offers", cfd.offers.without(answers))})
    if (!line.empty()) return line;
  return "";
}

std::string oneHalfAlone(const DemTerms& dem, const CfdTerms& cfd) {
  if (!(dem.step > 0))
    return "the DEM half's time step is " + text(dem.step) + " s; it must be above 0";
  if (dem.interval <= 0)
    return "the DEM half's coupling interval is " + std::to_string(dem.interval) +
           " steps; it must be 1 or more";
  if (!(dem.endTime >= dem.startTime))
    return "the DEM half's run ends at " + text(dem.endTime) + " s, before its start at " +
           text(dem.startTime) + " s";
  if (dem.particles < 0)
    return "the DEM half's coupled group holds " + std::to_string(dem.particles) + " particles";
  if (!(cfd.fluidDensity > 0))
    return "the CFD half's fluid density is " + text(cfd.fluidDensity) +
           " kg/m3; it must be above 0";
  if (!(cfd.fluidViscosity >= 0))
    return "the CFD half's fluid viscosity is " + text(cfd.fluidViscosity) +
           " Pa s; it must not be below 0";
  return "";
}

std::string times(const DemTerms& dem, const CfdTerms& cfd) {
  if (differ(dem.startTime, cfd.startTime, 0.5 * dem.step))
    return "the start times differ: " + text(dem.startTime) + " s in the DEM half, " +
           text(cfd.startTime) +
           " s in the CFD half; where the fluid's flow was computed beforehand, timeOffset " +
           text(cfd.startTime - dem.startTime) +
           "; in constant/couplingProperties lets it start from there";
  if (cfd.endTime && differ(dem.endTime, *cfd.endTime, 0.5 * dem.step))
    return "the end times differ: " + text(dem.endTime) + " s in the DEM half, " +
           text(*cfd.endTime) +
           " s in the CFD half, which follows the DEM half's runs if its case states none";
  const double interval = dem.step * static_cast<double>(dem.interval);
  if (cfd.couplingInterval && differ(interval, *cfd.couplingInterval, 1e-6 * interval))
    return "the coupling intervals differ: " + text(interval) + " s (" +
           std::to_string(dem.interval) + " steps of " + text(dem.step) + " s) in the DEM half, " +
           text(*cfd.couplingInterval) + " s in the CFD half";
  return "";
}

std::string pairs(const DemTerms& dem, const CfdTerms& cfd) {
  if (dem.pair == cfd.pair) return "";
  const auto from = [](double pair) {
    char s[48];
    std::snprintf(s, sizeof s, "from the saved pair %.0f", pair);
    return pair > 0 ? std::string(s) : std::string("from no saved pair");
  };
  return "the halves do not start from the same saved state: the DEM half goes on " +
         from(dem.pair) + ", the CFD half " + from(cfd.pair);
}

std::string gravities(const DemTerms& dem, const CfdTerms& cfd) {
  if (!dem.hasGravity || !cfd.gravity) return "";
  double size = 0;
  for (int i = 0; i < 3; ++i)
    size = std::max({size, std::fabs(dem.gravity[i]), std::fabs((*cfd.gravity)[i])});
  for (int i = 0; i < 3; ++i)
    if (differ(dem.gravity[i], (*cfd.gravity)[i], 1e-6 * size))
      return "the gravities differ: " + text(dem.gravity) + " m/s2 in the DEM half, " +
             text(*cfd.gravity) + " m/s2 in the CFD half";
  return "";
}

// A mesh in millimetres may well hold the whole DEM box: it is told by its size
std::string boxes(const DemTerms& dem, const CfdTerms& cfd) {
  if (!stated(dem.box) || !stated(cfd.box)) return "";
  const bool disjoint = apart(dem.box, cfd.box);
  const std::string hint = unitHint(dem.box, cfd.box);
  if (!disjoint && hint.empty()) return "";
  return "the DEM box " + text(dem.box) + " m and the mesh " + text(cfd.box) + " m " +
         (disjoint ? "do not overlap" : "differ too much in size") + hint;
}

// A particle that leaves through a periodic side comes back at the other: so must the fluid
std::string periods(const DemTerms& dem, const CfdTerms& cfd) {
  if (!cfd.period || !stated(dem.box)) return "";
  for (int k = 0; k < 3; ++k) {
    const double theirs = (*cfd.period)[k], length = dem.box.hi[k] - dem.box.lo[k];
    if (!dem.periodic[k] || theirs < 0) continue;
    const std::string ours =
        std::string("the DEM box is periodic along ") + "xyz"[k] + " with " + text(length) + " m, ";
    if (theirs == 0) return ours + "the mesh has no cyclic patches there";
    if (differ(length, theirs, 1e-6 * length)) return ours + "the mesh with " + text(theirs) + " m";
  }
  return "";
}

std::string fields(const DemTerms& dem, const CfdTerms& cfd) {
  const FieldSet cfdLacks = cfd.needs.without(dem.offers);
  if (!cfdLacks.empty())
    return "the CFD half needs " + list(cfdLacks) + ", the DEM half offers only " +
           list(dem.offers);
  const FieldSet strange = dem.brings.without(cfd.accepts);
  if (!strange.empty())
    return "the DEM half brings " + list(strange) + ", which the CFD half has no use for" +
           (cfd.accepts.empty() ? "" : "; it accepts only " + list(cfd.accepts));
  const FieldSet demLacks = dem.needs.without(cfd.offers);
  if (!demLacks.empty())
    return "the DEM half needs " + list(demLacks) + ", the CFD half offers only " +
           list(cfd.offers);
  return "";
}

}  // namespace

std::string disagreement(const DemTerms& dem, const CfdTerms& cfd) {
  if (dem.wire != cfd.wire)
    return "the halves speak different versions of the exchange: " + std::to_string(dem.wire) +
           " in the DEM half (" + dem.program + "), " + std::to_string(cfd.wire) +
           " in the CFD half (" + cfd.program + ")";
  for (auto check :
       {oneHalfAlone, noNumbers, directions, times, pairs, gravities, fields, periods}) {
    std::string line = check(dem, cfd);
    if (!line.empty()) return line;
  }
  return boxes(dem, cfd);
}

std::vector<std::string> warnings(const DemTerms& dem, const CfdTerms& cfd) {
  std::vector<std::string> lines;
  for (int k = 0; k < 3; ++k)
    if (cfd.period && (*cfd.period)[k] > 0 && !dem.periodic[k])
      lines.push_back(std::string("the mesh is cyclic along ") + "xyz"[k] +
                      ", the DEM box is not periodic there: particles do not pass, the fluid does");
  if (!dem.hasGravity)
    lines.push_back("the DEM half has no gravity: particles get no weight and no buoyancy");
  return lines;
}

}  // namespace clay
