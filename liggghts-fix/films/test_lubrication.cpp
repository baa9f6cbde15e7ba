// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "films/lubrication_law.h"
#include "films/lubrication_step.h"
#include "simd/cell_index.h"
#include "simd/near_pairs.h"

using namespace clay;

namespace {

LubricationLaw plain()
{
  LubricationLaw law;
  law.viscosity = 1 / (6 * M_PI);  // so that forces come in units of a U
  law.outer = 10;
  law.inner = 1e-9;
  law.shifted = false;
  return law;
}

}  // namespace

TEST(Lubrication, equalSpheresAsInTheBooks)
{
  // Kim and Karrila, table 11.1 and p. 281: 1/4, 9/40 and 1/6 for spheres of one size
  const LubricationLaw law = plain();
  const double xi = 1e-3, L = std::log(1 / xi);
  const Film f = law.spheres(1, 1, xi);
  EXPECT_NEAR(f.squeeze, 0.25 / xi + 9.0 / 40 * L, 1e-12 / xi);
  EXPECT_NEAR(f.shear, L / 6, 1e-12);
  EXPECT_NEAR(f.armI, 1, 1e-14);
  EXPECT_NEAR(f.armJ, 1, 1e-14);
  // couples: 8 pi mu a3 (1/5 L) on the sphere that turns, (1/20 L) on the other
  const double own = f.shear * f.armI * f.armI + f.roll, others = f.shear * f.armI * f.armJ - f.roll;
  EXPECT_NEAR(own, 8.0 / 6 / 5 * L, 1e-12);
  EXPECT_NEAR(others, 8.0 / 6 / 20 * L, 1e-12);
}

TEST(Lubrication, oneLawForUnequalSpheresAndTheWall)
{
  LubricationLaw law = plain();
  for (double b : {0.2, 0.7, 3.0}) {
    const Film f = law.spheres(1, b, 1e-3), g = law.spheres(b, 1, 1e-3);
    EXPECT_NEAR(f.squeeze, g.squeeze, 1e-12 * f.squeeze);
    EXPECT_NEAR(f.shear, g.shear, 1e-12 * f.shear);
    EXPECT_NEAR(f.roll, g.roll, 1e-12 * f.roll);
    EXPECT_NEAR(f.armI, g.armJ, 1e-14);
    EXPECT_NEAR(f.armI + f.armJ, 1 + b, 1e-14);
    EXPECT_NEAR(f.squeeze * 1e-3, std::pow(b / (1 + b), 2), 0.02 * f.squeeze * 1e-3);
  }
  // a wall is a sphere without end; the gap counts in the small one's radius
  law.inner = 1e-20;
  const double h = 1e-4, L = std::log(1 / h);
  const Film w = law.wall(1, h), big = law.spheres(1, 1e9, h);
  const double bigL = -std::log(2 * h / 1e9);
  EXPECT_NEAR(w.squeeze, 1 / h + L / 5, 1e-9 / h);
  EXPECT_NEAR(big.squeeze, 1 / h + bigL / 5, 1e-6 / h);
  EXPECT_NEAR(w.shear / L, 8.0 / 15, 1e-12);
  EXPECT_NEAR(big.shear / bigL, 8.0 / 15, 1e-6);
  EXPECT_NEAR(big.roll / bigL, w.roll / L, 1e-6);
  EXPECT_NEAR(big.armI, w.armI, 1e-6);
  // Goldman, Cox and Brenner: couple 8 pi mu a3 (2/5) L of a sphere that turns, force 6 pi mu a2 (2/15) L
  EXPECT_NEAR(w.shear * w.armI * w.armI + w.roll, 8.0 / 6 * 2 / 5 * L, 1e-12);
  EXPECT_NEAR(w.shear * w.armI, 2.0 / 15 * L, 1e-12);
}

TEST(Lubrication, wallNearlyExact)
{
  // Brenner's series for a sphere that approaches a plane, less Stokes's drag far away
  struct Row {
    double gap, lambda;
  };
  const LubricationLaw law = plain();
  for (const Row &r : {Row{0.0050, 201.868}, Row{0.1276, 9.2518}, Row{0.5431, 3.0361}})
    EXPECT_NEAR(1 + law.wall(1, r.gap).squeeze, r.lambda, 0.03 * r.lambda) << r.gap;
}

TEST(Lubrication, curvedWall)
{
  const LubricationLaw law = plain();
  const double flat = law.wall(1, 1e-4).squeeze;
  EXPECT_NEAR(law.wall(1, 1e-4, 1e9).squeeze, flat, 1e-6 * flat);
  EXPECT_GT(law.wall(1, 1e-4, 4).squeeze, 1.1 * flat);
  EXPECT_LT(law.wall(1, 1e-4, -4).squeeze, 0.95 * flat);
  // by hand: r = 4/3, 2 (4/3)^1.5/(7/3)
  EXPECT_NEAR(law.wall(1, 1e-6, 4).squeeze, 1e6 * 2 * std::pow(4.0 / 3, 1.5) / (7.0 / 3), 10);
}

