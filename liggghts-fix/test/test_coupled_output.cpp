// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
// What fix couple/foam shows, against what it tells the CFD half.
#include <gtest/gtest.h>

#include <cmath>

#include "beside_stand_in.h"

using test::BesideStandIn;

namespace {

const double dt = 1e-5, rho = 1000, g = 9.81, d = 1e-3;
const int interval = 5, steps = 60;

std::string opening()
{
  return "atom_style granular\natom_modify map array\ncommunicate single vel yes\nboundary f f f\nnewton off\n"
         "units si\nprocessors 1 1 *\nregion dom block -0.01 0.01 -0.01 0.01 -0.01 0.01 units box\ncreate_box 2 dom\n"
         "neighbor 0.0002 bin\nneigh_modify every 1 delay 0 check no\ntimestep 1e-5\n"
         "fix p1 all property/global kn peratomtypepair 2 5000 5000 5000 5000\n"
         "fix p2 all property/global kt peratomtypepair 2 5000 5000 5000 5000\n"
         "fix p3 all property/global gamman peratomtypepair 2 4000 4000 4000 4000\n"
         "fix p4 all property/global gammat peratomtypepair 2 4000 4000 4000 4000\n"
         "fix p5 all property/global coefficientFriction peratomtypepair 2 0.5 0.5 0.5 0.5\n"
         "pair_style gran model hooke/stiffness tangential history\npair_coeff * *\n";
}

// a lattice that flies in several directions; of type 2 no fix moves them
std::string spheres()
{
  std::string s;
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      for (int k = 0; k < 4; k++)
        s += "create_atoms " + std::to_string(i == 0 && j == 0 ? 2 : 1) + " single " +
            std::to_string(-0.006 + 0.006 * i) + " " + std::to_string(-0.006 + 0.006 * j) + " " +
            std::to_string(-0.0075 + 0.005 * k) + " units box\n";
  return s +
      "set group all diameter 1e-3 density 2500\ngroup move type 1\ngroup cross id 3:36:4\n"
      "group out id 4:36:4\nvelocity cross set 0.3 0.2 -6 units box\n"
      "velocity out set 0.1 -0.2 9 units box\nset type 2 diameter 1.1e-3 density 2500\n"
      "group held type 2\nvelocity held set 0 0 0 units box\n"
      "fix grav all gravity 9.81 vector 0 0 -1\nfix n move nve/sphere\n";
}

const std::string shows =
    "dump d all custom 1 grains.txt id radius f_cpl[1] f_cpl[2] f_cpl[3] f_cpl[4] f_cpl[5] f_cpl[6] f_cpl[7] f_cpl[8] "
    "f_cpl[9] f_cpl[10] fx fy fz vx vy vz\ndump_modify d format \"%d %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g "
    "%.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g\"\n"
    "compute sum all reduce sum f_cpl[1] f_cpl[2] f_cpl[3] f_cpl[4] f_cpl[5] f_cpl[6]\n"
    "thermo_style custom step f_cpl[1] f_cpl[2] f_cpl[3] f_cpl[4] f_cpl[5] f_cpl[6] f_cpl[7] f_cpl[8] f_cpl[9] "
    "c_sum[1] c_sum[2] c_sum[3] c_sum[4] c_sum[5] c_sum[6]\n"
    "thermo_modify lost ignore norm no format float %.17g\nthermo 1\n";

double volume(double radius) { return 4 / 3. * M_PI * radius * radius * radius; }

using Dump = std::map<long, std::map<int, std::vector<double>>>;

// impulse without that of the hydrostatic pressure, by the forces shown: of each step half,
// half of the next, where the grain is there in both
test::Vec impulse(const Dump &dump, long from, long to)
{
  test::Vec sum{};
  for (long s = from; s < to; s++)
    for (const auto &[id, row] : dump.at(s)) {
      const auto next = dump.at(s + 1).find(id);
      if (next == dump.at(s + 1).end()) continue;
      for (int k = 0; k < 3; k++) {
        const double hydro = k == 2 && row[9 + 1] > 0 ? rho * g * volume(row[0]) : 0;
        const double later = k == 2 && next->second[9 + 1] > 0 ? rho * g * volume(next->second[0]) : 0;
        sum[k] += 0.5 * dt * (row[1 + k] - hydro + next->second[1 + k] - later);
      }
    }
  return sum;
}

// each interval's against what the CFD half was told, and the totals against the sums
void expect_ledger(const BesideStandIn &run, const Dump &grains)
{
  const auto told = run.told();
  const auto thermo = run.thermo();
  ASSERT_EQ(told["exchanges"].size(), steps / interval + 1u);
  double scale = 0;
  for (int e = 1; e <= steps / interval; e++)
    for (int k = 0; k < 3; k++) scale = std::max(scale, std::fabs(told["exchanges"][e]["given"][k].get<double>()));
  ASSERT_GT(scale, 0);
  for (int e = 1; e <= steps / interval; e++) {
    const test::Vec shown = impulse(grains, (e - 1) * interval, e * interval);
    for (int k = 0; k < 3; k++) {
      const double before = told["exchanges"][e - 1]["given"][k], now = told["exchanges"][e]["given"][k];
      EXPECT_NEAR(shown[k], now - before, 1e-12 * scale) << "exchange " << e << " component " << k;
      EXPECT_NEAR(thermo.at(e * interval)[6 + k], now, 1e-12 * scale);
    }
  }
  for (const auto &[step, row] : thermo)
    for (int k = 0; k < 6; k++) {
      double sum = 0;
      for (const auto &[id, one] : grains.at(step)) sum += one[1 + k];
      EXPECT_NEAR(row[k], sum, 1e-13 + 1e-12 * std::fabs(sum)) << "step " << step << " total " << k;
      EXPECT_NEAR(row[9 + k], sum, 1e-13 + 1e-12 * std::fabs(sum));
    }
}

}  // namespace

