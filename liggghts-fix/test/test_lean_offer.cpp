// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>

#include "contacts/fix_wall_gran_lean.h"
#include "contacts/pair_gran_lean.h"
#include "fix_wall_gran.h"
#include "host.h"
#include "pair.h"

using test::Host;

namespace {

// a LIGGGHTS as liggghts-clay runs it, with a log
struct Offered {
  Host host;
  std::string name;

  explicit Offered(const std::string &log) : name(log + ".log")
  {
    LAMMPS_NS::offer_lean_contacts(host.lmp.get());
    int rank;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    if (rank == 0) host.lmp->logfile = std::fopen(name.c_str(), "w");
  }

  // its lines on contacts; of the first processor
  std::string said() const
  {
    std::string lines;
    if (!host.lmp->logfile) return lines;
    std::fflush(host.lmp->logfile);
    std::ifstream in(name);
    for (std::string line; std::getline(in, line);)
      if (line.compare(0, 11, "Contacts of") == 0) lines += line + "\n";
    return lines;
  }

  bool first() const { return host.lmp->logfile != nullptr; }

  int near_pairs()
  {
    const auto *pair = dynamic_cast<LAMMPS_NS::PairGranLean *>(host.lmp->force->pair_match("gran", 1));
    int mine = pair ? pair->near_pairs() : -1000, all;
    MPI_Allreduce(&mine, &all, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
    return all;
  }

  bool lean_floor() { return dynamic_cast<LAMMPS_NS::FixWallGranLean *>(host.fix("floor")) != nullptr; }
};

// spheres on a floor, as anybody's script has them
std::string heap(const std::string &model, const std::string &word = "", const std::string &wall_word = "",
                 const std::string &first = "")
{
  std::string s = test::opening("f f f", "-0.01 0.01 -0.01 0.01 0 0.04") + first +
      "fix m1 all property/global youngsModulus peratomtype 5e6 5e6\n"
      "fix m2 all property/global poissonsRatio peratomtype 0.25 0.25\n"
      "fix m3 all property/global coefficientRestitution peratomtypepair 2 0.6 0.6 0.6 0.6\n"
      "fix m4 all property/global coefficientFriction peratomtypepair 2 0.5 0.5 0.5 0.5\n"
      "fix m5 all property/global coefficientRollingFriction peratomtypepair 2 0.1 0.1 0.1 0.1\n"
      "fix m6 all property/global coefficientRollingViscousDamping peratomtypepair 2 0.2 0.2 0.2 0.2\n"
      "fix m7 all property/global characteristicVelocity scalar 0.1\n"
      "pair_style gran model " +
      model + word + "\npair_coeff * *\n";
  for (int i = 0; i < 40; i++)
    s += "create_atoms 1 single " + std::to_string(-0.004 + 0.002 * (i % 4) + 1e-5 * (i % 3)) + " " +
        std::to_string(-0.004 + 0.002 * (i / 4 % 4)) + " " + std::to_string(0.001 + 0.0019 * (i / 16)) + " units box\n";
  return s +
      "set group all diameter 2e-3 density 2600\nfix nve all nve/sphere\nfix grav all gravity 9.81 vector 0 0 -1\n" +
      "fix floor all wall/gran model " + model + wall_word + " primitive type 1 zplane 0.\ntimestep 1e-5\nrun 300\n";
}

const std::string HERTZ = "hertz tangential history";

void expect_as_stock(Offered &ours, const std::string &script)
{
  Host stock;
  stock(script);
  const auto a = stock.atoms(), b = ours.host.atoms();
  ASSERT_EQ(a.size(), 40u);
  for (std::size_t i = 0; i < a.size(); i++)
    for (int d = 0; d < 3; d++) {
      EXPECT_NEAR(b[i].x[d], a[i].x[d], 1e-13);
      EXPECT_NEAR(b[i].v[d], a[i].v[d], 1e-9);
    }
}

}  // namespace

TEST(LeanOffer, othersScriptsRunLean)
{
  for (const std::string model : {HERTZ, std::string("hooke tangential history"), std::string("hertz")}) {
    Offered ours("offer_lean");
    ours.host(heap(model));
    EXPECT_GT(ours.near_pairs(), 20) << model;
    EXPECT_TRUE(ours.lean_floor()) << model;
    expect_as_stock(ours, heap(model));
    const std::string friction = model == "hertz" ? "off" : "history";
    if (ours.first())
      EXPECT_EQ(ours.said(),
                "Contacts of pair gran: the lean loop, model " + model.substr(0, 5) + " tangential " + friction + "\n");
  }
}

TEST(LeanOffer, aWordLeavesTheOwnLoop)
{
  Offered ours("offer_no");
  ours.host(heap(HERTZ, " lean no"));
  EXPECT_EQ(ours.near_pairs(), 0);
  EXPECT_FALSE(ours.lean_floor());  // goes with the pair style
  expect_as_stock(ours, heap(HERTZ));
  if (ours.first()) EXPECT_EQ(ours.said(), "Contacts of pair gran: LIGGGHTS's own loop, as the script says lean no\n");

  Offered wall("offer_no_wall");
  wall.host(heap(HERTZ, " lean yes", " lean no"));
  EXPECT_GT(wall.near_pairs(), 20);
  EXPECT_FALSE(wall.lean_floor());

  Offered yes("offer_yes_wall");
  yes.host(heap(HERTZ, " lean no", " lean yes"));
  EXPECT_EQ(yes.near_pairs(), 0);
  EXPECT_TRUE(yes.lean_floor());
}

TEST(LeanOffer, whatItCannotDoRunsAsBefore)
{
  const std::string model = HERTZ + " rolling_friction epsd";
  Offered ours("offer_odd");
  ours.host(heap(model));
  EXPECT_EQ(ours.near_pairs(), 0);
  EXPECT_FALSE(ours.lean_floor());
  expect_as_stock(ours, heap(model));
  if (ours.first()) {
    const std::string why = "LIGGGHTS's own loop, as 'rolling_friction epsd' is not among what it can do\n";
    const std::string said = ours.said();
    EXPECT_NE(said.find("Contacts of fix floor wall/gran: " + why), std::string::npos) << said;
    EXPECT_NE(said.find("Contacts of pair gran: " + why), std::string::npos) << said;
  }
}

TEST(LeanOffer, settingsOfTheRunCount)
{
  const std::string further = "neigh_modify contact_distance_factor 1.1\n";
  Offered ours("offer_further");
  ours.host(heap(HERTZ, "", "", further));
  EXPECT_EQ(ours.near_pairs(), 0);
  expect_as_stock(ours, heap(HERTZ, "", "", further));
  if (ours.first())
    EXPECT_EQ(ours.said(), "Contacts of pair gran: LIGGGHTS's own loop, as contact_distance_factor must be 1\n");

  // which LIGGGHTS allows without history
  std::string newton = heap("hertz tangential no_history");
  newton.replace(newton.find("newton off"), 10, "newton on");
  Offered both("offer_newton");
  both.host(newton);
  EXPECT_EQ(both.near_pairs(), 0);
  expect_as_stock(both, newton);
  if (both.first()) EXPECT_EQ(both.said(), "Contacts of pair gran: LIGGGHTS's own loop, as newton must be off\n");
}

// a restart file of gran goes on in the lean loop, in which pair_style stands again
TEST(LeanOffer, goesOnFromARestart)
{
  Host first;
  first(heap(HERTZ) + "write_restart offer.restart\nrun 100\n");
  std::string again = heap(HERTZ);
  again.replace(0, again.find("fix m1"),
                "atom_style granular\natom_modify map array\nnewton off\ncommunicate single vel yes\nprocessors * * *\n"
                "read_restart offer.restart\nneighbor 0.0005 bin\nneigh_modify delay 0\n");
  again.erase(again.find("create_atoms"), again.find("fix nve") - again.find("create_atoms"));
  again.replace(again.find("run 300"), 7, "run 100");
  Offered ours("offer_restart");
  ours.host(again);
  EXPECT_GT(ours.near_pairs(), 20);
  const auto a = first.atoms(), b = ours.host.atoms();
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); i++)
    for (int d = 0; d < 3; d++) EXPECT_NEAR(b[i].v[d], a[i].v[d], 1e-9);
}
