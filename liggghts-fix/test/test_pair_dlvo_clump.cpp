// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "coulomb/pair_dlvo_clump.h"
#include "host.h"
#include "pair.h"

using test::Host;

namespace {

const double eps = 8.8541878128e-12 * 78.4;
const std::string style = "dlvo/clump 8e-4 debye 1e-4 hamaker 1e-14 contact 2e-5 retarded 1e-3";

double Y(double psi)
{
  const double thermal = 1.380649e-23 * 298.15 / 1.602176634e-19;
  return 4 * thermal * std::tanh(psi / 4 / thermal);
}

std::string two(const std::string &how, double gap)
{
  std::ostringstream s;
  s.precision(17);
  s << test::opening("f f f", "-0.01 0.01 -0.01 0.01 -0.01 0.01") << test::material(how)
    << "pair_coeff 1 1 dlvo/clump 0.03\npair_coeff 2 2 dlvo/clump -0.05\n"
    << "create_atoms 1 single 0 0 0 units box\ncreate_atoms 2 single " << 1.5e-3 + gap << " 0 0 units box\n"
    << "set type 1 diameter 1e-3\nset type 2 diameter 2e-3\nset group all density 2600\n"
    << "fix nve all nve/sphere\ntimestep 1e-6\n";
  return s.str();
}

// force on the second along x: R = 0.5 mm 1 mm/1.5 mm
double expected(double h)
{
  const double R = 1e-3 / 3;
  return R *
      (4 * M_PI * eps * Y(0.03) * Y(-0.05) * 1e4 * std::exp(-1e4 * h) - 1e-14 / (6 * h * h) / (1 + 5.32 * h / 1e-3));
}

}  // namespace

TEST(PairDlvoClump, forceByTheFormula)
{
  for (double gap : {1e-5, 1e-4, 7e-4, 8.1e-4}) {
    Host host;
    host(two(style, gap) + "run 0\n");
    const auto a = host.atoms();
    ASSERT_EQ(a.size(), 2u);
    const double f = gap > 8e-4 ? 0 : expected(std::max(gap, 2e-5));
    EXPECT_NEAR(a[1].f[0], f, 1e-10 * std::abs(f)) << gap;
    EXPECT_NEAR(a[0].f[0], -f, 1e-10 * std::abs(f)) << gap;
  }
}

TEST(PairDlvoClump, energyAndSingle)
{
  Host host;
  host(two(style, 1e-4) + "compute pe all pe pair\nthermo_style custom step c_pe\nrun 0\n");
  auto *pair = dynamic_cast<LAMMPS_NS::PairDlvoClump *>(host.lmp->force->pair_match("dlvo/clump", 1));
  ASSERT_NE(pair, nullptr);
  double sum = 0;
  const int parts = 20000;
  for (int i = 0; i <= parts; i++)
    sum += (i == 0 || i == parts ? 1 : i % 2 ? 4 : 2) * expected(1e-4 + 7e-4 * i / parts) * 7e-4 / parts / 3;
  double mine = host.lmp->force->pair->eng_coul, all;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  EXPECT_NEAR(all / sum, 1, 1e-9);
  if (test::processors() > 1) return;  // both atoms are needed
  double f = 0;
  const double r = host.atoms()[1].x[0] - host.atoms()[0].x[0];
  EXPECT_NEAR(pair->single(0, 1, 1, 2, r * r, 1, 1, f) / sum, 1, 1e-9);
  EXPECT_NEAR(f * r / expected(1e-4), 1, 1e-9);
}

TEST(PairDlvoClump, nothingToDo)
{
  Host host;
  host(two("dlvo/clump 8e-4 debye 1e-4 hamaker 0 contact 2e-5", 1e-4) + "pair_coeff * * dlvo/clump 0.0\nrun 5\n");
  auto *pair = dynamic_cast<LAMMPS_NS::PairDlvoClump *>(host.lmp->force->pair_match("dlvo/clump", 1));
  EXPECT_EQ(pair->evaluations(), 0);
  EXPECT_EQ(host.atoms()[0].f[0], 0);
}

