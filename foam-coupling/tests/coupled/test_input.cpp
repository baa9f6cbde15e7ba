// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
// What a case holds beside what is read; starts other than from time 0.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "coupledRun.h"

namespace {

namespace fs = std::filesystem;

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
  auto run = smallColumn(std::string("refused-") + p.name);
  file(run, p.file, p.body);
  ASSERT_NE(run.meshAndRun(), 0);
  EXPECT_TRUE(run.says(p.line)) << run.log();
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
  auto run = smallColumn(std::string("passed-") + p.name);
  file(run, p.file, p.body);
  EXPECT_EQ(run.meshAndRun(), 0) << run.log();
  EXPECT_TRUE(p.line[0] ? run.says(p.line) : run.cfd()["warnings"].empty()) << run.log();
}

INSTANTIATE_TEST_SUITE_P(Files, Passed,
                         testing::Values(Ignored{"nothing", "system/extra", "", ""},
                                         Ignored{"still", "constant/MRFProperties",
                                                 "zone { active no; cellZone all; }", ""},
                                         Ignored{"static", "constant/dynamicMeshDict",
                                                 "dynamicFvMesh staticFvMesh;", ""},
                                         Ignored{"elsewhere", "system/MRFProperties",
                                                 "zone { cellZone all; }",
                                                 "warning: system/MRFProperties is not read,"
                                                 " constant/MRFProperties is"},
                                         Ignored{"other", "constant/liggghtsCommands", "a 1;",
                                                 "warning: constant/liggghtsCommands is not read"}),
                         [](const auto& info) { return info.param.name; });

TEST(Solution, NamesThePimpleDictionary) {
  auto run = smallColumn("piso");
  run.edit("system/fvSolution", "PIMPLE", "PISO");
  ASSERT_NE(run.meshAndRun(), 0);
  EXPECT_TRUE(run.says("PISO is not read: the solver's dictionary is PIMPLE; rename it"))
      << run.log();
}

TEST(Solution, NamesAMissingSolver) {
  auto run = smallColumn("final");
  run.edit("system/fvSolution", "\"(U|UFinal)\"", "U");
  ASSERT_NE(run.meshAndRun(), 0);
  EXPECT_TRUE(run.says("solvers has no UFinal; add UFinal { $U; relTol 0; }")) << run.log();
}

// p is over the density: one in Pa would be taken for a thousand times its value
TEST(Fields, OfOtherDimensionsAreNamed) {
  auto run = smallColumn("dimensions");
  run.edit("0/p", "[0 2 -2 0 0 0 0]", "[1 -1 -2 0 0 0 0]");
  ASSERT_NE(run.meshAndRun(), 0);
  EXPECT_TRUE(
      run.says("0/p: dimensions [1 -1 -2 0 0 0 0] are not those of pressure over density,"
               " [0 2 -2 0 0 0 0]; give p in these"))
      << run.log();
}

TEST(Fluid, NamesAMissingDensity) {
  auto run = smallColumn("density");
  run.edit("constant/transportProperties", "rho             $rho;", "#remove rho");
  ASSERT_NE(run.meshAndRun(), 0);
  EXPECT_TRUE(run.says("rho is missing: the fluid's density [kg/m3], for water rho 1000;"))
      << run.log();
}

// Its threads and its communicator end before MPI does
TEST(Ranks, TheCollatedFormatEndsInOrder) {
  auto run = smallColumn("collated");
  run.edit("system/controlDict", "adjustTimeStep",
           "OptimisationSwitches { fileHandler collated; }\nadjustTimeStep");
  run.ranks(1, 2);
  EXPECT_EQ(run.meshAndRun(), 0) << run.log();
  EXPECT_FALSE(run.says("after MPI_FINALIZE")) << run.log();
}

