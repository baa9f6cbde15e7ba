// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
// What a case holds beside what is read; starts other than from time 0.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "coupledRun.h"

namespace {

namespace fs = std::filesystem;

/// A small column that would run well.
CoupledRun column(const std::string& name) {
  CoupledRun run("input-" + name);
  run.box(
      "x1 0.02; y1 0.02; z1 0.04; nx 2; ny 2; nz 4; topType patch; topU zeroGradient;"
      "topP fixedValue;");
  run.dem("hi", "0.02,0.02,0.04").dem("from", "0,0,0.02").dem("count", "4,4,4");
  run.dem("to", "0.02,0.02,0.04").dem("gravity", "0,0,-9.81").dem("steps", 200);
  return run;
}

bool says(const CoupledRun& run, const std::string& text) {
  return run.log().find(text) != std::string::npos;
}

/// Writes a file of the case with its header.
void file(const CoupledRun& run, const std::string& name, const std::string& body,
          const std::string& kind = "dictionary") {
  std::ofstream(run.path() / name) << "FoamFile { version 2.0; format ascii; class " << kind
                                   << "; object " << fs::path(name).filename().string() << "; }\n"
                                   << body << "\n";
}

struct Ignored {
  const char* name;
  const char* file;
  const char* body;
  const char* line;
};

class Refused : public testing::TestWithParam<Ignored> {};
class Passed : public testing::TestWithParam<Ignored> {};

}  // namespace

TEST_P(Refused, WhatWouldGiveAnotherAnswer) {
  const auto& p = GetParam();
  auto run = column(std::string("refused-") + p.name);
  file(run, p.file, p.body);
  ASSERT_NE(run.meshAndRun(), 0);
  EXPECT_TRUE(says(run, p.line)) << run.log();
}

INSTANTIATE_TEST_SUITE_P(
    Files, Refused,
    testing::Values(
        Ignored{"rotating", "constant/MRFProperties",
                "zone { cellZone all; origin (0 0 0); axis (0 0 1); omega 10; }",
                "constant/MRFProperties: zone: rotating zones are not computed"},
        Ignored{"frame", "constant/SRFProperties", "SRFModel rpm;", "constant/SRFProperties"},
        Ignored{"porous", "constant/porosityProperties", "bed { type DarcyForchheimer; }",
                "constant/porosityProperties: bed: porous zones are not computed"},
        Ignored{"moving", "constant/dynamicMeshDict", "dynamicFvMesh dynamicMotionSolverFvMesh;",
                "constant/dynamicMeshDict: dynamicFvMesh dynamicMotionSolverFvMesh"}),
    [](const auto& info) { return info.param.name; });

TEST_P(Passed, WhatChangesNothing) {
  const auto& p = GetParam();
  auto run = column(std::string("passed-") + p.name);
  file(run, p.file, p.body);
  EXPECT_EQ(run.meshAndRun(), 0) << run.log();
  EXPECT_TRUE(p.line[0] ? says(run, p.line) : run.cfd()["warnings"].empty()) << run.log();
}

INSTANTIATE_TEST_SUITE_P(Files, Passed,
                         testing::Values(Ignored{"nothing", "system/extra", "", ""},
                                         Ignored{"still", "constant/MRFProperties",
                                                 "zone { active no; cellZone all; }", ""},
                                         Ignored{"static", "constant/dynamicMeshDict",
                                                 "dynamicFvMesh staticFvMesh;", ""},
                                         Ignored{"other", "constant/liggghtsCommands", "a 1;",
                                                 "warning: constant/liggghtsCommands is not read"}),
                         [](const auto& info) { return info.param.name; });

TEST(Solution, NamesThePimpleDictionary) {
  auto run = column("piso");
  run.edit("system/fvSolution", "PIMPLE", "PISO");
  ASSERT_NE(run.meshAndRun(), 0);
  EXPECT_TRUE(says(run, "PISO is not read: the solver's dictionary is PIMPLE; rename it"))
      << run.log();
}

TEST(Solution, NamesAMissingSolver) {
  auto run = column("final");
  run.edit("system/fvSolution", "\"(U|UFinal)\"", "U");
  ASSERT_NE(run.meshAndRun(), 0);
  EXPECT_TRUE(says(run, "solvers has no UFinal; add UFinal { $U; relTol 0; }")) << run.log();
}

TEST(Unread, EntriesAndFieldsAreSaid) {
  auto run = column("unread");
  run.edit("system/fvSolution", "nCorrectors         3;", "nCorrectors 3; nNonOrthoCorrectors 1;");
  run.edit("system/controlDict", "maxCo           0.5;", "maxCo 0.5; maxDetlaT 1e-4; own 3;");
  run.edit("constant/transportProperties", "rho             $rho;",
           "rho $rho; BirdCarreauCoeffs { nu0 1; nuInf 1; k 1; n 1; }");
  file(run, "0/k", "dimensions [0 2 -2 0 0 0 0]; internalField uniform 1; boundaryField {}",
       "volScalarField");
  ASSERT_EQ(run.meshAndRun(), 0) << run.log();
  EXPECT_EQ(
      run.cfd()["warnings"],
      nlohmann::json({"system/fvSolution: PIMPLE: nNonOrthoCorrectors is not read; the nearest"
                      " entry that is: nNonOrthogonalCorrectors",
                      "system/controlDict: maxDetlaT is not read; maxDeltaT is",
                      "constant/transportProperties: BirdCarreauCoeffs is not read:"
                      " transportModel is Newtonian",
                      "0/k is not read (the flow is laminar)"}))
      << run.log();
}

