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

  void forces(double dt, bool update, int owned)
  {
    contactForces({x.data(), v.data(), omega.data(), f.data(), torque.data(), owned}, pairs, dt, update);
  }
};

// every pair of balls thrown into a box: some overlap, some do not
Scene scene(int n, unsigned seed, const ContactKind &kind = ContactKind())
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> box(0, 5e-3), unit(-1, 1), size(0.7e-3, 1e-3);
  Scene s;
  s.pairs.kind = kind;
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
      if (kind.normal != NormalForce::linear) {  // much the same at an overlap of 0.1 mm
        law.kn *= 100;
        law.kt *= 100;
        law.gamman *= kind.normal == NormalForce::hertz ? 10 : 100;
        law.gammat *= kind.normal == NormalForce::hertz ? 10 : 100;
      }
      law.friction = (i + j) % 5 ? 0.5 : 0.01;
      const double ri = s.balls[i].r, rj = s.balls[j].r;
      law.radius = ri * rj / (ri + rj);
      law.rolling = (i + j) % 3 ? 0.3 : 0.01;
      law.cohesion = 1e5 * (1 + (i + j) % 2);
      std::vector<double> history;
      for (int d = 0; d < kind.history(); ++d) history.push_back((d < kind.shears() ? 1e-5 : 2e-5) * unit(random));
      s.pairs.add(i, j, ri, rj, law, history.data(), false);
    }
  return s;
}

// a contact as the textbooks have it: force on i, torques, new displacement and rolling torque
struct Contact {
  bool touch, slides;
  Vector3d f, ti, tj, shear, roll;

  double history(const ContactKind &kind, int d) const
  {
    return d < kind.shears() ? shear[d] : roll[d - kind.shears()];
  }
};

// rolling torque on j; a wall is what has no radius
Vector3d rolling(const Ball &a, const Ball &b, const ContactPairs &p, int k, double elastic, double grip, double kt,
                 const Vector3d &before, double dt)
{
  const double distance = (a.x - b.x).norm(), delta = a.r + b.r - distance;
  const Vector3d n = (a.x - b.x) / distance;
  const Vector3d w = b.r > 0 ? Vector3d(a.w - b.w) : Vector3d((a.r - delta / 2) / distance * a.w);
  const Vector3d turns = p.kind.torsion ? w : Vector3d(w - w.dot(n) * n);
  const double reach = p.reach[k], most = p.rolling[k] * reach;
  if (p.kind.rolling == RollingTorque::constant) return most * elastic / w.norm() * turns;
  Vector3d torque = before + dt * kt * reach * reach * turns;
  if (torque.norm() > most * grip) torque *= most * grip / torque.norm();
  return torque;
}

// its attraction over the energy density: the area within both spheres' surfaces
double area(const Ball &a, const Ball &b)
{
  const double r = (a.x - b.x).norm();
  if (b.r == 0) return M_PI * (a.r * a.r - r * r);
  const double s = (r * r + a.r * a.r - b.r * b.r) / (2 * r);  // from a's centre to the circle where they meet
  return M_PI * (a.r * a.r - s * s);
}

Contact contact(const Ball &a, const Ball &b, const ContactPairs &p, int k, const double *before, double dt,
                bool update)
{
  Contact c = {};
  const int shears = p.kind.shears();
  c.shear = c.roll = Vector3d::Zero();
  if (shears) c.shear = Vector3d(before);
  if (p.kind.rolling == RollingTorque::sprung) c.roll = Vector3d(before + shears);
  const double delta = a.r + b.r - (a.x - b.x).norm();
  if (!(c.touch = delta > 0)) return c;
  const Vector3d n = (a.x - b.x).normalized(), ra = -(a.r - delta / 2) * n, rb = (b.r - delta / 2) * n;
  const Vector3d v = a.v + a.w.cross(ra) - b.v - b.w.cross(rb);
  const Vector3d vt = v - v.dot(n) * n;
  const NormalForce normal = p.kind.normal;
  const double stiff = normal == NormalForce::linear ? 1 : std::sqrt(delta);
  const double damp = normal == NormalForce::hertz ? std::sqrt(stiff) : stiff;
  const double kt = stiff * p.kt[k], gammat = damp * p.gammat[k];
  double fn = stiff * p.kn[k] * delta - damp * p.gamman[k] * v.dot(n);
  if (p.kind.limit) fn = std::max(fn, 0.0);
  const double held = p.kind.cohesion ? p.cohesion[k] * area(a, b) : 0;
  const double grip = std::abs(p.kind.reduce ? fn - held : fn), most = p.friction[k] * grip;
  fn -= held;
  Vector3d ft = Vector3d::Zero();
  if (p.kind.tangential == TangentialForce::damped) {
    ft = -gammat * vt;
    c.slides = ft.norm() > most;
    if (c.slides) ft *= most / ft.norm();
  }
  if (p.kind.tangential == TangentialForce::sprung) {
    Vector3d shear = c.shear;
    if (update) {
      shear += vt * dt;
      shear -= shear.dot(n) * n;
    }
    ft = -kt * shear;
    c.slides = ft.norm() > most;
    if (c.slides) ft *= most / ft.norm();
    if (update) c.shear = -ft / kt;
    if (!c.slides) ft -= gammat * vt;
  }
  c.f = fn * n + ft;
  c.ti = ra.cross(ft);
  c.tj = rb.cross(-ft);
  if (p.kind.rolling != RollingTorque::none) {
    const Vector3d torque = rolling(a, b, p, k, stiff * p.kn[k] * delta, grip, kt, c.roll, dt);
    if (update) c.roll = torque;
    c.ti -= torque;
    c.tj += torque;
  }
  return c;
}

