// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>

#include "host.h"

using test::Host;

namespace {

std::vector<std::array<double, 5>> rows(const std::string &file, std::string *header)
{
  std::vector<std::array<double, 5>> table;
  std::ifstream in(file);
  std::getline(in, *header);
  for (std::string line; std::getline(in, line);) {
    std::array<double, 5> r;
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream words(line);
    for (double &v : r) words >> v;
    table.push_back(r);
  }
  return table;
}

const char *name = "settling_test.csv";

}  // namespace

TEST(FixSettlingCurve, spheresInLayers)
{
  // a column of 20 mm side with layers of 25 spheres, 4 mm apart, the lowest 2 mm up
  std::ostringstream s;
  s << test::opening("f f f", "0 0.02 0 0.02 -0.004 0.1") << test::material("coul/clump 0.006")
    << "pair_coeff * * coul/clump 0.0\n"
       "fix floor all wall/gran model hooke tangential history primitive type 1 zplane 0.0\n";
  for (int l = 0; l < 20; l++)
    for (int i = 0; i < 25; i++)
      s << "create_atoms 1 single " << 0.002 + 0.004 * (i % 5) << ' ' << 0.002 + 0.004 * (i / 5) << ' '
        << 0.002 + 0.004 * l << " units box\n";
  s << "set type 1 diameter 3e-3\nset type 1 density 2600\nfix nve all nve/sphere\ntimestep 1e-6\n"
    << "fix sc all settling/curve 10 file " << name << " scale 8.64e4 bed_fraction 0.15\n"
    << "thermo_style custom step f_sc[1] f_sc[4]\nrun 25\n";
  {
    Host host;
    host(s.str());
    EXPECT_NEAR(host.fix("sc")->compute_vector(2), 0.04, 1e-9);
    EXPECT_EQ(host.fix("sc")->compute_vector(3), 0);  // nothing touches
    EXPECT_NEAR(host.fix("sc")->compute_vector(4), 500 * 4.0 / 3 * M_PI * std::pow(1.5e-3, 3), 1e-15);
  }
  std::string header;
  const auto table = rows(name, &header);
  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_EQ(header, "time_s,time_days,interface_m,bed_m,mean_height_m");
  ASSERT_EQ(table.size(), 3u);
  EXPECT_NEAR(table[2][0], 20e-6, 1e-12);
  EXPECT_NEAR(table[2][1], 20e-6, 1e-12);
  EXPECT_NEAR(table[0][2], 0.08, 0.002);  // top of the uppermost layer's share
  EXPECT_NEAR(table[0][3], 0.08, 0.003);  // solid fraction 0.22: all of it is bed
  EXPECT_NEAR(table[0][4], 0.04, 1e-12);
  std::remove(name);
}