TEST(Lubrication, gapsWithNothing)
{
  LubricationLaw law = plain();
  law.outer = 0.5;
  law.inner = 1e-2;
  EXPECT_FALSE(law.spheres(1, 1, 0.5).acts());
  EXPECT_FALSE(law.spheres(1, 1, -1e-3).acts());
  EXPECT_EQ(law.spheres(1, 1, 1e-3).squeeze, law.spheres(1, 1, 1e-2).squeeze);
  law.shifted = law.contact = true;
  EXPECT_TRUE(law.spheres(1, 1, -1e-3).acts());
  EXPECT_LT(law.spheres(1, 1, 0.4999).squeeze, 1e-3);
  EXPECT_GT(law.spheres(1, 1, 0.4999).squeeze, 0);
}

namespace {

const double zero[3] = {0, 0, 0};

// a packing of n spheres, films between all that are near; energy before and after a step
struct Packing {
  struct Sphere {
    double x[3], v[3], w[3], m, I;
    FilmLoad load;
  };
  struct Thin {
    Film film;
    int i, j;
    double n[3];
  };
  std::vector<Sphere> spheres;
  std::vector<Thin> films;

  Packing(int n, unsigned seed)
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> u(-1, 1);
    const LubricationLaw law = [] {
      LubricationLaw l;
      l.viscosity = 1;
      l.outer = 1;
      return l;
    }();
    for (int i = 0; i < n; i++) {
      Sphere s;
      s.m = std::exp(2 * u(random));
      s.I = 0.4 * s.m;
      for (int k = 0; k < 3; k++) s.x[k] = u(random), s.v[k] = u(random), s.w[k] = u(random);
      spheres.push_back(s);
    }
    for (int i = 0; i < n; i++)
      for (int j = i + 1; j < n; j++) {
        Thin t;
        const Sphere &p = spheres[i], &q = spheres[j];
        const double d[3] = {p.x[0] - q.x[0], p.x[1] - q.x[1], p.x[2] - q.x[2]};
        const double r = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        for (int k = 0; k < 3; k++) t.n[k] = d[k] / r;
        t.film = law.spheres(1, 1, std::exp(4 * u(random) - 4));
        t.i = i, t.j = j;
        if (t.film.acts()) films.push_back(t);
      }
    for (const Thin &t : films) {
      add_load(t.film, t.film.armI, spheres[t.i].m, spheres[t.i].I, spheres[t.i].load);
      add_load(t.film, t.film.armJ, spheres[t.j].m, spheres[t.j].I, spheres[t.j].load);
    }
  }

  double energy() const
  {
    double e = 0;
    for (const Sphere &s : spheres)
      for (int k = 0; k < 3; k++) e += 0.5 * s.m * s.v[k] * s.v[k] + 0.5 * s.I * s.w[k] * s.w[k];
    return e;
  }

  void step(double dt)
  {
    const std::vector<Sphere> old = spheres;
    for (const Thin &t : films) {
      const Sphere &p = old[t.i], &q = old[t.j];
      const FilmForce f = film_force(t.film, t.n, {p.v, p.w, zero, zero, p.load}, {q.v, q.w, zero, zero, q.load}, dt);
      for (int k = 0; k < 3; k++) {
        spheres[t.i].v[k] += dt * f.force[k] / p.m;
        spheres[t.j].v[k] -= dt * f.force[k] / q.m;
        spheres[t.i].w[k] += dt * f.coupleI[k] / p.I;
        spheres[t.j].w[k] += dt * f.coupleJ[k] / q.I;
      }
    }
  }
};

}  // namespace

TEST(LubricationStep, neverGainsEnergyWhateverTheStep)
{
  for (double dt : {1e-6, 1e-3, 1.0, 1e3, 1e9}) {
    Packing pack(40, 7);
    ASSERT_GT(pack.films.size(), 300u);
    double before = pack.energy();
    const double start = before;
    for (int n = 0; n < 50; n++) {
      pack.step(dt);
      const double after = pack.energy();
      ASSERT_LE(after, before * (1 + 1e-14)) << dt;
      before = after;
    }
    if (dt >= 1) EXPECT_LT(before, 0.75 * start) << dt;
  }
}