// each stiffness with each friction, with and without forces that pull
std::vector<ContactKind> kinds()
{
  std::vector<ContactKind> all;
  for (NormalForce normal : {NormalForce::linear, NormalForce::hertz, NormalForce::hertzStiffness})
    for (TangentialForce tangential : {TangentialForce::none, TangentialForce::damped, TangentialForce::sprung})
      for (bool limit : {true, false}) {
        ContactKind kind;
        kind.normal = normal;
        kind.tangential = tangential;
        kind.limit = limit;
        all.push_back(kind);
        for (RollingTorque rolling : {RollingTorque::constant, RollingTorque::sprung}) {
          kind.rolling = rolling;
          kind.cohesion = rolling == RollingTorque::sprung;
          kind.reduce = kind.torsion = limit;
          all.push_back(kind);
        }
      }
  return all;
}

}  // namespace

TEST(ContactKernel, everyContactByTheTextbook)
{
  const double dt = 1e-5;
  const int owned = 70;  // of 90
  for (const ContactKind &kind : kinds())
    for (bool update : {true, false}) {
      Scene s = scene(90, 3, kind);
      const bool sprung = kind.tangential == TangentialForce::sprung;
      std::vector<Vector3d> f(s.balls.size(), Vector3d::Zero()), torque = f;
      std::vector<Contact> expected;
      double size = 0, turn = 0;
      int touching = 0, sliding = 0;
      for (int k = 0; k < s.pairs.size(); ++k) {
        double before[6];
        s.pairs.tell(k, before);
        const Contact c = contact(s.balls[s.pairs.i[k]], s.balls[s.pairs.j[k]], s.pairs, k, before, dt, update);
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
      EXPECT_GT(sliding, kind.tangential == TangentialForce::none ? -1 : sprung ? 30 : 20);
      EXPECT_GT(touching, sliding + 50);
      EXPECT_GT(s.pairs.size(), touching + 50);

      s.forces(dt, update, owned);
      for (std::size_t i = 0; i < s.balls.size(); ++i)
        for (int d = 0; d < 3; ++d) {
          EXPECT_NEAR(s.f[3 * i + d], f[i][d], 1e-13 * size);
          EXPECT_NEAR(s.torque[3 * i + d], torque[i][d], 1e-13 * turn);
        }
      for (int k = 0; k < s.pairs.size(); ++k) {
        EXPECT_EQ(s.pairs.touched[k], expected[k].touch);
        double after[6];
        s.pairs.tell(k, after);
        for (int d = 0; d < kind.history(); ++d) EXPECT_NEAR(after[d], expected[k].history(kind, d), 2e-13 * 1e-5);
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
      for (const ContactKind &kind : kinds()) {
        Scene s = scene(90, 4, kind);
        const bool sprung = kind.tangential == TangentialForce::sprung;
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
          law.radius = a.r;
          law.rolling = i % 2 ? 0.3 : 0.01;
          law.cohesion = 1e5;
          const double none[6] = {0, 0, 0, 0, 0, 0};
          s.pairs.add(i, i, a.r, 0, law, none, false);
          Ball point = {a.x, Vector3d::Zero(), Vector3d::Zero(), 0};
          if (wall.cylinder) {
            const Vector3d axis(2.5e-3, 2.5e-3, a.x.z());
            point.x = axis + 2e-3 * (a.x - axis).normalized();
          } else point.x[1] = 1e-3;
          EXPECT_NEAR(wall.gap(a.x.data()), (a.x - point.x).norm(), 1e-15);
          // only one that touches has been displaced
          double before[6] = {0, 0, 0, 0, 0, 0};
          if ((a.x - point.x).norm() < a.r) laws.tell(i, before);
          history.insert(history.end(), before, before + kind.history());
          expected.push_back(contact(a, point, s.pairs, i, before, dt, update));
          size = std::max(size, expected.back().f.norm());
          turn = std::max(turn, expected.back().ti.norm());
          touching += expected.back().touch;
          sliding += expected.back().slides;
        }
        EXPECT_GT(sliding, kind.tangential == TangentialForce::none ? -1 : sprung ? 2 : 1);
        EXPECT_GT(touching, sliding + 3);
        EXPECT_LT(touching, 80);
        EXPECT_EQ(wallForces({s.x.data(), s.v.data(), s.omega.data(), s.f.data(), s.torque.data(), 90}, s.pairs, wall,
                             history.data(), dt, update),
                  touching);
        for (int i = 0; i < 90; ++i)
          for (int d = 0; d < 3; ++d) {
            EXPECT_NEAR(s.f[3 * i + d], expected[i].f[d], 1e-12 * size);
            EXPECT_NEAR(s.torque[3 * i + d], expected[i].ti[d], 1e-12 * turn);
          }
        for (int i = 0, width = kind.history(); i < 90; ++i)
          for (int d = 0; d < width; ++d)
            EXPECT_NEAR(history[width * i + d], expected[i].history(kind, d), 1e-12 * 1e-5);
      }
}

// 4/3 Y sqrt(R) delta^(3/2), slipping at 8 G sqrt(R delta) s; damping -2 sqrt(5/6) beta sqrt(S m),
// S the slope of the force: Hertz's and Tsuji's by their formulas
TEST(ContactKernel, hertzByItsFormula)
{
  const double r1 = 1e-3, r2 = 2e-3, R = r1 * r2 / (r1 + r2), m = 3e-6, Y = 6e6, G = 1.4e6, beta = -0.3;
  const ContactLaw law = hertzLaw(R, m, Y, G, beta);
  for (double delta : {1e-9, 1e-6, 2e-5}) {
    for (double speed : {0.0, 0.02}) {
      Scene s;
      s.pairs.kind.normal = NormalForce::hertz;
      s.x = {0, 0, 0, 0, 0, r1 + r2 - delta};
      s.v = {0, 0, 0, 0, 0, -speed};
      s.omega.assign(6, 0.0);
      s.f.assign(6, 0.0);
      s.torque.assign(6, 0.0);
      const double shear[3] = {delta / 7, 0, 0};
      ContactLaw rough = law;
      rough.friction = 100;
      s.pairs.add(0, 1, r1, r2, rough, shear, true);
      s.forces(1e-6, true, 2);
      const double root = std::sqrt(R * delta), spring = 4.0 / 3.0 * Y * root * delta;
      const double dashpot = -2 * std::sqrt(5.0 / 6) * beta * std::sqrt(2 * Y * root * m) * speed;
      EXPECT_NEAR(s.f[5], spring + dashpot, 1e-6 * (spring + dashpot)) << delta;
      EXPECT_NEAR(s.f[0], -8 * G * root * delta / 7, 1e-6 * G * root * delta) << delta;
      EXPECT_NEAR(s.torque[1], (r1 - delta / 2) * s.f[0], 1e-6 * std::abs(r1 * s.f[0])) << delta;
    }
  }
  EXPECT_NEAR(law.gammat, -2 * std::sqrt(5.0 / 6) * beta * std::sqrt(8 * G * std::sqrt(R) * m), 1e-12 * law.gammat);
}

// pairs of one law are kept without it; one more of another law, out of reach, changes nothing
TEST(ContactKernel, pairsOfOneLaw)
{
  for (ContactKind kind : kinds()) {
    Scene all[2];
    for (bool other : {false, true}) {
      Scene &s = all[other] = scene(40, 5, kind);
      const ContactPairs laws = s.pairs;
      s.pairs.clear();
      const ContactLaw law = {3000, 2000, 0.2, 0.1, 0.3, 0.1, 4e-4, 1e5};
      double history[6];
      for (int k = 0; k < laws.size(); ++k) {
        laws.tell(k, history);
        s.pairs.add(laws.i[k], laws.j[k], 9e-4, 8e-4, law, history, false);
      }
      EXPECT_TRUE(s.pairs.alike());
      if (other) {
        s.x.insert(s.x.end(), {1, 1, 1, 2, 2, 2});
        for (auto *v : {&s.v, &s.omega, &s.f, &s.torque}) v->resize(s.x.size());
        ContactLaw weak = law;
        weak.cohesion = 0;
        s.pairs.add(40, 41, 9e-4, 8e-4, weak, history, false);
        EXPECT_FALSE(s.pairs.alike());
      }
      s.forces(1e-5, true, 40);
    }
    double most = 0;
    for (int c = 0; c < 120; ++c) {
      EXPECT_EQ(all[0].f[c], all[1].f[c]);
      EXPECT_EQ(all[0].torque[c], all[1].torque[c]);
      most = std::max(most, std::abs(all[0].f[c]));
    }
    EXPECT_GT(most, 0.1);
    double one[6], two[6];
    for (int k = 0; k < all[0].pairs.size(); ++k) {
      all[0].pairs.tell(k, one);
      all[1].pairs.tell(k, two);
      for (int d = 0; d < kind.history(); ++d) EXPECT_EQ(one[d], two[d]);
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
  s.forces(1e-5, true, 2);
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
