// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "resistance/shape_drag.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace clay;
using Eigen::Vector3d;

namespace {

const double pi = std::acos(-1.0);

Clump hexagon(int layers = 1)
{
  PlateShape p;
  p.radius = 1;
  p.spacing = 2;
  p.layerSpacing = 2;
  p.layers = layers;
  return illitePlate(p);
}

Clump chain(int n, double spacing = 2)
{
  Clump c;
  for (int k = 0; k < n; ++k) c.push_back({Vector3d(0, 0, k * spacing), 1});
  return c;
}

const ShapeLaw laws[] = {ShapeLaw::holzerSommerfeld, ShapeLaw::ganser, ShapeLaw::tranCong};

}  // namespace

TEST(ShapeDrag, OfASphereIsNearTheMeasuredOne)
{
  // Roos and Willmarth, AIAA J. 9 (1971) 285: Re, C_D
  const double measured[][2] = {{5.99, 6.41}, {11.0, 4.01}, {14.6, 3.41}};
  for (const auto& m : measured) {
    EXPECT_NEAR(holzerSommerfeldDrag(m[0], 1, 1, 1) / m[1], 1, 0.17) << m[0];
    EXPECT_NEAR(tranCongDrag(m[0], 1, 1) / m[1], 1, 0.10) << m[0];
  }
  // standard drag curve: Clift, Grace and Weber (1978)
  EXPECT_NEAR(tranCongDrag(100, 1, 1) / 1.087, 1, 0.015);
  EXPECT_NEAR(tranCongDrag(1000, 1, 1) / 0.471, 1, 0.015);
}

TEST(ShapeDrag, HasTheFormulasValues)
{
  // worked by hand from the printed formulas
  EXPECT_NEAR(holzerSommerfeldDrag(1, 1, 1, 1), 8 + 16 + 3 + 0.42, 1e-12);
  EXPECT_NEAR(holzerSommerfeldDrag(100, 1, 1, 1), 0.08 + 0.16 + 0.3 + 0.42, 1e-12);
  // sphericity 0.1: log is -1, so the last term is 0.42 x 10^0.4 / crosswise
  EXPECT_NEAR(holzerSommerfeldDrag(100, 0.1, 0.25, 0.5),
              0.16 + 0.16 / std::sqrt(0.1) + 0.3 / std::pow(0.1, 0.75) + 0.84 * std::pow(10, 0.4), 1e-12);
  EXPECT_NEAR(ganserDrag(100, 1, 1), 0.24 * (1 + 0.1118 * std::pow(100, 0.6567)) + 0.4305 / 34.05, 1e-12);
  EXPECT_NEAR(ganserK2(0.1), std::pow(10, 1.8148), 1e-10);
  EXPECT_EQ(ganserK2(1), 1);
  EXPECT_NEAR(tranCongDrag(50, 1.2, 0.64),
              24.0 / 50 * 1.2 * (1 + 0.15 / 0.8 * std::pow(60, 0.687)) +
                  0.42 * 1.44 / (0.8 * (1 + 4.25e4 * std::pow(60, -1.16))),
              1e-12);
}

TEST(ShapeDrag, FactorIsOneAtRestAndGrowsSmoothly)
{
  ShapeFactors s;
  s.sphericity = 0.52;
  s.crosswise = 0.6;
  s.lengthwise = 0.4;
  s.circularity = 0.7;
  s.diameterRatio = 1.3;
  s.stokes = 1.2;
  for (ShapeLaw law : laws) {
    EXPECT_EQ(shapeDragFactor(law, 0, s), 1);
    double last = 1;
    for (double Re = 1e-6; Re < 1e4; Re *= 1.5) {
      const double f = shapeDragFactor(law, Re, s);
      EXPECT_GT(f, last);
      EXPECT_LT(f / last, 1.6);
      last = f;
    }
  }
}

TEST(ShapeDrag, FactorTimesStokesIsTheLaw)
{
  const double Re = 37;
  EXPECT_NEAR(holzerSommerfeldFactor(Re, 0.5, 0.4, 0.6) * (8 / std::sqrt(0.4) + 16 / std::sqrt(0.5)) / Re,
              holzerSommerfeldDrag(Re, 0.5, 0.4, 0.6), 1e-12);
  EXPECT_NEAR(ganserFactor(Re, 0.8, 4) * 24 / (Re * 0.8), ganserDrag(Re, 0.8, 4), 1e-12);
  EXPECT_NEAR(tranCongFactor(Re, 1.3, 0.6) * 24 / Re * 1.3, tranCongDrag(Re, 1.3, 0.6), 1e-12);
}