TEST(Unread, EntriesAndFieldsAreSaid) {
  auto run = smallColumn("unread");
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

// Coefficients that no model asks for, and settings that another one puts out of action
TEST(Unread, CoefficientsAndModelsThatAreNotChosenAreSaid) {
  auto run = smallColumn("unread-models");
  run.edit("constant/transportProperties", "transportModel  Newtonian;\nnu              $nu;",
           "transportModel BirdCarreau; nu $nu; mu 1e-3;\n"
           "BirdCarreauCoeffs { nu0 1e-6; nuInf 1e-6; k 1; n 0.5; aa 2; }");
  run.edit("constant/turbulenceProperties", "simulationType  laminar;",
           "simulationType laminar; RAS { RASModel kEpsilon; }");
  run.edit("system/controlDict", "startTime       0;",
           "startTime 0; stopAt nextWrite; maxDeltaT 1;");
  run.box("adjust no;");
  ASSERT_EQ(run.meshAndRun(), 0) << run.log();
  EXPECT_EQ(
      run.cfd()["warnings"],
      nlohmann::json(
          {"constant/transportProperties: nu is not read; BirdCarreauCoeffs is",
           "constant/transportProperties: mu is not read; BirdCarreauCoeffs is",
           "constant/transportProperties: BirdCarreauCoeffs: aa is not read; the nearest entry"
           " that is: a",
           "constant/turbulenceProperties: RAS is not read: simulationType is laminar",
           "system/controlDict: maxCo is not read: adjustTimeStep is no",
           "system/controlDict: maxDeltaT is not read: adjustTimeStep is no",
           "system/controlDict: stopAt nextWrite is not followed: the DEM half says when the run"
           " ends"}))
      << run.log();
}

TEST(Ranks, ACaseThatIsNotDecomposedIsNamed) {
  auto run = smallColumn("whole");
  run.mesh();
  run.ranks(1, 2);
  ASSERT_NE(run.run(), 0);
  EXPECT_TRUE(run.says("the case is not decomposed, the CFD half has 2; set numberOfSubdomains 2"))
      << run.log();
}

TEST(Ranks, ACaseOfOtherRanksIsNamed) {
  auto run = smallColumn("three");
  run.ranks(1, 2);
  run.mesh();
  run.ranks(1, 3);
  ASSERT_NE(run.run(), 0);
  EXPECT_TRUE(run.says("decomposed for another number of ranks, the CFD half has 3")) << run.log();
}

TEST(Start, StopAtEndTimeWithoutAnEndTimeFollowsTheDemHalf) {
  auto run = smallColumn("stopAt");
  run.mesh();
  run.edit("system/controlDict", "startTime       0;", "startTime 0; stopAt endTime;");
  ASSERT_EQ(run.run(), 0) << run.log();
  EXPECT_TRUE(fs::exists(run.path() / "0.002" / "U"));
}

// A flow that was computed up to 5 s: the same as from 0, five seconds later
TEST(Start, FromAFlowComputedBeforehand) {
  auto now = smallColumn("now"), later = smallColumn("later");
  later.mesh();
  fs::rename(later.path() / "0", later.path() / "5");
  ASSERT_NE(later.run(), 0);
  EXPECT_TRUE(later.says("the start times differ: 0 s in the DEM half, 5 s in the CFD half"))
      << later.log();
  EXPECT_TRUE(later.says("timeOffset 5;")) << later.log();

  later.properties("timeOffset 5;");
  ASSERT_EQ(later.run(), 0) << later.log();
  ASSERT_EQ(now.meshAndRun(), 0) << now.log();
  EXPECT_TRUE(fs::exists(later.path() / "5.002" / "U"));
  EXPECT_NEAR(later.lastVelocity() / now.lastVelocity(), 1, 1e-9);
  EXPECT_LT(later.cfd()["max_momentum_residual"], 1e-10);
}

TEST(Start, AVoidfractionWithoutTheMarkIsNoState) {
  auto with = smallColumn("foreign"), without = smallColumn("own");
  file(with, "0/voidfraction",
       "dimensions [0 0 0 0 0 0 0]; internalField uniform 0.3;"
       " boundaryField { \".*\" { type zeroGradient; } }",
       "volScalarField");
  ASSERT_EQ(with.meshAndRun(), 0) << with.log();
  ASSERT_EQ(without.meshAndRun(), 0) << without.log();
  EXPECT_EQ(with.lastVelocity(), without.lastVelocity());
  EXPECT_TRUE(
      with.says("warning: 0/voidfraction is not read: its folder has no uniform/couplingState"))
      << with.log();
  EXPECT_TRUE(fs::exists(without.path() / "0.002" / "uniform" / "couplingState"));
}

// A model's limits are said at the start
TEST(Limits, AreSaidWithFigureAndCure) {
  auto small = smallColumn("small-cells");
  small.box("nx 10; ny 10; nz 20;");
  ASSERT_EQ(small.meshAndRun(), 0) << small.log();
  EXPECT_TRUE(small.says(
      "warning: spheres of 1 cells: a sphere is mapped onto cells that hold little but itself"))
      << small.log();

  auto light = smallColumn("light");
  light.dem("density", 50);
  ASSERT_EQ(light.meshAndRun(), 0) << light.log();
  EXPECT_TRUE(light.says("warning: particles of 50 kg/m3 are lighter than the fluid"))
      << light.log();

  auto slab = smallColumn("slab");
  slab.box("y1 0.002; ny 1; sideU slip; nx 5; nz 10;");
  slab.dem("hi", "0.02,0.002,0.04")
      .dem("from", "0,0,0.02")
      .dem("to", "0.02,0.002,0.04")
      .dem("count", "6,1,6");
  slab.dem("radius", 1.6e-3);
  ASSERT_EQ(slab.meshAndRun(), 0) << slab.log();
  EXPECT_TRUE(slab.says("% of the solid volume found no room in its own cells")) << slab.log();
}

TEST(Limits, AreNotSaidWithinThem) {
  auto run = smallColumn("within");
  ASSERT_EQ(run.meshAndRun(), 0) << run.log();
  EXPECT_TRUE(run.cfd()["warnings"].empty()) << run.log();
}
