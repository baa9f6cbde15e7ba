// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file test_terms.cpp
/// Fields, the terms as text, and what makes the halves refuse.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "exchange/handshake.h"
#include "exchange/packing.h"
#include "exchange/routing.h"
#include "exchange/terms.h"
#include "exchange/test_halves.h"

using clay::CfdTerms;
using clay::DemTerms;
using clay::Field;
using clay::FieldSet;
using clay::Particles;

namespace {

testing::AssertionResult says(const std::string& line, const std::string& part) {
  if (line.find(part) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "no '" << part << "' in '" << line << "'";
}

TEST(Fields, HaveNamesAndWidths) {
  const FieldSet set{Field::position, Field::tag, Field::force};
  EXPECT_EQ(set.width(), 7);
  EXPECT_EQ(set.names(), (std::vector<std::string>{"position", "tag", "force"}));
  EXPECT_EQ(FieldSet::fromNames(set.names()), set);
  EXPECT_THROW(FieldSet::fromNames({"colour"}), std::invalid_argument);
  for (unsigned i = 0; i < clay::fieldCount; ++i) {
    const auto f = static_cast<Field>(i);
    EXPECT_EQ(FieldSet::fromNames({clay::name(f)}), FieldSet{f});
  }
}

TEST(Fields, DifferAsSets) {
  const FieldSet a{Field::position, Field::radius}, b{Field::radius};
  EXPECT_EQ(a.without(b), FieldSet{Field::position});
  EXPECT_TRUE(b.without(a).empty());
}

TEST(ParticleList, KeepsWhatItHoldsWhenItGrows) {
  Particles p({Field::position, Field::radius});
  p.resize(2);
  p[Field::position][5] = 3;
  p[Field::radius][1] = 4;
  p.resize(100);
  EXPECT_EQ(p.size(), 100);
  EXPECT_EQ(p[Field::position][5], 3);
  EXPECT_EQ(p[Field::radius][1], 4);
  p.clear();
  EXPECT_EQ(p.size(), 0);
}

TEST(ParticleList, FindsTheFirstValueThatItsFieldCannotHave) {
  Particles p({Field::position, Field::radius, Field::tag, Field::body, Field::touched});
  p.resize(5);
  EXPECT_EQ(clay::firstAstray(p).particle, -1);
  p[Field::radius][3] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(clay::firstAstray(p).particle, 3);
  EXPECT_EQ(clay::firstAstray(p).field, Field::radius);
  p[Field::position][3 * 2 + 1] = std::nan("");
  EXPECT_EQ(clay::firstAstray(p).particle, 2);
  EXPECT_EQ(clay::firstAstray(p).field, Field::position);
  EXPECT_EQ(clay::describe(clay::firstAstray(p), p, p),
            "particle 0 at (0 nan 0) m: position is (0 nan 0)");

  const double sound[] = {1e99, 0, 2147483647, -1, 1};
  const Field fields[] = {Field::position, Field::radius, Field::tag, Field::body, Field::touched};
  const std::vector<double> unsound[] = {
      {-1e100, 1e300}, {-1e-300}, {-1, 0.5, 2147483648., 1e18}, {-2, 0.5, 1e18}, {2, -1, 0.5}};
  for (int k = 0; k < 5; ++k) {
    Particles q({fields[k]});
    q.resize(2);
    q[fields[k]][0] = sound[k];
    EXPECT_EQ(clay::firstAstray(q).particle, -1) << clay::name(fields[k]);
    for (double x : unsound[k]) {
      q[fields[k]][0] = x;
      EXPECT_EQ(clay::firstAstray(q).particle, 0) << clay::name(fields[k]) << ' ' << x;
    }
  }
}

// Places come first, then each field of those that are owned, then the room.
TEST(Packing, TakesWhatIsOwnedFromFirstOn) {
  const FieldSet set{Field::fluidVelocity, Field::dragCoefficient};
  for (const bool all : {true, false}) {
    Particles answers(set);
    answers.resize(5);
    for (int i = 0; i < 5; ++i) {
      answers[Field::dragCoefficient][i] = i;
      for (int c = 0; c < 3; ++c) answers[Field::fluidVelocity][3 * i + c] = 10 * i + c;
    }
    const std::vector<char> owned{0, 1, static_cast<char>(all), 1, 0};
    std::vector<double> message(100, 7.0);
    packAnswers(answers, owned, set, 1, 3, 2, message);
    const std::vector<double> places =
        all ? std::vector<double>{0, 1, 2} : std::vector<double>{0, 2};
    ASSERT_EQ(message.size(), places.size() * 5 + 2);
    const double* m = message.data();
    for (const double i : places) EXPECT_EQ(*m++, i);
    for (const double i : places) EXPECT_EQ(*m++, i + 1);
    for (const double i : places)
      for (int c = 0; c < 3; ++c) EXPECT_EQ(*m++, 10 * (i + 1) + c);

    if (all) {
      Particles back(set);
      back.resize(4);
      const double* end = unpackFields(message.data() + 3, set, 3, back, 1);
      EXPECT_EQ(end, message.data() + 3 + 12);
      EXPECT_EQ(back[Field::dragCoefficient][3], 3);
      EXPECT_EQ(back[Field::fluidVelocity][5], 12);
    }
  }
}

TEST(BoxTest, IsReachedBySpheresThatTouchIt) {
  const clay::Box box = halves::meshBox();
  const double inside[] = {0.5, 0.2, 0.2}, beside[] = {1.1, 0.2, 0.2};
  EXPECT_TRUE(box.reaches(inside, 0.01));
  EXPECT_FALSE(box.reaches(beside, 0.09));
  EXPECT_TRUE(box.reaches(beside, 0.11));
  EXPECT_FALSE(clay::Box().reaches(inside, 1)) << "a rank without cells";
}

TEST(Routes, GoToEveryBoxThatIsTouchedOrToTheNearest) {
  clay::Routing routing({{halves::slab(0, 2)}, {clay::Box()}, {halves::slab(1, 2)}});
  const double x[] = {0.1, 0.2, 0.2, /**/ 0.495, 0.2, 0.2, /**/ 3, 0.2, 0.2};
  const double r[] = {0.01, 0.01, 0.01};
  for (int again = 0; again < 2; ++again) {
    routing.route(x, r, 3);
    EXPECT_EQ(routing[0].particles, (std::vector<int>{0, 1}));
    EXPECT_EQ(routing[0].shares, (std::vector<double>{1, 2, 0, 2}));
    EXPECT_TRUE(routing[1].particles.empty()) << "a rank without cells";
    EXPECT_EQ(routing[2].particles, (std::vector<int>{1, 2}));
    EXPECT_EQ(routing[2].shares, (std::vector<double>{0, 2, 0, 2}));
  }
  routing.route(x, r, 0);
  EXPECT_TRUE(routing[0].particles.empty() && routing[2].particles.empty());
}

TEST(Routes, GoToRanksThatAreReachedByAnImage) {
  // periodic in x with length 1: the last rank takes what reaches through x = 0
  clay::Box before = halves::slab(1, 2);
  for (double* x : {&before.lo[0], &before.hi[0]}) *x -= 1;
  clay::Routing routing({{halves::slab(0, 2)}, {halves::slab(1, 2), before}});
  const double x[] = {0.005, 0.2, 0.2, /**/ 0.1, 0.2, 0.2, /**/ 0.5, 0.2, 0.2, /**/ -7, 0.2, 0.2};
  const double r[] = {0.01, 0.01, 0.01, 0.01};
  routing.route(x, r, 4);
  // the one nowhere goes to the rank whose cells are nearest
  EXPECT_EQ(routing[0].particles, (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(routing[1].particles, (std::vector<int>{0, 2}));
  EXPECT_EQ(routing[1].shares, (std::vector<double>{0, 2, 0, 1, /**/ 1, 2, 0, 1}));
}

TEST(Text, BringsTheDemTermsBackBitByBit) {
  DemTerms t = halves::demTerms();
  t.program = "a \"quoted\" name \xff";
  t.step = 1. / 3e5;
  t.endTime = 0.1 + 0.2;
  t.brings = {Field::dragFactor};
  t.periodic = {{true, false, true}};
  t.clumpDrag = "resistance";
  t.bodyDiameter = 1. / 7;
  const DemTerms u = clay::decodeDem(clay::encode(t));
  EXPECT_EQ(u.step, t.step);
  EXPECT_EQ(u.interval, t.interval);
  EXPECT_EQ(u.startTime, t.startTime);
  EXPECT_EQ(u.endTime, t.endTime);
  EXPECT_EQ(u.gravity, t.gravity);
  EXPECT_EQ(u.hasGravity, t.hasGravity);
  EXPECT_EQ(u.box.lo, t.box.lo);
  EXPECT_EQ(u.box.hi, t.box.hi);
  EXPECT_EQ(u.periodic, t.periodic);
  EXPECT_EQ(u.particles, t.particles);
  EXPECT_EQ(u.maxRadius, t.maxRadius);
  EXPECT_EQ(u.bodyDiameter, t.bodyDiameter);
  EXPECT_EQ(u.offers, t.offers);
  EXPECT_EQ(u.brings, t.brings);
  EXPECT_EQ(u.needs, t.needs);
  EXPECT_EQ(u.clumpDrag, t.clumpDrag);
}

TEST(Text, BringsTheCfdTermsBackWithWhatIsNotStated) {
  CfdTerms t = halves::cfdTerms();
  t.gravity = {{0, 0, -9.81}};
  t.overlap = false;
  t.buoyancy = true;
  t.open = {{false, true, false, false, true, false}};
  t.period = {{0.3, 0, -1}};
  t.accepts = {Field::dragDiameter, Field::dragFactor};
  const CfdTerms u = clay::decodeCfd(clay::encode(t));
  EXPECT_FALSE(u.endTime.has_value());
  EXPECT_FALSE(u.couplingInterval.has_value());
  ASSERT_TRUE(u.gravity.has_value());
  EXPECT_EQ(*u.gravity, *t.gravity);
  EXPECT_FALSE(u.overlap);
  EXPECT_TRUE(u.buoyancy);
  EXPECT_EQ(u.open, t.open);
  EXPECT_EQ(u.period, t.period);
  EXPECT_EQ(u.fluidDensity, t.fluidDensity);
  EXPECT_EQ(u.fluidViscosity, t.fluidViscosity);
  EXPECT_EQ(u.needs, t.needs);
  EXPECT_EQ(u.accepts, t.accepts);
  t.endTime = 0.7;
  t.couplingInterval = 2e-4;
  const CfdTerms v = clay::decodeCfd(clay::encode(t));
  EXPECT_EQ(v.endTime, t.endTime);
  EXPECT_EQ(v.couplingInterval, t.couplingInterval);
}

TEST(Text, OfTheWrongHalfOrOfNoHalfIsRefused) {
  EXPECT_THROW(clay::decodeDem(clay::encode(halves::cfdTerms())), clay::Refusal);
  EXPECT_THROW(clay::decodeCfd(clay::encode(halves::demTerms())), clay::Refusal);
  EXPECT_THROW(clay::decodeDem("hello"), clay::Refusal);
  EXPECT_THROW(
      clay::decodeDem("{\"half\":\"DEM\",\"wire\":" + std::to_string(clay::wireVersion) + "}"),
      clay::Refusal);
}

TEST(Text, KeepsAValueThatIsNoNumber) {
  DemTerms t = halves::demTerms();
  t.step = std::nan("");
  EXPECT_TRUE(std::isnan(clay::decodeDem(clay::encode(t)).step));
  EXPECT_TRUE(says(clay::disagreement(t, halves::cfdTerms()), "time step"));
}

// A pair of terms that fits, one of which each test spoils
class Agreement : public testing::Test {
 protected:
  DemTerms dem = halves::demTerms();
  CfdTerms cfd = halves::cfdTerms();
  std::string line() const { return clay::disagreement(dem, cfd); }
};

TEST_F(Agreement, Fits) {
  EXPECT_EQ(line(), "");
  EXPECT_TRUE(clay::warnings(dem, cfd).empty());
  dem.particles = 0;
  EXPECT_EQ(line(), "") << "particles may come later";
  cfd.endTime = dem.endTime + 0.4 * dem.step;
  cfd.couplingInterval = 2e-4;
  cfd.gravity = dem.gravity;
  EXPECT_EQ(line(), "");
}

TEST_F(Agreement, OfVersions) {
  cfd.wire = clay::wireVersion + 1;
  EXPECT_TRUE(says(line(), std::to_string(clay::wireVersion) + " in the DEM half (test DEM), " +
                               std::to_string(clay::wireVersion + 1) +
                               " in the CFD half (test CFD)"));
  EXPECT_TRUE(says(clay::disagreement(dem, clay::decodeCfd(clay::encode(cfd))), "versions"));
}

TEST_F(Agreement, OfStartTimes) {
  cfd.startTime = 0.6 * dem.step;
  EXPECT_TRUE(says(line(), "start times differ: 0 s in the DEM half, 6e-06 s in the CFD half"));
}

TEST_F(Agreement, OfEndTimes) {
  cfd.endTime = dem.endTime + 0.6 * dem.step;
  EXPECT_TRUE(
      says(line(), "end times differ: 0.001 s in the DEM half, 0.001006 s in the CFD half"));
}

TEST_F(Agreement, OfIntervals) {
  cfd.couplingInterval = 1e-4;
  EXPECT_TRUE(says(line(),
                   "coupling intervals differ: 0.0002 s (20 steps of 1e-05 s) in the "
                   "DEM half, 0.0001 s in the CFD half"));
}

TEST_F(Agreement, OfGravities) {
  cfd.gravity = {{0, -9.81, 0}};
  EXPECT_TRUE(says(line(), "gravities differ: (0 0 -9.81) m/s2 in the DEM half, (0 -9.81 0)"));
  dem.hasGravity = false;
  EXPECT_EQ(line(), "");
  ASSERT_EQ(clay::warnings(dem, cfd).size(), 1u);
  EXPECT_TRUE(says(clay::warnings(dem, cfd)[0], "no gravity"));
}

TEST_F(Agreement, OfPeriods) {
  const double length = dem.box.hi[1] - dem.box.lo[1];
  dem.periodic = {{false, true, false}};
  EXPECT_EQ(line(), "") << "the CFD half does not state any";
  cfd.period = {{0, length, 0}};
  EXPECT_EQ(line(), "");
  EXPECT_TRUE(clay::warnings(dem, cfd).empty());
  cfd.period = {{0, -1, 0}};
  EXPECT_EQ(line(), "") << "nothing flows along y";
  cfd.period = {{0, 0, 0}};
  EXPECT_TRUE(says(
      line(), "the DEM box is periodic along y with 0.5 m, the mesh has no cyclic patches there"));
  cfd.period = {{0, 0.75 * length, 0}};
  EXPECT_TRUE(says(line(), "the DEM box is periodic along y with 0.5 m, the mesh with 0.375 m"));
  dem.periodic = {};
  EXPECT_EQ(line(), "");
  ASSERT_EQ(clay::warnings(dem, cfd).size(), 1u);
  EXPECT_TRUE(says(clay::warnings(dem, cfd)[0],
                   "the mesh is cyclic along y, the DEM box is not periodic there"));
}

TEST_F(Agreement, OfPlaces) {
  for (double& x : cfd.box.lo) x += 5;
  for (double& x : cfd.box.hi) x += 5;
  EXPECT_TRUE(says(line(),
                   "the DEM box (0 0 0) to (1 0.5 0.5) m and the mesh (5 5 5) to "
                   "(6 5.5 5.5) m do not overlap"));
  EXPECT_EQ(line().find("millimetres"), std::string::npos);
}

TEST_F(Agreement, OfUnits) {
  for (double& x : cfd.box.lo) x = 1000 * (x + 5);
  for (double& x : cfd.box.hi) x = 1000 * (x + 5);
  EXPECT_TRUE(says(line(), "is the mesh in millimetres?"));
  for (double& x : cfd.box.lo) x -= 5000;
  for (double& x : cfd.box.hi) x -= 5000;
  EXPECT_TRUE(says(line(), "m differ too much in size; is the mesh in millimetres?"));
  for (double& x : cfd.box.lo) x /= 100;
  for (double& x : cfd.box.hi) x /= 100;
  EXPECT_EQ(line(), "");
}

TEST_F(Agreement, OfTheSavedStates) {
  dem.pair = cfd.pair = 9007199254740991.;
  EXPECT_EQ(line(), "");
  EXPECT_EQ(clay::decodeDem(clay::encode(dem)).pair, dem.pair);
  EXPECT_EQ(clay::decodeCfd(clay::encode(cfd)).pair, cfd.pair);
  cfd.pair = 9007199254740989.;
  EXPECT_TRUE(says(line(),
                   "the DEM half goes on from the saved pair 9007199254740991, the CFD "
                   "half from the saved pair 9007199254740989"));
  cfd.pair = 0;
  EXPECT_TRUE(says(line(), "the CFD half from no saved pair"));
}

TEST_F(Agreement, OfFields) {
  cfd.needs.add(Field::impulse);
  EXPECT_EQ(line(), "");
  dem.offers = dem.offers.without({Field::impulse, Field::mass});
  cfd.needs.add(Field::mass);
  EXPECT_TRUE(says(line(), "the CFD half needs impulse, mass, the DEM half offers only position"));
  cfd = halves::cfdTerms();
  cfd.offers = {Field::dragCoefficient};
  EXPECT_TRUE(
      says(line(), "the DEM half needs fluidVelocity, the CFD half offers only dragCoefficient"));
}

TEST_F(Agreement, OfFieldsThatAreBrought) {
  dem.brings = {Field::dragDiameter, Field::dragFactor};
  EXPECT_TRUE(says(line(), "brings dragDiameter, dragFactor, which the CFD half has no use for"));
  cfd.accepts = {Field::dragFactor};
  EXPECT_TRUE(says(line(), "no use for; it accepts only dragFactor"));
  cfd.accepts.add(Field::dragDiameter);
  EXPECT_EQ(line(), "");
  clay::FieldSet all = cfd.needs;
  all.add(Field::dragDiameter);
  all.add(Field::dragFactor);
  EXPECT_EQ(clay::stateFields({dem, cfd}), all);
}

TEST_F(Agreement, NeedsSoundNumbers) {
  dem.interval = 0;
  EXPECT_TRUE(says(line(), "coupling interval is 0 steps; it must be 1 or more"));
  dem = halves::demTerms();
  dem.step = -1;
  EXPECT_TRUE(says(line(), "time step is -1 s; it must be above 0"));
  dem = halves::demTerms();
  dem.particles = -1;
  EXPECT_TRUE(says(line(), "holds -1 particles"));
  dem = halves::demTerms();
  dem.endTime = -1;
  EXPECT_TRUE(says(line(), "ends at -1 s, before its start at 0 s"));
  dem = halves::demTerms();
  cfd.fluidDensity = 0;
  EXPECT_TRUE(says(line(), "fluid density is 0 kg/m3; it must be above 0"));
  cfd = halves::cfdTerms();
  cfd.fluidViscosity = -1;
  EXPECT_TRUE(says(line(), "fluid viscosity is -1 Pa s"));
}

TEST_F(Agreement, DecidesWhatIsSent) {
  const clay::BothTerms both{dem, cfd};
  EXPECT_EQ(clay::stateFields(both), cfd.needs);
  EXPECT_EQ(clay::answerFields(both), cfd.offers) << "the force comes along when it is offered";
  cfd.offers = {Field::dragCoefficient, Field::fluidVelocity};
  EXPECT_EQ(clay::answerFields({dem, cfd}), cfd.offers);
  cfd.offers.add(Field::addedMass);
  cfd.offers.add(Field::turnCoefficient);
  cfd.offers.add(Field::fluidSpin);
  EXPECT_EQ(clay::answerFields({dem, cfd}), cfd.offers) << "what a model adds comes along";
  cfd.needs.add(Field::spin);
  EXPECT_TRUE(clay::stateFields({dem, cfd}).has(Field::spin));
}

}  // namespace
