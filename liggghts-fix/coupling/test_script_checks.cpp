// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/script_checks.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <stdexcept>

using namespace clay;

namespace {

// what a check throws, empty for nothing
std::string said(const std::function<void()> &check)
{
  try {
    check();
  } catch (const std::invalid_argument &e) {
    return e.what();
  }
  return "";
}

std::string order(const std::vector<FixEntry> &fixes, int mine)
{
  return said([&] { check_order(fixes, mine); });
}

std::string last(const std::vector<FixEntry> &fixes, int mine)
{
  return said([&] { check_last(fixes, mine); });
}

const FixEntry couple = {"cpl", "couple/foam", true};

}  // namespace

TEST(ScriptChecks, usualForcesStandAbove)
{
  for (const char *style :
       {"gravity", "addforce", "wall/gran", "wall/gran/lean", "spring", "spring/self", "lubrication", "brownian"}) {
    EXPECT_EQ(order({{"a", style}, couple}, 0 + 1), "") << style;
    EXPECT_EQ(order({couple, {"a", style}}, 0),
              std::string("must stand below 'fix a ") + style + "' in the script, since the drag needs its force");
    EXPECT_EQ(order({couple, {"a", style, false}}, 0), "") << style;
  }
  EXPECT_EQ(order({couple, {"a", "nve/sphere", false}, {"b", "property/atom/wall/x"}, {"c", "settling/curve"}}, 0), "");
}

TEST(ScriptChecks, fixesOfOtherCouplingsAreNamed)
{
  EXPECT_EQ(said([] { check_others({{"a", "gravity"}, couple, {"b", "viscous"}}); }), "");
  EXPECT_EQ(said([] {
              check_others({{"a", "couple/cfd/force/implicit"}, couple});
            }),
            "'fix a couple/cfd/force/implicit' belongs to another coupling and takes no part in this one; take it out");
  EXPECT_EQ(said([] {
              check_others({couple, {"b", "buoyancy"}});
            }),
            "'fix b buoyancy' would count twice, since the CFD half's force model buoyancy brings it; take it out");
}

TEST(ScriptChecks, withAddedMassAllForcesStandAbove)
{
  EXPECT_EQ(
      last({{"a", "efield"}, couple, {"b", "multisphere/clump"}, {"c", "property/atom"}, {"d", "nve/sphere", false}},
           1),
      "");
  EXPECT_EQ(last({couple, {"a", "efield"}}, 0),
            "the CFD half has added mass, which takes part of all other forces: 'fix a efield' must stand above "
            "it in the script");
}

TEST(ScriptChecks, whatAFixHoldsIsKnownByGroupAndAxis)
{
  FixEntry hold = {"hold", "setforce", true, 1};
  EXPECT_EQ(said([&] { check_holders({hold}); }), "");
  hold.odd = "acts in a region";
  EXPECT_EQ(said([&] { check_holders({hold}); }), "'fix hold setforce' acts in a region");
}

TEST(ScriptChecks, aRunEndsWithAnExchange)
{
  EXPECT_EQ(said([] { check_interval(100, 20); }), "");
  EXPECT_EQ(said([] { check_interval(110, 20); }),
            "run of 110 steps is no multiple of the coupling interval 'every 20'; use 100 or 120");
  EXPECT_EQ(said([] { check_interval(7, 20); }),
            "run of 7 steps is no multiple of the coupling interval 'every 20'; use 20");
}

TEST(ScriptChecks, contactLimit)
{
  EXPECT_EQ(said([] { check_contact_limit(1e-5, 1e-5, "a sphere"); }), "");
  EXPECT_EQ(said([] { check_contact_limit(1e-5, std::numeric_limits<double>::infinity(), ""); }), "");
  EXPECT_EQ(said([] { check_contact_limit(1e-4, 2.345e-5, "a clump 'ill'"); }),
            "timestep 0.0001 s is above 2.35e-05 s, the contact limit of a clump 'ill' at rest; "
            "take a smaller one, or a softer contact, or contact_limit no");
  EXPECT_EQ(contact_limit_warning(1e-4, 2.345e-5, 5, 700),
            "timestep 0.0001 s is above 2.35e-05 s, the contact limit of a body with 5 contacts at step 700");
}

TEST(ScriptChecks, rayleighTime)
{
  EXPECT_EQ(check_rayleigh(3e-6, 1e-5, "spheres"), "");
  EXPECT_EQ(check_rayleigh(1, std::numeric_limits<double>::infinity(), ""), "");
  EXPECT_EQ(
      check_rayleigh(8e-6, 1e-5, "spheres of type 2"),
      "timestep 8e-06 s is 0.8 of the Rayleigh time of spheres of type 2, 1e-05 s: contacts under load may not be "
      "stable; take at most 0.3 of it, 3e-06 s, or a smaller modulus");
}

TEST(ScriptChecks, chargesThatTheirContactHolds)
{
  LAMMPS_NS::ChargedContact c;
  EXPECT_EQ(check_charges(c), "");
  c.impact = 0.1;
  EXPECT_EQ(check_charges(c), "");
  c.impact = 0.25;
  c.overlap = 0.05;
  c.first = 1;
  c.second = 2;
  c.stiffness = 100;
  c.wanted = 300;
  EXPECT_EQ(check_charges(c),
            "the charges of types 1 and 2 make spheres that come from afar overlap by up to 0.25 d, "
            "at rest by 0.05 d; a stiffness of 300 N/m in place of 100 makes it 0.1 d");
  c.overlap = 1.5;
  EXPECT_NE(said([&] { check_charges(c); }).find("pull their spheres into each other"), std::string::npos);
}

TEST(ScriptChecks, theStepStaysWithinARun)
{
  EXPECT_EQ(said([] { check_step(1e-5, 1e-5); }), "");
  EXPECT_EQ(said([] { check_step(1e-5, 1e-6); }),
            "the timestep changed from 1e-05 to 1e-06 s within a run; change it between two runs");
}
