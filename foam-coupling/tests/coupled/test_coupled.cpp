// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
// Runs of both halves that have a known answer.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "coupledRun.h"

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double g = 9.81, rhoP = 2600, rhoF = 1000;

/// Slip of spheres that settle through a void fraction n in a closed column,
/// interstitial, by the balance (rhoP - rhoF) g = beta slip/(n (1 - n)) with
/// Wen and Yu's beta, exponent -2.7 [m/s].
double wenYuSlip(double n, double d, double mu) {
  const double stokes = (rhoP - rhoF) * g * d * d / (18 * mu) * std::pow(n, 3.7);
  double slip = stokes;
  for (int i = 0; i < 300; ++i) {
    const double Re = n * rhoF * slip * d / mu;
    slip = 0.5 * slip + 0.5 * stokes / (1 + 0.15 * std::pow(Re, 0.687));
  }
  return slip;
}

/// A closed column with a uniform suspension, of 4 x 4 staggered columns of
/// spheres, away from floor and lid.
CoupledRun suspension(const std::string& name, double solid, double d, double mu) {
  const int across = 4, high = 40;
  const double a = d * std::cbrt(pi / 6 / solid), width = across * a, height = (high + 4) * a;
  CoupledRun run(name);
  std::ostringstream entries, lo, hi, from, to;
  entries.precision(17);
  entries << "x1 " << width << "; y1 " << width << "; z1 " << height
          << "; nx 1; ny 1; nz 20; sideU slip; nu " << mu / rhoF << ";";
  for (auto* os : {&hi, &from, &to}) os->precision(17);
  hi << width << "," << width << "," << height;
  from << "0,0," << 2 * a;
  to << width << "," << width << "," << (high + 2) * a;
  run.box(entries.str());
  run.dem("hi", hi.str()).dem("from", from.str()).dem("to", to.str());
  run.dem("count", "4,4,40").dem("stagger", 1).dem("radius", d / 2);
  run.dem("gravity", "0,0,-9.81").dem("density", rhoP);
  run.dem("zlo", (2 + 0.25 * high) * a).dem("zhi", (2 + 0.75 * high) * a);
  return run;
}

/// Mean z velocity over the second half of the exchanges.
double meanVelocity(const CoupledRun& run) {
  const auto history = run.history();
  double sum = 0;
  const std::size_t half = history.size() / 2;
  for (std::size_t i = half; i < history.size(); ++i)
    sum += history[i]["velocity"][2].get<double>();
  return sum / static_cast<double>(history.size() - half);
}

void expectBalanced(const CoupledRun& run) {
  const auto cfd = run.cfd();
  EXPECT_LT(cfd["max_momentum_residual"], 1e-10);
  EXPECT_GT(cfd["exchanges"], 1);
  EXPECT_LT(cfd["max_void_fraction_volume_error"], 1e-12);
}

}  // namespace

TEST(SingleSphere, FallsAtTheLawsTerminalVelocity) {
  const double d = 2e-4, mu = 8.94e-4;
  CoupledRun run("single");
  run.box("x1 0.1; y1 0.1; z1 0.1; nx 10; ny 10; nz 10;");
  run.properties("dragModel SchillerNaumann;");
  run.dem("hi", "0.1,0.1,0.1").dem("from", "0.05,0.05,0.05").dem("to", "0.06,0.06,0.06");
  run.dem("radius", d / 2).dem("gravity", "0,0,-9.81").dem("steps", 4000);
  ASSERT_EQ(run.meshAndRun(), 0) << run.log();
  EXPECT_NEAR(-run.lastVelocity() / wenYuSlip(1, d, mu), 1, 2e-3);
  EXPECT_LT(run.cfd()["max_momentum_residual"], 1e-10);
  EXPECT_NEAR(run.cfd()["reynolds_max"].get<double>(), rhoF * wenYuSlip(1, d, mu) * d / mu, 0.05);
}

struct Column {
  const char* name;
  const char* properties;
  double solid, tolerance;
};

class ClosedColumn : public testing::TestWithParam<Column> {};

// v = v_t n^4.7 in the Stokes limit: the return flow and the split of forces
TEST_P(ClosedColumn, SettlesByTheLaw) {
  const auto& p = GetParam();
  const double d = 2e-3, mu = 1, n = 1 - p.solid;
  auto run = suspension(std::string("column-") + p.name, p.solid, d, mu);
  run.properties(p.properties).dem("steps", 2000);
  ASSERT_EQ(run.meshAndRun(), 0) << run.log();
  EXPECT_NEAR(-meanVelocity(run) / (n * wenYuSlip(n, d, mu)), 1, p.tolerance);
  expectBalanced(run);
}

