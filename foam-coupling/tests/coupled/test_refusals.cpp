// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
// Input that cannot work ends both halves with one clear line; a run that was
// cut in two gives what one run gives.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>

#include "coupledRun.h"

namespace {

int count(const std::string& text, const std::string& part) {
  int n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

struct Bad {
  const char* name;
  const char* properties;
  const char* line;
};

class Dictionary : public testing::TestWithParam<Bad> {};

}  // namespace

TEST_P(Dictionary, IsRefused) {
  const auto& p = GetParam();
  auto run = smallColumn(std::string("bad-") + p.name);
  run.properties(p.properties);
  ASSERT_NE(run.meshAndRun(), 0);
  EXPECT_TRUE(run.says(p.line)) << run.log();
  EXPECT_FALSE(std::filesystem::exists(run.path() / "cfd.json"));
}

INSTANTIATE_TEST_SUITE_P(
    All, Dictionary,
    testing::Values(
        Bad{"entry", "dragModell ergunWenYu;",
            "unknown entry dragModell; the nearest known one is dragModel"},
        Bad{"coeffs", "ergunWenYCoeffs {}", "the nearest known one is ergunWenYuCoeffs"},
        Bad{"unselected", "dragModel DiFelice; ergunWenYuBlendedCoeffs { width 0.1; }",
            "unknown entry ergunWenYuBlendedCoeffs; dragModel is DiFelice"},
        Bad{"drag", "dragModel ergunWenYuBlend;",
            "WenYu ergunWenYu ergunWenYuBlended); the nearest one is ergunWenYuBlended"},
        Bad{"void", "voidFractionModel exact;", "voidFractionModel exact is not known"},
        Bad{"model", "model C;", "model C is not known; known are (A B)"},
        Bad{"force", "forceModels (lift buoyancy);", "lift is not known"},
        Bad{"twice", "forceModels (buoyancy pressureGradient buoyancy);", "lists buoyancy twice"},
        Bad{"modelB", "model B; forceModels (pressureGradient buoyancy);", "model is B"},
        Bad{"buoyancy", "forceModels (pressureGradient);", "lacks buoyancy"},
        Bad{"ddt", "ddtVoidFraction sometimes;", "ddtVoidFraction sometimes is not known"},
        Bad{"min", "voidFractionMin 1.5;", "voidFractionMin 1.5 must lie between 0 and 1"},
        Bad{"interval", "couplingInterval 3e-4;", "coupling intervals differ"},
        Bad{"switch", "overlap perhaps;",
            "Expected 'true/false', 'on/off' ... found perhaps [couplingProperties.overlap]"}),
    [](const auto& info) { return info.param.name; });

TEST(Refusal, TransportWithoutDensity) {
  auto run = smallColumn("no-rho");
  run.edit("constant/transportProperties", "rho             $rho;", "rho 0;");
  ASSERT_NE(run.meshAndRun(), 0);
  EXPECT_TRUE(run.says("clayFoam: refused: rho 0 must be above 0")) << run.log();
}

TEST(Refusal, EndTimesThatDiffer) {
  auto run = smallColumn("end-time");
  run.edit("system/controlDict", "startTime       0;", "startTime       0;\nendTime         1;");
  ASSERT_NE(run.meshAndRun(), 0);
  EXPECT_TRUE(run.says("clayFoam: refused: the end times differ")) << run.log();
  EXPECT_EQ(count(run.log(), "clayFoam: refused:"), 1) << run.log();
}

TEST(Refusal, IsSaidOnceByTwoRanks) {
  auto run = smallColumn("end-time-parallel");
  run.edit("system/controlDict", "startTime       0;", "startTime       0;\nendTime         1;");
  run.ranks(1, 2);
  ASSERT_NE(run.meshAndRun(), 0);
  EXPECT_EQ(count(run.log(), "clayFoam: refused:"), 1) << run.log();
}

TEST(Refusal, OneOfTwoRanksSpeaksForABadDictionary) {
  auto run = smallColumn("bad-parallel");
  run.properties("dragModell ergunWenYu;").ranks(2, 2);
  ASSERT_NE(run.meshAndRun(), 0);
  EXPECT_TRUE(run.says("unknown entry dragModell")) << run.log();
}

TEST(Refusal, BuoyancyLeftOutOnPurpose) {
  auto run = smallColumn("no-buoyancy");
  run.properties("forceModels (pressureGradient); allowNoBuoyancy yes;");
  ASSERT_EQ(run.meshAndRun(), 0) << run.log();
  EXPECT_TRUE(run.says("warning: forceModels (pressureGradient) lacks buoyancy")) << run.log();
  EXPECT_EQ(run.cfd()["warnings"].size(), 1u);
}

TEST(Failure, AParticleThatIsNoNumberIsNamed) {
  auto run = smallColumn("spoiled");
  run.dem("spoilAt", 100);
  ASSERT_NE(run.meshAndRun(), 0);
  EXPECT_TRUE(run.says("clayFoam: from the DEM half came particle 1 at (")) << run.log();
  EXPECT_TRUE(run.says("velocity is (nan ")) << run.log();
  EXPECT_TRUE(run.says(", at time 0.001 s; a smaller timestep")) << run.log();
  EXPECT_TRUE(run.says("standInDem: stopped: the CFD half ended: from the DEM half")) << run.log();
}

TEST(Failure, AFluidThatIsNoNumberIsNamed) {
  auto run = smallColumn("nan");
  run.box("U0 (1e200 0 1e200); adjust no; deltaT 1e-3;");
  ASSERT_NE(run.meshAndRun(), 0);
  EXPECT_TRUE(run.says("the fluid is NaN or infinite at time")) << run.log();
}

TEST(Failure, AMissingCaseIsNamed) {
  auto run = smallColumn("no-mesh");
  ASSERT_NE(run.run(), 0);
  const std::string reason = "Cannot find file \"points\" in directory \"polyMesh\"";
  EXPECT_TRUE(run.says("clayFoam: " + reason)) << run.log();
  EXPECT_TRUE(run.says("standInDem: stopped: the CFD half ended: " + reason)) << run.log();
  // said once, and not in OpenFOAM's own frame
  EXPECT_FALSE(run.says("FOAM FATAL")) << run.log();
}

namespace {

/// One thing that keeps the CFD half from its first exchange.
struct Start {
  const char* name;
  const char* file;  ///< of the case
  const char* from;  ///< text of it, replaced; null: the file is taken away
  const char* to;
};

class Starting : public testing::TestWithParam<Start> {};

}  // namespace

// The half that waits hears why, and both end
TEST_P(Starting, IsHeardByTheOtherHalf) {
  const auto& p = GetParam();
  auto run = smallColumn(std::string("start-") + p.name);
  run.mesh();
  if (p.from)
    run.edit(p.file, p.from, p.to);
  else
    std::filesystem::remove_all(run.path() / p.file);
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_NE(run.run(), 0);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
  EXPECT_LT(time.count(), 30) << run.log();
  EXPECT_TRUE(run.says("standInDem: stopped: the CFD half ended: ")) << run.log();
  EXPECT_TRUE(run.says("clayFoam: ")) << run.log();
}

INSTANTIATE_TEST_SUITE_P(
    All, Starting,
    testing::Values(Start{"no-mesh", "constant/polyMesh", nullptr, nullptr},
                    Start{"no-controls", "system/controlDict", nullptr, nullptr},
                    Start{"torn-controls", "system/controlDict", "startTime", "{ startTime"},
                    Start{"no-solution", "system/fvSolution", nullptr, nullptr},
                    Start{"no-schemes", "system/fvSchemes", nullptr, nullptr},
                    Start{"no-U", "0/U", nullptr, nullptr},
                    Start{"odd-U", "0/U", "dimensions", "dimension"},
                    Start{"no-transport", "constant/transportProperties", nullptr, nullptr},
                    Start{"no-case", "system", nullptr, nullptr}),
    [](const auto& info) {
      std::string name = info.param.name;
      std::replace(name.begin(), name.end(), '-', '_');
      return name;
    });

TEST(Report, HoldsSettingsAndDefaults) {
  auto run = smallColumn("report");
  run.properties("voidFractionMin 0.3;");
  ASSERT_EQ(run.meshAndRun(), 0) << run.log();
  const auto cfd = run.cfd();
  EXPECT_EQ(cfd["program"], "clayFoam");
  EXPECT_EQ(cfd["settings"]["dragModel"], "ergunWenYu");
  EXPECT_EQ(cfd["settings"]["voidFractionMin"], 0.3);
  EXPECT_EQ(cfd["settings"]["maxCo"], 0.5);
  EXPECT_EQ(cfd["settings"]["adjustTimeStep"], true);
  EXPECT_EQ(cfd["settings"]["maxDeltaT"], "unlimited");
  EXPECT_EQ(cfd["settings"]["rho"], 1000);
  EXPECT_EQ(cfd["settings"]["meshCells"], 16);
  EXPECT_EQ(cfd["exchanges"], 11);
  EXPECT_GE(cfd["cfd_steps"], 10);
  EXPECT_GT(cfd["cfd_s"], 0);
  EXPECT_TRUE(run.says("defaults taken: overlap")) << run.log();
}

TEST(Report, ThatCannotBeWrittenIsAnError) {
  auto run = smallColumn("no-report");
  std::filesystem::create_directory(run.path() / "cfd.json");
  ASSERT_NE(run.meshAndRun(), 0);
  EXPECT_TRUE(run.says("cannot write")) << run.log();
  EXPECT_TRUE(run.says("cfd.json")) << run.log();
}

TEST(Report, WarnsOfParticlesOutsideTheMesh) {
  auto run = smallColumn("outside");
  // the upper layer's centres 0.2 mm above the lid, each still touching the mesh
  run.dem("hi", "0.02,0.02,0.0427").dem("from", "0,0,0.0227").dem("to", "0.02,0.02,0.0427");
  ASSERT_EQ(run.meshAndRun(), 0) << run.log();
  EXPECT_TRUE(run.says("warning: up to 16 particle centres lay outside the mesh")) << run.log();
}

TEST(Output, IsWrittenWhenDueAndAtTheEnd) {
  auto run = smallColumn("output");
  run.box("writeInterval 0.0006;");
  ASSERT_EQ(run.meshAndRun(), 0) << run.log();
  for (const char* time : {"0.0006", "0.0012", "0.0018", "0.002"})
    EXPECT_TRUE(std::filesystem::exists(run.path() / time / "voidfraction")) << time;
  EXPECT_FALSE(std::filesystem::exists(run.path() / "0.0004"));
}

TEST(Restart, GoesOnAsIfItHadNotStopped) {
  auto whole = smallColumn("whole");
  whole.dem("steps", 400);
  ASSERT_EQ(whole.meshAndRun(), 0) << whole.log();

  auto parts = smallColumn("parts");
  const std::string state = (parts.path() / "spheres").string();
  parts.dem("save", state);
  ASSERT_EQ(parts.meshAndRun(), 0) << parts.log();
  parts.dem("load", state).dem("start", 0.002);
  ASSERT_EQ(parts.run(), 0) << parts.log();

  EXPECT_NEAR(parts.lastVelocity() / whole.lastVelocity(), 1, 1e-9);
  const auto U = parts.meanOfField("U"), V = whole.meanOfField("U");
  EXPECT_NEAR(U[2], V[2], 1e-10 * std::fabs(whole.lastVelocity()));
  EXPECT_LT(parts.cfd()["max_momentum_residual"], 1e-10);
}

// Each part in turn: without it the run would go on from something else
TEST(Restart, NeedsEveryPartOfTheState) {
  auto run = smallColumn("state-parts");
  const std::string state = (run.path() / "spheres").string();
  run.properties("forceModels (buoyancy pressureGradient addedMass);").dem("save", state);
  ASSERT_EQ(run.meshAndRun(), 0) << run.log();
  run.dem("load", state).dem("start", 0.002);
  const auto folder = run.path() / "0.002", aside = run.path() / "aside";
  for (const char* part :
       {"phi", "voidfraction", "gradp", "couplingImpulse", "DUDt", "particleForceSent"}) {
    ASSERT_TRUE(std::filesystem::exists(folder / part)) << part;
    std::filesystem::rename(folder / part, aside);
    ASSERT_NE(run.run(), 0) << part;
    EXPECT_TRUE(run.says(std::string("the saved state of time 0.002 lacks ") + part)) << run.log();
    std::filesystem::rename(aside, folder / part);
  }
  for (const char* part : {"U", "p"}) {
    std::filesystem::rename(folder / part, aside);
    ASSERT_NE(run.run(), 0) << part;
    std::filesystem::rename(aside, folder / part);
  }
  EXPECT_EQ(run.run(), 0) << run.log();
}

TEST(Restart, FollowsAFurtherRunOfTheDemHalf) {
  auto whole = smallColumn("one-run");
  whole.dem("steps", 400);
  ASSERT_EQ(whole.meshAndRun(), 0) << whole.log();

  auto two = smallColumn("two-runs");
  two.dem("runs", 2);
  ASSERT_EQ(two.meshAndRun(), 0) << two.log();
  EXPECT_NEAR(two.lastVelocity() / whole.lastVelocity(), 1, 1e-9);
  EXPECT_EQ(two.cfd()["exchanges"], 22);
  EXPECT_LT(two.cfd()["max_momentum_residual"], 1e-10);
}

// a further run may read more of the fluid than the one before
TEST(Restart, AnswersWhatAFurtherRunReads) {
  auto two = smallColumn("two-runs-read");
  two.dem("runs", 2).dem("fractionFrom", 1);
  ASSERT_EQ(two.meshAndRun(), 0) << two.log();
  const auto history = two.history();
  ASSERT_EQ(history.size(), 22u);
  EXPECT_EQ(history[10]["answered"][3], 0);
  for (std::size_t e = 11; e < 22; ++e) {
    EXPECT_GT(history[e]["answered"][3], 0.5);
    EXPECT_LE(history[e]["answered"][3], 1);
  }
}
