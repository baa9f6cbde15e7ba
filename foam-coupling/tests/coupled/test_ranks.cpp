// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
// The same on two ranks of the CFD half, one of which holds no particles, as on
// one: no collective call stands behind what a rank alone can see.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "coupledRun.h"

namespace {

/// A column cut across its middle, with spheres in its upper half only.
CoupledRun column(const std::string& name, int ranks) {
  CoupledRun run(name + "-" + std::to_string(ranks));
  run.box(
      "x1 0.02; y1 0.02; z1 0.08; nx 4; ny 4; nz 16; topType patch; topU zeroGradient;"
      "topP fixedValue; nu 1e-4;");
  for (const char* from : {"1e-10", "0.01;"})
    run.edit("system/fvSolution", from, std::string(from) == "0.01;" ? "0;" : "1e-14");
  run.dem("hi", "0.02,0.02,0.08").dem("from", "0,0,0.05").dem("to", "0.02,0.02,0.07");
  run.dem("count", "4,4,4").dem("stagger", 1).dem("gravity", "0.3,0,-9.81");
  run.dem("steps", 400).ranks(1, ranks);
  return run;
}

struct Way {
  const char* name;
  const char* properties;
  const char* box;
};

class RankWithoutParticles : public testing::TestWithParam<Way> {};

}  // namespace