// spheres that fly through the processors' borders, some of which leave the box, some
// inserted, some held: the sum of their forces is what the ledger is told
TEST(CoupledOutput, sumOfForcesIsWhatTheLedgerIsTold)
{
  Dump first;
  for (int ranks : {1, 2}) {
    BesideStandIn run("spheres-" + std::to_string(ranks), ranks);
    ASSERT_TRUE(run.run(opening() + spheres() +
                            "fix t1 all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius "
                            "constant 0.0004\nfix pdd all particledistribution/discrete 32452843 1 t1 1.0\n"
                            "region ins block -0.002 0.002 -0.005 -0.001 -0.003 0.003 units box\n"
                            "fix ins move insert/rate/region seed 49979687 distributiontemplate pdd nparticles 3 "
                            "particlerate 5000 insert_every 17 overlapcheck yes vel constant 0 0 -0.5 region ins\n"
                            "fix cpl all couple/foam every 5 contact_limit no watch no\n" +
                            shows + "run 60\n",
                        "K=3e-3 u=0.5,-0.2,0.1 rate=30 force=1e-6,2e-6,-1e-6 rho=1000 n=0.6"))
        << run.log();
    const Dump grains = run.dump("grains.txt");
    ASSERT_EQ(grains.size(), steps + 1u);
    expect_ledger(run, grains);
    EXPECT_EQ(grains.rbegin()->second.count(8), 0u);         // some have left
    EXPECT_GT(grains.rbegin()->second.rbegin()->first, 36);  // some have come

    const auto &last = grains.rbegin()->second;
    const auto told = run.told()["exchanges"][steps / interval];
    for (const auto &[id, row] : last) {
      // the fluid at it is that of the exchange before
      EXPECT_NEAR(row[9 + 1], 0.6 * (1 + 0.1 * std::sin(id)), 1e-12);
      EXPECT_NEAR(row[7 + 1], -0.2, 1e-12);
      // drag by its velocity in the middle of the step before, to the step's order
      const double K = 3e-3 * (1 + 0.1 * std::sin(id)), m = 2500 * volume(row[0]);
      EXPECT_NEAR(row[5 - 1], K * (row[8 - 1] - row[14]), 2 * K * dt / m * K * 5);
    }
    if (ranks == 1) {
      first = grains;
      continue;
    }
    for (const auto &[step, atoms] : first) {
      for (const auto &[id, row] : atoms) {
        if (id > 36) break;  // inserted ones stand elsewhere
        for (int c = 1; c < 11; c++) ASSERT_NEAR(grains.at(step).at(id)[c], row[c], 1e-12 + 1e-9 * std::fabs(row[c]));
      }
    }
  }
}

