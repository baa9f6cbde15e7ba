// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>

#include "host.h"
#include "pair.h"
#include "coulomb/pair_coul_clump.h"
#include "update.h"

using test::Host;

namespace {

const double k = 8.9875517873681764e9;

std::string two(const std::string &style, double apart)
{
  std::ostringstream s;
  s.precision(17);
  s << test::opening("f f f", "-0.01 0.01 -0.01 0.01 -0.01 0.01") << test::material(style)
    << "pair_coeff 1 1 coul/clump 2e-10\npair_coeff 2 2 coul/clump -3e-10\n"
    << "create_atoms 1 single " << -apart / 2 << " 0 0 units box\n"
    << "create_atoms 2 single " << apart / 2 << " 0 0 units box\n"
    << "set type 1 diameter 1e-3\nset type 2 diameter 1e-3\n"
    << "set type 1 density 2600\nset type 2 density 2600\n"
    << "fix nve all nve/sphere\ntimestep 1e-6\n";
  return s.str();
}

struct Errors {
  double force, torque;
};

// largest difference of the forces on bodies and loose spheres, and of the torques on
// bodies about their first spheres, from pairs counted one by one, minimum image in the
// periodic directions, over the largest force or torque
Errors against_brute_force(const std::vector<test::Atom> &atoms, const double *charge, double cutoff,
                           const double *period, long *acting)
{
  struct Sum {
    double wanted[6], got[6];
    const test::Atom *first;
  };
  std::map<int, Sum> sums;
  *acting = 0;
  for (const test::Atom &i : atoms) {
    double f[3] = {0, 0, 0};
    for (const test::Atom &j : atoms) {
      if (i.tag == j.tag || (i.body >= 0 && i.body == j.body)) continue;
      double d[3], r2 = 0;
      for (int c = 0; c < 3; c++) {
        d[c] = i.x[c] - j.x[c];
        if (period[c] > 0) d[c] -= period[c] * std::round(d[c] / period[c]);
        r2 += d[c] * d[c];
      }
      if (r2 >= cutoff * cutoff) continue;
      ++*acting;
      for (int c = 0; c < 3; c++) f[c] += k * charge[i.type] * charge[j.type] * d[c] / std::pow(r2, 1.5);
    }
    Sum &sum = sums.insert({i.body >= 0 ? i.body : -1 - i.tag, Sum{{}, {}, &i}}).first->second;
    double r[3];
    for (int c = 0; c < 3; c++) {
      r[c] = i.x[c] - sum.first->x[c];
      if (period[c] > 0) r[c] -= period[c] * std::round(r[c] / period[c]);
    }
    for (int c = 0; c < 3; c++) {
      const int d = (c + 1) % 3, e = (c + 2) % 3;
      sum.wanted[c] += f[c];
      sum.wanted[3 + c] += r[d] * f[e] - r[e] * f[d];
      sum.got[c] += i.f[c];
      sum.got[3 + c] += r[d] * i.f[e] - r[e] * i.f[d] + i.torque[c];
    }
  }
  double error[2] = {0, 0}, largest[2] = {0, 0};
  for (const auto &s : sums)
    for (int c = 0; c < 6; c++) {
      error[c / 3] = std::max(error[c / 3], std::abs(s.second.wanted[c] - s.second.got[c]));
      largest[c / 3] = std::max(largest[c / 3], std::abs(s.second.wanted[c]));
    }
  return {error[0] / largest[0], error[1] / largest[1]};
}

}  // namespace

