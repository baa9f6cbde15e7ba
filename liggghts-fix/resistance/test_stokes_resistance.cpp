// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "resistance/stokes_resistance.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <gtest/gtest.h>

using namespace clay;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

const double pi = std::acos(-1.0);

Clump spheres(const std::vector<Vector3d>& centres, double r = 1)
{
  Clump c;
  for (const auto& x : centres) c.push_back({x, r});
  return c;
}

Clump hexagon()
{
  PlateShape p;
  p.radius = 1;
  p.spacing = 2;
  p.layers = 1;
  return illitePlate(p);
}

Clump plates(double layerSpacing)
{
  PlateShape p;
  p.radius = 1;
  p.spacing = 2;
  p.layerSpacing = layerSpacing;
  return illitePlate(p);
}

struct Case {
  const char* name;
  Clump clump;
  double x, z, mean;  ///< F/(6 pi mu a U), independently computed to about 0.2 %
};

std::vector<Case> cases()
{
  const double h = std::sqrt(1.0 / 3), q = std::sqrt(0.5);
  return {
      {"dimer", spheres({{0, 0, 1}, {0, 0, -1}}), 1.4490, 1.2905, 1.3920},
      {"chain3", spheres({{0, 0, 2}, {0, 0, 0}, {0, 0, -2}}), 1.8396, 1.5417, 1.7283},
      {"triangle3", spheres({{0, 2 * h, 0}, {1, -h, 0}, {-1, -h, 0}}), 1.5771, 1.7241, 1.6232},
      {"tetrahedron4", spheres({{q, q, q}, {q, -q, -q}, {-q, q, -q}, {-q, -q, q}}), 1.7841, 1.7841, 1.7841},
      {"hexplate7", hexagon(), 2.1748, 2.5346, 2.2828},
  };
}

Matrix3d someTurn() { return Eigen::AngleAxisd(1.1, Vector3d(1, -2, 0.5).normalized()).toRotationMatrix(); }

Clump turned(Clump c, const Matrix3d& Q, const Vector3d& shift)
{
  for (auto& s : c) s.x = Q * s.x + shift;
  return c;
}

Clump lopsided() { return {{{0, 0, 0}, 1}, {{1.3, 0.2, 0}, 0.6}, {{-0.3, 1.1, 0.4}, 0.5}, {{0, -0.2, 1.4}, 0.8}}; }

}  // namespace

TEST(RotnePragerYamakawa, IsContinuousWhereBlobsTouchAndWhereOneSwallowsTheOther)
{
  const Vector3d e = Vector3d(1, 2, -1).normalized();
  for (double b : {1.0, 0.4})
    for (double r : {1 + b, 1 - b + 1e-9}) {
      const Matrix3d in = rotnePragerYamakawa((r - 1e-9) * e, 1, b);
      const Matrix3d out = rotnePragerYamakawa((r + 1e-9) * e, 1, b);
      EXPECT_LT((in - out).norm(), 1e-8) << b << " " << r;
    }
  EXPECT_NEAR(rotnePragerYamakawa(Vector3d::Zero(), 1, 1)(0, 0), 1 / (6 * pi), 1e-15);
}

TEST(Icosphere, HasItsPointsAndNoMeanDirection)
{
  for (int f : {1, 2, 3, 5}) {
    const auto p = icosphere(f);
    EXPECT_EQ(p.size(), std::size_t(10 * f * f + 2));
    Vector3d sum = Vector3d::Zero();
    for (const auto& x : p) {
      sum += x;
      EXPECT_NEAR(x.norm(), 1, 1e-14);
    }
    EXPECT_LT(sum.norm(), 1e-12);
  }
}

TEST(StokesResistance, OfASphereIsExact)
{
  const double a = 1e-3;
  const Vector3d at(3e-3, 1e-3, -2e-3);
  const auto s = stokesResistance({{at, a}}, at);
  EXPECT_TRUE(s.converged);
  Matrix6d exact = Matrix6d::Zero();
  exact.topLeftCorner<3, 3>().diagonal().setConstant(6 * pi * a);
  exact.bottomRightCorner<3, 3>().diagonal().setConstant(8 * pi * a * a * a);
  EXPECT_LT((s.R - exact).topLeftCorner(3, 3).norm(), 1e-9 * 6 * pi * a);
  EXPECT_LT((s.R - exact).bottomRightCorner(3, 3).norm(), 1e-9 * 8 * pi * a * a * a);
  EXPECT_LT((s.R - exact).topRightCorner(3, 3).norm(), 1e-9 * 6 * pi * a * a);
}

