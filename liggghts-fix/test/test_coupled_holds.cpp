// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
// What spheres get that something else than the fluid holds, and what is told of it.
#include <gtest/gtest.h>

#include <cmath>

#include "beside_stand_in.h"

using test::BesideStandIn;

namespace {

// two spheres at rest, the second one of group `held`; K dt/m is 7
std::string script(const std::string &above, const std::string &below, const std::string &integrator = "all nve/sphere")
{
  return "atom_style granular\natom_modify map array\ncommunicate single vel yes\nboundary f f f\nnewton off\n"
         "units si\n"
         "region dom block -0.01 0.01 -0.01 0.01 -0.01 0.01 units box\ncreate_box 2 dom\nneighbor 0.0002 bin\n"
         "neigh_modify every 1 delay 0 check no\ntimestep 1e-4\n"
         "fix p1 all property/global kn peratomtypepair 2 50 50 50 50\n"
         "fix p2 all property/global kt peratomtypepair 2 50 50 50 50\n"
         "fix p3 all property/global gamman peratomtypepair 2 40 40 40 40\n"
         "fix p4 all property/global gammat peratomtypepair 2 40 40 40 40\n"
         "fix p5 all property/global coefficientFriction peratomtypepair 2 0.5 0.5 0.5 0.5\n"
         "pair_style gran model hooke/stiffness tangential history\npair_coeff * *\n"
         "create_atoms 1 single -0.005 0 0 units box\ncreate_atoms 2 single 0.005 0 0 units box\n"
         "set group all diameter 1e-3 density 2600\ngroup held type 2\ngroup free type 1\nfix n " +
      integrator + "\n" + above + "fix cpl all couple/foam every 10 contact_limit no\n" + below +
      "thermo_modify lost ignore\nrun 30\n";
}

// of the second sphere
struct Second {
  bool ran;
  test::Vec impulse, moved;
  bool touched;
  std::string log;

  Second(const std::string &name, const std::string &in, const std::string &fluid = "K=0.1 u=1e-3,2e-3,3e-3")
  {
    BesideStandIn run(name, 1);
    ran = run.run(in, fluid);
    log = run.log();
    if (!ran) return;
    const auto told = run.told()["exchanges"];
    const auto of = [&](int e) {
      for (const auto &p : told[e]["particles"])
        if (p["tag"] == 2) return p;
      return nlohmann::json();
    };
    impulse = of(2)["impulse"];
    touched = of(2)["touched"] != 0;
    const test::Vec first = of(0)["position"], last = of(3)["position"];
    for (int k = 0; k < 3; k++) moved[k] = last[k] - first[k];
  }
};

const double whole = 0.1 * (1 + 0.1 * 0.90929742682568171) * 1e-3;  // K u of 1 s, sin(2)

}  // namespace

// whatever holds it, and in whatever order: K u of the whole interval, no step
TEST(CoupledHolds, whatIsHeldGetsTheWholeDrag)
{
  const std::string set = "fix hold held setforce 0 0 0\n", freeze = "fix hold held freeze\n";
  const std::vector<std::array<std::string, 4>> ways = {
      {"set-below", "", set, "all nve/sphere"},
      {"set-above", set, "", "all nve/sphere"},
      {"freeze-below", "", freeze, "all nve/sphere"},
      {"freeze-above", freeze, "", "all nve/sphere"},
      {"noforce", "", "fix hold held nve/noforce\n", "free nve/sphere"},
      {"move", "", "fix hold held move linear 0 0 0 units box\n", "free nve/sphere"},
      {"none", "", "", "free nve/sphere"}};
  for (const auto &way : ways) {
    const Second s("holds-" + way[0], script(way[1], way[2], way[3]));
    ASSERT_TRUE(s.ran) << way[0] << s.log;
    for (int k = 0; k < 3; k++) {
      EXPECT_NEAR(s.impulse[k], 1e-3 * whole * (k + 1), 1e-9 * whole) << way[0];
      EXPECT_EQ(s.moved[k], 0) << way[0];
    }
  }
}

// along one axis: all of the drag there, the fluid's velocity along the others
TEST(CoupledHolds, alongSomeAxes)
{
  const std::vector<std::array<std::string, 3>> ways = {{"set-below", "", "fix hold held setforce NULL NULL 0\n"},
                                                        {"set-above", "fix hold held setforce NULL NULL 0\n", ""},
                                                        {"plane", "fix hold held planeforce 0 0 1\n", ""}};
  for (const auto &way : ways) {
    const Second s("along-" + way[0], script(way[1], way[2]));
    ASSERT_TRUE(s.ran) << way[0] << s.log;
    EXPECT_NEAR(s.impulse[2], 1e-3 * whole * 3, 1e-9 * whole) << way[0];
    EXPECT_EQ(s.moved[2], 0) << way[0];
    EXPECT_NEAR(s.impulse[0], 0, 1e-6 * whole) << way[0];
    EXPECT_NEAR(s.moved[0], 30e-4 * 1e-3, 0.1 * 30e-4 * 1e-3) << way[0];
  }
  const Second line("along-line", script("fix hold held lineforce 1 0 0\n", ""));
  ASSERT_TRUE(line.ran) << line.log;
  EXPECT_NEAR(line.impulse[1], 1e-3 * whole * 2, 1e-9 * whole);
  EXPECT_NEAR(line.impulse[0], 0, 1e-6 * whole);
}

TEST(CoupledHolds, whatCannotBeToldIsRefused)
{
  const Second region("odd-region",
                      script("region r block 0 0.01 INF INF INF INF units box\n"
                             "fix hold all setforce 0 0 0 region r\n",
                             ""));
  EXPECT_FALSE(region.ran);
  EXPECT_NE(region.log.find("'fix hold setforce' acts in a region"), std::string::npos) << region.log;
  const Second slanted("odd-slanted", script("fix hold held planeforce 1 0 1\n", ""));
  EXPECT_FALSE(slanted.ran);
  EXPECT_NE(slanted.log.find("takes a direction between the axes"), std::string::npos) << slanted.log;
}

// gravity that changes within the interval is no other force
TEST(CoupledHolds, changingGravityTouchesNothing)
{
  const std::string turning = "variable g equal 9.81*step*0.01\nfix grav all gravity v_g vector 0 0 -1\n"
                              "fix side held gravity v_g vector 1 0 0\n";
  const Second s("gravity", script(turning, ""), "K=1e-4 u=1e-3,2e-3,3e-3");
  ASSERT_TRUE(s.ran) << s.log;
  EXPECT_FALSE(s.touched);
  const Second pushed("gravity-pushed", script(turning + "fix push held addforce 1e-6 0 0\n", ""), "K=1e-4");
  ASSERT_TRUE(pushed.ran) << pushed.log;
  EXPECT_TRUE(pushed.touched);
}
