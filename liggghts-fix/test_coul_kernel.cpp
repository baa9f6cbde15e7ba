// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "coul_kernel.h"

using namespace clay;

namespace {

struct Ball { double x[3], q; long body; bool owned; };

// bodies of 5 spheres within a small ball, and loose spheres, in a box
std::vector<Ball> suspension(int bodies, int loose, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> box(0, 10), near(-0.4, 0.4), sign(-1, 1);
  std::vector<Ball> balls;
  for (int b = 0; b < bodies; ++b) {
    const double c[3] = {box(random), box(random), box(random)};
    for (int s = 0; s < 5; ++s)
      balls.push_back({{c[0] + near(random), c[1] + near(random), c[2] + near(random)},
                       sign(random) * 1e-9, b, b % 3 != 0});
  }
  for (int l = 0; l < loose; ++l)
    balls.push_back({{box(random), box(random), box(random)}, sign(random) * 1e-9, -1, true});
  return balls;
}

ChargeGroups grouped(const std::vector<Ball>& balls)
{
  ChargeGroups g;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    g.add(balls[i].x[0], balls[i].x[1], balls[i].x[2], balls[i].q);
    // loose spheres in sevens
    const bool last = i + 1 == balls.size() || balls[i + 1].body != balls[i].body
                      || (balls[i].body < 0 && i % 7 == 0);
    if (last) g.close(balls[i].body, balls[i].owned);
  }
  return g;
}

void expectBruteForce(const std::vector<Ball>& balls, const CoulombLaw& law)
{
  ChargeGroups g = grouped(balls);
  coulombForces(g, law);
  double largest = 0, error = 0;
  int acting = 0;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    if (!balls[i].owned) continue;
    double f[3] = {0, 0, 0};
    for (std::size_t j = 0; j < balls.size(); ++j) {
      if (i == j || (balls[i].body >= 0 && balls[i].body == balls[j].body)) continue;
      double d[3], r2 = 0;
      for (int c = 0; c < 3; ++c) { d[c] = balls[i].x[c] - balls[j].x[c]; r2 += d[c] * d[c]; }
      const double r = std::sqrt(r2);
      if (r >= law.cutoff) continue;
      ++acting;
      const double size = 8.9875517873681764e9 * balls[i].q * balls[j].q
                          * (1 / r2 - (law.shifted ? 1 / (law.cutoff * law.cutoff) : 0));
      for (int c = 0; c < 3; ++c) f[c] += size * d[c] / r;
    }
    const double got[3] = {g.fx[i], g.fy[i], g.fz[i]};
    for (int c = 0; c < 3; ++c) {
      largest = std::max(largest, std::abs(f[c]));
      error = std::max(error, std::abs(f[c] - got[c]));
    }
  }
  EXPECT_GT(acting, 100);
  EXPECT_LT(error, 1e-12 * largest);
}

}  // namespace

TEST(CoulKernel, allPairsWithinTheCutOff)
{
  for (bool shifted : {false, true})
    for (double cutoff : {0.7, 2.5, 30.0}) {
      CoulombLaw law;
      law.cutoff = cutoff;
      law.shifted = shifted;
      expectBruteForce(suspension(60, 90, 1), law);
      expectBruteForce(suspension(150, 0, 2), law);
      expectBruteForce(suspension(0, 400, 3), law);
    }
}

TEST(CoulKernel, spheresOfABodyDoNotAct)
{
  ChargeGroups g;
  g.add(0, 0, 0, 1e-9);
  g.add(1, 0, 0, 1e-9);
  g.close(5, true);
  CoulombLaw law;
  law.cutoff = 10;
  coulombForces(g, law);
  EXPECT_EQ(g.fx[0], 0);
  EXPECT_EQ(g.fx[1], 0);
}

TEST(CoulKernel, forcesBalance)
{
  auto balls = suspension(100, 50, 4);
  for (auto& b : balls) b.owned = true;
  ChargeGroups g = grouped(balls);
  CoulombLaw law;
  law.cutoff = 3;
  coulombForces(g, law);
  double sum = 0, size = 0;
  for (double f : g.fx) { sum += f; size += std::abs(f); }
  EXPECT_LT(std::abs(sum), 1e-13 * size);
}

TEST(CoulKernel, lawIsTheSlopeOfItsEnergy)
{
  for (bool shifted : {false, true}) {
    CoulombLaw law;
    law.cutoff = 0.012;
    law.shifted = shifted;
    const double qq = 1.5e-19, h = 1e-8;
    for (double r : {0.002, 0.005, 0.0119}) {
      const double slope = -(law.energy(qq, r + h) - law.energy(qq, r - h)) / (2 * h);
      EXPECT_NEAR(law.forceOverDistance(qq, r) * r, slope, 1e-6 * std::abs(slope));
    }
    EXPECT_NEAR(law.energy(qq, 0.012 * (1 - 1e-12)), 0, 1e-12 * law.energy(qq, 0.006));
    EXPECT_EQ(law.forceOverDistance(qq, 0.012), 0);
  }
  CoulombLaw sharp;
  sharp.cutoff = 1;
  EXPECT_NEAR(sharp.forceOverDistance(1e-18, 0.5) * 0.5, 8.9875517873681764e9 * 1e-18 / 0.25, 1e-20);
}

TEST(CoulKernel, visitsEachPairOnce)
{
  const auto balls = suspension(40, 60, 5);
  const ChargeGroups g = grouped(balls);
  CoulombLaw law;
  law.cutoff = 2;
  int visited = 0, wanted = 0;
  eachPair(g, law, [&](int i, int j, double r) {
    ++visited;
    EXPECT_NE(i, j);
    EXPECT_LT(r, 2);
  });
  for (std::size_t i = 0; i < balls.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (!balls[i].owned && !balls[j].owned) continue;
      if (balls[i].body >= 0 && balls[i].body == balls[j].body) continue;
      wanted += std::hypot(balls[i].x[0] - balls[j].x[0], balls[i].x[1] - balls[j].x[1],
                           balls[i].x[2] - balls[j].x[2]) < 2;
    }
  EXPECT_EQ(visited, wanted);
  EXPECT_GT(wanted, 50);
}