TEST(StokesResistance, AgreesWithComputedClustersWithinHalfAPercent)
{
  for (const auto& c : cases()) {
    const auto s = stokesResistance(c.clump, Vector3d::Zero());
    EXPECT_TRUE(s.converged) << c.name;
    const Matrix6d R = s.R / (6 * pi);
    EXPECT_NEAR(R(0, 0) / c.x, 1, 0.005) << c.name;
    EXPECT_NEAR(R(1, 1) / c.x, 1, 0.005) << c.name;
    EXPECT_NEAR(R(2, 2) / c.z, 1, 0.005) << c.name;
    EXPECT_NEAR(meanResistance(R) / c.mean, 1, 0.005) << c.name;
  }
}

TEST(StokesResistance, OfTheTouchingDoubletIsTheExactOne)
{
  const auto s = stokesResistance(spheres({{0, 0, 1}, {0, 0, -1}}), Vector3d::Zero());
  // along the axis: Stimson and Jeffery (1926), in the limit of contact
  EXPECT_NEAR(s.R(2, 2) / (12 * pi), 0.6451, 0.002 * 0.6451);
  // turning about the axis: 3/4 zeta(3) of two single spheres, Jeffery (1915)
  EXPECT_NEAR(s.R(5, 5) / (16 * pi), 0.75 * 1.2020569, 0.002);
}

TEST(StokesResistance, KeepsTheSymmetriesOfTheClump)
{
  for (double spacing : {1.0, 2.0}) {
    const Matrix6d R = stokesResistance(plates(spacing), Vector3d::Zero(), {0.02}).R;
    const double size = R(0, 0);
    EXPECT_NEAR(R(0, 0), R(1, 1), 1e-9 * size);
    EXPECT_NEAR(R(3, 3), R(4, 4), 1e-9 * R(3, 3));
    Matrix6d off = R;
    off.diagonal().setZero();
    EXPECT_LT(off.norm(), 1e-9 * size);
  }
  const Matrix6d chain = stokesResistance(spheres({{2, 2, 0}, {0, 0, 0}}), Vector3d(1, 1, 0)).R;
  EXPECT_NEAR(chain(0, 0), chain(1, 1), 1e-9);
  EXPECT_LT(chain.topRightCorner(3, 3).norm(), 1e-9);
}

TEST(StokesResistance, IsSymmetricAndPositiveDefinite)
{
  std::vector<Clump> all{lopsided(), plates(1.0)};
  for (const auto& c : cases()) all.push_back(c.clump);
  for (const auto& c : all) {
    const Matrix6d R = stokesResistance(c, Vector3d(0.3, -0.2, 0.5), {0.02}).R;
    EXPECT_EQ((R - R.transpose()).norm(), 0);
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(R).eigenvalues().minCoeff(), 0);
  }
}

TEST(StokesResistance, TurnsWithTheClump)
{
  const Matrix3d Q = someTurn();
  const Vector3d shift(4, 1, -3);
  std::vector<Clump> all{lopsided(), hexagon()};
  for (const auto& c : all) {
    const StokesOptions rough{0.01};
    const Matrix6d R = stokesResistance(c, Vector3d(0.1, 0.2, 0), rough).R;
    const Vector3d about = Q * Vector3d(0.1, 0.2, 0) + shift;
    const Matrix6d T = stokesResistance(turned(c, Q, shift), about, rough).R;
    EXPECT_LT((T - rotated(R, Q)).norm(), 1e-7 * R.norm());
  }
}

TEST(StokesResistance, DoesNotDependOnTheOrderOfTheSpheres)
{
  // the order chooses the axes the blobs are laid out in: what is left is their error
  Clump other = lopsided();
  std::reverse(other.begin(), other.end());
  const Matrix6d R = stokesResistance(lopsided(), Vector3d::Zero()).R;
  const Matrix6d S = stokesResistance(other, Vector3d::Zero()).R;
  for (int k = 0; k < 6; ++k) EXPECT_NEAR(S(k, k) / R(k, k), 1, 0.004) << k;
}

TEST(StokesResistance, ScalesWithTheSize)
{
  Clump small = lopsided();
  for (auto& s : small) {
    s.x *= 1e-3;
    s.r *= 1e-3;
  }
  const Matrix6d R = stokesResistance(lopsided(), Vector3d::Zero(), {0.01}).R;
  const Matrix6d S = stokesResistance(small, Vector3d::Zero(), {0.01}).R;
  EXPECT_LT((S.topLeftCorner(3, 3) * 1e3 - R.topLeftCorner(3, 3)).norm(), 1e-7 * R.norm());
  EXPECT_LT((S.topRightCorner(3, 3) * 1e6 - R.topRightCorner(3, 3)).norm(), 1e-7 * R.norm());
  EXPECT_LT((S.bottomRightCorner(3, 3) * 1e9 - R.bottomRightCorner(3, 3)).norm(), 1e-7 * R.norm());
}

