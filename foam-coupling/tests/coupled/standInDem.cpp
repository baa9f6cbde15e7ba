// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file standInDem.cpp
/// A DEM half for tests of the CFD half: a lattice of spheres that know gravity
/// and the fluid and not each other. Arguments are key=value, see Settings.
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "exchange/session.h"

const clay::Half clay::programHalf = clay::Half::dem;

namespace {

using clay::Field;
using Vec = std::array<double, 3>;

/// What the test asks for.
class Settings {
 public:
  Settings(int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
      const std::string word = argv[i];
      const auto sign = word.find('=');
      values_[word.substr(0, sign)] = sign == std::string::npos ? "" : word.substr(sign + 1);
    }
  }
  double number(const std::string& key, double byDefault) const {
    const auto it = values_.find(key);
    return it == values_.end() ? byDefault : std::stod(it->second);
  }
  Vec vec(const std::string& key, Vec byDefault) const {
    const auto it = values_.find(key);
    if (it == values_.end()) return byDefault;
    std::istringstream is(it->second);
    for (auto& x : byDefault) {
      is >> x;
      is.ignore(1);
    }
    return byDefault;
  }
  std::string text(const std::string& key) const {
    const auto it = values_.find(key);
    return it == values_.end() ? "" : it->second;
  }

 private:
  std::map<std::string, std::string> values_;
};

struct Sphere {
  Vec x, v, impulse{};
  Vec moved{}, other{};  // since the last exchange: displacement, impulse of all but the fluid
  bool held = false;     // by more than gravity and fluid then
  double tag;
};

/// The spheres of this rank and their motion.
class Suspension {
 public:
  explicit Suspension(const Settings& s)
      : radius_(s.number("radius", 1e-3)),
        gravity_(s.vec("gravity", {})),
        lo_(s.vec("lo", {})),
        hi_(s.vec("hi", {})),
        wrap_(s.vec("wrap", {})),
        frozen_(s.number("frozen", 0) > 0) {
    volume_ = 4 / 3. * M_PI * radius_ * radius_ * radius_;
    mass_ = volume_ * s.number("density", 2600);
    const Vec n = s.vec("count", {1, 1, 1});
    const Vec from = s.vec("from", lo_), to = s.vec("to", hi_);
    const Vec v = s.vec("velocity", {});
    const int rank = clay::World::instance().rank(), size = clay::World::instance().size();
    int tag = 0;
    for (int k = 0; k < n[2]; ++k)
      for (int j = 0; j < n[1]; ++j)
        for (int i = 0; i < n[0]; ++i, ++tag) {
          if (tag % size != rank) continue;
          const Vec at{i + 0.5, j + 0.5, k + 0.5};
          Sphere p;
          for (int c = 0; c < 3; ++c) p.x[c] = from[c] + (to[c] - from[c]) * at[c] / n[c];
          // columns at different heights cross a plane at different times
          p.x[2] += s.number("stagger", 0) * (to[2] - from[2]) / n[2] *
                    std::fmod((i * n[1] + j) * 5, n[0] * n[1]) / (n[0] * n[1]);
          p.v = v;
          p.tag = tag + 1;
          spheres.push_back(p);
        }
    total_ = tag;
  }

