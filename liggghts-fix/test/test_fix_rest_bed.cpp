// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "contacts/pair_gran_lean.h"
#include "fix.h"
#include "host.h"
#include "update.h"

using test::Host;

namespace {

/// Spheres of 2 mm, four columns of three with gaps, that fall on a floor with friction.
std::string fall(const std::string &more)
{
  std::string script = test::opening("f f f", "-0.006 0.006 -0.006 0.006 0 0.05") + test::material("coul/clump 0.004");
  script += "pair_coeff * * coul/clump 0\n";
  const double x[] = {-0.0022, 0.0022};
  for (double a : x)
    for (double b : x)
      for (int k = 0; k < 3; k++)
        script += "create_atoms 1 single " + std::to_string(a + 1e-4 * k) + " " + std::to_string(b) + " " +
            std::to_string(0.0015 + 0.0024 * k) + " units box\n";
  return script +
      "set group all diameter 2e-3 density 2600\nfix move all nve/sphere\nfix damp all viscous 2e-3\n"
      "fix g all gravity 9.81 vector 0 0 -1\n"
      "fix floor all wall/gran model hooke tangential history primitive type 1 zplane 0\n"
      "fix xl all wall/gran model hooke tangential history primitive type 1 xplane -0.0033\n"
      "fix xh all wall/gran model hooke tangential history primitive type 1 xplane 0.0033\n"
      "fix yl all wall/gran model hooke tangential history primitive type 1 yplane -0.0033\n"
      "fix yh all wall/gran model hooke tangential history primitive type 1 yplane 0.0033\n"
      "timestep 1e-5\n" +
      more;
}

double mean_height(Host &host)
{
  double z = 0;
  const auto atoms = host.atoms();
  for (const auto &a : atoms) z += a.x[2] / atoms.size();
  return z;
}

double skipped(Host &host) { return host.fix("rest")->compute_vector(0); }

}  // namespace

TEST(FixRestBed, leavesABedAtRestAlone)
{
  Host every, some;
  every(fall("run 60000\n"));
  some(fall("fix rest all rest/bed window 2e-3\nrun 60000\n"));
  EXPECT_EQ(some.lmp->update->ntimestep, 60000);
  EXPECT_GT(skipped(some), 4000);
  EXPECT_NEAR(mean_height(some), mean_height(every), 1e-3 * mean_height(every));
  EXPECT_NEAR(mean_height(some), mean_height(every), 2 * some.fix("rest")->compute_vector(1) + 1e-7);
}

// in the lean loops, as liggghts-clay runs such a script
TEST(FixRestBed, leavesABedOfHertzSpheresAlone)
{
  Host every, some;
  const auto hertz = [](Host &host, const std::string &more) {
    LAMMPS_NS::offer_lean_contacts(host.lmp.get());
    std::string script = fall(more);
    for (std::size_t at = 0; (at = script.find("model hooke", at)) != std::string::npos;)
      script.replace(at, 11, "model hertz");
    host(script);
  };
  hertz(every, "run 60000\n");
  hertz(some, "fix rest all rest/bed window 2e-3\nrun 60000\n");
  const auto *lean = dynamic_cast<LAMMPS_NS::PairGranLean *>(some.lmp->force->pair_match("gran", 1));
  ASSERT_NE(lean, nullptr);
  int pairs = lean->near_pairs();
  MPI_Allreduce(MPI_IN_PLACE, &pairs, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
  EXPECT_GT(pairs, 8);
  EXPECT_GT(skipped(some), 4000);
  EXPECT_NEAR(mean_height(some), mean_height(every), 2 * some.fix("rest")->compute_vector(1) + 1e-7);
}

TEST(FixRestBed, computesEveryStepWhileParticlesFall)
{
  // 5 mm at 9.81 m/s2 take 0.03 s: none of these steps may be left out
  Host host;
  host(fall("fix rest all rest/bed window 2e-4\nrun 1000\n"));
  EXPECT_EQ(skipped(host), 0);
}

TEST(FixRestBed, wakesForANewSphere)
{
  const std::string drop = "create_atoms 2 single 0.0 0.0 0.012 units box\ngroup late type 2\n"
                           "set group late diameter 2e-3 density 2600\nrun 20000\n";
  Host every, some;
  every(fall("run 40000\n" + drop));
  some(fall("fix rest all rest/bed window 2e-3\nrun 40000\n" + drop));
  EXPECT_GT(skipped(some), 5000);
  double z[2] = {NAN, NAN};
  for (const auto &a : every.atoms())
    if (a.type == 2) z[0] = a.x[2];
  for (const auto &a : some.atoms())
    if (a.type == 2) z[1] = a.x[2];
  EXPECT_LT(z[0], 0.0115);
  EXPECT_NEAR(z[1], z[0], 2e-5);
  // its height is nothing that the bed has missed
  EXPECT_LT(some.fix("rest")->compute_vector(1), 5e-4 * mean_height(some));
}

TEST(FixRestBed, leavesScriptsAloneThatActByThemselves)
{
  Host host;
  host(fall("fix rest all rest/bed window 2e-3\nfix pull all spring/self 1e-9\nrun 20000\n"));
  EXPECT_EQ(skipped(host), 0);
}

TEST(FixRestBed, leavesScriptsAloneThatChangeForces)
{
  for (const char *change : {"fix pull all addforce v_f 0 0\n", "fix turn all gravity v_f vector 1 0 0\n"}) {
    Host host;
    host(fall(std::string("variable f equal 0.0\nfix rest all rest/bed window 2e-3\n") + change + "run 20000\n"));
    EXPECT_EQ(skipped(host), 0) << change;
  }
  Host constant;
  constant(fall("fix rest all rest/bed window 2e-3\nfix pull all addforce 0 0 0\nrun 40000\n"));
  EXPECT_GT(skipped(constant), 3000);
}

TEST(FixRestBed, leavesForcesInImpulsesAlone)
{
  std::string script = fall("fix rest all rest/bed window 2e-3\nrun 20000\n");
  script.replace(script.find("coul/clump 0.004"), 16, "coul/clump 0.004 every 10");
  Host host;
  host(script);
  EXPECT_EQ(skipped(host), 0);
}

TEST(FixRestBed, keepsTheClock)
{
  Host host;
  host(fall("fix rest all rest/bed window 2e-3\nthermo 1000\nrun 40000\n"));
  EXPECT_GT(skipped(host), 3000);
  EXPECT_EQ(host.lmp->update->ntimestep, 40000);
  EXPECT_NEAR(host.lmp->update->get_cur_time(), 0.4, 1e-12);
}
