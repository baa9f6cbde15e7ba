// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file stand_in_cfd.cpp
/// A CFD half for tests of the DEM half, on one rank: a fluid that moves and drags as
/// it is told, whatever it gets. Arguments are key=value: half (the box's half width
/// [m]), K [kg/s], u, rate (u grows by rate z along x [1/s]), force [N], rho (of the
/// buoyancy; 0: none), added [kg], turn [N m s], n, late, g [m/s2], out, stop (at its 3rd exchange it asks for
/// the end, by that signal), from (folder of a saved pair that it goes on from) and start [s]. A sphere's K is (1 + 0.1
/// sin(number)) of the one given, its n that times n. Writes what it was told of each exchange as JSON.
#include <cmath>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <string>

#include <nlohmann/json.hpp>

#include "exchange/saved_pair.h"
#include "exchange/session.h"

const clay::Half clay::programHalf = clay::Half::cfd;

namespace {

using clay::Field;
using Vec = std::array<double, 3>;

class Settings {
 public:
  Settings(int argc, char **argv)
  {
    for (int i = 1; i < argc; i++) {
      const std::string word = argv[i];
      const auto sign = word.find('=');
      if (sign != std::string::npos) values_[word.substr(0, sign)] = word.substr(sign + 1);
    }
  }
  double number(const std::string &key, double byDefault) const
  {
    const auto it = values_.find(key);
    return it == values_.end() ? byDefault : std::stod(it->second);
  }
  Vec vec(const std::string &key) const
  {
    Vec v{};
    const auto it = values_.find(key);
    if (it == values_.end()) return v;
    std::istringstream is(it->second);
    for (double &x : v) {
      is >> x;
      is.ignore(1);
    }
    return v;
  }
  std::string text(const std::string &key) const
  {
    const auto it = values_.find(key);
    return it == values_.end() ? "" : it->second;
  }

 private:
  std::map<std::string, std::string> values_;
};

clay::CfdTerms terms(const Settings &s)
{
  clay::CfdTerms t;
  const double half = s.number("half", 0.01), rho = s.number("rho", 0);
  t.program = "stand_in_cfd";
  t.fluidDensity = rho > 0 ? rho : 1000;
  t.fluidViscosity = 1e-3;
  t.box.lo = {-half, -half, -half};
  t.box.hi = {half, half, half};
  t.buoyancy = rho > 0;
  t.startTime = s.number("start", 0);
  std::string word;
  std::ifstream(s.text("from") + "/cfd/sums") >> word >> t.pair;
  t.needs = {Field::position, Field::radius, Field::volume,       Field::velocity,   Field::tag,    Field::body,
             Field::impulse,  Field::mass,   Field::meanVelocity, Field::otherForce, Field::touched};
  t.accepts = {Field::dragDiameter, Field::dragFactor, Field::gravity};
  t.offers = {Field::dragCoefficient, Field::fluidVelocity, Field::force, Field::voidFraction};
  if (s.number("added", 0) > 0) t.offers.add(Field::addedMass);
  if (s.number("turn", 0) > 0) {
    t.offers.add(Field::turnCoefficient);
    t.offers.add(Field::fluidSpin);
  }
  return t;
}

nlohmann::json told(const clay::Particles &p, const clay::CfdSession &session)
{
  nlohmann::json e;
  e["time"] = session.time();
  e["given"] = session.impulse();
  e["particles"] = nlohmann::json::array();
  for (int i = 0; i < p.size(); i++) {
    nlohmann::json one;
    for (unsigned k = 0; k < clay::fieldCount; k++) {
      const Field f = static_cast<Field>(k);
      if (!p.fields().has(f)) continue;
      const double *value = p[f] + clay::components(f) * i;
      if (clay::components(f) == 1) one[clay::name(f)] = value[0];
      else one[clay::name(f)] = {value[0], value[1], value[2]};
    }
    e["particles"].push_back(one);
  }
  return e;
}

void fill(const clay::Particles &p, const Settings &s, clay::Particles &answer)
{
  const double K = s.number("K", 0), rate = s.number("rate", 0), rho = s.number("rho", 0), g = s.number("g", 9.81);
  const Vec u = s.vec("u"), force = s.vec("force");
  answer.resize(p.size());
  for (int i = 0; i < p.size(); i++) {
    const double vary = 1 + 0.1 * std::sin(p[Field::tag][i]);
    answer[Field::dragCoefficient][i] = K * vary;
    for (int k = 0; k < 3; k++) {
      answer[Field::fluidVelocity][3 * i + k] = u[k];
      answer[Field::force][3 * i + k] = force[k] * vary;
    }
    answer[Field::fluidVelocity][3 * i] += rate * p[Field::position][3 * i + 2];
    answer[Field::force][3 * i + 2] += rho * g * p[Field::volume][i];
    if (answer.fields().has(Field::addedMass)) answer[Field::addedMass][i] = s.number("added", 0) * vary;
    if (answer.fields().has(Field::turnCoefficient)) {
      answer[Field::turnCoefficient][i] = s.number("turn", 0) * vary;
      std::fill_n(answer[Field::fluidSpin] + 3 * i, 3, 0.);
    }
    if (answer.fields().has(Field::voidFraction)) answer[Field::voidFraction][i] = s.number("n", 0.5) * vary;
  }
}

// its part of a pair, of which it needs nothing
void save(const clay::CfdSession &session)
{
  const std::string folder = session.remoteTerms().pairs, part = clay::unfinishedPair(folder, session.pair()) + "/cfd";
  clay::makeEmpty(part);
  std::ofstream(part + "/nothing") << "of a fluid that does as it is told\n";
  clay::writeSums(part, session.pair());
  clay::completePair(folder, session.pair());
}

void run(const Settings &s)
{
  clay::CfdTerms mine = terms(s);
  clay::RankBoxes boxes{mine.box};
  clay::CfdSession session(mine, boxes);
  clay::Particles got(session.receives()), answer(session.sends());
  nlohmann::json all;
  all["exchanges"] = nlohmann::json::array();
  all["answers"] = session.sends().names();
  while (true) {
    const auto event = session.next(got);
    if (event == clay::CfdSession::Event::closed) break;
    if (event == clay::CfdSession::Event::resumed) {
      answer = clay::Particles(session.sends());
      all["answers"] = session.sends().names();
      continue;
    }
    if (session.pair().number > 0) save(session);
    all["exchanges"].push_back(told(got, session));
    if (all["exchanges"].size() == 3 && s.number("stop", 0) > 0) session.askStop(static_cast<int>(s.number("stop", 0)));
    fill(got, s, answer);
    session.report(0, s.number("late", 0) > 0);
    session.answer(answer, std::vector<char>(got.size(), 1));
  }
  session.close();
  std::ofstream(s.text("out")) << all.dump(1) << '\n';
}

}  // namespace

int main(int argc, char **argv)
{
  clay::World::init(argc, argv);
  int status = 0;
  try {
    run(Settings(argc, argv));
  } catch (const clay::Refusal &refusal) {
    std::cerr << "stand_in_cfd: refused: " << refusal.what() << std::endl;
    status = 1;
  }
  MPI_Finalize();
  return status;
}
