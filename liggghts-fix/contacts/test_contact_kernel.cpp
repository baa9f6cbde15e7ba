// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "contacts/contact_kernel.h"

using namespace clay;
using Eigen::Vector3d;

namespace {

struct Ball {
  Vector3d x, v, w;
  double r;
};

struct Scene {
  std::vector<Ball> balls;
  std::vector<double> x, v, omega, f, torque;
  ContactPairs pairs;

  void forces(double dt, bool update, bool limit, int owned)
  {
    contactForces({x.data(), v.data(), omega.data(), f.data(), torque.data(), owned}, pairs, dt, update, limit);
  }
};

// every pair of balls thrown into a box: some overlap, some do not
Scene scene(int n, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> box(0, 5e-3), unit(-1, 1), size(0.7e-3, 1e-3);
  Scene s;
  for (int i = 0; i < n; ++i)
    s.balls.push_back({Vector3d(box(random), box(random), box(random)),
                       0.1 * Vector3d(unit(random), unit(random), unit(random)),
                       50 * Vector3d(unit(random), unit(random), unit(random)), size(random)});
  for (const Ball &b : s.balls) {
    s.x.insert(s.x.end(), b.x.data(), b.x.data() + 3);
    s.v.insert(s.v.end(), b.v.data(), b.v.data() + 3);
    s.omega.insert(s.omega.end(), b.w.data(), b.w.data() + 3);
  }
  s.f.assign(3 * n, 0.0);
  s.torque.assign(3 * n, 0.0);
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j) {
      ContactLaw law;
      law.kn = 3000 + 100 * unit(random);
      law.kt = 2000 + 100 * unit(random);
      law.gamman = 0.2;
      law.gammat = 0.1;
      law.friction = (i + j) % 5 ? 0.5 : 0.01;
      const Vector3d shear = 1e-5 * Vector3d(unit(random), unit(random), unit(random));
      s.pairs.add(i, j, s.balls[i].r, s.balls[j].r, law, shear.data(), false);
    }
  return s;
}

// a contact as the textbooks have it: force on i, torques, new displacement
struct Contact {
  bool touch, slides;
  Vector3d f, ti, tj, shear;
};

Contact contact(const Ball &a, const Ball &b, const ContactPairs &p, int k, const Vector3d &before, double dt,
                bool update, bool limit)
{
  Contact c = {};
  c.shear = before;
  const double delta = a.r + b.r - (a.x - b.x).norm();
  if (!(c.touch = delta > 0)) return c;
  const Vector3d n = (a.x - b.x).normalized(), ra = -(a.r - delta / 2) * n, rb = (b.r - delta / 2) * n;
  const Vector3d v = a.v + a.w.cross(ra) - b.v - b.w.cross(rb);
  const Vector3d vt = v - v.dot(n) * n;
  double fn = p.kn[k] * delta - p.gamman[k] * v.dot(n);
  if (limit) fn = std::max(fn, 0.0);
  Vector3d shear = c.shear;
  if (update) {
    shear += vt * dt;
    shear -= shear.dot(n) * n;
  }
  Vector3d ft = -p.kt[k] * shear;
  c.slides = ft.norm() > p.friction[k] * std::abs(fn);
  if (c.slides) ft *= p.friction[k] * std::abs(fn) / ft.norm();
  if (update) c.shear = -ft / p.kt[k];
  if (!c.slides) ft -= p.gammat[k] * vt;
  c.f = fn * n + ft;
  c.ti = ra.cross(ft);
  c.tj = rb.cross(-ft);
  return c;
}

}  // namespace

TEST(ContactKernel, everyContactByTheTextbook)
{
  const double dt = 1e-5;
  const int owned = 70;  // of 90
  for (bool update : {true, false})
    for (bool limit : {true, false}) {
      Scene s = scene(90, 3);
      std::vector<Vector3d> f(s.balls.size(), Vector3d::Zero()), torque = f;
      std::vector<Contact> expected;
      double size = 0, turn = 0;
      int touching = 0, sliding = 0;
      for (int k = 0; k < s.pairs.size(); ++k) {
        const Contact c = contact(s.balls[s.pairs.i[k]], s.balls[s.pairs.j[k]], s.pairs, k,
                                  Vector3d(s.pairs.sx[k], s.pairs.sy[k], s.pairs.sz[k]), dt, update, limit);
        expected.push_back(c);
        f[s.pairs.i[k]] += c.f;
        torque[s.pairs.i[k]] += c.ti;
        if (s.pairs.j[k] < owned) {
          f[s.pairs.j[k]] -= c.f;
          torque[s.pairs.j[k]] += c.tj;
        }
        size = std::max(size, c.f.norm());
        turn = std::max(turn, c.ti.norm());
        touching += c.touch;
        sliding += c.slides;
      }
      EXPECT_GT(sliding, 40);
      EXPECT_GT(touching, sliding + 50);
      EXPECT_GT(s.pairs.size(), touching + 50);

      s.forces(dt, update, limit, owned);
      for (std::size_t i = 0; i < s.balls.size(); ++i)
        for (int d = 0; d < 3; ++d) {
          EXPECT_NEAR(s.f[3 * i + d], f[i][d], 1e-13 * size);
          EXPECT_NEAR(s.torque[3 * i + d], torque[i][d], 1e-13 * turn);
        }
      for (int k = 0; k < s.pairs.size(); ++k) {
        EXPECT_EQ(s.pairs.touched[k], expected[k].touch);
        const double shear[3] = {s.pairs.sx[k], s.pairs.sy[k], s.pairs.sz[k]};
        for (int d = 0; d < 3; ++d) EXPECT_NEAR(shear[d], expected[k].shear[d], 1e-13 * 1e-5);
      }
    }
}

