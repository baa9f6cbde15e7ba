// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "thermal/thermal_kick.h"

using namespace clay;

TEST(ThermalKick, normalAndIndependent)
{
  const int particles = 2000, steps = 100;
  double mean = 0, square = 0, fourth = 0, sameStep = 0, nextStep = 0, nextTag = 0, streams = 0;
  for (int p = 1; p <= particles; p++)
    for (int s = 0; s < steps; s++) {
      double a[4], b[4], c[4], d[4];
      normals(12345, p, s, 0, a);
      normals(12345, p, s + 1, 0, b);
      normals(12345, p + 1, s, 0, c);
      normals(12345, p, s, 1, d);
      for (int k = 0; k < 4; k++) {
        mean += a[k];
        square += a[k] * a[k];
        fourth += a[k] * a[k] * a[k] * a[k];
        sameStep += a[k] * a[(k + 1) % 4];
        nextStep += a[k] * b[k];
        nextTag += a[k] * c[k];
        streams += a[k] * d[k];
      }
    }
  const double n = 4.0 * particles * steps, error = 4 / std::sqrt(n);
  EXPECT_NEAR(mean / n, 0, error);
  EXPECT_NEAR(square / n, 1, error * std::sqrt(2.0));
  EXPECT_NEAR(fourth / n, 3, error * std::sqrt(96.0));
  EXPECT_NEAR(sameStep / n, 0, error);
  EXPECT_NEAR(nextStep / n, 0, error);
  EXPECT_NEAR(nextTag / n, 0, error);
  EXPECT_NEAR(streams / n, 0, error);
}

TEST(ThermalKick, sameAgainAndOtherwiseOtherwise)
{
  double a[4], b[4], c[4];
  normals(1, 7, 1000000, 0, a);
  normals(1, 7, 1000000, 0, b);
  normals(2, 7, 1000000, 0, c);
  for (int k = 0; k < 4; k++) {
    EXPECT_EQ(a[k], b[k]);
    EXPECT_NE(a[k], c[k]);
  }
}

TEST(ThermalKick, forceByEinstein)
{
  // random walk of steps F dt/K: variance 2 D dt a step, D = kT/K
  const double K = 2e-8, T = 300, dt = 1e-4, F = thermal_force(K, T, dt);
  EXPECT_NEAR(F * dt / K * F * dt / K, 2 * 1.380649e-23 * T / K * dt, 1e-25);
}
