// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>

#include "allocations.h"
#include "clumps/clump_geometry.h"
#include "contacts/pair_gran_lean.h"
#include "coupling/run_checks.h"
#include "host.h"

using test::Host;

namespace {

const double k = 5000, gamma_n = 4000;

std::string stiff()
{
  return "fix p1 all property/global kn peratomtypepair 2 5000 5000 5000 5000\n"
         "fix p2 all property/global kt peratomtypepair 2 5000 5000 5000 5000\n"
         "fix p3 all property/global gamman peratomtypepair 2 4000 4000 4000 4000\n"
         "fix p4 all property/global gammat peratomtypepair 2 4000 4000 4000 4000\n"
         "fix p5 all property/global coefficientFriction peratomtypepair 2 0.5 0.5 0.5 0.5\n"
         "pair_style gran model hooke/stiffness tangential history\npair_coeff * *\n";
}

// two spheres that overlap by 1e-5 m and come together at 0.02 m/s
std::string pressed()
{
  return "create_atoms 1 single 0 0 0 units box\ncreate_atoms 2 single 1.99e-3 0 0 units box\n"
         "set group all diameter 2e-3\nset group all density 2600\ngroup left type 1\n"
         "velocity left set 0.02 0 0 units box\nfix nve all nve/sphere\ntimestep 1e-7\nrun 0\n";
}

// one illite plate, its faces level, that has come to rest on the floor
std::string resting()
{
  return test::opening("f f f", "-0.01 0.01 -0.01 0.01 -0.001 0.01") + stiff() +
      "fix g all gravity 9.81 vector 0 0 -1\n"
      "fix floor all wall/gran model hooke/stiffness tangential history primitive type 1 zplane 0.0\n"
      "fix ill all particletemplate/clay illite seed 15485863 type 1 atom_types 1 2 radius 1e-3 density 2600\n"
      "fix pdd all particledistribution/discrete 32452843 1 ill 1.0\nfix ms all multisphere\n"
      "region ins block -0.002 0.002 -0.002 0.002 0.0016 0.0026 units box\n"
      "fix ins all insert/pack seed 49979687 distributiontemplate pdd insert_every once overlapcheck no "
      "orientation template all_in no vel constant 0 0 0 region ins particles_in_region 1 ntry_mc 10000\n"
      "timestep 2e-6\nthermo 10000\nrun 12000\n";
}

// the longest stable step of the plate that rests on the floor with seven spheres
double exact_limit()
{
  const auto clump = clay::illitePlate({1e-3, 2e-3, 1e-3, 2});
  const auto g = clay::sumOfSpheres(clump);
  const double m = 2600 * g.volume;
  std::vector<clay::BodyContact> floor;
  for (int i = 0; i < 7; i++)
    floor.push_back(
        {clump[i].x - Eigen::Vector3d(0, 0, 1e-3), -Eigen::Vector3d::UnitZ(), {k, k, gamma_n * m, gamma_n * m}, true});
  return clay::stableStep(m, 2600 * g.inertia, floor);
}

double kinetic(Host &host)
{
  double e = 0;
  for (const auto &a : host.atoms()) e += a.v[0] * a.v[0] + a.v[1] * a.v[1] + a.v[2] * a.v[2];
  return e;
}

}  // namespace

TEST(RunChecks, coefficientsAreThoseOfTheHost)
{
  for (int stiffness = 0; stiffness < 2; stiffness++) {
    Host host;
    host(test::opening("f f f", "-0.01 0.01 -0.01 0.01 -0.01 0.01") +
         (stiffness ? stiff() : test::material("coul/clump 0.006") + "pair_coeff * * coul/clump 0.0\n") + pressed());
    const LAMMPS_NS::ContactModel model(host.lmp.get());
    ASSERT_TRUE(model.known());
    const auto a = host.atoms();
    const double m = a[0].rmass;
    const auto c = model.between(1, 2, m / 2, 0.5e-3);
    const double expected = c.kn * 1e-5 + c.cn * 0.02;
    EXPECT_NEAR(a[1].f[0], expected, 1e-6 * expected);
    EXPECT_GT(c.cn * 0.02, 1e-3 * expected);
  }
}