// a wall is a sphere of no size, at the nearest point of the wall
TEST(ContactKernel, everyWallByTheTextbook)
{
  const double dt = 1e-5;
  WallShape plane, tube;
  plane.axis = 1;
  plane.at = 1e-3;
  tube.axis = 2;
  tube.cylinder = true;
  tube.at = 2e-3;
  tube.centre[0] = tube.centre[1] = 2.5e-3;
  for (const WallShape &wall : {plane, tube})
    for (bool update : {true, false})
      for (bool limit : {true, false}) {
        Scene s = scene(90, 4);
        const ContactPairs laws = s.pairs;
        s.pairs.clear();
        std::vector<double> history;
        std::vector<Contact> expected;
        double size = 0, turn = 0;
        int touching = 0, sliding = 0;
        for (int i = 0; i < 90; ++i) {
          const Ball &a = s.balls[i];
          ContactLaw law;
          law.kn = laws.kn[i];
          law.kt = laws.kt[i];
          law.gamman = laws.gamman[i];
          law.gammat = laws.gammat[i];
          law.friction = i % 3 ? 0.5 : 0.01;
          const double none[3] = {0, 0, 0};
          s.pairs.add(i, i, a.r, 0, law, none, false);
          Ball point = {a.x, Vector3d::Zero(), Vector3d::Zero(), 0};
          if (wall.cylinder) {
            const Vector3d axis(2.5e-3, 2.5e-3, a.x.z());
            point.x = axis + 2e-3 * (a.x - axis).normalized();
          } else point.x[1] = 1e-3;
          EXPECT_NEAR(wall.gap(a.x.data()), (a.x - point.x).norm(), 1e-15);
          // only one that touches has been displaced
          Vector3d shear(laws.sx[i], laws.sy[i], laws.sz[i]);
          if ((a.x - point.x).norm() >= a.r) shear.setZero();
          history.insert(history.end(), shear.data(), shear.data() + 3);
          expected.push_back(contact(a, point, s.pairs, i, shear, dt, update, limit));
          size = std::max(size, expected.back().f.norm());
          turn = std::max(turn, expected.back().ti.norm());
          touching += expected.back().touch;
          sliding += expected.back().slides;
        }
        EXPECT_GT(sliding, 3);
        EXPECT_GT(touching, sliding + 3);
        EXPECT_LT(touching, 80);
        EXPECT_EQ(wallForces({s.x.data(), s.v.data(), s.omega.data(), s.f.data(), s.torque.data(), 90}, s.pairs, wall,
                             history.data(), dt, update, limit),
                  touching);
        for (int i = 0; i < 90; ++i)
          for (int d = 0; d < 3; ++d) {
            EXPECT_NEAR(s.f[3 * i + d], expected[i].f[d], 1e-12 * size);
            EXPECT_NEAR(s.torque[3 * i + d], expected[i].ti[d], 1e-12 * turn);
            EXPECT_NEAR(history[3 * i + d], expected[i].shear[d], 1e-12 * 1e-5);
          }
      }
}

// forces are added to, and what has touched before counts as touched
TEST(ContactKernel, whatIsThereStays)
{
  Scene s = scene(2, 1);
  s.x[3] = 1;
  s.f[0] = 7;
  s.pairs.touched[0] = 1;
  const double before = s.pairs.sx[0];
  s.forces(1e-5, true, false, 2);
  EXPECT_EQ(s.f[0], 7);
  EXPECT_EQ(s.pairs.touched[0], 1);
  EXPECT_EQ(s.pairs.sx[0], before);
}

TEST(ContactKernel, knowsWhetherAPointHasLeftItsPlace)
{
  const int n = 37;
  const std::vector<double> was(3 * n, 0.25);
  for (int i : {0, 8, n - 1})
    for (const Vector3d &way : {Vector3d(1, 0, 0), Vector3d(0, 0, -1), Vector3d(1, -1, 1), Vector3d(-1, 2, 0.5)}) {
      std::vector<double> x = was;
      for (double length : {0.99e-3, 1.01e-3}) {
        const Vector3d to = Vector3d::Constant(0.25) + length * way.normalized();
        std::copy(to.data(), to.data() + 3, x.begin() + 3 * i);
        EXPECT_EQ(stayed(x.data(), was.data(), n, 1e-3), length < 1e-3);
      }
    }
}