  /// One DEM step by the exact solution for constant K, u and force; buoyant: density of
  /// the fluid whose hydrostatic pressure is in the force.
  void step(double dt, const clay::Particles& answer, double buoyant) {
    for (std::size_t i = 0; i < spheres.size(); ++i) {
      auto& p = spheres[i];
      const double K = answer[Field::dragCoefficient][i];
      const double* u = answer[Field::fluidVelocity] + 3 * i;
      const double* F = answer[Field::force] + 3 * i;
      for (int c = 0; c < 3; ++c) {
        const double other = mass_ * gravity_[c] + F[c];
        double dv = (u[c] + other / K - p.v[c]) * -std::expm1(-K * dt / mass_);
        double impulse = mass_ * dv - mass_ * gravity_[c] * dt;
        if (frozen_) {
          dv = 0;
          impulse = (K * (u[c] - p.v[c]) + F[c]) * dt;
        }
        p.v[c] += dv;
        p.x[c] += p.v[c] * dt;
        p.moved[c] += p.v[c] * dt;
        p.other[c] += mass_ * dv - impulse;
        if (wrap_[c] > 0) {
          const double length = hi_[c] - lo_[c];
          p.x[c] -= length * std::floor((p.x[c] - lo_[c]) / length);
        }
        impulse += buoyant * volume_ * gravity_[c] * dt;  // it is no part of what is told
        p.impulse[c] += impulse;
        given[c] += impulse;
      }
      if (wrap_[2] == 0 && p.x[2] < lo_[2] + radius_) {  // the floor stops it
        p.x[2] = lo_[2] + radius_;
        p.v[2] = 0;
        p.held = true;
      }
      p.held = p.held || frozen_;
    }
    time_ += dt;
  }

  void pack(clay::Particles& to) {
    to.resize(static_cast<int>(spheres.size()));
    for (std::size_t i = 0; i < spheres.size(); ++i) {
      auto& p = spheres[i];
      for (int c = 0; c < 3; ++c) {
        to[Field::position][3 * i + c] = p.x[c];
        to[Field::velocity][3 * i + c] = p.v[c];
        to[Field::impulse][3 * i + c] = p.impulse[c];
        to[Field::meanVelocity][3 * i + c] = time_ > 0 ? p.moved[c] / time_ : p.v[c];
        to[Field::otherForce][3 * i + c] = time_ > 0 ? p.other[c] / time_ : mass_ * gravity_[c];
      }
      to[Field::touched][i] = p.held;
      to[Field::radius][i] = radius_;
      to[Field::volume][i] = volume_;
      to[Field::mass][i] = mass_;
      to[Field::tag][i] = p.tag;
      p.impulse = p.moved = p.other = {};
      p.held = false;
    }
    time_ = 0;
  }

  clay::DemTerms terms(const Settings& s) const {
    clay::DemTerms t;
    t.program = "standInDem";
    t.step = s.number("step", 1e-5);
    t.interval = static_cast<long>(s.number("interval", 20));
    t.startTime = s.number("start", 0);
    t.endTime = t.startTime + t.step * s.number("steps", 1000);
    t.gravity = gravity_;
    for (double g : gravity_) t.hasGravity = t.hasGravity || g != 0;
    t.box.lo = lo_;
    t.box.hi = hi_;
    t.particles = total_;
    t.maxRadius = radius_;
    t.offers = {Field::position,   Field::radius,  Field::volume, Field::velocity,
                Field::tag,        Field::impulse, Field::mass,   Field::meanVelocity,
                Field::otherForce, Field::touched};
    t.needs = {Field::dragCoefficient, Field::fluidVelocity, Field::force};
    return t;
  }

  /// Mean velocity of the spheres between two heights, over all ranks.
  nlohmann::json report(double zlo, double zhi) const {
    std::array<double, 5> sum{};
    for (const auto& p : spheres) {
      if (p.x[2] < zlo || p.x[2] > zhi) continue;
      for (int c = 0; c < 3; ++c) sum[c] += p.v[c];
      sum[3] += 1;
      sum[4] += p.x[2];
    }
    MPI_Allreduce(MPI_IN_PLACE, sum.data(), 5, MPI_DOUBLE, MPI_SUM, clay::World::instance().half());
    nlohmann::json j;
    j["count"] = sum[3];
    j["velocity"] = {sum[0] / sum[3], sum[1] / sum[3], sum[2] / sum[3]};
    j["height"] = sum[4] / sum[3];
    j["mass"] = mass_;
    return j;
  }