TEST(RunChecks, otherModelsAreNotJudged)
{
  Host host;
  host(test::opening("f f f", "-0.01 0.01 -0.01 0.01 -0.01 0.01") +
       "fix m1 all property/global youngsModulus peratomtype 5e6 5e6\n"
       "fix m2 all property/global poissonsRatio peratomtype 0.25 0.25\n"
       "fix m3 all property/global coefficientRestitution peratomtypepair 2 0.3 0.3 0.3 0.3\n"
       "fix m4 all property/global coefficientFriction peratomtypepair 2 0.5 0.5 0.5 0.5\n"
       "pair_style gran model hertz tangential history\npair_coeff * *\n" +
       pressed());
  EXPECT_FALSE(LAMMPS_NS::ContactModel(host.lmp.get()).known());
  EXPECT_TRUE(std::isinf(LAMMPS_NS::resting_step_limit(host.lmp.get())));
  EXPECT_TRUE(std::isinf(LAMMPS_NS::present_step_limit(host.lmp.get())));
}

// the smallest of those that move, with the stiffest material of the script
TEST(RunChecks, rayleighTime)
{
  const auto script = [](const std::string &moduli, const std::string &model) {
    return test::opening("f f f", "-0.01 0.01 -0.01 0.01 -0.01 0.01") +
        "fix m1 all property/global youngsModulus peratomtype " + moduli +
        "\nfix m2 all property/global poissonsRatio peratomtype 0.25 0.25\n"
        "fix m3 all property/global coefficientRestitution peratomtypepair 2 0.3 0.3 0.3 0.3\n"
        "fix m4 all property/global coefficientFriction peratomtypepair 2 0.5 0.5 0.5 0.5\n"
        "fix m5 all property/global characteristicVelocity scalar 0.1\n"
        "pair_style gran model " +
        model + " tangential history\npair_coeff * *\n" + pressed() +
        "set type 2 diameter 1e-3\nset type 2 density 2600\nrun 0\n";
  };
  const auto time = [](double r, double E) { return clay::rayleighTime(r * std::sqrt(2600.), E, 0.25); };
  std::string which;
  Host host;
  host(script("5e6 5e6", "hertz"));
  const double E = clay::effectiveModulus(5e6, 0.25, 5e6, 0.25), usual = time(0.5e-3, E);
  EXPECT_NEAR(LAMMPS_NS::rayleigh_step(host.lmp.get(), &which), usual, 1e-9 * usual);
  EXPECT_EQ(which, "spheres of type 2");
  for (const char *offered : {"hertz", "gran/lean"}) {  // in the lean loop, either way
    std::string text = script("5e6 5e6", "hertz");
    Host lean;
    LAMMPS_NS::offer_lean_contacts(lean.lmp.get());
    if (offered[0] == 'g') text.replace(text.find("gran model"), 4, offered);
    lean(text);
    ASSERT_NE(dynamic_cast<LAMMPS_NS::PairGranLean *>(LAMMPS_NS::granular_pair(lean.lmp.get())), nullptr);
    EXPECT_NEAR(LAMMPS_NS::rayleigh_step(lean.lmp.get(), &which), usual, 1e-9 * usual);
  }
  host("unfix nve\nfix nve left nve/sphere\nrun 0\n");
  EXPECT_NEAR(LAMMPS_NS::rayleigh_step(host.lmp.get(), &which), 2 * usual, 1e-9 * usual);
  EXPECT_EQ(which, "spheres of type 1");

  // of another material, as a wall's may be
  Host pair;
  pair(script("5e8 5e6", "hertz"));
  const double stiff = time(0.5e-3, clay::effectiveModulus(5e6, 0.25, 5e8, 0.25));
  const double alone = time(1e-3, clay::effectiveModulus(5e8, 0.25, 5e8, 0.25));
  EXPECT_NEAR(LAMMPS_NS::rayleigh_step(pair.lmp.get()), std::min(stiff, alone), 1e-9 * alone);
  pair("unfix nve\ngroup right type 2\nfix nve right nve/sphere\nrun 0\n");
  EXPECT_NEAR(LAMMPS_NS::rayleigh_step(pair.lmp.get()), stiff, 1e-9 * stiff);

  Host other;
  other(script("5e6 5e6", "hooke"));
  EXPECT_TRUE(std::isinf(LAMMPS_NS::rayleigh_step(other.lmp.get())));
}

