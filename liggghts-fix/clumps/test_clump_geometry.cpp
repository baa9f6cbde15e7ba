// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "clumps/clump_geometry.h"

using namespace clay;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

const double pi = 3.14159265358979323846;

Clump turned(Clump c, const Matrix3d& R, const Vector3d& shift)
{
  for (auto& s : c) s.x = R * s.x + shift;
  return c;
}

Matrix3d someRotation()
{
  return (Eigen::AngleAxisd(0.7, Vector3d::UnitX()) * Eigen::AngleAxisd(-1.1, Vector3d::UnitY()) *
          Eigen::AngleAxisd(2.3, Vector3d::UnitZ()))
      .toRotationMatrix();
}

// volume, moments about the contact plane of a sphere cut at z = -h from its centre
struct CutSphere {
  double volume, first, second, axial;
  CutSphere(double r, double h)
  {
    // integrals of rho2 = r2 - z2 and powers from z = -h to r
    const auto I = [&](auto f) { return f(r) - f(-h); };
    volume = pi * I([&](double z) { return r * r * z - z * z * z / 3; });
    first = pi * I([&](double z) { return r * r * z * z / 2 - std::pow(z, 4) / 4; });
    second = pi * I([&](double z) { return r * r * z * z * z / 3 - std::pow(z, 5) / 5; });
    axial = pi / 2 * I([&](double z) { return std::pow(r, 4) * z - 2 * r * r * z * z * z / 3 + std::pow(z, 5) / 5; });
  }
};

// union of two spheres of radius r, d apart along z
BodyGeometry twoSpheres(double r, double d)
{
  const double h = std::min(d / 2, r);
  const CutSphere c(r, h);
  BodyGeometry g;
  g.volume = 2 * c.volume;
  const double across = 2 * (c.axial / 2 + c.second + d * c.first + d * d / 4 * c.volume);
  g.inertia = Vector3d(across, across, 2 * c.axial).asDiagonal();
  return g;
}

void expectSame(const BodyGeometry& a, const BodyGeometry& b, double tol)
{
  EXPECT_NEAR(a.volume, b.volume, tol * b.volume);
  EXPECT_NEAR((a.inertia - b.inertia).norm(), 0, tol * b.inertia.norm());
}

}  // namespace

TEST(ClumpGeometry, oneSphere)
{
  const double r = 1.3e-3;
  const Clump c{{Vector3d(0.1, -0.2, 0.3), r}};
  for (const auto& g : {unionOfSpheres(c), sumOfSpheres(c)}) {
    const double v = 4.0 / 3 * pi * r * r * r;
    EXPECT_NEAR(g.volume, v, 1e-13 * v);
    EXPECT_NEAR((g.centre - c[0].x).norm(), 0, 1e-13);
    EXPECT_NEAR((g.inertia - 0.4 * v * r * r * Matrix3d::Identity()).norm(), 0, 1e-12 * v * r * r);
    EXPECT_NEAR(g.share[0], 1, 1e-14);
  }
}

TEST(ClumpGeometry, twoSpheresTouching)
{
  const Clump c{{Vector3d(0, 0, -1), 1}, {Vector3d(0, 0, 1), 1}};
  expectSame(unionOfSpheres(c), twoSpheres(1, 2), 1e-12);
  expectSame(sumOfSpheres(c), twoSpheres(1, 2), 1e-13);
}

TEST(ClumpGeometry, twoSpheresOverlapping)
{
  for (double d : {0.2, 1.0, 1.9}) {
    const Clump c{{Vector3d(0, 0, -d / 2), 1}, {Vector3d(0, 0, d / 2), 1}};
    expectSame(unionOfSpheres(c), twoSpheres(1, d), 1e-12);
    // lying across the slices, and askew
    for (const Matrix3d& R : {Matrix3d(Eigen::AngleAxisd(pi / 2, Vector3d::UnitX())), someRotation()}) {
      const auto g = unionOfSpheres(turned(c, R, Vector3d(3, 2, 1)));
      BodyGeometry wanted = twoSpheres(1, d);
      wanted.inertia = R * wanted.inertia * R.transpose();
      expectSame(g, wanted, 2e-12);
      EXPECT_NEAR((g.centre - Vector3d(3, 2, 1)).norm(), 0, 1e-12);
      EXPECT_NEAR(g.share[0], 0.5, 1e-12);
    }
  }
}

