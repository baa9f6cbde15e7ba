// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file terms.cpp
/// The terms as JSON. Doubles survive the way there and back bit by bit.
#include "exchange/terms.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace clay {

namespace {

using Json = nlohmann::json;

// JSON has no infinity and no NaN; a null stands for either
double number(const Json& j) {
  return j.is_null() ? std::numeric_limits<double>::quiet_NaN() : j.get<double>();
}

// A whole number as it is: one with a fraction or out of range would become another
template <class Int>
Int whole(const Json& j) {
  if (!j.is_number_integer()) throw std::invalid_argument(j.dump() + " is no whole number");
  if (j.is_number_unsigned() &&
      j.get<std::uint64_t>() > static_cast<std::uint64_t>(std::numeric_limits<Int>::max()))
    throw std::invalid_argument(j.dump() + " is too large");
  const auto n = j.get<std::int64_t>();
  if (n < std::numeric_limits<Int>::min() || n > std::numeric_limits<Int>::max())
    throw std::invalid_argument(j.dump() + " is too large");
  return static_cast<Int>(n);
}

// The number of a pair of saved states: whole, so that it is told from any other
double pairNumber(const Json& j) {
  const double n = j.get<double>();
  if (!(n >= 0 && n <= largestPairNumber) || n != std::floor(n))
    throw std::invalid_argument(j.dump() + " is no number of a pair of saved states");
  return n;
}

// A name, which will stand in messages of one line
std::string word(const Json& j) {
  auto s = j.get<std::string>();
  for (char& c : s)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = ' ';
  return s;
}

template <std::size_t n>
void checkLength(const Json& j) {
  if (!j.is_array() || j.size() != n)
    throw std::invalid_argument(j.dump() + " must have " + std::to_string(n) + " values");
}

std::array<double, 3> triple(const Json& j) {
  checkLength<3>(j);
  return {{number(j.at(0)), number(j.at(1)), number(j.at(2))}};
}

Json text(const Box& box) { return {{"lo", box.lo}, {"hi", box.hi}}; }

Box box(const Json& j) {
  Box b;
  b.lo = triple(j.at("lo"));
  b.hi = triple(j.at("hi"));
  return b;
}

template <std::size_t n>
std::array<bool, n> flags(const Json& j) {
  checkLength<n>(j);
  return j.get<std::array<bool, n>>();
}

FieldSet fields(const Json& j) { return FieldSet::fromNames(j.get<std::vector<std::string>>()); }

// Text of the given half, or a Refusal
Json parse(const std::string& s, const std::string& half, const std::string& other) {
  Json j = Json::parse(s, nullptr, false);
  if (j.is_discarded() || !j.is_object() || !j.contains("half") || !j.contains("wire"))
    throw Refusal("the other program of this mpirun does not speak clayFoam's exchange");
  if (j["half"] != half)
    throw Refusal("both programs of this mpirun are " + other +
                  " halves; a coupled run has one DEM half and one CFD half");
  return j;
}

template <class Terms, class Read>
Terms decode(const std::string& s, const char* half, const char* other, Read read) {
  const Json j = parse(s, half, other);
  Terms t;
  try {
    t.wire = whole<int>(j["wire"]);
    t.program = j.contains("program") ? word(j["program"]) : "";
    // what another version of the wire holds is not known
    if (t.wire == wireVersion) read(j, t);
  } catch (const std::exception& e) {
    throw Refusal(std::string("the terms of the ") + half + " half cannot be read: " + e.what());
  }
  return t;
}

}  // namespace

std::string encode(const DemTerms& t) {
  return Json{{"half", "DEM"},
              {"wire", t.wire},
              {"program", t.program},
              {"step", t.step},
              {"interval", t.interval},
              {"startTime", t.startTime},
              {"endTime", t.endTime},
              {"gravity", t.gravity},
              {"hasGravity", t.hasGravity},
              {"box", text(t.box)},
              {"periodic", t.periodic},
              {"particles", t.particles},
              {"maxRadius", t.maxRadius},
              {"bodyDiameter", t.bodyDiameter},
              {"offers", t.offers.names()},
              {"brings", t.brings.names()},
              {"needs", t.needs.names()},
              {"clumpDrag", t.clumpDrag},
              {"pairs", t.pairs},
              {"pair", t.pair}}
      .dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string encode(const CfdTerms& t) {
  Json j{{"half", "CFD"},
         {"wire", t.wire},
         {"program", t.program},
         {"startTime", t.startTime},
         {"fluidDensity", t.fluidDensity},
         {"fluidViscosity", t.fluidViscosity},
         {"box", text(t.box)},
         {"buoyancy", t.buoyancy},
         {"open", t.open},
         {"overlap", t.overlap},
         {"pair", t.pair},
         {"needs", t.needs.names()},
         {"accepts", t.accepts.names()},
         {"offers", t.offers.names()}};
  if (t.endTime) j["endTime"] = *t.endTime;
  if (t.couplingInterval) j["couplingInterval"] = *t.couplingInterval;
  if (t.gravity) j["gravity"] = *t.gravity;
  if (t.period) j["period"] = *t.period;
  return j.dump(-1, ' ', false, Json::error_handler_t::replace);
}

DemTerms decodeDem(const std::string& s) {
  return decode<DemTerms>(s, "DEM", "CFD", [](const Json& j, DemTerms& t) {
    t.step = number(j.at("step"));
    t.interval = whole<long>(j.at("interval"));
    t.startTime = number(j.at("startTime"));
    t.endTime = number(j.at("endTime"));
    t.gravity = triple(j.at("gravity"));
    t.hasGravity = j.at("hasGravity").get<bool>();
    t.box = box(j.at("box"));
    t.periodic = flags<3>(j.at("periodic"));
    t.particles = whole<long>(j.at("particles"));
    t.maxRadius = number(j.at("maxRadius"));
    t.bodyDiameter = number(j.at("bodyDiameter"));
    t.offers = fields(j.at("offers"));
    t.brings = fields(j.at("brings"));
    t.needs = fields(j.at("needs"));
    t.clumpDrag = word(j.at("clumpDrag"));
    t.pairs = word(j.at("pairs"));
    t.pair = pairNumber(j.at("pair"));
  });
}

CfdTerms decodeCfd(const std::string& s) {
  return decode<CfdTerms>(s, "CFD", "DEM", [](const Json& j, CfdTerms& t) {
    t.startTime = number(j.at("startTime"));
    t.fluidDensity = number(j.at("fluidDensity"));
    t.fluidViscosity = number(j.at("fluidViscosity"));
    t.box = box(j.at("box"));
    t.buoyancy = j.at("buoyancy").get<bool>();
    t.open = flags<6>(j.at("open"));
    t.overlap = j.at("overlap").get<bool>();
    t.pair = pairNumber(j.at("pair"));
    t.needs = fields(j.at("needs"));
    t.accepts = fields(j.at("accepts"));
    t.offers = fields(j.at("offers"));
    if (j.contains("endTime")) t.endTime = number(j["endTime"]);
    if (j.contains("couplingInterval")) t.couplingInterval = number(j["couplingInterval"]);
    if (j.contains("gravity")) t.gravity = triple(j["gravity"]);
    if (j.contains("period")) t.period = triple(j["period"]);
  });
}

}  // namespace clay