TEST(PairCoulClump, forceByTheFormula)
{
  struct Case {
    const char *style;
    double r, expected;
  };
  const double qq = 2e-10 * -3e-10;
  const Case cases[] = {
      {"coul/clump 0.006", 0.004, k * qq / 1.6e-5},
      {"coul/clump 0.006 sharp", 0.0059, k * qq / (0.0059 * 0.0059)},
      {"coul/clump 0.006", 0.0061, 0},
      {"coul/clump 0.006 shifted", 0.004, k * qq * (1 / 1.6e-5 - 1 / 3.6e-5)},
      {"coul/clump 0.006 permittivity 78.5", 0.004, k * qq / 1.6e-5 / 78.5},
      {"coul/clump 0.006 screened 1e-3 points", 0.004, k * qq / 1.6e-5 * 5 * std::exp(-4.)},
      {"coul/clump 0.006 screened 1e-3 points", 0.0061, 0},
      {"coul/clump 0.006 screened 1e-3 points permittivity 78.5", 0.004, k * qq / 1.6e-5 * 5 * std::exp(-4.) / 78.5},
      {"coul/clump 0.006 shifted screened 1e-3 points", 0.004,
       k * qq * (5 * std::exp(-4.) / 1.6e-5 - 7 * std::exp(-6.) / 3.6e-5)},
      // radii of 0.5 mm: (exp(0.5)/1.5)^2
      {"coul/clump 0.006 screened 1e-3", 0.004, k * qq / 1.6e-5 * 5 * std::exp(-3.) / 2.25},
      {"coul/clump 0.006 screened 1e-3 spheres", 0.004, k * qq / 1.6e-5 * 5 * std::exp(-3.) / 2.25},
      {"coul/clump 0.006 shifted screened 1e-3", 0.004,
       k * qq * (5 * std::exp(-3.) / 1.6e-5 - 7 * std::exp(-5.) / 3.6e-5) / 2.25},
  };
  for (const Case &c : cases) {
    Host host;
    host(two(c.style, c.r) + "run 0\n");
    const auto a = host.atoms();
    ASSERT_EQ(a.size(), 2u);
    // unlike charges: the left one is drawn to the right
    EXPECT_NEAR(a[0].f[0], -c.expected, 1e-12 * std::abs(c.expected)) << c.style;
    EXPECT_NEAR(a[1].f[0], c.expected, 1e-12 * std::abs(c.expected)) << c.style;
  }
}