TEST(ClumpGeometry, sphereInsideAnotherAddsNothing)
{
  const Clump big{{Vector3d(0, 0, 0), 1}};
  expectSame(unionOfSpheres({big[0], {Vector3d(0.2, 0.1, -0.3), 0.4}}), unionOfSpheres(big), 1e-12);
  const auto twice = unionOfSpheres({big[0], big[0]});
  expectSame(twice, unionOfSpheres(big), 1e-12);
  EXPECT_NEAR(twice.share[0] + twice.share[1], 1, 1e-14);
}

TEST(ClumpGeometry, unlikeSpheresMeetAtTheRadicalPlane)
{
  // cut planes at 0.4 from the one and 1.2 - 0.4 from the other: r2 - 0.16 = s2 - 0.64
  const double r = 1, d = 1.2, a = 0.4, s = std::sqrt(r * r - a * a + (d - a) * (d - a));
  const auto g = unionOfSpheres({{Vector3d(0, 0, 0), r}, {Vector3d(0, 0, d), s}});
  const CutSphere lower(r, a), upper(s, d - a);
  EXPECT_NEAR(g.volume, lower.volume + upper.volume, 1e-12 * g.volume);
  EXPECT_NEAR(g.share[0], lower.volume / g.volume, 1e-12);
  EXPECT_NEAR(g.centre.z(), (-lower.first + d * upper.volume + upper.first) / g.volume, 1e-12);
}

TEST(ClumpGeometry, plateIsSevenPairs)
{
  // layers r apart: only spheres one above the other overlap
  const double r = 1e-3;
  const Clump plate = illitePlate({r, 2 * r, r, 2});
  ASSERT_EQ(plate.size(), 14u);
  const auto g = unionOfSpheres(plate);
  const auto pair = twoSpheres(r, r);
  EXPECT_NEAR(g.volume, 7 * pair.volume, 1e-12 * g.volume);
  Matrix3d wanted = 7 * pair.inertia;
  // six pairs at 2 r from the axis: sum of y2 is half of the sum of squares
  wanted.diagonal() += pair.volume * 4 * r * r * Vector3d(3, 3, 6);
  EXPECT_NEAR((g.inertia - wanted).norm(), 0, 1e-12 * wanted.norm());
  for (double s : g.share) EXPECT_NEAR(s, 1.0 / 14, 1e-12);
}

TEST(ClumpGeometry, closePlateDoesNotDependOnItsOrientation)
{
  const Clump plate = kaolinitePlate({1, 1.5, 0.8, 2});  // all spheres overlap
  const auto g = unionOfSpheres(plate);
  EXPECT_LT(g.volume, 0.9 * sumOfSpheres(plate).volume);
  EXPECT_NEAR(g.inertia(0, 0), g.inertia(1, 1), 1e-11 * g.inertia(2, 2));
  const Matrix3d R = someRotation();
  const auto h = unionOfSpheres(turned(plate, R, Vector3d(-5, 4, 7)));
  EXPECT_NEAR(h.volume, g.volume, 1e-11 * g.volume);
  EXPECT_NEAR((h.inertia - R * g.inertia * R.transpose()).norm(), 0, 1e-11 * g.inertia.norm());
  EXPECT_NEAR((h.centre - Vector3d(-5, 4, 7)).norm(), 0, 1e-11);
  for (std::size_t i = 0; i < plate.size(); ++i) EXPECT_NEAR(h.share[i], g.share[i], 1e-10);
  double total = 0;
  for (double s : h.share) total += s;
  EXPECT_NEAR(total, 1, 1e-14);
}

