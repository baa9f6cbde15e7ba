// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>
#include <utility>

#include "coulomb/coul_kernel.h"

using namespace clay;

namespace {

struct Ball {
  double x[3], q;
  long body;
  bool owned;
};

// bodies of 5 spheres within a small ball, and loose spheres, in a box
std::vector<Ball> suspension(int bodies, int loose, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> box(0, 10), near(-0.4, 0.4), sign(-1, 1);
  std::vector<Ball> balls;
  for (int b = 0; b < bodies; ++b) {
    const double c[3] = {box(random), box(random), box(random)};
    for (int s = 0; s < 5; ++s)
      balls.push_back(
          {{c[0] + near(random), c[1] + near(random), c[2] + near(random)}, sign(random) * 1e-9, b, b % 3 != 0});
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
    const bool last = i + 1 == balls.size() || balls[i + 1].body != balls[i].body || (balls[i].body < 0 && i % 7 == 0);
    if (last) g.close(balls[i].body, balls[i].owned);
  }
  return g;
}

// of two charges of one over k; without a Debye length, 0, Coulomb's
double unitForce(double debye, double r)
{
  return debye > 0 ? (1 + r / debye) * std::exp(-r / debye) / (r * r) : 1 / (r * r);
}

// forces by the sum over all pairs, one by one
std::vector<std::array<double, 3>> oneByOne(const std::vector<Ball>& balls, const CoulombLaw& law, int* acting)
{
  std::vector<std::array<double, 3>> f(balls.size(), {0, 0, 0});
  *acting = 0;
  for (std::size_t i = 0; i < balls.size(); ++i)
    for (std::size_t j = 0; j < balls.size(); ++j) {
      if (i == j || !balls[i].owned || (balls[i].body >= 0 && balls[i].body == balls[j].body)) continue;
      double d[3], r2 = 0;
      for (int c = 0; c < 3; ++c) {
        d[c] = balls[i].x[c] - balls[j].x[c];
        r2 += d[c] * d[c];
      }
      const double r = std::sqrt(r2);
      if (r >= law.cutoff) continue;
      ++*acting;
      const double size = 8.9875517873681764e9 * balls[i].q * balls[j].q *
          (unitForce(law.debye, r) - (law.shifted ? unitForce(law.debye, law.cutoff) : 0));
      for (int c = 0; c < 3; ++c) f[i][c] += size * d[c] / r;
    }
  return f;
}

struct Errors {
  double force, torque;
};

// of bodies' forces and torques and loose spheres' forces, over the largest
Errors against(const ChargeGroups& g, const std::vector<std::array<double, 3>>& f)
{
  double size[2] = {0, 0}, error[2] = {0, 0};
  const auto compare = [&](int what, double wanted, double got) {
    size[what] = std::max(size[what], std::abs(wanted));
    error[what] = std::max(error[what], std::abs(wanted - got));
  };
  for (std::size_t k = 0; k < g.groups.size(); ++k) {
    const ChargeGroup& group = g.groups[k];
    if (!group.acted) continue;
    double F[3] = {0, 0, 0}, T[3] = {0, 0, 0};
    for (int i = group.begin; i < group.end; ++i) {
      const double r[3] = {g.x[i] - group.x, g.y[i] - group.y, g.z[i] - group.z};
      const double sphere[3] = {g.fx[i], g.fy[i], g.fz[i]};
      for (int c = 0; c < 3; ++c) {
        const int d = (c + 1) % 3, e = (c + 2) % 3;
        F[c] += f[i][c];
        T[c] += r[d] * f[i][e] - r[e] * f[i][d];
        if (group.loose()) compare(0, f[i][c], sphere[c]);
      }
    }
    for (int c = 0; c < 3 && !group.loose(); ++c) {
      compare(0, F[c], g.wrenches[k].f[c]);
      compare(1, T[c], g.wrenches[k].t[c]);
    }
  }
  return {error[0] / size[0], size[1] > 0 ? error[1] / size[1] : 0};
}

// Single precision: 1e-7 of what the places are counted in, a group's size, is up to 3e-6 of the
// distance of two spheres here, which do not mind to overlap.
void expectBruteForce(const std::vector<Ball>& balls, const CoulombLaw& law)
{
  int acting;
  const auto f = oneByOne(balls, law, &acting);
  EXPECT_GT(acting, 100);
  for (bool single : {false, true}) {
    ChargeGroups g = grouped(balls);
    g.single = single;
    g.act(law);
    const Errors e = against(g, f);
    EXPECT_LT(e.force, single ? 1e-5 : 1e-12);
    EXPECT_LT(e.torque, single ? 1e-5 : 1e-12);
    if (single) { EXPECT_GT(e.force, 1e-9); }
  }
}

void shift(std::vector<Ball>& balls, ChargeGroups& g, double by)
{
  // each body its own way, loose spheres each theirs
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const double turn = balls[i].body >= 0 ? balls[i].body : 1.3 * i;
    balls[i].x[0] += by * std::cos(turn);
    balls[i].x[1] += by * std::sin(turn);
    balls[i].x[2] += by * std::sin(2 * turn);
    g.x[i] = balls[i].x[0];
    g.y[i] = balls[i].x[1];
    g.z[i] = balls[i].x[2];
  }
  g.moved();
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

TEST(CoulKernel, allPairsScreened)
{
  for (bool shifted : {false, true})
    for (double cutoff : {0.7, 2.5, 30.0})
      for (double debye : {0.15, 1.0, 100.0}) {
        CoulombLaw law;
        law.cutoff = cutoff;
        law.shifted = shifted;
        law.debye = debye;
        expectBruteForce(suspension(60, 90, 1), law);
        expectBruteForce(suspension(0, 400, 3), law);
      }
}

// with the screening counted from a distance on, up to its largest exponent where spheres lie in each other
TEST(CoulKernel, screeningCountedFromADistance)
{
  CoulombLaw law;
  law.cutoff = 2.5;
  law.debye = 0.015;
  law.near = 1.1;
  law.spheres = true;
  EXPECT_NEAR(law.weight(0.8), std::exp(0.25 / 0.015) / (1 + 0.8 / 0.015), 1e-9 * law.weight(0.8));
  for (bool shifted : {false, true})
    for (bool single : {false, true}) {
      law.shifted = shifted;
      for (double r : {0.01, 0.3, 1.05, 1.1, 1.4}) {
        ChargeGroups g;
        g.single = single;
        for (double x : {0.0, r}) {
          g.add(x, 0, 0, 1e-9);
          g.close(x > 0, true);
        }
        g.act(law);
        const double least = shifted ? std::exp(-1.4 / 0.015) * (1 / 6.25 + 1 / 0.0375) : 0;
        const double right =
            law.k * 1e-18 * (std::exp(std::min(60., (1.1 - r) / 0.015)) * (1 / (r * r) + 1 / (0.015 * r)) - least);
        EXPECT_NEAR(g.wrenches[1].f[0] / right, 1, single ? 2e-5 : 1e-12) << r;
        EXPECT_NEAR(law.forceOverDistance(1e-18, r) * r / right, 1, 1e-12) << r;
      }
    }
}

// many Debye lengths within the cut-off: nothing overflows, and what is left is next to nothing
TEST(CoulKernel, screenedToNothing)
{
  for (bool single : {false, true})
    for (double debye = 1e-6; debye < 5e-3; debye *= 1.3) {
      ChargeGroups g;
      g.single = single;
      for (double x : {0.0, 0.9}) {
        g.add(x, 0, 0, 1e-9);
        g.close(x > 0, true);
      }
      CoulombLaw law;
      law.cutoff = 1;
      law.debye = debye;
      g.act(law);
      EXPECT_LT(std::abs(g.wrenches[0].f[0]), 1e-30 * law.k * 1e-18) << debye;
    }
}

// with a Debye length that grows, (1 + r/L) exp(-r/L) = 1 - (r/L)^2/2 + ..., until it is Coulomb's
TEST(CoulKernel, weaklyScreenedIsCoulombs)
{
  CoulombLaw bare, screened;
  bare.cutoff = screened.cutoff = 3;
  const auto balls = suspension(60, 90, 1);
  ChargeGroups a = grouped(balls);
  a.act(bare);
  for (double debye : {1e3, 1e9}) {
    screened.debye = debye;
    ChargeGroups b = grouped(balls);
    b.act(screened);
    double apart = 0, size = 0;
    for (std::size_t k = 0; k < a.groups.size(); ++k)
      for (int d = 0; d < 3 && !a.groups[k].loose(); ++d) {
        apart = std::max(apart, std::abs(a.wrenches[k].f[d] - b.wrenches[k].f[d]));
        size = std::max(size, std::abs(a.wrenches[k].f[d]));
      }
    EXPECT_LT(apart / size, debye < 1e6 ? 1e-6 : 1e-13);
    if (debye < 1e6) { EXPECT_GT(apart / size, 1e-10); }
    const double r = 1.7, qq = 1e-18;
    EXPECT_NEAR(screened.energy(qq, r), bare.energy(qq, r), 10 / debye / debye * bare.energy(qq, r) + 1e-30);
  }
}

// energy [J] against the force's integral from there to the cut-off, by Simpson's rule
TEST(CoulKernel, energyIsTheForcesIntegral)
{
  for (bool shifted : {false, true})
    for (double debye : {0.0, 2e-4, 1e-3, 0.1}) {
      CoulombLaw law;
      law.cutoff = 0.012;
      law.shifted = shifted;
      law.debye = debye;
      const double qq = -1.5e-19, start = 0.002, end = law.cutoff * (1 - 1e-15);
      const int parts = 20000;
      double sum = 0;
      for (int i = 0; i <= parts; ++i) {
        const double r = start + (end - start) * i / parts;
        sum += (i == 0 || i == parts ? 1 : i % 2 ? 4 : 2) * law.forceOverDistance(qq, r) * r;
      }
      sum *= (end - start) / parts / 3;
      EXPECT_NEAR(law.energy(qq, start) / sum, 1, 1e-9) << debye;
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
  g.act(law);
  for (int c = 0; c < 3; ++c) {
    EXPECT_EQ(g.wrenches[0].f[c], 0);
    EXPECT_EQ(g.wrenches[0].t[c], 0);
  }
}

TEST(CoulKernel, forcesBalance)
{
  auto balls = suspension(100, 50, 4);
  for (auto& b : balls) b.owned = true;
  ChargeGroups g = grouped(balls);
  CoulombLaw law;
  law.cutoff = 3;
  for (bool single : {false, true}) {
    g = grouped(balls);
    g.single = single;
    g.act(law);
    double sum = 0, turn = 0, size = 0;
    for (std::size_t k = 0; k < g.groups.size(); ++k) {
      const ChargeGroup& group = g.groups[k];
      if (!group.loose()) {
        const Wrench& w = g.wrenches[k];
        sum += w.f[0];
        turn += w.t[0] + group.y * w.f[2] - group.z * w.f[1];
        size += std::abs(w.f[0]);
        continue;
      }
      for (int i = group.begin; i < group.end; ++i) {
        sum += g.fx[i];
        turn += g.y[i] * g.fz[i] - g.z[i] * g.fy[i];
        size += std::abs(g.fx[i]);
      }
    }
    EXPECT_LT(std::abs(sum), (single ? 1e-7 : 1e-13) * size);
    EXPECT_LT(std::abs(turn), (single ? 1e-5 : 1e-12) * size);
  }
}

// a list kept while spheres move, until it has to be made anew
TEST(CoulKernel, groupsThatMove)
{
  auto balls = suspension(100, 60, 6);
  ChargeGroups g = grouped(balls);
  CoulombLaw law;
  law.cutoff = 2.5;
  for (int step = 0; step < 12; ++step) {
    g.act(law);
    int acting;
    EXPECT_LT(against(g, oneByOne(balls, law, &acting)).force, 1e-12) << step;
    shift(balls, g, step < 9 ? 0.03 : 0.4);
  }
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
  std::set<std::pair<int, int>> wanted, visited;
  eachPair(g, law.cutoff, [&](int i, int j, double r) {
    EXPECT_TRUE(visited.insert(std::minmax(i, j)).second) << i << ' ' << j;
    EXPECT_LT(r, 2);
  });
  for (int i = 0; i < static_cast<int>(balls.size()); ++i)
    for (int j = 0; j < i; ++j) {
      if (!balls[i].owned && !balls[j].owned) continue;
      if (balls[i].body >= 0 && balls[i].body == balls[j].body) continue;
      const double r =
          std::hypot(balls[i].x[0] - balls[j].x[0], balls[i].x[1] - balls[j].x[1], balls[i].x[2] - balls[j].x[2]);
      if (r < 2) wanted.emplace(j, i);
    }
  EXPECT_EQ(visited, wanted);
  EXPECT_GT(wanted.size(), 50u);
}
