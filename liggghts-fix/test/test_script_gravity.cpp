// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "clumps/script_gravity.h"
#include "group.h"
#include "host.h"

using LAMMPS_NS::ScriptGravity;
using test::Host;

namespace {

// two free spheres, the second in the group `some`; without contact
std::string two(const std::string &gravity, const std::string &more = "run 1\n")
{
  return test::opening("f f f", "0 0.03 0 0.03 0 0.03") + test::material("coul/clump 0.01") +
      "pair_coeff * * coul/clump 0.0\ncreate_atoms 1 single 0.01 0.01 0.01 units box\n"
      "create_atoms 2 single 0.02 0.02 0.02 units box\nset group all diameter 2e-3\nset group all density 2600\n"
      "group some type 2\nfix nve all nve/sphere\ntimestep 1e-5\n" +
      gravity + more;
}

// gravity on both as the script's fixes gravity have it
std::array<std::array<double, 3>, 2> told(Host &host)
{
  ScriptGravity script(host.lmp.get());
  script.find();
  script.evaluate();
  const clay::GroupGravity now = script.now();
  return {{now.on(1), now.on(1 | host.lmp->group->bitmask[host.lmp->group->find("some")])}};
}

// and what LIGGGHTS moves them by: their forces over their masses
void expect_as_moved(Host &host)
{
  const auto g = told(host);
  const auto atoms = host.atoms();
  ASSERT_EQ(atoms.size(), 2u);
  for (int i = 0; i < 2; i++)
    for (int k = 0; k < 3; k++) EXPECT_NEAR(g[i][k], atoms[i].f[k] / atoms[i].rmass, 1e-10) << i << k;
}

}  // namespace

TEST(ScriptGravity, severalFixesAndGroups)
{
  Host host;
  host(two(
      "fix a all gravity 9.81 vector 0 0 -1\nfix b some gravity 2 vector 1 0 0\nfix c all gravity 1 vector 0 3 4\n"));
  expect_as_moved(host);
  EXPECT_NEAR(told(host)[0][2], -9.81 + 0.8, 1e-12);
  EXPECT_NEAR(told(host)[1][0], 2, 1e-12);
  ScriptGravity script(host.lmp.get());
  EXPECT_FALSE(script.any());
  script.find();
  EXPECT_TRUE(script.any());
  EXPECT_FALSE(script.changes());
  EXPECT_TRUE(script.differs(0));
}

TEST(ScriptGravity, ofAVariableFromTheStart)
{
  Host host;
  host(two("variable g equal 9.81\nfix a all gravity v_g vector 0 0 -1\n", ""));
  // no force has been computed yet
  host.lmp->init();
  EXPECT_NEAR(told(host)[0][2], -9.81, 1e-12);
  ScriptGravity script(host.lmp.get());
  script.find();
  EXPECT_TRUE(script.changes());
  EXPECT_TRUE(script.differs(0));
}

TEST(ScriptGravity, rampedAndTurning)
{
  Host host;
  host(two("variable size equal 1e-2*step\nvariable angle equal 90*step/400\n"
           "fix a all gravity v_size vector 0 0 -1\nfix b all gravity 5 chute v_angle\n",
           "run 100\n"));
  expect_as_moved(host);
  EXPECT_NEAR(told(host)[0][2], -1. - 5 * std::cos(M_PI / 8), 1e-9);
  host("run 100");
  expect_as_moved(host);
  EXPECT_NEAR(told(host)[0][2], -2. - 5 * std::cos(M_PI / 4), 1e-9);
}

TEST(ScriptGravity, oneOnAllIsTheSameForAll)
{
  Host host;
  host(two("fix a all gravity 9.81 vector 0 0 -1\n"));
  ScriptGravity script(host.lmp.get());
  script.find();
  EXPECT_FALSE(script.differs(0));
}