TEST(ClumpGeometry, irregularClumpAgainstCountedPoints)
{
  const Clump c{{Vector3d(0, 0, 0), 1},
                {Vector3d(1.1, 0.2, 0.1), 0.7},
                {Vector3d(0.3, 0.9, 0.4), 0.8},
                {Vector3d(-0.2, 0.3, 1.2), 0.5}};
  const auto g = unionOfSpheres(c);
  const int n = 240;
  const double lo = -1.1, cell = 3.1 / n;
  double count = 0;
  Vector3d first = Vector3d::Zero();
  Matrix3d second = Matrix3d::Zero();
  std::vector<double> share(c.size(), 0.0);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k) {
        const Vector3d p = Vector3d::Constant(lo) + cell * Vector3d(i + 0.5, j + 0.5, k + 0.5);
        int owner = -1;
        double least = 0;
        for (std::size_t s = 0; s < c.size(); ++s) {
          const double power = (p - c[s].x).squaredNorm() - c[s].r * c[s].r;
          if (power < least) {
            least = power;
            owner = int(s);
          }
        }
        if (owner < 0) continue;
        count += 1;
        first += p;
        second += p * p.transpose();
        share[owner] += 1;
      }
  const Vector3d centre = first / count;
  second = second / count - centre * centre.transpose();
  const Matrix3d inertia = second.trace() * Matrix3d::Identity() - second;
  EXPECT_NEAR(g.volume, count * cell * cell * cell, 1e-3 * g.volume);
  EXPECT_NEAR((g.centre - centre).norm(), 0, 1e-3);
  EXPECT_NEAR((g.inertia / g.volume - inertia).norm(), 0, 1e-3 * inertia.norm());
  for (std::size_t s = 0; s < c.size(); ++s) EXPECT_NEAR(g.share[s], share[s] / count, 1e-3);
}

TEST(ClumpGeometry, offDiagonalEntriesKeepTheirSign)
{
  // two unlike spheres askew: every product of inertia differs from zero
  const Clump c{{Vector3d(0, 0, 0), 1}, {Vector3d(2, 1, 3), 0.6}};
  const auto g = unionOfSpheres(c), s = sumOfSpheres(c);
  EXPECT_NEAR((g.inertia - s.inertia).norm(), 0, 1e-11 * s.inertia.norm());
  EXPECT_LT(g.inertia(1, 2), 0);
  EXPECT_LT(g.inertia(0, 1), 0);
}

TEST(ClumpGeometry, principalAxesAreRightHandedAndGiveTheTensorBack)
{
  const Clump c{{Vector3d(0, 0, 0), 1}, {Vector3d(2, 1, 3), 0.6}, {Vector3d(-1, 2, 0), 0.7}};
  const auto g = sumOfSpheres(c);
  const auto p = principalAxes(g.inertia);
  EXPECT_NEAR(p.axes.determinant(), 1, 1e-12);
  EXPECT_LE(p.moments[0], p.moments[1]);
  EXPECT_LE(p.moments[1], p.moments[2]);
  const Matrix3d back = p.axes * p.moments.asDiagonal() * p.axes.transpose();
  EXPECT_NEAR((back - g.inertia).norm(), 0, 1e-12 * g.inertia.norm());
}

TEST(ClumpGeometry, boundingBallHoldsAllAndIsTight)
{
  const Clump plate = illitePlate({1, 2, 1, 2});
  const auto b = boundingBall(plate);
  EXPECT_NEAR(b.r, 1 + std::sqrt(4.25), 1e-9);
  const Clump row{{Vector3d(0, 0, 0), 1}, {Vector3d(1, 0, 0), 0.5}, {Vector3d(4, 0, 0), 2}};
  const auto l = boundingBall(row);
  EXPECT_NEAR(l.r, 3.5, 0.01);
  for (const auto& s : row) EXPECT_LE((s.x - l.x).norm() + s.r, l.r);
}

TEST(ClumpGeometry, platesCarryTheirCharges)
{
  const PlateShape p{1, 2, 1, 2};
  int illite = 0, kaolinite = 0;
  for (const auto& s : illitePlate(p)) {
    illite += s.positive;
    EXPECT_EQ(s.positive, s.x.z() < 0);
  }
  for (const auto& s : kaolinitePlate(p)) {
    kaolinite += s.positive;
    EXPECT_EQ(s.positive, s.x.head<2>().norm() < 1e-12);
  }
  EXPECT_EQ(illite, 7);
  EXPECT_EQ(kaolinite, 2);
}