// two that are let go draw near, and their energy is kept
TEST(PairDlvoClump, approachKeepsTheEnergy)
{
  Host host;
  host(two("dlvo/clump 8e-4 debye 1e-4 hamaker 1e-12 contact 2e-5", 4e-4) +
       "timestep 5e-6\nthermo_style custom step ke\nrun 0\n");
  auto *pair = dynamic_cast<LAMMPS_NS::PairDlvoClump *>(host.lmp->force->pair_match("dlvo/clump", 1));
  const double yy = Y(0.03) * Y(-0.05), R = 1e-3 / 3;
  const auto total = [&](double &gap) {
    double e = 0;
    const auto a = host.atoms();
    for (const auto &p : a) e += 0.5 * p.rmass * p.v[0] * p.v[0];
    gap = a[1].x[0] - a[0].x[0] - 1.5e-3;
    return e + pair->law().energy(yy, R, gap);
  };
  double gap = 0, worst = 0;
  const double start = total(gap);
  for (int i = 0; i < 4000 && gap > 5e-6; i++) {
    host("run 1000 pre no post no\n");
    worst = std::max(worst, std::abs(total(gap) / start - 1));
    if (gap < 2e-5) break;
  }
  EXPECT_LT(gap, 2e-5);
  EXPECT_LT(worst, 1e-3);
}

namespace {

// two like spheres of 1 mm and 30 mV along x, so far apart, with a secondary minimum
std::string like(double gap, const std::string &more = "")
{
  std::ostringstream s;
  s.precision(17);
  s << test::opening("f f f", "-0.01 0.01 -0.01 0.01 -0.01 0.01")
    << test::material("dlvo/clump 1.5e-3 debye 1e-4 hamaker 2e-15 contact 2e-5" + more)
    << "pair_coeff * * dlvo/clump 0.03\ncreate_atoms 1 single " << -0.5e-3 - gap / 2
    << " 0 0 units box\ncreate_atoms 2 single " << 0.5e-3 + gap / 2 << " 0 0 units box\n"
    << "set group all diameter 1e-3\nset group all density 2600\nfix nve all nve/sphere\n";
  return s.str();
}

const double barrier[] = {1.254636956879e-4, 8.505899356407e-5};  // top of the barrier, not retarded and with W = 1 mm
const double minimum[] = {2.994496975772e-4, 5.653893614688e-4};  // secondary minimum
const double massOfOne = 2600 * M_PI / 6 * 1e-9;

}  // namespace

// The places by numpy and scipy's brentq, from constants of nature alone, with Z = 64 pi eps (kT/e)^2 tanh(e
// psi/4kT)^2: F = R (Z/L exp(-h/L) - A/(6 h h)/(1 + 5.32 h/W)), R = a/2
TEST(PairDlvoClump, secondaryMinimumWhereTheFormulasHaveIt)
{
  for (int retarded : {0, 1}) {
    const std::string more = retarded ? " retarded 1e-3" : "";
    const auto force = [&](double gap) {
      Host host;
      host(like(gap, more) + "timestep 1e-6\nrun 0\n");
      return host.atoms()[1].f[0];
    };
    const double top = barrier[retarded], low = minimum[retarded];
    EXPECT_LT(force(top * (1 - 1e-8)), 0);  // drawn into contact
    EXPECT_GT(force(top * (1 + 1e-8)), 0);
    EXPECT_GT(force(low * (1 - 1e-8)), 0);
    EXPECT_LT(force(low * (1 + 1e-8)), 0);
  }
}

// let go a fifth within it they swing through it, and their energy stays
TEST(PairDlvoClump, swingsAboutTheSecondaryMinimum)
{
  if (test::processors() > 1) return;  // thousands of steps of two spheres
  Host host;
  host(like(0.8 * minimum[0]) + "timestep 0.04\nthermo_style custom step ke\nrun 0\n");
  auto *pair = dynamic_cast<LAMMPS_NS::PairDlvoClump *>(host.lmp->force->pair_match("dlvo/clump", 1));
  const double yy = Y(0.03) * Y(0.03), R = 2.5e-4, floor = pair->law().energy(yy, R, minimum[0]);
  const double start = pair->law().energy(yy, R, 0.8 * minimum[0]) - floor;
  double worst = 0, near = 1, far = 0;
  int turns = 0;
  bool parting = true;
  for (int i = 0; i < 75; i++) {
    host("run 100 pre no post no\n");
    const auto a = host.atoms();
    const double gap = a[1].x[0] - a[0].x[0] - 1e-3, v = a[1].v[0] - a[0].v[0];
    const double energy = 0.25 * massOfOne * v * v + pair->law().energy(yy, R, gap) - floor;
    worst = std::max(worst, std::abs(energy / start - 1));
    near = std::min(near, gap);
    far = std::max(far, gap);
    turns += v > 0 ? !parting : parting;
    parting = v > 0;
  }
  EXPECT_LT(worst, 1e-5);
  EXPECT_GE(turns, 4);
  EXPECT_GT(near, 0.8 * minimum[0] * (1 - 1e-6));
  EXPECT_GT(far, 1.2 * minimum[0]);
}

