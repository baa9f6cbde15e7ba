// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "thermal/thermal_kick.h"

using namespace clay;

// the generator's published answers: of zeros, of ones, of the digits of pi
TEST(ThermalKick, generatorGivesItsKnownAnswers)
{
  typedef r123::Philox4x64::ctr_type Counter;
  typedef r123::Philox4x64::key_type Key;
  const std::uint64_t ones = ~std::uint64_t(0);
  struct Known {
    Counter counter;
    Key key;
    Counter answer;
  };
  const Known all[] = {
      {{{0, 0, 0, 0}}, {{0, 0}}, {{0x16554d9eca36314c, 0xdb20fe9d672d0fdc, 0xd7e772cee186176b, 0x7e68b68aec7ba23b}}},
      {{{ones, ones, ones, ones}},
       {{ones, ones}},
       {{0x87b092c3013fe90b, 0x438c3c67be8d0224, 0x9cc7d7c69cd777b6, 0xa09caebf594f0ba0}}},
      {{{0x243f6a8885a308d3, 0x13198a2e03707344, 0xa4093822299f31d0, 0x082efa98ec4e6c89}},
       {{0x452821e638d01377, 0xbe5466cf34e90c6c}},
       {{0xa528f45403e61d95, 0x38c72dbd566e9788, 0xa5a1610e72fd18b5, 0x57bd43b5e52b7fe6}}},
  };
  for (const Known &k : all) EXPECT_TRUE(r123::Philox4x64()(k.counter, k.key) == k.answer);
}

// the answer of zeros, made normal
TEST(ThermalKick, normalsAreThoseOfTheGenerator)
{
  double four[4];
  normals(0, 0, 0, 0, four);
  const double bits[4] = {0x16554d9eca36314cp-64, 0xdb20fe9d672d0fdcp-64, 0xd7e772cee186176bp-64,
                          0x7e68b68aec7ba23bp-64};
  for (int p = 0; p < 2; p++) {
    const double r = std::sqrt(-2 * std::log(bits[2 * p])), angle = 2 * M_PI * bits[2 * p + 1];
    EXPECT_NEAR(four[2 * p], r * std::cos(angle), 1e-14);
    EXPECT_NEAR(four[2 * p + 1], r * std::sin(angle), 1e-14);
  }
}

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
  double a[4], b[4], others[4][4];
  normals(1, 7, 1000000, 0, a);
  normals(1, 7, 1000000, 0, b);
  normals(2, 7, 1000000, 0, others[0]);
  normals(1, 8, 1000000, 0, others[1]);
  normals(1, 7, 1000001, 0, others[2]);
  normals(1, 7, 1000000, 1, others[3]);
  for (int k = 0; k < 4; k++) {
    EXPECT_EQ(a[k], b[k]);
    for (const auto &c : others) EXPECT_NE(a[k], c[k]);
  }
}

TEST(ThermalKick, forceByEinstein)
{
  // random walk of steps F dt/K: variance 2 D dt a step, D = kT/K
  const double K = 2e-8, T = 300, dt = 1e-4, F = thermal_force(K, T, dt);
  EXPECT_NEAR(F * dt / K * F * dt / K, 2 * 1.380649e-23 * T / K * dt, 1e-25);
}