  /// Sum of K (u - v) over the spheres of this rank, their number and the sum of their n.
  nlohmann::json answered(const clay::Particles& answer) const {
    std::array<double, 4> sum{};
    for (std::size_t i = 0; i < spheres.size(); ++i) {
      for (std::size_t c = 0; c < 3; ++c)
        sum[c] += answer[Field::dragCoefficient][i] *
                  (answer[Field::fluidVelocity][3 * i + c] - spheres[i].v[c]);
      if (answer.fields().has(Field::voidFraction))
        sum[3] += answer[Field::voidFraction][i] / static_cast<double>(spheres.size());
    }
    return sum;
  }

  /// The state as a file, for a later start (one rank).
  void save(const std::string& file) const {
    std::ofstream os(file);
    os.precision(17);
    for (const auto& p : spheres)
      for (int c = 0; c < 3; ++c) os << p.x[c] << ' ' << p.v[c] << '\n';
  }

  void load(const std::string& file) {
    std::ifstream is(file);
    for (auto& p : spheres)
      for (int c = 0; c < 3; ++c) is >> p.x[c] >> p.v[c];
    if (!is) throw clay::Refusal("cannot read " + file);
  }

  std::vector<Sphere> spheres;
  Vec given{};

 private:
  double radius_, volume_, mass_;
  double time_ = 0;  // since the last exchange
  Vec gravity_, lo_, hi_, wrap_;
  bool frozen_;
  long total_ = 0;
};

/// One run of a session, as a LIGGGHTS script may hold several.
void march(clay::DemSession& session, Suspension& suspension, const clay::DemTerms& terms,
           const Settings& s, nlohmann::json& history) {
  clay::Particles state(session.sends()), answer(session.receives());
  const double zlo = s.number("zlo", -1e300), zhi = s.number("zhi", 1e300);
  const long steps = std::lround((terms.endTime - terms.startTime) / terms.step);
  const double buoyant = session.remoteTerms().buoyancy ? session.remoteTerms().fluidDensity : 0;
  const long spoil = std::lround(s.number("spoilAt", -1));
  for (long done = 0; done <= steps; done += terms.interval) {
    suspension.pack(state);
    if (spoil >= 0 && done >= spoil && state.size()) state[Field::velocity][0] = NAN;
    session.send(state, terms.startTime + done * terms.step, done == steps, suspension.given);
    history.push_back(suspension.report(zlo, zhi));
    session.receive(answer);
    history.back()["answered"] = suspension.answered(answer);
    if (done == steps) break;
    for (long i = 0; i < terms.interval; ++i) suspension.step(terms.step, answer, buoyant);
  }
}

int run(const Settings& s) {
  Suspension suspension(s);
  if (!s.text("load").empty()) suspension.load(s.text("load"));
  auto terms = suspension.terms(s);
  const double fractionFrom = s.number("fractionFrom", 0);  // the first run that reads it
  if (!(fractionFrom > 0)) terms.needs.add(Field::voidFraction);
  clay::DemSession session(terms);
  nlohmann::json history = nlohmann::json::array();

  march(session, suspension, terms, s, history);
  for (int further = 1; further < s.number("runs", 1); ++further) {
    const double length = terms.endTime - terms.startTime;
    terms.startTime = terms.endTime;
    terms.endTime += length;
    if (further >= fractionFrom) terms.needs.add(Field::voidFraction);
    session.resume(terms);
    march(session, suspension, terms, s, history);
  }
  session.close();

  if (!s.text("save").empty()) suspension.save(s.text("save"));
  if (clay::World::instance().rank() == 0) {
    std::ofstream os(s.text("out"));
    os << history.dump(1) << '\n';
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  clay::World::init(argc, argv);
  int status = 0;
  try {
    status = run(Settings(argc, argv));
  } catch (const clay::Refusal& refusal) {
    std::cerr << "standInDem: refused: " << refusal.what() << std::endl;
    status = 1;
  }
  MPI_Finalize();
  return status;
}