// 1, 2, 4: x, y, z
TEST(RunChecks, axesThatFixesSet)
{
  const auto held = [](const std::string &fix) {
    Host host;
    host(test::opening("f f f", "-0.01 0.01 -0.01 0.01 -0.01 0.01") + "fix nve all nve/sphere\n" + fix + "\n");
    return LAMMPS_NS::moving_groups(host.lmp.get()).held(1);
  };
  EXPECT_EQ(held(""), 0);
  EXPECT_EQ(held("fix h all setforce 0 NULL 0"), 1 | 4);
  EXPECT_EQ(held("fix h all planeforce 0 2 0"), 2);
  EXPECT_EQ(held("fix h all lineforce 0 2 0"), 1 | 4);
  EXPECT_EQ(held("fix h all enforce2d"), 4);
}

TEST(RunChecks, limitsOfAPlateAtRest)
{
  Host host;
  host(resting());
  ASSERT_EQ(host.atoms().size(), 14u);
  EXPECT_LT(kinetic(host), 1e-12);
  int contacts = 0;
  const double now = LAMMPS_NS::present_step_limit(host.lmp.get(), &contacts);
  EXPECT_EQ(contacts, 7);
  std::string which;
  const double worst = LAMMPS_NS::resting_step_limit(host.lmp.get(), &which);
  EXPECT_EQ(which, "a clump 'ill'");
  EXPECT_LT(worst, now);

  // seven contacts with the floor, exactly
  const double exact = exact_limit();
  EXPECT_NEAR(now, exact, 2e-3 * exact);
}

namespace {

// illite clumps as a list has them
std::string listed(const std::string &processors, const std::string &boundary, const std::string &list)
{
  int rank;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0) std::ofstream("run_checks.txt") << list;
  MPI_Barrier(MPI_COMM_WORLD);
  std::string start = test::opening(boundary, "-0.02 0.02 -0.02 0.02 -0.04 0.04");
  start.replace(start.find("* * *"), 5, processors);
  return start + stiff() +
      "fix ill all particletemplate/clay illite seed 15485863 type 1 atom_types 1 2 radius 1e-3 density 2600\n"
      "fix ms all multisphere\nfix put all insert/placed file run_checks.txt templates ill verbose no\n"
      "timestep 1e-6\nrun 0\n";
}

}  // namespace

// two plates face to face, seven contacts: in the middle of a processor, across the border of
// two, through a periodic side
TEST(RunChecks, sameLimitWhereverThePlatesAre)
{
  const auto limit = [](const std::string &boundary, double x, double z, int *contacts) {
    Host host;
    std::ostringstream list;
    list.precision(17);
    const double q1 = std::sqrt(1 - 0.99 * 0.99), axis[2] = {-2 * 0.99 * q1, 1 - 2 * q1 * q1};
    for (double along : {-1.49e-3, 1.49e-3})
      list << "ill " << x << ' ' << 0.001 + along * axis[0] << ' ' << z + along * axis[1] << " 0.99 " << q1 << " 0 0\n";
    host(listed("1 1 *", boundary, list.str()));
    return LAMMPS_NS::present_step_limit(host.lmp.get(), contacts);
  };
  int here = 0, contacts = 0;
  const double usual = limit("f f f", 0.003, 0.02, &here);
  EXPECT_EQ(here, 7);
  EXPECT_LT(usual, 1e-4);
  EXPECT_NEAR(limit("f f f", 0.003, 0.0003, &contacts), usual, 1e-9 * usual);  // the border is at 0
  EXPECT_EQ(contacts, here);
  EXPECT_NEAR(limit("p f f", 0.0195, 0.0003, &contacts), usual, 1e-9 * usual);
  EXPECT_EQ(contacts, here);
}