TEST(ShapeDrag, LawsAreKnownByName)
{
  EXPECT_EQ(shapeLaw("holzerSommerfeld"), ShapeLaw::holzerSommerfeld);
  EXPECT_EQ(shapeLaw("ganser"), ShapeLaw::ganser);
  EXPECT_EQ(shapeLaw("tranCong"), ShapeLaw::tranCong);
  EXPECT_THROW(shapeLaw("Stokes"), std::invalid_argument);
}

TEST(Shadow, OfSpheresInARow)
{
  const Shadow end = shadow(chain(3), Vector3d::UnitZ());
  EXPECT_NEAR(end.area, pi, 1e-12);
  EXPECT_NEAR(end.perimeter, 2 * pi, 1e-5);
  const Shadow side = shadow(chain(3), Vector3d(1, 1, 0));
  EXPECT_NEAR(side.area, 3 * pi, 1e-12);
  EXPECT_NEAR(side.perimeter, 6 * pi, 2e-2);  // joined by a hair where they touch
  const Shadow lens = shadow(chain(2, 1), Vector3d::UnitX());
  EXPECT_NEAR(lens.area, 2 * pi - (2 * pi / 3 - std::sqrt(3) / 2), 1e-12);
  EXPECT_NEAR(lens.perimeter, 2 * 2 * pi * 2 / 3, 1e-5);
}

TEST(Shadow, OfAPlateCountsItsOuterBorderOnly)
{
  const Shadow s = shadow(hexagon(2), Vector3d::UnitZ());
  EXPECT_NEAR(s.area, 7 * pi, 1e-9);
  EXPECT_NEAR(s.perimeter, 8 * pi, 2e-2);  // two thirds of six circles
}

TEST(UnionSurface, IsExact)
{
  EXPECT_NEAR(unionSurface(chain(1)), 4 * pi, 1e-5);
  EXPECT_NEAR(unionSurface(chain(3)), 12 * pi, 1e-4);
  // two caps of height 1/2 are hidden, each 2 pi r h
  EXPECT_NEAR(unionSurface(chain(2, 1)), 8 * pi - 2 * pi, 1e-4);
  Clump twice = chain(1);
  twice.push_back(twice.front());
  EXPECT_NEAR(unionSurface(twice), 4 * pi, 1e-5);
}

TEST(ClumpShape, OfASphereIsThatOfASphere)
{
  const ClumpShape s({{Vector3d(1, 2, 3), 2e-3}});
  EXPECT_NEAR(s.diameter(), 4e-3, 1e-12);
  const ShapeFactors f = s.factors(Vector3d(1, -2, 0.3));
  for (double v : {f.sphericity, f.crosswise, f.lengthwise, f.circularity, f.diameterRatio}) EXPECT_NEAR(v, 1, 1e-5);
}

TEST(ClumpShape, OfAPlateIsTheExactOneAlongItsAxesAndNearItElsewhere)
{
  const ClumpShape s(hexagon());
  EXPECT_NEAR(s.sphericity(), std::pow(7, 2.0 / 3) / 7, 1e-5);
  const ShapeFactors f = s.factors(Vector3d::UnitZ());
  EXPECT_NEAR(f.crosswise, std::pow(7, 2.0 / 3) / 7, 1e-9);
  EXPECT_NEAR(f.diameterRatio, std::sqrt(7) / std::cbrt(7), 1e-9);
  EXPECT_NEAR(f.circularity, std::sqrt(7) / 4, 1e-3);
  EXPECT_LT(s.fitError(), 0.08);
  // edge on, three spheres wide at most: less drag at speed than broadside
  const ShapeFactors edge = s.factors(Vector3d::UnitX());
  for (ShapeLaw law : {ShapeLaw::holzerSommerfeld, ShapeLaw::tranCong})
    EXPECT_LT(shapeDragFactor(law, 100, edge), shapeDragFactor(law, 100, f));
}

TEST(ClumpShape, ForgetsTheSignOfTheDirection)
{
  const ClumpShape s({{{0, 0, 0}, 1}, {{1.3, 0.2, 0}, 0.6}, {{-0.3, 1.1, 0.4}, 0.5}});
  for (const Vector3d& n : {Vector3d(1, 0.2, -0.4), Vector3d(-0.3, 2, 0.1), Vector3d(0.1, 0.2, -1)}) {
    const ShapeFactors a = s.factors(n), b = s.factors(-3 * n), e = s.exactFactors(n);
    EXPECT_DOUBLE_EQ(a.crosswise, b.crosswise);
    EXPECT_NEAR(a.crosswise / e.crosswise, 1, 0.01);
    EXPECT_NEAR(a.lengthwise / e.lengthwise, 1, 0.02);
    EXPECT_NEAR(a.circularity / e.circularity, 1, 0.02);
  }
}
