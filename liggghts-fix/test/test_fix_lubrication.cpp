// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "films/fix_lubrication.h"
#include "host.h"

using test::Host;

namespace {

const double mu = 1, a = 0.5e-3;

// spheres of radius a, by places; those of type 2 are pushed down by F
std::string spheres(const std::string &boundary, const std::vector<std::array<double, 3>> &places,
                    const std::string &films, double F, double dt, const std::string &before = "")
{
  std::ostringstream s;
  s.precision(17);
  s << test::opening(boundary, "0 0.01 0 0.01 0 0.01") << test::material("");
  for (std::size_t i = 0; i < places.size(); i++)
    s << "create_atoms " << (i ? 2 : 1) << " single " << places[i][0] << " " << places[i][1] << " " << places[i][2]
      << " units box\n";
  s << "set group all diameter " << 2 * a << "\nset group all density 2600\ngroup one type 1\ngroup other type 2\n"
    << before << "fix push other addforce 0 0 " << -F << "\n";
  if (F > 0) s << "fix pull one addforce 0 0 " << F << "\n";
  s << "fix films all lubrication viscosity " << mu << " " << films << "\n"
    << "fix nve all nve/sphere\ntimestep " << dt << "\n";
  return s.str();
}

double gap(const std::vector<test::Atom> &s)
{
  double r2 = 0;
  for (int k = 0; k < 3; k++) r2 += (s[0].x[k] - s[1].x[k]) * (s[0].x[k] - s[1].x[k]);
  return std::sqrt(r2) - 2 * a;
}

}  // namespace

TEST(FixLubrication, exponentialApproachWhateverTheStep)
{
  // dh/dt = -F h/(6 pi mu (a/2)2) where inertia is small: h = h0 exp(-t/T)
  const double h0 = 0.02 * a, F = 1e-5, T = 6 * M_PI * mu * a * a / 4 / F;
  const double m = 2600 * 4.0 / 3 * M_PI * a * a * a, relax = 0.5 * m / (6 * M_PI * mu * a * a / 4 / h0);
  ASSERT_GT(T, 50 * relax);
  for (const double dt : {0.02 * relax, 0.2 * relax, 2 * relax}) {
    Host host;
    const int steps = static_cast<int>(std::lround(0.7 * T / dt));
    // start at the velocity of the approach: a half step of force stands before it
    const double v0 = 0.5 * F / (6 * M_PI * mu * a * a / 4 / h0);
    std::ostringstream start;
    start.precision(17);
    start << "velocity one set 0 0 " << v0 << " units box\nvelocity other set 0 0 " << -v0 << " units box\n";
    host(spheres("f f f", {{0.005, 0.005, 0.004}, {0.005, 0.005, 0.004 + 2 * a + h0}},
                 "logarithm no shifted no inner 1e-6", F, dt, start.str()) +
         "run " + std::to_string(steps) + "\n");
    EXPECT_NEAR(gap(host.atoms()) / (h0 * std::exp(-steps * dt / T)), 1, 0.01) << dt / relax;
  }
}

TEST(FixLubrication, sameAcrossProcessorsAndPeriodicSides)
{
  // the pair stands across a periodic side, then across the processors' border
  std::vector<double> gaps;
  for (const double z : {0.0096, 0.0046, 0.003}) {
    Host host;
    double other = z + 2.02 * a;
    if (other >= 0.01) other -= 0.01;
    host(spheres("p p p", {{0.005, 0.005, z}, {0.0051, 0.005, other}}, "outer 1", 1e-4, 1e-6) + "run 400\n");
    auto s = host.atoms();
    ASSERT_EQ(s.size(), 2u);
    for (int k = 0; k < 3; k++) s[1].x[k] -= 0.01 * std::round((s[1].x[k] - s[0].x[k]) / 0.01);
    gaps.push_back(gap(s));
    EXPECT_NEAR(s[0].v[2], -s[1].v[2], 1e-12 * std::abs(s[0].v[2]));
    EXPECT_NEAR(host.fix("films")->compute_vector(2), 2 * gap(s) / (2 * a), 1e-3 * gap(s) / a);
  }
  EXPECT_LT(gaps[0], 0.029 * a);  // 0.03 a at the start
  EXPECT_NEAR(gaps[1], gaps[0], 1e-9 * gaps[0]);
  EXPECT_NEAR(gaps[2], gaps[0], 1e-9 * gaps[0]);
}