// many bodies on one processor, two on the other: what that one keeps has nothing to do
// with all of them
TEST(RunChecksParallel, memoryGoesByOwnBodies)
{
  ASSERT_EQ(test::processors(), 2);
  int rank;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  double most[2];
  for (int k = 0; k < 2; k++) {
    std::string list = "ill 0 0 0.0301 1 0 0 0\nill 0 0 0.03309 1 0 0 0\n";
    const int layers = k ? 8 : 2;
    for (int n = 0; n < 25 * layers; n++)
      list += "ill " + std::to_string(-0.0124 + 0.0062 * (n % 5)) + ' ' +
          std::to_string(-0.0124 + 0.0062 * (n / 5 % 5)) + ' ' + std::to_string(-0.037 + 0.00299 * (n / 25)) +
          " 1 0 0 0\n";
    Host host;
    host(listed("1 1 2", "f f f", list));
    ASSERT_EQ(host.multisphere()->n_body(), rank ? 2 : 25 * layers);
    const test::Allocations allocations;
    int contacts;
    LAMMPS_NS::present_step_limit(host.lmp.get(), &contacts);
    EXPECT_GT(contacts, 2);
    most[k] = allocations.most();
  }
  EXPECT_GT(most[0], 2 * 89 * 8);
  if (rank) EXPECT_LT(most[1], 1.02 * most[0]);
  else EXPECT_GT(most[1], 2 * most[0]);
}

TEST(RunChecks, theHostBlowsUpWhereTheLimitSays)
{
  const double limit = exact_limit();
  for (double factor : {0.85, 1.15}) {
    Host host;
    std::ostringstream s;
    s.precision(17);
    s << resting() << "unfix g\nfix g all gravity 9.81 vector 0.001 0 -1\ntimestep " << factor * limit
      << "\nrun 3000\n";
    host(s.str());
    if (factor < 1) EXPECT_LT(kinetic(host), 1e-12);
    else EXPECT_GT(kinetic(host), 1e-8);
  }
}

// of the spheres there are the lightest decides; the limit is that of its contacts
TEST(RunChecks, sphereAtRest)
{
  Host host;
  host(test::opening("f f f", "-0.01 0.01 -0.01 0.01 -0.01 0.01") + stiff() + pressed());
  std::string which;
  const double limit = LAMMPS_NS::resting_step_limit(host.lmp.get(), &which);
  EXPECT_EQ(which, "a sphere of type 1");
  const double m = host.atoms()[0].rmass, r = 1e-3;
  const LAMMPS_NS::ContactModel model(host.lmp.get());
  // what holds it below and aside are walls; above, another sphere: contacts on two opposite
  // sides and one across, of which those with a wall count once
  const auto wall = model.between(1, 1, m, r), other = model.between(1, 1, m / 2, r / 2);
  const std::vector<clay::BodyContact> around = {
      {{0, 0, -r}, {0, 0, -1}, wall, true}, {{r, 0, 0}, {1, 0, 0}, wall, true}, {{0, 0, r}, {0, 0, 1}, other, false}};
  EXPECT_NEAR(limit, clay::stableStep(m, 0.4 * m * r * r * Eigen::Matrix3d::Identity(), around), 1e-9 * limit);

  host("set type 2 diameter 1e-3\nset type 2 density 2600\nrun 0\n");
  EXPECT_LT(LAMMPS_NS::resting_step_limit(host.lmp.get(), &which), 0.7 * limit);
  EXPECT_EQ(which, "a sphere of type 2");

  // what no fix moves has no limit
  host("unfix nve\ngroup right type 2\nfix nve left nve/sphere\nrun 0\n");
  EXPECT_NEAR(LAMMPS_NS::resting_step_limit(host.lmp.get(), &which), limit, 1e-12);
  EXPECT_EQ(which, "a sphere of type 1");
}

namespace {

std::string charged(const std::string &law)
{
  return test::opening("f f f", "-0.01 0.01 -0.01 0.01 -0.01 0.01") +
      "fix p1 all property/global kn peratomtypepair 2 5000 5000 5000 5000\n"
      "fix p2 all property/global kt peratomtypepair 2 5000 5000 5000 5000\n"
      "fix p3 all property/global gamman peratomtypepair 2 4000 4000 4000 4000\n"
      "fix p4 all property/global gammat peratomtypepair 2 4000 4000 4000 4000\n"
      "fix p5 all property/global coefficientFriction peratomtypepair 2 0.5 0.5 0.5 0.5\n"
      "pair_style hybrid/overlay gran model hooke/stiffness tangential history coul/clump 0.012 " +
      law + "\npair_coeff * * gran\npair_coeff 1 1 coul/clump 1e-8\npair_coeff 2 2 coul/clump -1e-8\n" + pressed();
}

}  // namespace

