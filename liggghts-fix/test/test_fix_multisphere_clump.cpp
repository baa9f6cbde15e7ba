// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "clumps/fix_multisphere_clump.h"
#include "fix_property_atom.h"
#include "host.h"
#include "update.h"

using test::Host;

namespace {

typedef LAMMPS_NS::VectorContainer<double, 3> Vectors;

/// Clumps under a style of multisphere, falling at each other and on the floor.
std::string tumble(const std::string &style, const std::string &boundary, const std::string &more)
{
  std::string clumps = test::clumps(30);
  const std::string from = "all multisphere\n", to = "constant 0 0 0";
  clumps.replace(clumps.find(from), from.size(), "all " + style + "\n");
  clumps.replace(clumps.find(to), to.size(), "constant 0.1 0.2 -1 omega constant 30 20 10");
  const bool closed = boundary[0] == 'f';
  return test::opening(boundary, "-0.012 0.012 -0.012 0.012 0 0.065") +
      "region ins block -0.011 0.011 -0.011 0.011 0.001 0.045 units box\n" + test::material("coul/clump 0.006") +
      "pair_coeff 1 1 coul/clump 4e-10\npair_coeff 2 2 coul/clump -4e-10\n" + clumps +
      "fix grav all gravity 9.81 vector 0 0 -1\n"
      "fix floor all wall/gran model hooke tangential history primitive type 1 zplane 0\n" +
      (closed ? "fix side all wall/gran model hooke tangential history primitive type 1 zcylinder 0.012 0 0\n" : "") +
      more + "timestep 5e-6\n";
}

/// Largest difference of velocity over the largest velocity, and of place [m].
void compare(Host &one, Host &other, double *velocity, double *place)
{
  const auto a = one.atoms(), b = other.atoms();
  ASSERT_EQ(a.size(), b.size());
  ASSERT_GE(a.size(), 280u);
  double largest = 0;
  *velocity = *place = 0;
  for (std::size_t i = 0; i < a.size(); i++)
    for (int d = 0; d < 3; d++) {
      largest = std::max(largest, std::abs(a[i].v[d]));
      *velocity = std::max(*velocity, std::abs(a[i].v[d] - b[i].v[d]));
      *place = std::max(*place, std::abs(a[i].x[d] - b[i].x[d]));
    }
  EXPECT_GT(largest, 0.1);
  *velocity /= largest;
}

/// Largest speed upwards [m/s]: all fall at 1 m/s, and go up only after a blow.
double rebound(Host &host)
{
  double v = -1;
  for (const auto &a : host.atoms()) v = std::max(v, a.v[2]);
  return v;
}

void same_as_stock(const std::string &boundary, const std::string &more, int steps)
{
  Host stock, lean;
  const std::string run = "run " + std::to_string(steps) + "\n";
  stock(tumble("multisphere", boundary, more) + run);
  lean(tumble("multisphere/clump", boundary, more) + run);
  double velocity = 1, place = 1;
  compare(stock, lean, &velocity, &place);
  EXPECT_LT(velocity, 1e-8);
  EXPECT_LT(place, 1e-12);
  EXPECT_GT(rebound(lean), 0.2);
}

/// Energy of rotation of all bodies [J].
double energy(Host &host)
{
  auto &bodies = host.multisphere()->data();
  double sum = 0, all;
  for (int b = 0; b < bodies.n_body(); b++) {
    const double *I = (*bodies.prop().getElementProperty<Vectors>("inertia"))(b);
    double w[3], L[3];
    bodies.angmom(L, b);
    const char *axes[3] = {"ex_space", "ey_space", "ez_space"};
    for (int k = 0; k < 3; k++) {
      const double *e = (*bodies.prop().getElementProperty<Vectors>(axes[k]))(b);
      w[k] = (e[0] * L[0] + e[1] * L[1] + e[2] * L[2]) / I[k];
      sum += 0.5 * I[k] * w[k] * w[k];
    }
  }
  MPI_Allreduce(&sum, &all, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  return all;
}

}  // namespace

TEST(FixMultisphereClump, collidesAsStockDoes) { same_as_stock("f f f", "", 800); }

TEST(FixMultisphereClump, passesPeriodicSidesAsStockDoes) { same_as_stock("p p f", "", 800); }

TEST(FixMultisphereClump, leavesTheVirialToStock)
{
  // pressure is asked for in every seventh step only: both paths in one run
  const std::string pressure = "compute p all pressure thermo_temp\nthermo_style custom step c_p\nthermo 7\n";
  same_as_stock("f f f", pressure, 700);
}

TEST(FixMultisphereClump, keepsWhatActsOnABody)
{
  // flags of the body, and forces other commands gave it
  Host hosts[2];
  const char *styles[2] = {"multisphere", "multisphere/clump"};
  for (int n = 0; n < 2; n++) {
    Host &host = hosts[n];
    host(tumble(styles[n], "f f f", "") + "run 1\n");
    auto &bodies = host.multisphere()->data();
    for (int b = 0; b < bodies.n_body(); b++) {
      double f[3] = {1e-4 * bodies.tag(b), 0, 2e-3}, t[3] = {1e-7, 2e-7 * bodies.tag(b), 0};
      bool hold[3] = {true, bodies.tag(b) % 2 == 0, true}, turn[3] = {bodies.tag(b) % 3 == 0, true, true};
      bodies.prop().getElementProperty<Vectors>("dragforce_cm")->set(b, f);
      bodies.prop().getElementProperty<Vectors>("hdtorque_cm")->set(b, t);
      bodies.set_fflag(b, hold);
      bodies.set_tflag(b, turn);
    }
    host("run 40\n");
  }
  double velocity = 1, place = 1;
  compare(hosts[0], hosts[1], &velocity, &place);
  EXPECT_LT(velocity, 1e-9);
  Host plain;
  plain(tumble("multisphere/clump", "f f f", "") + "run 1\nrun 40\n");
  compare(plain, hosts[1], &velocity, &place);
  EXPECT_GT(velocity, 1e-5);
}

// of clumps like these, whose spheres count in full
TEST(FixMultisphereClump, meanDiameterOfItsBodies)
{
  Host host;
  host(tumble("multisphere/clump", "f f f", "") + "run 1\n");
  std::map<int, double> volumes;
  for (const auto &a : host.atoms()) volumes[a.body] += 4. / 3. * M_PI * a.radius * a.radius * a.radius;
  double all = 0, mean = 0;
  for (const auto &v : volumes) all += v.second;
  for (const auto &v : volumes) mean += v.second / all * std::cbrt(6 / M_PI * v.second);
  ASSERT_GE(volumes.size(), 20u);
  EXPECT_GT(mean, 1e-3);
  auto *bodies = dynamic_cast<LAMMPS_NS::FixMultisphereClump *>(host.multisphere());
  ASSERT_TRUE(bodies);
  EXPECT_NEAR(bodies->mean_diameter() / mean, 1, 1e-6);

  // that of the templates, before there is any body
  Host empty;
  std::string script = tumble("multisphere/clump", "f f f", "");
  script.erase(script.find("fix ins all"), script.find('\n', script.find("fix ins all")) - script.find("fix ins all"));
  empty(script + "run 0\n");
  bodies = dynamic_cast<LAMMPS_NS::FixMultisphereClump *>(empty.multisphere());
  ASSERT_TRUE(bodies);
  EXPECT_NEAR(bodies->mean_diameter() / mean, 1, 1e-6);
}

TEST(FixMultisphereClump, takesInsertedBodiesUp)
{
  // a second batch comes while the first one moves
  const std::string more =
      "region upper block -0.011 0.011 -0.011 0.011 0.046 0.064 units box\n"
      "fix late all insert/pack seed 86028121 distributiontemplate pdd insert_every 200 overlapcheck yes "
      "orientation random all_in yes maxattempt 200 vel constant 0 0 -0.5 region upper "
      "particles_in_region 2 ntry_mc 10000\n";
  same_as_stock("f f f", more, 700);
}

TEST(FixMultisphereClump, freeRotationOfAnAsymmetricBody)
{
  double drift[2] = {0, 0}, turned[2][3];
  for (int n = 0; n < 2; n++) {
    Host host;
    std::string clumps = test::clumps(1);
    const std::string from = "all multisphere\n";
    if (n) clumps.replace(clumps.find(from), from.size(), "all multisphere/clump\n");
    host(test::opening("f f f", "-0.03 0.03 -0.03 0.03 -0.03 0.03") +
         "region ins block -0.01 0.01 -0.01 0.01 -0.01 0.01 units box\n" + test::material("coul/clump 0.006") +
         "pair_coeff * * coul/clump 0\n" + clumps + "timestep 1e-5\nrun 1\n");
    auto &bodies = host.multisphere()->data();
    for (int b = 0; b < bodies.n_body(); b++) {
      Vectors &inertia = *bodies.prop().getElementProperty<Vectors>("inertia");
      for (int k = 0; k < 3; k++) inertia(b)[k] = (2 + k) * 1e-10;
      // close to the middle axis, about which rotation is not stable
      double w[3];
      const double *ex = (*bodies.prop().getElementProperty<Vectors>("ex_space"))(b);
      const double *ey = (*bodies.prop().getElementProperty<Vectors>("ey_space"))(b);
      for (int k = 0; k < 3; k++) w[k] = 300 * ey[k] + 30 * ex[k];
      bodies.set_angmom_via_omega_body(b, w);
    }
    double L0[3] = {0, 0, 0}, L[3] = {0, 0, 0};
    if (bodies.n_body()) bodies.angmom(L0, 0);
    const double before = energy(host);
    ASSERT_GT(before, 0);
    for (int part = 0; part < 20; part++) {
      host("run 200\n");
      drift[n] = std::max(drift[n], std::abs(energy(host) / before - 1));
    }
    if (bodies.n_body()) bodies.angmom(L, 0);
    for (int k = 0; k < 3; k++) {
      EXPECT_EQ(L[k], L0[k]);
      turned[n][k] = host.atoms()[0].x[k];
    }
  }
  EXPECT_LT(drift[1], 1e-6);
  EXPECT_LE(drift[1], drift[0] + 1e-13);
  for (int k = 0; k < 3; k++) EXPECT_NEAR(turned[1][k], turned[0][k], 1e-12);
}

// also one whose place in memory was another body's before, or nobody's
TEST(FixMultisphereClump, bodiesBeginWithoutAFluid)
{
  Host host;
  host(tumble("multisphere/clump", "f f f", "") + "run 1\n");
  auto *bodies = dynamic_cast<LAMMPS_NS::FixMultisphereClump *>(host.fix("ms"));
  ASSERT_NE(bodies, nullptr);
  ASSERT_GE(bodies->n_body_all(), 20);
  for (int b = 0; b < bodies->n_body(); b++) {
    EXPECT_FALSE(bodies->knows_fluid(b));
    double impulse[3];
    bodies->take_impulse(b, impulse);
    for (int k = 0; k < 3; k++) EXPECT_EQ(impulse[k], 0);
  }
}

TEST(FixMultisphereClump, saysBeforeItTakesSpheresOut)
{
  // a sphere that stock multisphere has marked goes when particles change places
  Host host;
  host(tumble("multisphere/clump", "f f f", "") + "run 0\n");
  auto *bodies = static_cast<LAMMPS_NS::FixMultisphereClump *>(host.multisphere());
  const int before = host.lmp->atom->nlocal;
  if (before == 0) return;  // another processor has them
  auto *marks = static_cast<LAMMPS_NS::FixPropertyAtom *>(host.fix("delflag"));
  ASSERT_TRUE(marks);
  marks->vector_atom[0] = 1.0;
  int seen = 0;
  bodies->couple([&] { seen = host.lmp->atom->nlocal; });
  bodies->pre_exchange();
  EXPECT_EQ(seen, before);
  EXPECT_EQ(host.lmp->atom->nlocal, before - 1);
}