INSTANTIATE_TEST_SUITE_P(
    Ways, ClosedColumn,
    testing::Values(
        Column{"modelA", "", 0.1, 2e-3}, Column{"dense", "", 0.15, 2e-3},
        Column{"modelB", "model B;", 0.1, 2e-3}, Column{"sequential", "overlap no;", 0.1, 2e-3},
        Column{"viscous", "forceModels (pressureGradient viscous buoyancy);", 0.1, 2e-3},
        Column{"cell", "interpolation cell;", 0.1, 2e-3},
        Column{"cellPoint", "interpolation cellPoint;", 0.1, 2e-2},
        Column{"centre", "voidFractionModel centre;", 0.1, 2e-2},
        Column{"divided", "voidFractionModel divided;", 0.1, 2e-2},
        Column{"smoothed", "smoothingModel diffusion; diffusionCoeffs { bandwidth 6e-3; }", 0.1,
               2e-2}),
    [](const auto& info) { return info.param.name; });

TEST(ClosedColumnFine, IsStableWhenDragIsStiff) {
  // relaxation time of these grains: 60 us; coupling interval: 1 ms
  const double d = 2e-5, mu = 1e-3, n = 0.9;
  auto run = suspension("stiff-column", 1 - n, d, mu);
  run.dem("steps", 3000).dem("interval", 100);
  ASSERT_EQ(run.meshAndRun(), 0) << run.log();
  EXPECT_NEAR(-meanVelocity(run) / (n * wenYuSlip(n, d, mu)), 1, 1e-2);
  EXPECT_GT(run.cfd()["stiff_exchanges"], 0);
  EXPECT_FALSE(run.cfd()["warnings"].empty());
  EXPECT_LT(run.cfd()["max_momentum_residual"], 1e-10);
}

struct Limit {
  double massRatio;  ///< of particles to fluid
  double stiffness;  ///< K T/M
  bool overlap;
};

class PeriodicBox : public testing::TestWithParam<Limit> {};

// Particles set off in a fluid at rest: after some intervals both have the
// common velocity if the drag is stiff; momentum is kept in any case
TEST_P(PeriodicBox, KeepsMomentumAndRelaxes) {
  const auto& p = GetParam();
  const double d = 2e-3, solid = 0.1, n = 1 - solid, v0 = 1e-6, T = 1e-3;
  const double a = d * std::cbrt(pi / 6 / solid), width = 4 * a;
  const double density = p.massRatio * rhoF * n / solid;
  // K/M = 18 mu (1 - n) n^-2.7/(d^2 rhoF n)
  const double mu = p.stiffness / T * d * d * rhoF * n / (18 * solid * std::pow(n, -2.7));

  std::ostringstream name, entries, hi;
  name << "periodic-" << p.massRatio << "-" << p.stiffness << (p.overlap ? "-overlap" : "");
  CoupledRun run(name.str());
  entries.precision(17);
  hi.precision(17);
  entries << "x1 " << width << "; y1 " << width << "; z1 " << width << "; nx 2; ny 2; nz 2;"
          << "sideType cyclic; bottomType cyclic; topType cyclic; sideU cyclic; bottomU cyclic;"
          << "topU cyclic; sideP cyclic; bottomP cyclic; topP cyclic; nu " << mu / rhoF << ";";
  hi << width << "," << width << "," << width;
  run.box(entries.str());
  run.properties(std::string("forceModels (); overlap ") + (p.overlap ? "yes;" : "no;"));
  run.dem("hi", hi.str()).dem("wrap", "1,1,1").dem("count", "4,4,4").dem("radius", d / 2);
  run.dem("velocity", "1e-6,0,0").dem("density", density);
  run.dem("step", T / 20).dem("steps", 20 * 40);
  ASSERT_EQ(run.meshAndRun(), 0) << run.log();

  const auto history = run.history();
  const double m = 64 * history[0]["mass"].get<double>();
  const double M = rhoF * (width * width * width - 64 * pi / 6 * d * d * d);
  const double common = m * v0 / (m + M);
  const double v = run.lastVelocity(0), U = run.meanOfField("U")[0];

  // the last interval's difference between foreseen and felt drag is not yet
  // the fluid's: it is kept in couplingImpulse
  const double owed = run.meanOfField("couplingImpulse")[0] * width * width * width;
  EXPECT_NEAR((m * v + M * U + owed) / (m * v0), 1, 1e-8);
  EXPECT_LT(run.cfd()["max_momentum_residual"], 1e-10);

  if (p.stiffness >= 0.5) {
    EXPECT_NEAR(v, common, 0.01 * v0);
    EXPECT_NEAR(U, common, 0.01 * v0);
  }
  // no overshoot: particles and fluid never trade places
  for (const auto& state : history) {
    EXPECT_GT(state["velocity"][0].get<double>(), common - 0.02 * v0);
    EXPECT_LT(state["velocity"][0].get<double>(), v0 * (1 + 1e-9));
  }
  if (p.stiffness < 0.01) {
    // slow exchange: the exact solution of the pair
    const double kM = p.stiffness / T, rate = kM * (1 + 1 / p.massRatio), time = 40 * T;
    EXPECT_NEAR(v, common + (v0 - common) * std::exp(-rate * time), 0.02 * v0);
  }
}