// about each other, a little beyond the minimum: T = 2 pi sqrt(m/2 r/F)
TEST(PairDlvoClump, circularOrbit)
{
  if (test::processors() > 1) return;  // thousands of steps of two spheres
  for (const std::string every : {"", " every 10 hold"}) {
    const double gap = 1.05 * minimum[0], r = 1e-3 + gap;
    const double Z = 4 * M_PI * eps * Y(0.03) * Y(0.03);
    const double F = -2.5e-4 * (Z * 1e4 * std::exp(-1e4 * gap) - 2e-15 / (6 * gap * gap));
    ASSERT_GT(F, 0);
    const double T = 2 * M_PI * std::sqrt(massOfOne / 2 * r / F), v = M_PI * r / T;
    Host host;
    std::ostringstream s;
    s.precision(17);
    s << like(gap, every) << "group one type 1\ngroup other type 2\nvelocity one set 0 " << -v
      << " 0 units box\nvelocity other set 0 " << v << " 0 units box\ntimestep " << T / 4000 << "\nrun 4000\n";
    host(s.str());
    const auto a = host.atoms();
    EXPECT_NEAR(std::atan2(a[1].x[1], a[1].x[0]), 0, 1e-3 * 2 * M_PI) << every;
    EXPECT_NEAR(std::hypot(a[1].x[0] - a[0].x[0], a[1].x[1] - a[0].x[1]) - 1e-3, gap, 1e-3 * gap) << every;
  }
}

// the layers alone are those of coul/clump screened, whose form is that of spheres at any Debye length:
// of charges Q = 4 pi eps a (1 + a/L) Y, and F = 4 pi eps Y Y a1 a2 (r + L)/(L r2) exp(-h/L)
TEST(PairDlvoClump, layersBesideThoseOfCoulClump)
{
  const double a1 = 0.5e-3, a2 = 1e-3;
  for (double L : {2e-5, 1e-4, 1e-3})
    for (double gap : {1e-5, 3e-5, 1e-4}) {
      std::ostringstream own, charged;
      own.precision(17);
      charged.precision(17);
      own << "dlvo/clump 8e-4 contact 1e-6 hamaker 0 debye " << L;
      const auto Q = [&](double a, double psi) { return 4 * M_PI * eps * a * (1 + a / L) * Y(psi); };
      charged << test::opening("f f f", "-0.01 0.01 -0.01 0.01 -0.01 0.01");
      std::ostringstream law;
      law.precision(17);
      law << "coul/clump 0.008 permittivity 78.4 screened " << L;
      charged << test::material(law.str()) << "pair_coeff 1 1 coul/clump " << Q(a1, 0.03)
              << "\npair_coeff 2 2 coul/clump " << Q(a2, -0.05) << "\n";
      std::string script = two(own.str(), gap);
      const std::string atoms = script.substr(script.find("create_atoms"));
      Host first, second;
      first(script + "run 0\n");
      second(charged.str() + atoms + "run 0\n");
      const double r = a1 + a2 + gap, ratio = (a1 + a2) * (r + L) / (r * r);
      const double f = first.atoms()[1].f[0];
      EXPECT_LT(f, 0);
      EXPECT_NEAR(second.atoms()[1].f[0] / f / ratio, 1, 1e-8) << L << " " << gap;
      if (L < 5e-5) { EXPECT_NEAR(ratio, 1, 0.06); }
    }
}

// the two together, no salt and no potentials: Coulomb's law and van der Waals'
TEST(PairDlvoClump, attractionBesideCoulombsLaw)
{
  const double gap = 1e-4, r = 1.5e-3 + gap, R = 1e-3 / 3, q = 1e-13;
  std::ostringstream law;
  law << "coul/clump 0.008 screened 1e6 dlvo/clump 8e-4 debye 1e-4 hamaker 1e-14 contact 2e-5";
  std::string script = two(law.str(), gap);
  Host host;
  host(script +
       "pair_coeff * * dlvo/clump 0\npair_coeff 1 1 coul/clump 1e-13\npair_coeff 2 2 coul/clump -1e-13\nrun 0\n");
  const double waals = -1e-14 * R / (6 * gap * gap), coulomb = -8.9875517873681764e9 * q * q / (r * r);
  EXPECT_GT(waals / coulomb, 0.1);
  EXPECT_LT(waals / coulomb, 10);
  EXPECT_NEAR(host.atoms()[1].f[0] / (waals + coulomb), 1, 1e-10);
}

