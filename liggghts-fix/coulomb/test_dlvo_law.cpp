// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "coulomb/coul_kernel.h"

using namespace clay;

namespace {

DlvoLaw clay1mm(double retardation)
{
  DlvoLaw law;
  law.permittivity = 6.94e-10;
  law.debye = 1e-4;
  law.hamaker = 1e-14;
  law.retardation = retardation;
  law.contact = 2e-5;
  law.gap = 8e-4;
  law.cutoff = 8e-4 + 2 * 1.5e-3;
  return law;
}

const double yy = -2.5e-3, R = 6e-4;  // V2, m

}  // namespace

// by the formulas as the sources have them
TEST(DlvoLaw, formulas)
{
  for (double retardation : {0.0, 1e-4}) {
    const DlvoLaw law = clay1mm(retardation);
    for (double h : {3e-5, 2e-4, 7.9e-4}) {
      const double layers = 4 * M_PI * 6.94e-10 * yy * R * 1e4 * std::exp(-1e4 * h);
      const double attraction = 1e-14 * R / (6 * h * h) / (retardation > 0 ? 1 + 5.32 * h / retardation : 1);
      EXPECT_NEAR(law.force(yy, R, h) / (layers - attraction), 1, 1e-13);
    }
    EXPECT_EQ(law.force(yy, R, 8e-4), 0);
    EXPECT_EQ(law.energy(yy, R, 8e-4), 0);
  }
  // 25 mV at kT/e = 25.693 mV; small potentials as they are, large ones no more than 4 kT/e
  EXPECT_NEAR(effectivePotential(0.025, 298.15), 4 * 0.0256926 * std::tanh(0.025 / 4 / 0.0256926), 1e-8);
  EXPECT_NEAR(effectivePotential(1e-5, 298.15), 1e-5, 1e-12);
  EXPECT_NEAR(effectivePotential(-10, 298.15), -4 * 0.0256926, 1e-6);
}

// energy [J] against the force's integral, by Simpson's rule, also through what is held below contact
TEST(DlvoLaw, energyIsTheForcesIntegral)
{
  for (double retardation : {0.0, 1e-4})
    for (double start : {-1e-4, 0.0, 2e-5, 1e-4}) {
      const DlvoLaw law = clay1mm(retardation);
      const auto integral = [&](double from, double to) {
        const int parts = 40000;
        double sum = 0;
        for (int i = 0; i <= parts; ++i)
          sum += (i == 0 || i == parts ? 1 : i % 2 ? 4 : 2) * law.force(yy, R, from + (to - from) * i / parts);
        return sum * (to - from) / parts / 3;
      };
      const double end = law.gap * (1 - 1e-15), outside = std::max(start, law.contact);
      const double sum = integral(outside, end) + integral(start, outside);
      EXPECT_NEAR(law.energy(yy, R, start) / sum, 1, 1e-8) << start;
    }
}

TEST(DlvoLaw, noDivergence)
{
  const DlvoLaw law = clay1mm(0);
  for (double h : {1e-5, 0.0, -5e-4}) EXPECT_EQ(law.force(yy, R, h), law.force(yy, R, law.contact));
}

// spheres of several radii in bodies and alone, against the sum over all pairs
TEST(DlvoLaw, allPairsOfTheTiles)
{
  for (double retardation : {0.0, 1e-4})
    for (int kind = 0; kind < 3; ++kind) {
      DlvoLaw law = clay1mm(retardation);
      if (kind == 1) law.hamaker = 0;
      std::mt19937 random(7);
      std::uniform_real_distribution<double> box(0, 0.012), near(-1e-3, 1e-3), one(-1, 1), size(5e-4, 1.5e-3);
      ChargeGroups g;
      for (int b = 0; b < 90; ++b) {
        const double c[3] = {box(random), box(random), box(random)};
        for (int s = 0; s < (b < 50 ? 5 : 1); ++s) {
          const double x = near(random), y = near(random), z = near(random);
          g.add(c[0] + x, c[1] + y, c[2] + z, kind == 2 ? 0 : 0.05 * one(random));
          g.radius.push_back(size(random));
        }
        if (b < 50) g.close(b, b % 4 != 0);
        else if (b % 7 == 0 || b == 89) g.close(-1, true);
      }
      g.act(law);
      double worst = 0, largest = 0;
      long acting = 0;
      for (std::size_t a = 0; a < g.groups.size(); ++a) {
        if (!g.groups[a].acted) continue;
        double f[3] = {0, 0, 0}, t[3] = {0, 0, 0};
        for (int i = g.groups[a].begin; i < g.groups[a].end; ++i) {
          double fi[3] = {0, 0, 0};
          for (std::size_t b = 0; b < g.groups.size(); ++b)
            for (int j = g.groups[b].begin; j < g.groups[b].end; ++j) {
              if (i == j || (a == b && !g.groups[a].loose())) continue;
              const double d[3] = {g.x[i] - g.x[j], g.y[i] - g.y[j], g.z[i] - g.z[j]};
              const double r = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]), ri = g.radius[i], rj = g.radius[j];
              const double F = law.force(g.q[i] * g.q[j], ri * rj / (ri + rj), r - ri - rj);
              acting += F != 0;
              for (int c = 0; c < 3; ++c) fi[c] += F * d[c] / r;
            }
          const double lever[3] = {g.x[i] - g.groups[a].x, g.y[i] - g.groups[a].y, g.z[i] - g.groups[a].z};
          for (int c = 0; c < 3; ++c) {
            const int d = (c + 1) % 3, e = (c + 2) % 3;
            f[c] += fi[c];
            t[c] += lever[d] * fi[e] - lever[e] * fi[d];
          }
          const double sphere[3] = {g.fx[i], g.fy[i], g.fz[i]};
          for (int c = 0; c < 3 && g.groups[a].loose(); ++c) {
            worst = std::max(worst, std::abs(sphere[c] - fi[c]));
            largest = std::max(largest, std::abs(fi[c]));
          }
        }
        for (int c = 0; c < 3 && !g.groups[a].loose(); ++c) {
          worst = std::max({worst, std::abs(g.wrenches[a].f[c] - f[c]), 1e3 * std::abs(g.wrenches[a].t[c] - t[c])});
          largest = std::max(largest, std::abs(f[c]));
        }
      }
      EXPECT_GT(acting, 100);
      EXPECT_LT(worst, 1e-11 * largest) << kind;
    }
}