TEST(RunChecks, chargesAgainstStiffness)
{
  Host host;
  host(charged(""));
  const auto c = LAMMPS_NS::charged_contact(host.lmp.get());
  EXPECT_EQ(c.first, 1);
  EXPECT_EQ(c.second, 2);
  const double pull = 8.9875517873681764e9 * 1e-16, d = 2e-3;
  EXPECT_NEAR(c.overlap, clay::attractedOverlap([&](double r) { return pull / (r * r); }, 5000, d), 1e-12);
  // from the cut-off to contact: all that potential energy in the spring
  const double energy = pull * (1 / d - 1 / 0.012);
  EXPECT_NEAR(c.impact, std::sqrt(2 * energy / 5000) / d, 1e-6);
  EXPECT_NEAR(std::sqrt(2 * energy / c.wanted) / d, 0.1, 1e-6);

  Host plain;
  plain(test::opening("f f f", "-0.01 0.01 -0.01 0.01 -0.01 0.01") + stiff() + pressed());
  EXPECT_EQ(LAMMPS_NS::charged_contact(plain.lmp.get()).impact, 0);
}

// at the overlap that is found the spring holds what the screened law pulls with
TEST(RunChecks, screenedChargesAgainstStiffness)
{
  Host host;
  host(charged("screened 5e-4 points"));
  const auto c = LAMMPS_NS::charged_contact(host.lmp.get());
  const double d = 2e-3, r = d * (1 - c.overlap), L = 5e-4;
  const double pull = 8.9875517873681764e9 * 1e-16 * std::exp(-r / L) * (1 / (r * r) + 1 / (L * r));
  EXPECT_NEAR(5000 * c.overlap * d / pull, 1, 1e-9);

  // spheres of 1 mm keep ions off, which screen the less: exp(a/L)/(1 + a/L) twice
  Host spheres;
  spheres(charged("screened 5e-4"));
  const auto s = LAMMPS_NS::charged_contact(spheres.lmp.get());
  const double q = d * (1 - s.overlap), more = std::exp(4.) / 9;
  const double harder = more * 8.9875517873681764e9 * 1e-16 * std::exp(-q / L) * (1 / (q * q) + 1 / (L * q));
  EXPECT_NEAR(5000 * s.overlap * d / harder, 1, 1e-9);
  EXPECT_EQ(s.by, "the charges");
}

// of van der Waals forces, which stay as they are in contact, spheres of one type are held as others are
TEST(RunChecks, pullOfDlvoAgainstStiffness)
{
  Host host;
  host(
      test::opening("f f f", "-0.01 0.01 -0.01 0.01 -0.01 0.01") +
      "fix p1 all property/global kn peratomtypepair 2 5 5 5 5\n"
      "fix p2 all property/global kt peratomtypepair 2 5 5 5 5\n"
      "fix p3 all property/global gamman peratomtypepair 2 1 1 1 1\n"
      "fix p4 all property/global gammat peratomtypepair 2 1 1 1 1\n"
      "fix p5 all property/global coefficientFriction peratomtypepair 2 0.5 0.5 0.5 0.5\n"
      "pair_style hybrid/overlay gran model hooke/stiffness tangential history dlvo/clump 1e-3 debye 1e-4 hamaker 3e-9 "
      "contact 2e-5\npair_coeff * * gran\npair_coeff * * dlvo/clump 0\n" +
      pressed());
  const auto c = LAMMPS_NS::charged_contact(host.lmp.get());
  EXPECT_EQ(c.by, "dlvo/clump");
  const double pull = 3e-9 * 5e-4 / (6 * 4e-10), energy = 3e-9 * 5e-4 / 6 * (1 / 2e-5 - 1 / 1e-3) + pull * 2e-5;
  EXPECT_NEAR(c.overlap, pull / 5 / 2e-3, 1e-9);
  EXPECT_NEAR(c.impact, std::sqrt(2 * energy / 5) / 2e-3, 1e-6);
}