TEST(PairCoulClump, energyAndSingle)
{
  Host host;
  host(two("coul/clump 0.006", 0.004) + "compute pe all pe pair\nthermo_style custom step c_pe\nrun 0\n");
  const double qq = 2e-10 * -3e-10, expected = k * qq * (1 / 0.004 - 1 / 0.006);
  double mine = host.lmp->force->pair->eng_coul, sum;
  MPI_Allreduce(&mine, &sum, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  EXPECT_NEAR(sum, expected, 1e-12 * std::abs(expected));

  auto *pair = dynamic_cast<LAMMPS_NS::PairCoulClump *>(host.lmp->force->pair_match("coul/clump", 1));
  ASSERT_NE(pair, nullptr);
  double f = 0;
  EXPECT_NEAR(pair->single(0, 0, 1, 2, 1.6e-5, 1, 1, f), expected, 1e-12 * std::abs(expected));
  EXPECT_NEAR(f, k * qq / 1.6e-5 / 0.004, 1e-12 * std::abs(f));
}

TEST(PairCoulClump, circularOrbit)
{
  // two charges of one mass about each other: T = 2 pi sqrt(m/2 r3/(k q2))
  const double m = 1.3875e-9, q = 1e-13, r = 1e-3;
  const double T = 2 * M_PI * std::sqrt(0.5 * m * r * r * r / (k * q * q)), v = M_PI * r / T;
  for (const std::string every : {"", " every 10 impulse"}) {
    Host host;
    std::ostringstream s;
    s.precision(17);
    s << test::opening("f f f", "-0.01 0.01 -0.01 0.01 -0.01 0.01") << test::material("coul/clump 0.004" + every)
      << "pair_coeff 1 1 coul/clump " << q << "\npair_coeff 2 2 coul/clump " << -q
      << "\ncreate_atoms 1 single -0.0005 0 0 units box\ncreate_atoms 2 single 0.0005 0 0 units box\n"
      << "set group all diameter 1e-4\nset group all density " << m / (M_PI / 6 * 1e-12) << "\n"
      << "group one type 1\ngroup other type 2\n"
      << "velocity one set 0 " << -v << " 0 units box\nvelocity other set 0 " << v << " 0 units box\n"
      << "fix nve all nve/sphere\ntimestep " << T / 20000 << "\ncompute pe all pe pair\nthermo_style custom step c_pe\n"
      << "thermo 20000\nrun 20000\n";
    host(s.str());
    const auto a = host.atoms();
    EXPECT_NEAR(std::atan2(a[1].x[1], a[1].x[0]), 0, 1e-3 * 2 * M_PI);
    double kinetic = 0;
    for (const auto &p : a) kinetic += 0.5 * m * (p.v[0] * p.v[0] + p.v[1] * p.v[1] + p.v[2] * p.v[2]);
    const double apart = std::hypot(a[0].x[0] - a[1].x[0], a[0].x[1] - a[1].x[1]);
    const double energy = kinetic - k * q * q / apart, start = -0.5 * k * q * q / r;
    EXPECT_NEAR(energy, start, (every.empty() ? 1e-6 : 1e-5) * std::abs(start));
  }
}

// two like charges flung at each other turn where the energy says, and come back as they went
TEST(PairCoulClump, screenedApproachTurnsWhereItsEnergySays)
{
  const double m = 1.3875e-9, q = 1e-13, far = 3e-3, debye = 5e-4;
  const auto U = [&](double r) { return k * q * q * std::exp(-r / debye) / r; };
  const double turn = 4e-4, v = std::sqrt((U(turn) - U(far)) / m);  // each; 2 m v2/2
  Host host;
  std::ostringstream s;
  s.precision(17);
  s << test::opening("f f f", "-0.01 0.01 -0.01 0.01 -0.01 0.01")
    << test::material("coul/clump 0.004 screened 5e-4 points") << "pair_coeff * * coul/clump " << q << "\n"
    << "create_atoms 1 single " << -far / 2 << " 0 0 units box\ncreate_atoms 2 single " << far / 2
    << " 0 0 units box\nset group all diameter 1e-4\nset group all density " << m / (M_PI / 6 * 1e-12) << "\n"
    << "group one type 1\ngroup other type 2\nvelocity one set " << v << " 0 0 units box\nvelocity other set " << -v
    << " 0 0 units box\nfix nve all nve/sphere\ntimestep " << far / v / 40000 << "\ncompute pe all pe pair\n"
    << "thermo_style custom step c_pe\nrun 0\n";
  host(s.str());
  double least = far, worst = 0;
  for (int i = 0; i < 120; i++) {
    host("run 500 pre no post no\n");
    const auto a = host.atoms();
    const double r = a[1].x[0] - a[0].x[0];
    least = std::min(least, r);
    const double energy = m * (a[0].v[0] * a[0].v[0] + a[1].v[0] * a[1].v[0]) / 2 + U(r);
    worst = std::max(worst, std::abs(energy / (m * v * v + U(far)) - 1));
    if (r > far) break;
  }
  EXPECT_LT(worst, 1e-5);
  EXPECT_GE(least, turn * (1 - 1e-6));
  EXPECT_LT(least, 1.05 * turn);
}

TEST(PairCoulClump, screenedEnergyOfAStep)
{
  Host host;
  host(two("coul/clump 0.006 screened 1e-3 points", 0.004) +
       "compute pe all pe pair\nthermo_style custom step c_pe\nrun 0\n");
  const double qq = 2e-10 * -3e-10, expected = k * qq * (std::exp(-4.) / 0.004 - std::exp(-6.) / 0.006);
  double mine = host.lmp->force->pair->eng_coul, sum;
  MPI_Allreduce(&mine, &sum, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  EXPECT_NEAR(sum, expected, 1e-12 * std::abs(expected));
}

// energy and the energy of a single pair with spheres of two sizes, 0.5 mm and 1 mm
TEST(PairCoulClump, screenedSpheresOfTwoSizes)
{
  for (const std::string precision : {"double", "single"}) {
    Host host;
    host(two("coul/clump 0.006 screened 4e-4 " + precision, 0.004) +
         "set type 2 diameter 2e-3\nset type 2 density 2600\n"
         "compute pe all pe pair\nthermo_style custom step c_pe\nrun 0\n");
    const double a = 0.5 / 0.4, b = 1 / 0.4, qq = 2e-10 * -3e-10 * std::exp(a + b) / (1 + a) / (1 + b);
    const double force = k * qq * std::exp(-10.) * (1 / 0.004 + 1 / 4e-4) / 0.004,
                 near = precision == "single" ? 1e-6 : 1e-12;
    EXPECT_NEAR(host.atoms()[1].f[0], force, near * std::abs(force));
    const double expected = k * qq * (std::exp(-10.) / 0.004 - std::exp(-15.) / 0.006);
    double mine = host.lmp->force->pair->eng_coul, sum;
    MPI_Allreduce(&mine, &sum, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    EXPECT_NEAR(sum, expected, 1e-12 * std::abs(expected));
  }
}

TEST(PairCoulClump, everyStepsGivesTheSameImpulse)
{
  for (const char *mode : {"impulse", "hold"}) {
    Host often, seldom;
    often(two("coul/clump 0.006", 0.004) + "run 100\n");
    seldom(two(std::string("coul/clump 0.006 every 10 ") + mode, 0.004) + "run 100\n");
    auto *pair = dynamic_cast<LAMMPS_NS::PairCoulClump *>(seldom.lmp->force->pair_match("coul/clump", 1));
    EXPECT_LE(pair->evaluations(), 12);
    EXPECT_GE(pair->evaluations(), 10);
    const auto a = often.atoms(), b = seldom.atoms();
    EXPECT_GT(std::abs(a[0].v[0]), 1e-6);
    EXPECT_NEAR(b[0].v[0], a[0].v[0], 0.06 * std::abs(a[0].v[0])) << mode;
  }
}

TEST(PairCoulClump, noChargesNoWork)
{
  Host host;
  std::string script =
      two("coul/clump 0.006", 0.004) + "pair_coeff 1 1 coul/clump 0.0\npair_coeff 2 2 coul/clump 0.0\nrun 5\n";
  host(script);
  auto *pair = dynamic_cast<LAMMPS_NS::PairCoulClump *>(host.lmp->force->pair_match("coul/clump", 1));
  EXPECT_EQ(pair->evaluations(), 0);
  EXPECT_EQ(host.atoms()[0].f[0], 0);
}

TEST(PairCoulClump, everyPairOfClumpsInReach)
{
  const double charge[] = {0, 4e-10, -4e-10};
  for (double cutoff : {0.003, 0.008}) {
    Host host;
    std::ostringstream s;
    s << test::opening("f f f", "-0.012 0.012 -0.012 0.012 0 0.06")
      << "region ins block -0.012 0.012 -0.012 0.012 0 0.06 units box\n"
      << test::material("coul/clump " + std::to_string(cutoff))
      << "pair_coeff 1 1 coul/clump 4e-10\npair_coeff 2 2 coul/clump -4e-10\n"
      << test::clumps(40) << "timestep 1e-6\nrun 2\n";
    host(s.str());
    const auto atoms = host.atoms();
    ASSERT_EQ(atoms.size(), 560u);
    const double period[3] = {0, 0, 0};
    long acting;
    const Errors e = against_brute_force(atoms, charge, cutoff, period, &acting);
    EXPECT_LT(e.force, 1e-11) << cutoff;
    EXPECT_LT(e.torque, 1e-11) << cutoff;
    EXPECT_GT(acting, 50);
  }
}

TEST(PairCoulClump, singlePrecision)
{
  const double charge[] = {0, 4e-10, -4e-10}, period[3] = {0, 0, 0};
  Host host;
  host(test::opening("f f f", "-0.012 0.012 -0.012 0.012 0 0.06") +
       "region ins block -0.012 0.012 -0.012 0.012 0 0.06 units box\n" + test::material("coul/clump 0.008 single") +
       "pair_coeff 1 1 coul/clump 4e-10\npair_coeff 2 2 coul/clump -4e-10\n" + test::clumps(40) +
       "timestep 1e-6\nrun 2\n");
  long acting;
  const Errors e = against_brute_force(host.atoms(), charge, 0.008, period, &acting);
  EXPECT_LT(e.force, 1e-6);
  EXPECT_LT(e.torque, 1e-6);
  EXPECT_GT(e.force, 1e-10);
}

// Two that part at 10 m/s: the force of N steps is that of the middle one
TEST(PairCoulClump, heldForceIsThatOfTheMiddle)
{
  const double qq = 2e-10 * -3e-10, start = 0.0041;
  const int steps = 21;
  for (const char *boundary : {"f f f", "p p p"}) {
    Host host;
    std::string script = two("coul/clump 0.006 every 21 hold", start);
    script.replace(script.find("f f f"), 5, boundary);
    host(script + "group right type 2\nvelocity right set 10 0 0 units box\nrun 0\n");
    const auto first = host.atoms();
    const double middle = start + 10e-6 * (steps - 1) / 2;
    EXPECT_NEAR(first[0].f[0], -k * qq / (middle * middle), 1e-9 * std::abs(first[0].f[0])) << boundary;
    host("run " + std::to_string(steps - 1) + " pre no\n");
    EXPECT_EQ(host.atoms()[0].f[0], first[0].f[0]);
    host("run 1 pre no\n");
    EXPECT_GT(std::abs(host.atoms()[0].f[0] - first[0].f[0]), 0.05 * std::abs(first[0].f[0]));
  }
}

TEST(PairCoulClump, acrossPeriodicSides)
{
  const double charge[] = {0, 4e-10, -4e-10};
  Host host;
  host(test::opening("p p f", "-0.012 0.012 -0.012 0.012 0 0.05") +
       "region ins block -0.012 0.012 -0.012 0.012 0 0.05 units box\n" + test::material("coul/clump 0.007") +
       "pair_coeff 1 1 coul/clump 4e-10\npair_coeff 2 2 coul/clump -4e-10\n" + test::clumps(30) +
       "timestep 1e-6\nrun 2\n");
  const double period[3] = {0.024, 0.024, 0};
  long acting;
  const Errors e = against_brute_force(host.atoms(), charge, 0.007, period, &acting);
  EXPECT_LT(e.force, 1e-11);
  EXPECT_LT(e.torque, 1e-11);
  EXPECT_GT(acting, 1000);
}

namespace {

const std::string laws[] = {"shifted every 2", "screened 1e-3 every 2 hold"};
const std::string charges = "pair_coeff 1 1 coul/clump 4e-10\npair_coeff 2 2 coul/clump -4e-10\n";

// clumps that have moved for ten steps, and the restart file of that moment
std::string begun(const std::string &law)
{
  return test::opening("f f f", "-0.012 0.012 -0.012 0.012 0 0.06") +
      "region ins block -0.012 0.012 -0.012 0.012 0 0.06 units box\n" + test::material("coul/clump 0.008 " + law) +
      charges + test::clumps(40) + "timestep 1e-5\nrun 10\nwrite_restart coul_clump.restart\n";
}

std::string again(const std::string &law)
{
  return "atom_style granular\natom_modify map array\nnewton off\ncommunicate single vel yes\nprocessors * * *\n"
         "read_restart coul_clump.restart\nneighbor 0.0005 bin\nneigh_modify delay 0\n" +
      test::material("coul/clump 0.008 " + law) + charges + "fix ms all multisphere\ntimestep 1e-5\nrun 300\n";
}

void expect_same(const std::vector<test::Atom> &a, const std::vector<test::Atom> &b)
{
  ASSERT_EQ(a.size(), 560u);
  ASSERT_EQ(b.size(), 560u);
  double moved = 0, apart = 0;
  for (std::size_t i = 0; i < a.size(); i++)
    for (int d = 0; d < 3; d++) {
      moved = std::max(moved, std::abs(a[i].v[d]));
      apart = std::max(apart, std::abs(a[i].v[d] - b[i].v[d]));
    }
  EXPECT_GT(moved, 1e-3);
  EXPECT_LT(apart, 1e-8 * moved);
}

}  // namespace

TEST(PairCoulClump, goesOnAfterARestart)
{
  for (const std::string &law : laws) {
    Host straight;
    straight(begun(law) + "run 300\n");
    Host restarted;
    restarted(again(law));
    expect_same(straight.atoms(), restarted.atoms());
  }
}

// the style alone, which LIGGGHTS then makes from the file
TEST(PairCoulClump, settingsComeBackFromARestart)
{
  const std::string styles[] = {"coul/clump 0.006 screened 1e-3 permittivity 78.5 every 5 hold single",
                                "coul/clump 0.006 shifted screened 2e-3", "coul/clump 0.006 shifted",
                                "coul/clump 0.007"};
  for (const std::string &style : styles) {
    Host host;
    host(test::opening("f f f", "-0.01 0.01 -0.01 0.01 -0.01 0.01") + "atom_modify sort 0 0\npair_style " + style +
         "\npair_coeff 1 1 2e-10\npair_coeff 2 2 -3e-10\ncreate_atoms 1 single 0 0 0 units box\n"
         "create_atoms 2 single 0.004 0 0 units box\nset group all diameter 1e-3\nset group all density 2600\n"
         "fix nve all nve/sphere\ntimestep 1e-6\nrun 0\nwrite_restart coul_settings.restart\n");
    Host again;
    again("atom_style granular\natom_modify map array sort 0 0\nnewton off\ncommunicate single vel yes\n"
          "read_restart coul_settings.restart\nneighbor 0.0005 bin\nneigh_modify delay 0\nfix nve all nve/sphere\n"
          "timestep 1e-6\nrun 0\n");
    auto *was = dynamic_cast<LAMMPS_NS::PairCoulClump *>(host.lmp->force->pair);
    auto *is = dynamic_cast<LAMMPS_NS::PairCoulClump *>(again.lmp->force->pair);
    ASSERT_NE(is, nullptr);
    EXPECT_EQ(is->law().debye, was->law().debye) << style;
    EXPECT_EQ(is->law().k, was->law().k) << style;
    EXPECT_EQ(is->law().shifted, was->law().shifted) << style;
    EXPECT_EQ(is->law().cutoff, was->law().cutoff) << style;
    EXPECT_EQ(is->every(), was->every()) << style;
    EXPECT_EQ(again.atoms()[0].f[0], host.atoms()[0].f[0]) << style;
    EXPECT_NE(host.atoms()[0].f[0], 0) << style;
  }
}

// one processor writes a restart; one alone and both together go on from it
TEST(PairCoulClumpParallel, twoProcessorsGiveTheSameAsOne)
{
  ASSERT_EQ(test::processors(), 2);
  int rank;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  for (const std::string &law : laws) {
    if (rank == 0) {
      Host first(MPI_COMM_SELF);
      first(begun(law));
    }
    MPI_Barrier(MPI_COMM_WORLD);
    Host alone(MPI_COMM_SELF), together(MPI_COMM_WORLD);
    alone(again(law));
    together(again(law));
    expect_same(alone.atoms(), together.atoms());
    MPI_Barrier(MPI_COMM_WORLD);
  }
}

namespace {

// two rods that lie across the border of two processors and fall until both are on one, which then has no ghosts
std::vector<test::Atom> fallen(MPI_Comm comm)
{
  Host host(comm);
  host(test::opening("f f f", "-0.01 0.01 -0.01 0.01 -0.03 0.03") + test::material("coul/clump 0.008") + charges +
       "fix rod all particletemplate/clay generic seed 15485863 type 1 atom_types 1 2 density 2600 "
       "spheres 2 0 0 -7e-4 1e-3 P 0 0 7e-4 1e-3 P\n"
       "fix ms all multisphere\nfix put all insert/placed file coul_clump_fall.places templates rod verbose no\n"
       "fix fall all gravity 9.81 vector 0 0 -1\ntimestep 1e-4\nrun 250\n");
  return host.atoms();
}

}  // namespace

TEST(PairCoulClumpParallel, spheresThatWereGhostsAreActedOnOnceTheyAreTheProcessorsOwn)
{
  ASSERT_EQ(test::processors(), 2);
  int rank;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0) {
    std::ofstream f("coul_clump_fall.places");
    f << "rod -0.0025 0 0.0003 1 0 0 0\nrod 0.0025 0 0.0003 1 0 0 0\n";
  }
  MPI_Barrier(MPI_COMM_WORLD);
  const std::vector<test::Atom> alone = fallen(MPI_COMM_SELF), together = fallen(MPI_COMM_WORLD);
  ASSERT_EQ(alone.size(), 4u);
  ASSERT_EQ(together.size(), 4u);
  for (std::size_t i = 0; i < 4; i++) {
    EXPECT_LT(together[i].x[2], -5e-4);
    EXPECT_GT(std::abs(alone[i].v[0]), 1e-4);
    EXPECT_NEAR(together[i].v[0], alone[i].v[0], 1e-9 * std::abs(alone[i].v[0]));
  }
}