// two spheres 0.15 mm into each other, on both sides of the middle, which may be a border of processors;
// then one of them deeper in a wall, and a wall for others only
TEST(FixSettlingCurve, largestOverlapOfSpheresAndWalls)
{
  const std::string model = "model hooke/stiffness tangential history";
  struct Case {
    std::string style, coeff, wall;
  };
  const Case cases[] = {{"gran " + model, "* *", "wall/gran "},
                        {"gran/lean " + model, "* *", "wall/gran/lean "},
                        {"hybrid/overlay gran/lean " + model + " coul/clump 0.01", "* * gran/lean", "wall/gran/lean "}};
  for (const Case &c : cases) {
    const auto overlap = [&c, &model](const std::string &more) {
      Host host;
      host(test::opening("f f f", "0 0.02 0 0.02 0 0.1") +
           "fix m1 all property/global kn peratomtypepair 2 100 100 100 100\n"
           "fix m2 all property/global kt peratomtypepair 2 100 100 100 100\n"
           "fix m3 all property/global gamman peratomtypepair 2 1 1 1 1\n"
           "fix m4 all property/global gammat peratomtypepair 2 1 1 1 1\n"
           "fix m5 all property/global coefficientFriction peratomtypepair 2 0.5 0.5 0.5 0.5\n"
           "pair_style " +
           c.style + "\npair_coeff " + c.coeff + "\n" +
           (c.style[0] == 'h' ? "pair_coeff 1 1 coul/clump 0\npair_coeff 2 2 coul/clump 0\n" : "") +
           "create_atoms 1 single 0.01 0.01 0.0486 units box\ncreate_atoms 1 single 0.01 0.01 0.05145 units box\n"
           "set group all diameter 3e-3 density 2600\nfix nve all nve/sphere\ngroup none type 2\n" +
           more + "timestep 1e-6\nfix sc all settling/curve 10 file " + name + "\nrun 0\n");
      return host.fix("sc")->compute_vector(3);
    };
    const std::string in = c.wall + model + " primitive type 1 zplane ";
    EXPECT_NEAR(overlap(""), 0.05, 1e-9) << c.style;
    EXPECT_NEAR(overlap("fix far all " + in + "0.04695\n"), 0.05, 1e-9) << c.style;
    EXPECT_NEAR(overlap("fix near all " + in + "0.0474\n"), 0.1, 1e-9) << c.style;
    EXPECT_NEAR(overlap("fix others none " + in + "0.0474\n"), 0.05, 1e-9) << c.style;
  }
  std::remove(name);
}

TEST(FixSettlingCurve, crossSectionComesFromTheColumnsWall)
{
  const std::string start = test::opening("f f f", "-0.0165 0.0165 -0.0165 0.0165 -0.001 0.151") +
      "region ins cylinder z 0 0 0.01625 0.0 0.15 units box\n" + test::material("coul/clump 0.006") +
      "pair_coeff * * coul/clump 0.0\n"
      "fix w1 all wall/gran model hooke tangential history primitive type 1 zplane 0.01\n"
      "fix w2 all wall/gran model hooke tangential history primitive type 1 zcylinder 0.01625 0. 0.\n" +
      test::clumps(60) + "timestep 1e-6\n";
  double bed[2], mean[2];
  for (int given = 0; given < 2; given++) {
    Host host;
    std::ostringstream s;
    s << start << "fix sc all settling/curve 1 file " << name << " bed_fraction 0.01";
    if (given) s.precision(17), s << " area " << M_PI * 0.01625 * 0.01625 << " bottom 0.01";
    host(s.str() + "\nrun 1\n");
    bed[given] = host.fix("sc")->compute_vector(1);
    mean[given] = host.fix("sc")->compute_vector(2);
  }
  EXPECT_DOUBLE_EQ(mean[0], mean[1]);
  EXPECT_NEAR(bed[0], bed[1], 1e-9);
  std::remove(name);
}

TEST(FixSettlingCurve, clumpsCountWithTheirVolume)
{
  for (const char *volume : {"volume sum", "volume union"}) {
    Host host;
    host(test::opening("f f f", "-0.0165 0.0165 -0.0165 0.0165 -0.001 0.151") +
         "region ins cylinder z 0 0 0.01625 0 0.15 units box\n" + test::material("coul/clump 0.006") +
         "pair_coeff * * coul/clump 0.0\n" + test::clumps(135, volume) + "fix sc all settling/curve 1 file " + name +
         "\ntimestep 1e-6\nrun 1\n");
    const double sum = 1890 * 4.0 / 3 * M_PI * 1e-9;
    EXPECT_NEAR(host.fix("sc")->compute_vector(4), volume[7] == 's' ? sum : sum / 2 * 27 / 16, 1e-12 * sum);
    // the suspension fills the column but for what a clump's ball leaves free at the ends
    EXPECT_NEAR(host.fix("sc")->compute_vector(0), 0.15, 0.006);
    EXPECT_EQ(host.fix("sc")->compute_vector(1), 0);
  }
  std::remove(name);
}