TEST_P(RankWithoutParticles, GivesTheSameAsOneRank) {
  const auto& way = GetParam();
  double v[3] = {}, sideways[3] = {};
  for (int ranks : {1, 2}) {
    auto run = column(way.name, ranks);
    run.properties(std::string("quietFluid 0; ") + way.properties).box(way.box);
    ASSERT_EQ(run.meshAndRun(), 0) << run.log();
    v[ranks] = run.lastVelocity();
    sideways[ranks] = run.lastVelocity(0);
    EXPECT_EQ(run.cfd()["exchanges"], 21);
    EXPECT_LT(run.cfd()["max_momentum_residual"], 1e-10);
  }
  EXPECT_LT(v[1], -1e-3);
  EXPECT_NEAR(v[2] / v[1], 1, 1e-9);
  EXPECT_NEAR(sideways[2] / sideways[1], 1, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(
    Ways, RankWithoutParticles,
    testing::Values(
        Way{"plain", "", ""},
        Way{"smoothedAddedMass",
            "forceModels (pressureGradient buoyancy addedMass); smoothingModel diffusion;"
            "diffusionCoeffs { bandwidth 0.01; }",
            ""},
        Way{"allForces",
            "forceModels (pressureGradient viscous buoyancy addedMass saffmanMei);"
            "interpolation cellPoint;",
            ""},
        Way{"ownDisturbance", "selfDisturbance latticeMemory; voidFractionModel divided;", ""},
        // the upper rank holds no face of the floor, the lower none of the lid; at the sides the
        // spheres' force reaches the wall
        Way{"fluxPressure", "", "bottomP fixedFluxPressure; sideP fixedFluxPressure;"}),
    [](const auto& info) { return info.param.name; });

/// A box, periodic along all axes, with a lattice of spheres that drift through
/// its sides while they are pulled along.
CoupledRun periodicBox(const std::string& name, int ranks, const std::string& cut) {
  CoupledRun run(name + "-" + std::to_string(ranks));
  run.box(
      "x1 0.04; y1 0.04; z1 0.04; nx 8; ny 8; nz 8; sideType cyclic; bottomType cyclic;"
      "topType cyclic; sideU cyclic; bottomU cyclic; topU cyclic; sideP cyclic;"
      "bottomP cyclic; topP cyclic; nu 1e-5;");
  for (const char* from : {"1e-10", "0.01;"})
    run.edit("system/fvSolution", from, std::string(from) == "0.01;" ? "0;" : "1e-14");
  run.edit("system/decomposeParDict", "numberOfSubdomains  2;",
           "numberOfSubdomains  " + std::to_string(ranks) + ";");
  run.edit("system/decomposeParDict", "(1 1 2)", cut);
  run.dem("hi", "0.04,0.04,0.04").dem("wrap", "1,1,1").dem("density", 2600);
  run.dem("count", "5,5,5").dem("radius", 2e-3).dem("velocity", "0.9,0.7,-0.8");
  run.dem("step", 1e-5).dem("steps", 400).dem("interval", 20).ranks(1, ranks);
  return run;
}

// spheres that reach through periodic sides count on the rank behind them
TEST(PeriodicSides, CutUpOverRanksGiveTheSame) {
  const char* cuts[] = {"", "(1 1 1)", "(1 1 2)", "", "(1 2 2)"};
  double v[5][3];
  for (int ranks : {1, 2, 4}) {
    auto run = periodicBox("periodic", ranks, cuts[ranks]);
    run.properties("quietFluid 0; forceModels (pressureGradient);");
    ASSERT_EQ(run.meshAndRun(), 0) << run.log();
    for (int c = 0; c < 3; ++c) v[ranks][c] = run.lastVelocity(c);
    EXPECT_LT(run.cfd()["max_void_fraction_volume_error"], 1e-12);
    EXPECT_LT(run.cfd()["max_momentum_residual"], 1e-10);
  }
  for (int c = 0; c < 3; ++c) {
    EXPECT_GT(std::abs(v[1][c] - (c == 0 ? 0.9 : c == 1 ? 0.7 : -0.8)), 1e-3);
    EXPECT_NEAR(v[2][c] / v[1][c], 1, 1e-9);
    EXPECT_NEAR(v[4][c] / v[1][c], 1, 1e-9);
  }
}

namespace {

/// The values of a written scalar field, of all ranks' folders, in ascending order.
std::vector<double> ascending(const CoupledRun& run, int ranks, const std::string& file) {
  std::vector<double> all;
  for (int rank = 0; rank < ranks; ++rank) {
    const auto folder = ranks > 1 ? run.path() / ("processor" + std::to_string(rank)) : run.path();
    std::ifstream is(folder / file);
    std::string word;
    while (is >> word && word != "List<scalar>") continue;
    std::size_t count = 0;
    char opening;
    is >> count >> opening;
    for (double x; count > 0 && is >> x; --count) all.push_back(x);
  }
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

// decomposePar leaves the mean of both sides on periodic sides that it parts; a
// state of one rank goes on from there on two as on one, its turbulence too
TEST(PeriodicSides, AStateOfOneRankGoesOnOnTwo) {
  const auto start = [](const std::string& name) {
    auto run = periodicBox(name, 1, "(2 1 1)");
    run.properties("quietFluid 0; forceModels (pressureGradient addedMass);");
    run.edit("constant/turbulenceProperties", "laminar;",
             "LES; LES { LESModel kEqn; turbulence on; delta cubeRootVol;"
             " cubeRootVolCoeffs { deltaCoeff 1; } }");
    run.edit("system/fvSchemes", "default                         none;",
             "default none; div(phi,k) Gauss limitedLinear 1;");
    run.edit("system/fvSolution", "\"(U|UFinal)\"", "\"(U|UFinal|k|kFinal)\"");
    for (const std::string field : {"k", "nut"}) {
      const std::string value = field == "k" ? "1e-3" : "1e-5";
      const std::string dims = field == "k" ? "[0 2 -2 0 0 0 0]" : "[0 2 -1 0 0 0 0]";
      std::ofstream(run.path() / "0" / field)
          << "FoamFile { version 2.0; format ascii; class volScalarField; object " << field
          << "; } dimensions " << dims << "; internalField uniform " << value
          << "; boundaryField { \".*\" { type cyclic; } }\n";
    }
    return run;
  };
  double v[3][3] = {};
  std::vector<double> k[3];
  for (int ranks : {1, 2}) {
    auto run = start("periodic-state-" + std::to_string(ranks));
    const std::string state = (run.path() / "spheres").string();
    run.dem("save", state);
    ASSERT_EQ(run.meshAndRun(), 0) << run.log();
    run.dem("load", state).dem("start", 0.004).dem("steps", 100);
    run.edit("system/decomposeParDict", "numberOfSubdomains  1;", "numberOfSubdomains  2;");
    run.ranks(1, ranks);
    if (ranks > 1) run.mesh();
    ASSERT_EQ(run.run(), 0) << run.log();
    for (int c = 0; c < 3; ++c) v[ranks][c] = run.lastVelocity(c);
    k[ranks] = ascending(run, ranks, "0.005/k");
    ASSERT_EQ(k[ranks].size(), 512u);
  }
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(v[2][c] / v[1][c], 1, 1e-10);
  EXPECT_GT(k[1].back() / k[1].front(), 1.01);
  for (std::size_t i = 0; i < 512; ++i) EXPECT_NEAR(k[2][i] / k[1][i], 1, 1e-10);
}

TEST(SavedState, OnOneRankOnlyIsRefused) {
  auto run = column("half-saved", 2);
  const std::string state = (run.path() / "spheres").string();
  run.dem("save", state);
  ASSERT_EQ(run.meshAndRun(), 0) << run.log();
  run.dem("load", state).dem("start", 0.004);
  ASSERT_TRUE(std::filesystem::remove(run.path() / "processor1" / "0.004" / "gradp"));
  ASSERT_NE(run.run(), 0);
  EXPECT_NE(run.log().find("field gradp of time 0.004 is there in some processor folders only"),
            std::string::npos)
      << run.log();
}