TEST(StokesResistance, AboutAnotherPointIsTheMovedTensor)
{
  const Vector3d d(0.7, -0.4, 0.2);
  const Matrix6d R = stokesResistance(lopsided(), Vector3d::Zero(), {0.01}).R;
  const Matrix6d S = stokesResistance(lopsided(), d, {0.01}).R;
  EXPECT_LT((movedTo(R, d) - S).norm(), 1e-9 * S.norm());
  // a sphere at -d from the new point resists its turning: d x (6 pi d x)
  const Matrix6d one = movedTo(stokesResistance({{Vector3d::Zero(), 1}}, Vector3d::Zero()).R, d);
  EXPECT_NEAR(one(5, 5), 8 * pi + 6 * pi * (d.x() * d.x() + d.y() * d.y()), 1e-6);
}

TEST(StokesResistance, OfSpheresOfDifferentSizeGoesToTheLargeOne)
{
  const auto with = stokesResistance({{{0, 0, 0}, 1}, {{0, 0, 1.05}, 0.05}}, Vector3d::Zero());
  EXPECT_GT(with.R(0, 0), 6 * pi);
  EXPECT_LT(with.R(0, 0), 6 * pi * 1.02);
}

TEST(StokesResistance, DoesNotSeeSpheresInsideOthers)
{
  const Clump two = spheres({{0, 0, 1}, {0, 0, -1}});
  Clump more = two;
  more.push_back({{0, 0, 1}, 1});
  more.push_back({{0, 0.2, 1}, 0.5});
  const Matrix6d R = stokesResistance(two, Vector3d::Zero(), {0.01}).R;
  EXPECT_LT((stokesResistance(more, Vector3d::Zero(), {0.01}).R - R).norm(), 1e-9 * R.norm());
}

TEST(StokesResistance, GoesToTheSphereAsOverlapGrows)
{
  double last = 1e9;
  for (double d : {2.0, 1.0, 0.5, 0.2}) {
    const double k = stokesResistance(spheres({{0, 0, d / 2}, {0, 0, -d / 2}}), Vector3d::Zero()).R(2, 2);
    EXPECT_LT(k, last);
    last = k;
  }
  EXPECT_NEAR(last / (6 * pi), 1, 0.06);
  EXPECT_GT(last / (6 * pi), 1);
}

TEST(StokesResistance, OfAPlateConvergesBelowTheCapAndIsKept)
{
  using clock = std::chrono::steady_clock;
  const auto s = stokesResistance(plates(2.0), Vector3d::Zero());
  EXPECT_TRUE(s.converged);
  EXPECT_LE(s.levels.back().change, 3e-3);
  EXPECT_LE(3 * s.levels.back().blobs, 6000);
  const auto t = clock::now();
  const auto again = stokesResistance(plates(2.0), Vector3d::Zero());
  EXPECT_LT(std::chrono::duration<double>(clock::now() - t).count(), 0.05);
  EXPECT_EQ((again.R - s.R).norm(), 0);
}

TEST(StokesResistance, SaysWhatIsWrong)
{
  EXPECT_THROW(stokesResistance({}, Vector3d::Zero()), std::invalid_argument);
  EXPECT_THROW(stokesResistance({{Vector3d::Zero(), -1}}, Vector3d::Zero()), std::invalid_argument);
  EXPECT_THROW(stokesResistance({{Vector3d::Zero(), 1}}, Vector3d::Zero(), {3e-3, 20}), std::invalid_argument);
  const auto capped = stokesResistance(hexagon(), Vector3d::Zero(), {1e-9, 900});
  EXPECT_FALSE(capped.converged);
  EXPECT_NE(capped.report().find("not converged"), std::string::npos);
  char change[20];
  std::snprintf(change, sizeof change, "%.2g %%", 100 * capped.levels.back().change);
  EXPECT_NE(capped.warning().find(std::string("it still changed by ") + change), std::string::npos) << capped.warning();
  const auto lone = stokesResistance(hexagon(), Vector3d::Zero(), {1e-9, 300});
  EXPECT_EQ(lone.levels.size(), 1u);
  EXPECT_NE(lone.warning().find("only "), std::string::npos) << lone.warning();
  EXPECT_EQ(stokesResistance({{Vector3d::Zero(), 1}}, Vector3d::Zero()).warning(), "");
}