// of a clump each sphere shows its part, and the local array the body
TEST(CoupledOutput, spheresOfClumpsAddUpToThem)
{
  for (const std::string drag : {"", "clumpDrag resistance"})
    for (const std::string added : {"", " added=1e-6", " turn=1e-12"}) {
      Dump first, firstBodies;
      for (int ranks : {1, 2}) {
        BesideStandIn run("clumps-" + std::to_string(ranks), ranks);
        const std::string bodies =
            "fix ill all particletemplate/clay illite seed 15485863 type 1 atom_types 1 2 radius 5e-4 density 2600\n"
            "fix ms all multisphere/clump\n"
            "print 'ill 0 0 0.0003 0.923380516876639 "
            "0.307793505625546 0.205195670417031 0.102597835208515' file places.txt\n"
            "print 'ill 0.005 0.001 -0.004 0.905821627315677 "
            "-0.339683110243379 0.226455406828919 0.11322770341446' append places.txt\n"
            "print 'ill -0.005 0.001 0.004 0.881917103688197 "
            "-0.377964473009227 0.251976315339485 0.125988157669742' append places.txt\n"
            "fix put all insert/placed file places.txt templates ill verbose no\n"
            "fix grav all gravity 9.81 vector 0 0 -1\nrun 0\nvelocity all set 0 0 0 units box\n";
        ASSERT_TRUE(run.run(opening() + bodies + "fix cpl all couple/foam every 5 contact_limit no " + drag + "\n" +
                                shows +
                                "dump b all local 1 bodies.txt f_cpl[1] f_cpl[2] f_cpl[3] f_cpl[4] f_cpl[5] f_cpl[6] "
                                "f_cpl[7] f_cpl[8] f_cpl[9] f_cpl[10] f_cpl[11]\ndump_modify b format \"%.17g %.17g "
                                "%.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g\"\nrun 60\n",
                            "K=3e-4 u=0.5,-0.2,0.1 rate=300 force=1e-6,2e-6,-1e-6 n=0.6" + added))
            << run.log();
        const Dump grains = run.dump("grains.txt"), local = run.dump("bodies.txt");
        ASSERT_EQ(grains.rbegin()->second.size(), 42u);
        ASSERT_EQ(local.rbegin()->second.size(), 3u);
        double given = 0;
        const auto told = run.told();
        const auto thermo = run.thermo();
        for (const auto &[step, rows] : thermo) {
          for (int k = 0; k < 6; k++) {
            double all = 0, bodies = 0;
            for (const auto &[id, row] : grains.at(step)) all += row[1 + k];
            for (const auto &[tag, row] : local.at(step)) bodies += row[k];
            const double size = 1e-12 * std::fabs(rows[k]) + 1e-16;
            EXPECT_NEAR(all, rows[k], size) << step << ' ' << k;
            EXPECT_NEAR(bodies, rows[k], size) << step << ' ' << k;
          }
          if (step > 0) {
            const auto &before = thermo.at(step - 1);
            given += 0.5 * dt * (rows[0] + before[0]);
          }
          if (step % interval == 0) {
            const double was = told["exchanges"][step / interval]["given"][0];
            EXPECT_NEAR(given, was, 1e-12 * std::fabs(was) + 1e-18);
            EXPECT_NEAR(rows[6], was, 1e-12 * std::fabs(was) + 1e-18);
          }
        }
        if (ranks == 1) {
          first = grains;
          firstBodies = local;
          continue;
        }
        for (const auto &[step, atoms] : first)
          for (const auto &[id, row] : atoms)
            for (int c = 1; c < 11; c++)
              ASSERT_NEAR(grains.at(step).at(id)[c], row[c], 1e-9 * std::fabs(row[c]) + 1e-13)
                  << step << ' ' << id << ' ' << c;
        for (const auto &[step, bodies] : firstBodies)
          for (const auto &[tag, row] : bodies)
            for (int c = 0; c < 10; c++)
              ASSERT_NEAR(local.at(step).at(tag)[c], row[c], 1e-9 * std::fabs(row[c]) + 1e-13) << step << ' ' << c;
      }
    }
}

