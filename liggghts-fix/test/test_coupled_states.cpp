// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
// States that the DEM half saves: what a run that goes on has, what saving changes, and
// runs that are asked to end.
#include <gtest/gtest.h>

#include <cmath>

#include "beside_stand_in.h"

using test::BesideStandIn;

namespace {

// spheres that fall through a fluid, and touch; save: steps between two states, 0 for none
std::string script(int save, int steps, const std::string &more = "", const std::string &restart = "")
{
  const std::string start = restart.empty() ? "create_box 2 dom\n" : "read_restart " + restart + "\n";
  const std::string make = restart.empty()
      ? "create_atoms 1 single -0.005 0 0.001 units box\ncreate_atoms 2 single 0.005 0 0.002 units box\n"
        "create_atoms 1 single 0.0059 0 0.002 units box\n"
        "set group all diameter 1e-3 density 2600\nvelocity all set 0.01 0 -0.05\n"
      : "";
  return "atom_style granular\natom_modify map array\ncommunicate single vel yes\nboundary f f f\nnewton off\n"
         "units si\nregion dom block -0.01 0.01 -0.01 0.01 -0.01 0.01 units box\n" +
      start +
      "neighbor 0.0002 bin\nneigh_modify every 1 delay 0 check no\ntimestep 1e-4\n"
      "fix p1 all property/global kn peratomtypepair 2 50 50 50 50\n"
      "fix p2 all property/global kt peratomtypepair 2 50 50 50 50\n"
      "fix p3 all property/global gamman peratomtypepair 2 40 40 40 40\n"
      "fix p4 all property/global gammat peratomtypepair 2 40 40 40 40\n"
      "fix p5 all property/global coefficientFriction peratomtypepair 2 0.5 0.5 0.5 0.5\n"
      "pair_style gran model hooke/stiffness tangential history\npair_coeff * *\n" +
      make + "fix n all nve/sphere\n" + more + "fix cpl all couple/foam every 10 contact_limit no" +
      (save ? " checkpoint saved checkpoint_steps " + std::to_string(save) : "") + "\nrun " + std::to_string(steps) +
      " upto\n";
}

// what was told of an exchange at that time [s], by tag
std::map<int, nlohmann::json> at(const nlohmann::json &told, double time)
{
  std::map<int, nlohmann::json> found;
  for (const auto &e : told["exchanges"])
    if (std::fabs(e["time"].get<double>() - time) < 1e-6)
      for (const auto &p : e["particles"]) found[p["tag"]] = p;
  return found;
}

void expect_same(const std::map<int, nlohmann::json> &one, const std::map<int, nlohmann::json> &other, double most)
{
  ASSERT_EQ(one.size(), 3u);
  ASSERT_EQ(other.size(), 3u);
  for (const auto &[tag, p] : one) {
    EXPECT_EQ(p["touched"], other.at(tag)["touched"]) << tag;
    for (const char *field : {"position", "velocity", "meanVelocity", "otherForce", "impulse"}) {
      const test::Vec a = p[field], b = other.at(tag)[field];
      for (int k = 0; k < 3; k++)
        EXPECT_NEAR(a[k], b[k], most * (1e-12 + std::fabs(a[k]))) << field << " of " << tag << ", " << k;
    }
  }
}

// K dt/m is 0.02; the fluid moves faster the higher a sphere is
const std::string fluid = "K=3e-4 u=0.02,0.01,0.005 rate=20";

}  // namespace

// its forces are those of the step before: a set-up would take the answer that has just come
TEST(CoupledStates, savingOneChangesNothing)
{
  BesideStandIn plain("states-plain", 1), saving("states-saving", 1);
  ASSERT_TRUE(plain.run(script(0, 60), fluid)) << plain.log();
  ASSERT_TRUE(saving.run(script(20, 60), fluid)) << saving.log();
  EXPECT_TRUE(std::filesystem::exists(saving.path() / "saved" / "000000040" / "cfd" / "sums"));
  expect_same(at(plain.told(), 30e-4), at(saving.told(), 30e-4), 1e-12);
  expect_same(at(plain.told(), 60e-4), at(saving.told(), 60e-4), 1e-12);
}

// gravity that changes: its mean over the interval ahead of the state is told at its end, by both
TEST(CoupledStates, oneThatGoesOnHasTheMeanGravity)
{
  const std::string swing = "variable g equal 9.81*cos(0.1*step)\nfix grav all gravity v_g vector 1 0 -1\n";
  BesideStandIn run("states-swing", 1);
  ASSERT_TRUE(run.run(script(20, 60, swing), fluid)) << run.log();
  const auto whole = run.told();
  ASSERT_TRUE(run.run(script(20, 60, swing, "saved/000000040/dem/state"), fluid + " from=saved/000000040 start=40e-4"))
      << run.log();
  const auto parts = run.told();
  for (const double time : {40e-4, 50e-4, 60e-4}) expect_same(at(whole, time), at(parts, time), 0);
  // nothing but gravity and the fluid acts on the first sphere
  EXPECT_EQ(at(parts, 40e-4)[1]["touched"], 0);
}

// a signal to the CFD half ends the run as one to the DEM half does
TEST(CoupledStates, theCfdHalfAsksForTheEnd)
{
  for (const bool saves : {true, false}) {
    BesideStandIn run(saves ? "states-asked" : "states-asked-unsaved", 2);
    EXPECT_FALSE(run.run(script(saves ? 1000 : 0, 1000), fluid + " stop=15"));
    EXPECT_NE(run.log().find("liggghts-clay: ended by SIGTERM to the CFD half at "), std::string::npos) << run.log();
    // asked at its 3rd exchange, step 20, the DEM half ends the run at the next
    EXPECT_EQ(std::filesystem::exists(run.path() / "saved" / "000000030" / "cfd" / "sums"), saves);
    EXPECT_EQ(run.log().find("; the last saved state is that of step 30") != std::string::npos, saves) << run.log();
    EXPECT_EQ(run.log().find("step 30; the last"), std::string::npos) << "said once";
  }
}