TEST(PairDlvoClump, settingsComeBackFromARestart)
{
  Host host;
  std::string script = two(style + " permittivity 70 temperature 310 every 3 hold", 1e-4);
  script.replace(script.find("pair_style hybrid/overlay gran model hooke tangential history "), 62, "pair_style ");
  script.replace(script.find("pair_coeff * * gran\n"), 20, "");
  for (std::size_t at; (at = script.find(" dlvo/clump 0.03")) != std::string::npos;) script.replace(at, 11, "");
  for (std::size_t at; (at = script.find(" dlvo/clump -0.05")) != std::string::npos;) script.replace(at, 11, "");

  script.replace(script.find("map array"), 9, "map array sort 0 0");
  host(script + "run 0\nwrite_restart dlvo_settings.restart\n");
  Host again;
  again("atom_style granular\natom_modify map array sort 0 0\nnewton off\ncommunicate single vel yes\n"
        "read_restart dlvo_settings.restart\nneighbor 0.0005 bin\nneigh_modify delay 0\nfix nve all nve/sphere\n"
        "timestep 1e-6\nrun 0\n");
  auto *was = dynamic_cast<LAMMPS_NS::PairDlvoClump *>(host.lmp->force->pair);
  auto *is = dynamic_cast<LAMMPS_NS::PairDlvoClump *>(again.lmp->force->pair);
  ASSERT_NE(is, nullptr);
  EXPECT_EQ(is->law().debye, was->law().debye);
  EXPECT_EQ(is->law().permittivity, was->law().permittivity);
  EXPECT_EQ(is->law().retardation, 1e-3);
  EXPECT_EQ(is->every(), 3);
  EXPECT_EQ(is->kicks(), false);
  EXPECT_NE(host.atoms()[0].f[0], 0);
  EXPECT_EQ(again.atoms()[0].f[0], host.atoms()[0].f[0]);
}

namespace {

const std::string both = "coul/clump 0.008 screened 1e-3 every 2 hold dlvo/clump 8e-4 debye 1e-4 hamaker 1e-11 contact "
                         "2e-5 every 2 hold";
const std::string values = "pair_coeff 1 1 coul/clump 1e-10\npair_coeff 2 2 coul/clump -1e-10\n"
                           "pair_coeff 1 1 dlvo/clump 0.05\npair_coeff 2 2 dlvo/clump -0.05\n";

std::string begun()
{
  return test::opening("f f f", "-0.012 0.012 -0.012 0.012 0 0.06") +
      "region ins block -0.012 0.012 -0.012 0.012 0 0.06 units box\n" + test::material(both) + values +
      test::clumps(40) + "timestep 1e-5\nrun 11\nwrite_restart dlvo_clump.restart\n";
}

std::string again()
{
  return "atom_style granular\natom_modify map array\nnewton off\ncommunicate single vel yes\nprocessors * * *\n"
         "read_restart dlvo_clump.restart\nneighbor 0.0005 bin\nneigh_modify delay 0\n" +
      test::material(both) + values + "fix ms all multisphere\ntimestep 1e-5\nrun 300\n";
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
  EXPECT_GT(moved, 1e-6);
  EXPECT_LT(apart, 1e-7 * moved);
}

}  // namespace

// with coul/clump and contacts beside it, within an interval of held forces; on one processor bit for bit
TEST(PairDlvoClump, goesOnAfterARestart)
{
  Host straight, restarted;
  straight(begun() + "run 300\n");
  restarted(again());
  const auto a = straight.atoms(), b = restarted.atoms();
  expect_same(a, b);
  for (std::size_t i = 0; i < a.size() && test::processors() == 1; i++)
    for (int d = 0; d < 3; d++) {
      ASSERT_EQ(a[i].x[d], b[i].x[d]) << a[i].tag;
      ASSERT_EQ(a[i].v[d], b[i].v[d]) << a[i].tag;
    }
}

// on 2, and on 4
TEST(PairDlvoClumpParallel, processorsGiveTheSameAsOne)
{
  ASSERT_GT(test::processors(), 1);
  int rank;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0) {
    Host first(MPI_COMM_SELF);
    first(begun());
  }
  MPI_Barrier(MPI_COMM_WORLD);
  Host alone(MPI_COMM_SELF), together(MPI_COMM_WORLD);
  alone(again());
  together(again());
  expect_same(alone.atoms(), together.atoms());
}
