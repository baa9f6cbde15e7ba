// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>

#include "host.h"

using test::Host;

namespace {

const double kB = 1.380649e-23, mu = 1e-3, a = 1e-6, T = 300;
const double K = 6 * M_PI * mu * a, m = 2600 * 4.0 / 3 * M_PI * a * a * a;

// side^3 spheres a long way apart, free to go through each other's images; put one by one they have
// the same numbers on any number of processors
std::string cloud(int side, double dt, bool one_by_one = false)
{
  std::ostringstream s;
  s.precision(17);
  const double apart = 20 * a, L = side * apart;
  s << "0 " << L << " 0 " << L << " 0 " << L;
  std::string text = test::opening("p p p", s.str());
  text.replace(text.find("neighbor 0.0005"), 15, "neighbor 4e-6");
  std::ostringstream r;
  r.precision(17);
  if (one_by_one)
    for (int n = 0; n < side * side * side; n++)
      r << "create_atoms 1 single " << apart * (0.5 + n % side) << ' ' << apart * (0.5 + n / side % side) << ' '
        << apart * (0.5 + n / side / side) << " units box\n";
  else r << "lattice sc " << apart << "\ncreate_atoms 1 box\n";
  r << "set group all diameter " << 2 * a << "\nset group all density 2600\nfix b all brownian temperature " << T
    << " seed 5 viscosity " << mu << "\nfix nve all nve/sphere\ntimestep " << dt << "\n";
  return text + test::material("") + r.str();
}

}  // namespace

TEST(FixBrownian, diffusesByEinsteinWhateverTheStep)
{
  const double D = kB * T / K, relax = m / K;
  for (const double x : {0.1, 1.0, 30.0}) {
    Host host;
    const double dt = x * relax;
    const int settle = static_cast<int>(5 / x) + 2, steps = x < 1 ? 400 : 60;
    host(cloud(14, dt) + "run " + std::to_string(settle) + "\n");
    const auto before = host.atoms();
    host("run " + std::to_string(steps) + "\n");
    const auto after = host.atoms();
    ASSERT_EQ(after.size(), 2744u);
    const double L = 14 * 20 * a;
    double square = 0, kinetic = 0;
    for (std::size_t i = 0; i < after.size(); i++)
      for (int k = 0; k < 3; k++) {
        double d = after[i].x[k] - before[i].x[k];
        d -= L * std::round(d / L);
        square += d * d;
        kinetic += m * after[i].v[k] * after[i].v[k];
      }
    const double n = 3.0 * after.size(), t = steps * dt;
    // displacement of a particle with memory: 2 D (t - relax (1 - exp(-t/relax)))
    const double expected = 2 * D * (t - relax * (1 - std::exp(-t / relax)));
    const double deviation = std::sqrt(2 / n);
    EXPECT_NEAR(square / n / expected, 1, 4 * deviation + 0.005) << x;
    if (x < 1) EXPECT_NEAR(kinetic / n / (kB * T), 1, 4 * deviation + 0.005);
  }
}

TEST(FixBrownianParallel, twoProcessorsGiveTheSameAsOne)
{
  ASSERT_EQ(test::processors(), 2);
  const double dt = m / K;
  Host alone(MPI_COMM_SELF), together(MPI_COMM_WORLD);
  alone(cloud(5, dt, true) + "run 50\n");
  together(cloud(5, dt, true) + "run 50\n");
  const auto p = alone.atoms(), q = together.atoms();
  ASSERT_EQ(p.size(), 125u);
  ASSERT_EQ(q.size(), 125u);
  const double typical = std::sqrt(kB * T / m);
  double square = 0;
  for (std::size_t i = 0; i < p.size(); i++) {
    ASSERT_EQ(p[i].tag, q[i].tag);
    for (int k = 0; k < 3; k++) {
      EXPECT_NEAR(p[i].v[k], q[i].v[k], 1e-12 * typical) << p[i].tag;
      EXPECT_NEAR(p[i].x[k], q[i].x[k], 1e-9 * a) << p[i].tag;
      square += p[i].v[k] * p[i].v[k] / 375;
    }
  }
  EXPECT_NEAR(std::sqrt(square), typical, 0.2 * typical);  // all of them have been kicked
}

TEST(FixBrownian, bodiesDiffuseAsTheirSpheresTogether)
{
  // the random force on a body: of variance 2 kT/dt times the sum of its spheres' K
  Host host;
  host(test::opening("p p p", "-0.012 0.012 -0.012 0.012 0 0.048") +
       "region ins block -0.012 0.012 -0.012 0.012 0 0.048 units box\n" + test::material("") + test::clumps(100) +
       "fix b all brownian temperature 300 seed 3 viscosity 1e-3\ntimestep 1e-5\nrun 0\n");
  double square = 0;
  int count = 0;
  for (int s = 1; s <= 30; s++) {
    host("run 1\n");
    std::map<int, std::array<double, 3>> force;
    for (const test::Atom &p : host.atoms())
      for (int k = 0; k < 3; k++) force[p.body][k] += p.f[k];
    for (const auto &body : force)
      for (int k = 0; k < 3; k++, count++) square += body.second[k] * body.second[k];
  }
  const double sum = 14 * 6 * M_PI * 1e-3 * 1e-3, expected = 2 * kB * 300 * sum / 1e-5;
  ASSERT_GT(count, 8000);
  EXPECT_NEAR(square / count / expected, 1, 4 * std::sqrt(2.0 / count) + 0.01);
}
