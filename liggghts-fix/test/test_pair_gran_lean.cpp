// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "coupling/run_checks.h"
#include "fix_property_atom.h"
#include "host.h"
#include "modify.h"
#include "neighbor.h"
#include "pair.h"
#include "contacts/pair_gran_lean.h"
#include "update.h"

using test::Host;

namespace {

// two kinds of spheres, with different coefficients for each pair of kinds
std::string contacts(const std::string &style, const std::string &more = "")
{
  return "fix m1 all property/global kn peratomtypepair 2 3000. 2500. 2500. 2000.\n"
         "fix m2 all property/global kt peratomtypepair 2 2000. 1500. 1500. 1200.\n"
         "fix m3 all property/global gamman peratomtypepair 2 2000. 1500. 1500. 1000.\n"
         "fix m4 all property/global gammat peratomtypepair 2 1000. 1200. 1200. 800.\n"
         "fix m5 all property/global coefficientFriction peratomtypepair 2 0.5 0.3 0.3 0.1\n"
         "pair_style " +
      style + " model hooke/stiffness tangential history " + more + "\n";
}

const std::string walls =
    "fix floor all wall/gran model hooke/stiffness tangential history primitive type 1 zplane 0.\n"
    "fix side all wall/gran model hooke/stiffness tangential history primitive type 2 "
    "zcylinder 0.009 0. 0.\n";

// spheres thrown together, with velocities; in contact from the start
std::string spheres(int n, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> side(-5e-3, 5e-3), up(1e-3, 14e-3), speed(-0.3, 0.3), size(1.2e-3, 2e-3);
  std::ostringstream s;
  s.precision(17);
  for (int i = 1; i <= n; i++) {
    s << "create_atoms " << 1 + i % 2 << " single " << side(random) << ' ' << side(random) << ' ' << up(random)
      << " units box\n"
      << "set atom " << i << " diameter " << size(random) << "\nset atom " << i << " density 2600\n"
      << "group one id " << i << "\nvelocity one set " << speed(random) << ' ' << speed(random) << ' ' << speed(random)
      << " units box\ngroup one delete\n";
  }
  s << "fix nve all nve/sphere\nfix grav all gravity 9.81 vector 0 0 -1\n";
  return s.str();
}

std::string box(const std::string &boundary = "f f f")
{
  return test::opening(boundary, "-0.01 0.01 -0.01 0.01 0 0.04");
}

LAMMPS_NS::PairGranLean *lean(Host &host)
{
  return dynamic_cast<LAMMPS_NS::PairGranLean *>(host.lmp->force->pair_match("gran/lean", 1));
}

// of all processors
int near_pairs(Host &host)
{
  int mine = lean(host)->near_pairs(), all;
  MPI_Allreduce(&mine, &all, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
  return all;
}

// largest difference of positions, velocities, forces and torques, each over the largest there is
struct Apart {
  double x, v, f, torque, largest_f;
};

Apart apart(const std::vector<test::Atom> &a, const std::vector<test::Atom> &b)
{
  Apart worst = {1, 1, 1, 1, 0};
  if (a.size() != b.size()) return worst;
  double d[4] = {0, 0, 0, 0}, size[4] = {0, 0, 0, 1e-30};
  const auto compare = [&](int what, const double *p, const double *q) {
    for (int c = 0; c < 3; c++) {
      d[what] = std::max(d[what], std::abs(p[c] - q[c]));
      size[what] = std::max(size[what], std::abs(p[c]));
    }
  };
  for (std::size_t i = 0; i < a.size(); i++) {
    compare(0, a[i].x, b[i].x);
    compare(1, a[i].v, b[i].v);
    compare(2, a[i].f, b[i].f);
    compare(3, a[i].torque, b[i].torque);
  }
  return {d[0] / size[0], d[1] / size[1], d[2] / size[2], d[3] / size[3], size[2]};
}

// the same script with gran/lean for gran
std::string lean_of(std::string script)
{
  for (std::size_t at = 0; (at = script.find("gran model", at)) != std::string::npos; at += 10)
    if (script.compare(at - 5, 5, "wall/") != 0) script.replace(at, 4, "gran/lean"), at += 5;
  const std::size_t coeff = script.find("pair_coeff * * gran\n");
  if (coeff != std::string::npos) script.insert(coeff + 19, "/lean");
  return script;
}

// the same script with wall/gran/lean for wall/gran
std::string lean_walls_of(std::string script)
{
  for (std::size_t at = 0; (at = script.find("wall/gran ", at)) != std::string::npos; at += 14)
    script.insert(at + 9, "/lean");
  return script;
}

void expect_same(const std::string &script, double tolerance, const std::string &what, bool walls_too = false)
{
  Host stock, ours;
  const auto run = [](Host &host, const std::string &all) {
    const std::size_t at = all.find("# spin\n");
    host(all.substr(0, at));
    if (at == std::string::npos) return;
    for (int i = 0; i < host.lmp->atom->nlocal; i++)
      for (int d = 0; d < 3; d++) host.lmp->atom->omega[i][d] = 40 * std::sin(7 * host.lmp->atom->tag[i] + 2 * d);
    host(all.substr(at));
  };
  run(stock, script);
  run(ours, walls_too ? lean_walls_of(lean_of(script)) : lean_of(script));
  ASSERT_NE(lean(ours), nullptr);
  const Apart d = apart(stock.atoms(), ours.atoms());
  EXPECT_GT(d.largest_f, 0.01) << what;
  EXPECT_LT(d.x, tolerance) << what;
  EXPECT_LT(d.v, tolerance) << what;
  EXPECT_LT(d.f, tolerance) << what;
  EXPECT_LT(d.torque, tolerance) << what;
  EXPECT_GT(near_pairs(ours), 0) << what;
}

const std::string material = box() + contacts("gran") + "pair_coeff * *\n" + walls;

}  // namespace

// few steps from the same state: gran's forces to rounding
TEST(PairGranLean, forcesOfGran)
{
  for (const std::string more : {"", "tangential_damping off", "limitForce on"})
    expect_same(box() + contacts("gran", more) + "pair_coeff * *\n" + walls + spheres(220, 7) +
                    "timestep 1e-6\nrun 20\n",
                1e-12, more);
}

TEST(PairGranLean, absoluteDamping)
{
  expect_same(box() +
                  "fix a1 all property/global gamman_abs peratomtypepair 2 0.01 0.02 0.02 0.03\n"
                  "fix a2 all property/global gammat_abs peratomtypepair 2 0.005 0.01 0.01 0.015\n" +
                  contacts("gran", "absolute_damping on") + "pair_coeff * *\n" + spheres(220, 8) +
                  "timestep 1e-6\nrun 20\n",
              1e-12, "absolute_damping");
}

namespace {

const std::string modulus = "fix y all property/global youngsModulus peratomtype 2.5e7 1e7\n"
                            "fix p all property/global poissonsRatio peratomtype 0.45 0.3\n"
                            "fix e all property/global coefficientRestitution peratomtypepair 2 0.8 0.6 0.6 0.4\n"
                            "fix c all property/global coefficientFriction peratomtypepair 2 0.3 0.2 0.2 0.1\n"
                            "fix v all property/global characteristicVelocity scalar 0.1\n";

}  // namespace

// stiffness and damping from Young's modulus and restitution
TEST(PairGranLean, modulusAndRestitution)
{
  for (const std::string more : {"", "tangential_damping off", "limitForce on", "ktToKnUser on"})
    expect_same(box() + modulus + "pair_style gran model hooke tangential history " + more + "\npair_coeff * *\n" +
                    spheres(220, 13) + "timestep 1e-6\nrun 20\n",
                1e-12, "hooke " + more);
  expect_same(box() + modulus +
                  "pair_style gran model hooke tangential history\npair_coeff * *\n"
                  "fix floor all wall/gran model hooke tangential history primitive type 1 zplane 0.\n" +
                  spheres(120, 14) + "neighbor 0.0001 bin\ntimestep 5e-6\nrun 1000\n",
              1e-8, "hooke, 1000 steps");
}

namespace {

const std::string stiffness = "fix m1 all property/global kn peratomtypepair 2 9e6 8e6 8e6 6e6\n"
                              "fix m2 all property/global kt peratomtypepair 2 7e6 6e6 6e6 5e6\n"
                              "fix m3 all property/global gamman peratomtypepair 2 3e6 2e6 2e6 1e6\n"
                              "fix m4 all property/global gammat peratomtypepair 2 1e6 2e6 2e6 3e6\n"
                              "fix m5 all property/global coefficientFriction peratomtypepair 2 0.5 0.3 0.3 0.1\n";

const std::string hertz_walls =
    "fix floor all wall/gran model hertz tangential history primitive type 1 zplane 0.\n"
    "fix side all wall/gran model hertz tangential history primitive type 2 zcylinder 0.009 0. 0.\n";

}  // namespace

// of two types, unequal radii: stiffness that grows with the overlap, each friction, each switch
TEST(PairGranLean, hertzOfGran)
{
  for (const std::string friction : {"history", "no_history", "off"})
    for (const std::string more : {"", "tangential_damping off", "limitForce on"}) {
      const std::string law = " tangential " + friction + " " + more + "\npair_coeff * *\n";
      const std::string spheres_of = spheres(220, 13) + "timestep 1e-6\nrun 20\n";
      expect_same(box() + modulus + "pair_style gran model hertz" + law + spheres_of, 1e-12, "hertz " + law);
      expect_same(box() + stiffness + "pair_style gran model hertz/stiffness" + law + spheres_of, 1e-12,
                  "hertz/stiffness " + law);
    }
  for (const std::string friction : {"no_history", "off"})
    expect_same(box() + modulus + "pair_style gran model hooke tangential " + friction + "\npair_coeff * *\n" +
                    spheres(220, 13) + "timestep 1e-6\nrun 20\n",
                1e-12, "hooke " + friction);
}

// of one size, or of one size and mass: what differs is the mass, or the types alone
TEST(PairGranLean, spheresOfOneSize)
{
  for (const std::string model : {"hertz", "hooke"})
    for (const std::string mass : {"", "group heavy id 1:110\nset group heavy density 5000\n"})
      expect_same(box() + modulus + "pair_style gran model " + model + " tangential history\npair_coeff * *\n" +
                      spheres(220, 13) + "set group all diameter 1.6e-3 density 2600\n" + mass +
                      "timestep 1e-6\nrun 20\n",
                  1e-12, model + " " + mass);
}

// rolling friction and cohesion, each with each friction; with their switches
TEST(PairGranLean, rollingAndCohesionOfGran)
{
  const std::string more = "fix rf all property/global coefficientRollingFriction peratomtypepair 2 0.2 0.1 0.1 0.05\n"
                           "fix ce all property/global cohesionEnergyDensity peratomtypepair 2 3e3 1e4 1e4 3e4\n";
  for (const std::string model : {"hertz", "hooke"})
    for (const std::string friction : {"history", "no_history", "off"})
      for (const std::string extra : {"rolling_friction cdt", "rolling_friction epsd2", "cohesion sjkr",
                                      "cohesion sjkr rolling_friction epsd2", "rolling_friction cdt torsionTorque on",
                                      "cohesion sjkr rolling_friction epsd2 torsionTorque on tangential_reduce on"}) {
        const std::string law = model + " tangential " + friction + " " + extra;
        expect_same(box() + modulus + more + "pair_style gran model " + law + "\npair_coeff * *\n" + spheres(220, 13) +
                        "# spin\ntimestep 1e-6\nrun 20\n",
                    1e-12, law);
      }
  std::string walls_too = hertz_walls;
  for (std::size_t at = 0; (at = walls_too.find("history primitive", at)) != std::string::npos; at += 8)
    walls_too.insert(at + 8, "cohesion sjkr rolling_friction epsd2 ");
  expect_same(
      box() + modulus + more +
          "pair_style gran model hertz tangential history cohesion sjkr rolling_friction epsd2\npair_coeff * *\n" +
          walls_too + spheres(120, 14) + "neighbor 0.0001 bin\ntimestep 5e-6\nrun 1000\n",
      1e-8, "1000 steps", true);
}

// through many lists, rolling and sliding, at walls, some spheres frozen
TEST(PairGranLean, hertzOverThousandSteps)
{
  const std::string style = box() + modulus + "pair_style gran model hertz tangential history\npair_coeff * *\n";
  const std::string run = "neighbor 0.0001 bin\ntimestep 5e-6\nrun 1000\n";
  expect_same(style + hertz_walls + spheres(120, 14) + run, 1e-8, "hertz");
  expect_same(style + hertz_walls + spheres(120, 14) + "group held id 1:20\nfix hold held freeze\n" + run, 1e-8,
              "hertz, frozen");
}

// the mass that counts is the body's
TEST(PairGranLean, bodiesOfFixRigid)
{
  std::string script = spheres(120, 15);
  script.erase(script.find("fix nve all nve/sphere"), 23);
  expect_same(box() + modulus + "pair_style gran model hertz tangential history\npair_coeff * *\n" + hertz_walls +
                  "fix cut all wall/gran model hertz tangential history primitive type 1 zplane 0.006\n" + script +
                  "group bound id 1:8\ngroup free subtract all bound\nfix body bound rigid single\n"
                  "fix nve free nve/sphere\nneighbor 0.0002 bin\ntimestep 2e-6\nrun 200\n",
              1e-10, "rigid", true);
}

// The lists are built anew and the spheres roll and slide; a thousand steps of
// collisions multiply what rounding there is.
TEST(PairGranLean, historyOverThousandSteps)
{
  const std::string script = material + spheres(120, 9) + "neighbor 0.0001 bin\ntimestep 5e-6\nrun 1000\n";
  expect_same(script, 1e-8, "1000 steps");
  Host ours;
  ours(lean_of(script));
  EXPECT_GT(ours.lmp->neighbor->ncalls, 10);
  EXPECT_GT(lean(ours)->searches(), ours.lmp->neighbor->ncalls);
}

// steps with stresses are left to gran's own loop, on the same contacts
TEST(PairGranLean, alternatesWithGransLoop)
{
  expect_same(material + spheres(120, 10) +
                  "compute p all stress/atom pair\ncompute l all pair/gran/local id force\n"
                  "compute s all reduce sum c_p[3]\ncompute m all reduce sum c_l[3]\n"
                  "fix t all ave/time 7 1 7 c_s c_m\ntimestep 5e-6\nrun 400\n",
              1e-9, "stress");
}

// runs one after the other, and restarts in either style, carry the contacts on
TEST(PairGranLean, contactsLastFromRunToRun)
{
  const std::string pile = "neighbor 0.0002 bin\nfix drag all viscous 2e-4\ntimestep 5e-6\n";
  const std::string start = material + spheres(120, 11) + pile + "run 300\nrun 150\nrun 450\n";
  expect_same(start, 1e-8, "run after run");

  Host first;
  first(lean_of(start) + "write_restart gran_lean.restart\nrun 100\n");
  const std::string again =
      "atom_style granular\natom_modify map array\nnewton off\ncommunicate single vel yes\nprocessors * * *\n"
      "read_restart gran_lean.restart\nneigh_modify delay 0\n" +
      contacts("gran") + "pair_coeff * *\n" + walls +
      "fix nve all nve/sphere\nfix grav all gravity 9.81 vector 0 0 -1\n" + pile + "run 100\n";
  for (const std::string &script : {again, lean_of(again)}) {
    Host later;
    later(script);
    EXPECT_LT(apart(first.atoms(), later.atoms()).v, 1e-8);
  }
}

// with the histories of sliding and of rolling friction
TEST(PairGranLean, hertzGoesOnAfterARestart)
{
  const std::string rolls =
      "fix rf all property/global coefficientRollingFriction peratomtypepair 2 0.2 0.1 0.1 0.05\n";
  for (const std::string extra : {"", " rolling_friction epsd2"}) {
    const std::string style =
        modulus + rolls + "pair_style gran model hertz tangential history" + extra + "\npair_coeff * *\n" + hertz_walls;
    const std::string pile = "neighbor 0.0002 bin\nfix drag all viscous 2e-4\ntimestep 5e-6\n";
    Host first;
    first(lean_of(box() + style + spheres(120, 11) + pile + "run 900\nwrite_restart gran_hertz.restart\nrun 100\n"));
    const std::string again =
        "atom_style granular\natom_modify map array\nnewton off\ncommunicate single vel yes\nprocessors * * *\n"
        "read_restart gran_hertz.restart\nneigh_modify delay 0\n" +
        style + "fix nve all nve/sphere\nfix grav all gravity 9.81 vector 0 0 -1\n" + pile + "run 100\n";
    for (const std::string &script : {again, lean_of(again)}) {
      Host later;
      later(script);
      EXPECT_LT(apart(first.atoms(), later.atoms()).v, 1e-8) << extra;
    }
  }
}

// fix heat/gran reads from the lists which pairs touch
TEST(PairGranLean, heatGoesThroughItsContacts)
{
  double warm[2];
  for (const char *style : {"gran", "gran/lean"}) {
    Host host;
    host(box() + contacts(style) +
         "pair_coeff * *\n"
         "fix p1 all property/global thermalConductivity peratomtype 100. 100.\n"
         "fix p2 all property/global thermalCapacity peratomtype 1. 1.\n"
         "create_atoms 1 single 0 0 0.0100 units box\ncreate_atoms 1 single 0.0000 0 0.0124 units box\n"
         "set group all diameter 2e-3 density 2600\nfix nve all nve/sphere\n"
         "group top id 2\nvelocity top set 0 0 -0.5 units box\n"
         "fix heat all heat/gran/conduction initial_temperature 300.\ntimestep 1e-6\nrun 0\n"
         "set group top property/atom Temp 500.\nrun 3000\n");
    const LAMMPS_NS::FixPropertyAtom *temp = static_cast<LAMMPS_NS::FixPropertyAtom *>(
        host.lmp->modify->find_fix_property("Temp", "property/atom", "scalar", 0, 0, "test"));
    double mine = 0;
    for (int i = 0; i < host.lmp->atom->nlocal; i++)
      if (host.lmp->atom->tag[i] == 2) mine = temp->vector_atom[i];
    MPI_Allreduce(&mine, &warm[style[4] == '/'], 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  }
  EXPECT_LT(warm[0], 499.9);
  EXPECT_NEAR(warm[1], warm[0], 1e-8 * warm[0]);
}

// clumps with charges beside: the mass that counts is the body's
TEST(PairGranLean, clumpsWithCharges)
{
  std::string sides;
  for (const std::string at : {"xplane -0.012", "xplane 0.012", "yplane -0.012", "yplane 0.012"})
    sides += "fix w" + std::to_string(sides.size()) +
        " all wall/gran model hooke/stiffness tangential history primitive type 1 " + at + "\n";
  const std::string script = test::opening("f f f", "-0.012 0.012 -0.012 0.012 0 0.06") +
      "region ins block -0.012 0.012 -0.012 0.012 0 0.06 units box\n" +
      contacts("hybrid/overlay gran", "coul/clump 0.006 every 2") +
      "pair_coeff * * gran\npair_coeff 1 1 coul/clump 3e-10\npair_coeff 2 2 coul/clump -3e-10\n" + test::clumps(40) +
      "fix grav all gravity 9.81 vector 0 0 -1\nfix push all addforce 0. 0. -0.001\n"
      "fix floor all wall/gran model hooke/stiffness tangential history primitive type 1 zplane 0.\n" +
      sides + "timestep 1e-5\nrun 3500\n";
  Host stock, ours;
  stock(script);
  ours(lean_of(script));
  const auto a = stock.atoms(), b = ours.atoms();
  ASSERT_GT(a.size(), 500u);
  EXPECT_GT(near_pairs(ours), 20);
  const Apart d = apart(a, b);
  EXPECT_LT(d.x, 1e-8);
  EXPECT_LT(d.v, 1e-6);

  // what reads the contacts elsewhere finds them with either style
  const double limit = LAMMPS_NS::present_step_limit(stock.lmp.get());
  EXPECT_LT(limit, 1e-2);
  EXPECT_NEAR(LAMMPS_NS::present_step_limit(ours.lmp.get()), limit, 1e-4 * limit);
}

TEST(PairGranLeanParallel, twoProcessorsGiveTheSameAsOne)
{
  ASSERT_EQ(test::processors(), 2);
  int rank;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0) {
    Host first(MPI_COMM_SELF);
    first(lean_of(material + spheres(150, 12) + "timestep 5e-6\nrun 300\nwrite_restart gran_lean_many.restart\n"));
  }
  MPI_Barrier(MPI_COMM_WORLD);
  const std::string again =
      lean_of("atom_style granular\natom_modify map array\nnewton off\ncommunicate single vel yes\nprocessors * * 1\n"
              "read_restart gran_lean_many.restart\nneighbor 0.0002 bin\nneigh_modify delay 0\n" +
              contacts("gran") + "pair_coeff * *\n" + walls +
              "fix nve all nve/sphere\nfix grav all gravity 9.81 vector 0 0 -1\ntimestep 5e-6\nrun 600\n");
  Host alone(MPI_COMM_SELF), together(MPI_COMM_WORLD);
  alone(again);
  together(again);
  const Apart d = apart(alone.atoms(), together.atoms());
  EXPECT_GT(d.largest_f, 0.01);
  EXPECT_LT(d.x, 1e-9);
  EXPECT_LT(d.v, 1e-8);
}