INSTANTIATE_TEST_SUITE_P(Limits, PeriodicBox,
                         testing::Values(Limit{0.01, 1e-4, true}, Limit{0.01, 0.1, true},
                                         Limit{0.01, 1e4, true}, Limit{1, 1e-3, true},
                                         Limit{1, 1, true}, Limit{1, 1e4, true}, Limit{1, 1, false},
                                         Limit{100, 1e-3, true}, Limit{100, 0.1, true},
                                         Limit{100, 1, true}, Limit{100, 1e4, true},
                                         Limit{100, 1e4, false}));

// Spheres that move through the middle of a periodic box: what they lose, the
// fluid's n U gains, although n varies in space and time. n U is summed up from
// the written fields
TEST(MovingCloud, KeepsMomentumOfParticlesAndFluid) {
  const double v0[] = {0.05, 0, 0.03}, volume = 0.04 * 0.04 * 0.04;
  CoupledRun run("moving-cloud");
  run.box(
      "x1 0.04; y1 0.04; z1 0.04; nx 8; ny 8; nz 8; sideType cyclic; bottomType cyclic;"
      "topType cyclic; sideU cyclic; bottomU cyclic; topU cyclic; sideP cyclic;"
      "bottomP cyclic; topP cyclic; nu 1e-6; deltaT 2e-4;");
  run.properties("forceModels (pressureGradient); voidFractionModel exactOverlap;");
  run.dem("hi", "0.04,0.04,0.04").dem("wrap", "1,1,1").dem("density", rhoP);
  run.dem("from", "0.01,0.01,0.01").dem("to", "0.03,0.03,0.03").dem("count", "6,6,6");
  run.dem("radius", 1e-3).dem("velocity", "0.05,0,0.03");
  run.dem("step", 1e-5).dem("steps", 2000).dem("interval", 20);
  ASSERT_EQ(run.meshAndRun(), 0) << run.log();

  const double m = 216 * run.history()[0]["mass"].get<double>();
  const auto n = run.scalars("voidfraction");
  const auto U = run.values("U");
  const auto owed = run.meanOfField("couplingImpulse");
  ASSERT_EQ(n.size(), 512u);
  ASSERT_EQ(U.size(), 512u);
  EXPECT_LT(*std::min_element(n.begin(), n.end()), 0.95);
  for (std::size_t c : {0u, 2u}) {
    double fluid = 0;
    for (std::size_t i = 0; i < n.size(); ++i) fluid += rhoF * n[i] * U[i][c] * volume / 512;
    const double particles = m * run.lastVelocity(static_cast<int>(c));
    EXPECT_GT(fluid, 0.01 * m * v0[c]);
    EXPECT_NEAR((particles + fluid + owed[c] * volume) / (m * v0[c]), 1, 1e-8);
  }
  expectBalanced(run);
}

// Spheres at rest, half as large as a cell, next to clear fluid: they can only
// brake a flow
TEST(Bed, BrakesTheFluid) {
  auto run = CoupledRun("bed");
  run.box("x1 0.04; y1 0.04; z1 0.05; nx 10; ny 10; nz 5; U0 (0.1 0 0.1);");
  run.dem("hi", "0.04,0.04,0.05").dem("from", "0,0,0").dem("to", "0.04,0.04,0.023");
  run.dem("count", "17,17,10").dem("frozen", 1).dem("gravity", "0,0,-9.81").dem("steps", 12000);
  ASSERT_EQ(run.meshAndRun(), 0) << run.log();
  double below = 0, above = 0;
  const auto U = run.values("U");
  ASSERT_EQ(U.size(), 500u);
  for (std::size_t i = 0; i < U.size(); ++i) {
    const double speed = std::hypot(U[i][0], U[i][1], U[i][2]);
    (i < 200 ? below : above) = std::max(i < 200 ? below : above, speed);
  }
  EXPECT_LT(below, 0.02);
  EXPECT_LT(above, 0.1);
  expectBalanced(run);
}

TEST(Parallel, TwoRanksGiveTheSameAsOne) {
  double v[3];
  for (int cfd : {1, 2}) {
    auto run = suspension("ranks-" + std::to_string(cfd), 0.1, 2e-3, 8.94e-4);
    run.box("nx 2; ny 2;").ranks(cfd, cfd).dem("steps", 1000).dem("velocity", "0.01,0,0");
    ASSERT_EQ(run.meshAndRun(), 0) << run.log();
    v[cfd] = run.lastVelocity();
    expectBalanced(run);
  }
  EXPECT_NEAR(v[2] / v[1], 1, 1e-6);
}