TEST(Ranks, ACaseThatIsNotDecomposedIsNamed) {
  auto run = column("whole");
  run.mesh();
  run.ranks(1, 2);
  ASSERT_NE(run.run(), 0);
  EXPECT_TRUE(says(run, "the case is not decomposed, the CFD half has 2; set numberOfSubdomains 2"))
      << run.log();
}

TEST(Ranks, ACaseOfOtherRanksIsNamed) {
  auto run = column("three");
  run.ranks(1, 2);
  run.mesh();
  run.ranks(1, 3);
  ASSERT_NE(run.run(), 0);
  EXPECT_TRUE(says(run, "decomposed for another number of ranks, the CFD half has 3")) << run.log();
}

TEST(Start, StopAtEndTimeWithoutAnEndTimeFollowsTheDemHalf) {
  auto run = column("stopAt");
  run.mesh();
  run.edit("system/controlDict", "startTime       0;", "startTime 0; stopAt endTime;");
  ASSERT_EQ(run.run(), 0) << run.log();
  EXPECT_TRUE(fs::exists(run.path() / "0.002" / "U"));
}

// A flow that was computed up to 5 s: the same as from 0, five seconds later
TEST(Start, FromAFlowComputedBeforehand) {
  auto now = column("now"), later = column("later");
  later.mesh();
  fs::rename(later.path() / "0", later.path() / "5");
  ASSERT_NE(later.run(), 0);
  EXPECT_TRUE(says(later, "the start times differ: 0 s in the DEM half, 5 s in the CFD half"))
      << later.log();
  EXPECT_TRUE(says(later, "timeOffset 5;")) << later.log();

  later.properties("timeOffset 5;");
  ASSERT_EQ(later.run(), 0) << later.log();
  ASSERT_EQ(now.meshAndRun(), 0) << now.log();
  EXPECT_TRUE(fs::exists(later.path() / "5.002" / "U"));
  EXPECT_NEAR(later.lastVelocity() / now.lastVelocity(), 1, 1e-9);
  EXPECT_LT(later.cfd()["max_momentum_residual"], 1e-10);
}

TEST(Start, AVoidfractionWithoutTheMarkIsNoState) {
  auto with = column("foreign"), without = column("own");
  file(with, "0/voidfraction",
       "dimensions [0 0 0 0 0 0 0]; internalField uniform 0.3;"
       " boundaryField { \".*\" { type zeroGradient; } }",
       "volScalarField");
  ASSERT_EQ(with.meshAndRun(), 0) << with.log();
  ASSERT_EQ(without.meshAndRun(), 0) << without.log();
  EXPECT_EQ(with.lastVelocity(), without.lastVelocity());
  EXPECT_TRUE(
      says(with, "warning: 0/voidfraction is not read: its folder has no uniform/couplingState"))
      << with.log();
  EXPECT_TRUE(fs::exists(without.path() / "0.002" / "uniform" / "couplingState"));
}

// A model's limits are said at the start
TEST(Limits, AreSaidWithFigureAndCure) {
  auto small = column("small-cells");
  small.box("nx 10; ny 10; nz 20;");
  ASSERT_EQ(small.meshAndRun(), 0) << small.log();
  EXPECT_TRUE(says(
      small,
      "warning: spheres of 1 cells: a sphere is mapped onto cells that hold little but itself"))
      << small.log();

  auto light = column("light");
  light.dem("density", 50);
  ASSERT_EQ(light.meshAndRun(), 0) << light.log();
  EXPECT_TRUE(says(light, "warning: particles of 50 kg/m3 are lighter than the fluid"))
      << light.log();

  auto slab = column("slab");
  slab.box("y1 0.002; ny 1; sideU slip; nx 5; nz 10;");
  slab.dem("hi", "0.02,0.002,0.04")
      .dem("from", "0,0,0.02")
      .dem("to", "0.02,0.002,0.04")
      .dem("count", "6,1,6");
  slab.dem("radius", 1.6e-3);
  ASSERT_EQ(slab.meshAndRun(), 0) << slab.log();
  EXPECT_TRUE(says(slab, "% of the solid volume found no room in its own cells")) << slab.log();
}

TEST(Limits, AreNotSaidWithinThem) {
  auto run = column("within");
  ASSERT_EQ(run.meshAndRun(), 0) << run.log();
  EXPECT_TRUE(run.cfd()["warnings"].empty()) << run.log();
}