// who does not ask does not pay
TEST(CoupledOutput, voidFractionCrossesWhereItIsReadOnly)
{
  const auto answers = [](const std::string &name, const std::string &more) {
    BesideStandIn run("readers-" + name, 1);
    EXPECT_TRUE(run.run(opening() + spheres() + "fix cpl all couple/foam every 5 contact_limit no watch no\n" + more +
                            "run 10\n",
                        "K=1e-4"))
        << run.log();
    return run.told()["answers"].dump();
  };
  const auto reads = [](const std::string &set) { return set.find("voidFraction") != std::string::npos; };
  EXPECT_FALSE(reads(answers("none",
                             "dump d all custom 5 d.txt id x fx\nthermo_style custom step f_cpl[1]\n"
                             "fix av all ave/time 1 5 5 f_cpl[3] file av.txt\n")));
  EXPECT_TRUE(reads(answers("dump", "dump d all custom 5 d.txt id f_cpl[1]\n")));
  EXPECT_TRUE(reads(answers("reduce", "compute r all reduce sum f_cpl[10]\nthermo_style custom step c_r\n")));
  EXPECT_TRUE(reads(answers("ave", "fix av all ave/atom 1 5 5 f_cpl[1]\n")));
  EXPECT_TRUE(reads(answers("variable", "variable v atom f_cpl[1]*2\n")));
}

// loops, lists, words and the environment's have no formula; those behind them are read
TEST(CoupledOutput, scriptsWithVariablesOfAnyStyle)
{
  BesideStandIn run("variables", 1);
  EXPECT_TRUE(run.run(opening() + spheres() +
                          "variable i loop 3\nvariable j loop 2 7 pad\nvariable n index 5 10 f_cpl[1]\n"
                          "variable w string f_cpl[1]\nvariable e getenv HOME\nvariable u uloop 4\n"
                          "variable f equal v_i*2\n"
                          "fix cpl all couple/foam every 5 contact_limit no watch no\n"
                          "label again\nrun 5\nnext i\njump SELF again\n",
                      "K=1e-4"))
      << run.log();
  EXPECT_EQ(run.told()["answers"].dump().find("voidFraction"), std::string::npos);
  EXPECT_EQ(run.told()["exchanges"].size(), 6u);
}

// fix ave/atom reads in steps in which no output is due
TEST(CoupledOutput, valuesAreThereWithinSteps)
{
  const auto run = [](const std::string &name, const std::string &more) {
    BesideStandIn run(name, 1);
    EXPECT_TRUE(run.run(opening() + spheres() + "fix cpl all couple/foam every 5 contact_limit no watch no\n" + more +
                            "fix mean all ave/atom 1 5 5 f_cpl[3]\ndump m all custom 5 means.txt id f_mean\n"
                            "dump_modify m format \"%d %.17g\"\nthermo 100\nthermo_modify lost ignore\nrun 10\n",
                        "K=3e-3 u=0,0,1"))
        << run.log();
    return run;
  };
  const auto often =
      run("within-often", "dump d all custom 1 grains.txt id f_cpl[3]\ndump_modify d format \"%d %.17g\"\n");
  const auto seldom = run("within-seldom", "");
  const Dump grains = often.dump("grains.txt"), means = seldom.dump("means.txt");
  ASSERT_EQ(means.at(10).size(), 36u);
  for (const auto &[id, row] : means.at(10)) {
    double sum = 0;
    for (long s = 6; s <= 10; s++) sum += grains.at(s).at(id)[0] / 5;
    EXPECT_NEAR(row[0], sum, 1e-12 * std::fabs(sum));
    if (id > 4) EXPECT_GT(std::fabs(grains.at(6).at(id)[0] - grains.at(10).at(id)[0]), 1e-3 * std::fabs(sum));
  }
}