TEST(LubricationStep, oneFilmIsExact)
{
  // sphere at a wall under a constant force: v -> v exp(-x) + F/c (1 - exp(-x))
  LubricationLaw law;
  law.viscosity = 1;
  const Film film = law.wall(1, 0.01);
  const double m = 3, n[3] = {0, 0, 1}, v[3] = {0, 0, -2}, a[3] = {0, 0, -0.7};
  for (double dt : {1e-9, 1e-5, 1e-3, 1.0, 1e6}) {
    FilmSide i = {v, zero, a, zero, {}}, wall = {zero, zero, zero, zero, {}};
    add_load(film, film.armI, m, 0.4 * m, i.load);
    const FilmForce f = film_force(film, n, i, wall, dt);
    const double x = film.squeeze * dt / m, steady = m * a[2] / film.squeeze;
    const double expected = steady + (v[2] - steady) * std::exp(-x);
    EXPECT_NEAR(v[2] + dt * (f.force[2] / m + a[2]), expected, 1e-9 * std::abs(v[2]) + 1e-9 * dt * std::abs(a[2]))
        << dt;
  }
}

TEST(LubricationStep, rigidMotionIsFree)
{
  // two unequal spheres that turn about a point as one body
  LubricationLaw law;
  law.viscosity = 1;
  const double a = 1, b = 0.3, h = 1e-3;
  const Film film = law.spheres(a, b, h);
  const double w[3] = {0.3, -0.8, 0.5}, xi[3] = {0.2, 0.1, -0.4}, n[3] = {2.0 / 3, -1.0 / 3, 2.0 / 3};
  double xj[3], vi[3], vj[3];
  for (int k = 0; k < 3; k++) xj[k] = xi[k] - (a + b) * n[k];
  for (int k = 0; k < 3; k++) {
    const int p = (k + 1) % 3, q = (k + 2) % 3;
    vi[k] = w[p] * xi[q] - w[q] * xi[p];
    vj[k] = w[p] * xj[q] - w[q] * xj[p];
  }
  FilmSide i = {vi, w, zero, zero, {}}, j = {vj, w, zero, zero, {}};
  add_load(film, film.armI, 1, 1, i.load);
  add_load(film, film.armJ, 1, 1, j.load);
  const FilmForce f = film_force(film, n, i, j, 1e-6);
  for (int k = 0; k < 3; k++) {
    EXPECT_NEAR(f.force[k], 0, 1e-12 * film.squeeze);
    EXPECT_NEAR(f.coupleI[k], 0, 1e-12 * film.squeeze);
    EXPECT_NEAR(f.coupleJ[k], 0, 1e-12 * film.squeeze);
  }
}

TEST(NearPairs, allOfThem)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> u(0, 1);
  const int n = 600, owned = 400;
  std::vector<double> place(3 * n), reach(n);
  std::vector<double *> x(n);
  for (int i = 0; i < n; i++) {
    x[i] = &place[3 * i];
    for (int k = 0; k < 3; k++) x[i][k] = u(random);
    reach[i] = 0.01 + 0.05 * u(random);
  }
  std::vector<std::pair<int, int>> found, wanted;
  near_pairs(x.data(), reach.data(), owned, n, found);
  for (int i = 0; i < owned; i++)
    for (int j = i + 1; j < n; j++) {
      const double d[3] = {x[i][0] - x[j][0], x[i][1] - x[j][1], x[i][2] - x[j][2]}, r = reach[i] + reach[j];
      if (d[0] * d[0] + d[1] * d[1] + d[2] * d[2] < r * r) wanted.emplace_back(i, j);
    }
  std::sort(found.begin(), found.end());
  ASSERT_GT(wanted.size(), 100u);
  EXPECT_EQ(found, wanted);
}

// A point that is no number is near to none, and hides no other pair; one that is far does not
// make more cells than there is memory for
TEST(NearPairs, beyondAllNumbers)
{
  for (double odd : {std::nan(""), HUGE_VAL, 1e300, -1e300, 1e120})
    for (int where : {0, 2}) {
      double place[4][3] = {{0, 0, 0}, {0.1, 0, 0}, {3, 1, 2}, {3.1, 1, 2}};
      place[where][1] = odd;
      double *x[4] = {place[0], place[1], place[2], place[3]};
      const double reach[4] = {0.06, 0.06, 0.06, 0.06};
      std::vector<std::pair<int, int>> found;
      near_pairs(x, reach, 4, 4, found);
      const std::pair<int, int> left = where ? std::make_pair(0, 1) : std::make_pair(2, 3);
      ASSERT_EQ(found.size(), 1u) << odd << ' ' << where;
      EXPECT_EQ(found[0], left) << odd << ' ' << where;
    }
}

TEST(CellIndex, liesAmongTheCells)
{
  EXPECT_EQ(cell_index(2.9, 5), 2);
  EXPECT_EQ(cell_index(-1, 5), 0);
  EXPECT_EQ(cell_index(5, 5), 4);
  EXPECT_EQ(cell_index(1e300, 5), 4);
  EXPECT_EQ(cell_index(std::nan(""), 5), 0);
  EXPECT_EQ(cell_number(-7), -7);
  EXPECT_EQ(cell_number(1e300), 1 << 30);
  EXPECT_EQ(cell_number(-1e300), -(1 << 30));
  EXPECT_EQ(cell_number(std::nan("")), 0);
}