TEST(FixLubrication, wallsFlatAndRound)
{
  // one sphere beside a plane, another inside a cylinder: the force at a given velocity
  const double h = 1e-3 * a, v = 1e-6;
  struct Case {
    const char *wall;
    double x[3], n[3], curved;
  };
  const double R = 4e-3;
  const Case cases[] = {
      {"zplane 0", {0.005, 0.005, a + h}, {0, 0, 1}, 0},
      {"zplane 0.01", {0.005, 0.005, 0.01 - a - h}, {0, 0, -1}, 0},
      {"zcylinder 0.004 0.005 0.005", {0.005 + R - a - h, 0.005, 0.004}, {-1, 0, 0}, R},
      {"zcylinder 0.002 0.005 0.005", {0.005, 0.007 + a + h, 0.004}, {0, 1, 0}, -0.002},
  };
  for (const Case &c : cases) {
    Host host;
    std::ostringstream wall;
    wall.precision(17);
    wall << "fix w all wall/gran model hooke tangential history primitive type 1 " << c.wall << "\n"
         << "velocity all set " << -v * c.n[0] << " " << -v * c.n[1] << " " << -v * c.n[2] << " units box\n";
    host(spheres("f f f", {{c.x[0], c.x[1], c.x[2]}}, "outer 0.5", 0, 1e-13, wall.str()) + "run 0\n");
    clay::LubricationLaw law;
    law.viscosity = mu;
    const double expected = v * law.wall(a, h, c.curved).squeeze;
    const auto s = host.atoms();
    for (int k = 0; k < 3; k++) EXPECT_NEAR(s[0].f[k], expected * c.n[k], 1e-4 * expected) << c.wall;
    EXPECT_EQ(host.fix("films")->compute_vector(1), 1) << c.wall;
  }
}

TEST(FixLubrication, clumpsInSyrupNeverGainEnergy)
{
  Host host;
  host(test::opening("p p p", "-0.012 0.012 -0.012 0.012 0 0.024") +
       "region ins block -0.012 0.012 -0.012 0.012 0 0.024 units box\n" + test::material("") + test::clumps(110) +
       "fix films all lubrication viscosity 1e3 outer 1\ntimestep 1e-5\nrun 1\n" +
       "velocity all set 0 0 0 units box\n");
  auto energy = [&] {
    double e = 0;
    LAMMPS_NS::FixMultisphere *ms = host.multisphere();
    for (int b = 0; b < ms->n_body(); b++) {
      double v[3];
      ms->data().vcm(v, b);
      e += 0.5 * ms->data().mass(b) * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }
    double all;
    MPI_Allreduce(&e, &all, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    return all;
  };
  // moving clumps in syrup: films stop what is near, however long the step against it
  LAMMPS_NS::FixMultisphere *ms = host.multisphere();
  for (int b = 0; b < ms->n_body(); b++) {
    const int tag = ms->data().tag(b);
    double v[3] = {0.01 * std::sin(3.0 * tag), 0.01 * std::cos(5.0 * tag), 0.01 * std::sin(7.0 * tag + 1)};
    ms->data().set_v_body(b, v);
  }
  double before = energy();
  const double start = before;
  EXPECT_GT(host.fix("films")->compute_vector(0), 20);
  for (int n = 0; n < 20; n++) {
    host("run 1\n");
    const double now = energy();
    EXPECT_LE(now, before * (1 + 1e-9));
    before = now;
  }
  EXPECT_LT(before, 0.95 * start);
}
