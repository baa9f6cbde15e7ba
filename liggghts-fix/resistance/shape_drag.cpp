// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "resistance/shape_drag.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "clumps/clump_slice.h"
#include "clumps/hidden_arcs.h"

namespace clay {
namespace {

constexpr double pi = 3.14159265358979323846;
using Eigen::Matrix3d;
using Eigen::Vector3d;

struct Disc {
  double x, y, r;
};

struct Arc {
  int disc;
  double from, to;  ///< angles, counter-clockwise
};

/// Parts of a disc's border that no other disc covers.
void openArcs(const std::vector<Disc>& discs, int i, std::vector<Arc>& arcs)
{
  const Disc& d = discs[i];
  Arcs hidden;
  for (int j = 0; j < int(discs.size()); ++j) {
    if (j == i) continue;
    const Disc& e = discs[j];
    const double dx = e.x - d.x, dy = e.y - d.y, dist = std::hypot(dx, dy);
    if (dist >= d.r + e.r || dist + e.r <= d.r) continue;
    if (dist + d.r <= e.r) return;
    const double mid = 0.5 * (d.r * d.r - e.r * e.r + dist * dist) / dist;
    hide(hidden, std::atan2(dy, dx), std::acos(mid / d.r));
  }
  std::sort(hidden.begin(), hidden.end());
  double at = -pi;
  for (const auto& h : hidden) {
    if (h.first > at) arcs.push_back({i, at, h.first});
    at = std::max(at, h.second);
  }
  if (at < pi) arcs.push_back({i, at, pi});
}

/// Length of the outer borders: the loops of arcs that run counter-clockwise.
double outline(const std::vector<Disc>& discs)
{
  std::vector<Arc> arcs;
  for (int i = 0; i < int(discs.size()); ++i) openArcs(discs, i, arcs);
  const auto point = [&](const Arc& a, double t) {
    const Disc& d = discs[a.disc];
    return Eigen::Vector2d(d.x + d.r * std::cos(t), d.y + d.r * std::sin(t));
  };
  double total = 0;
  std::vector<bool> used(arcs.size(), false);
  for (std::size_t first = 0; first < arcs.size(); ++first) {
    if (used[first]) continue;
    double area = 0, length = 0;
    for (std::size_t k = first; !used[k];) {
      used[k] = true;
      const Arc& a = arcs[k];
      const Disc& d = discs[a.disc];
      length += d.r * (a.to - a.from);
      area += 0.5 * d.r *
          (d.x * (std::sin(a.to) - std::sin(a.from)) - d.y * (std::cos(a.to) - std::cos(a.from)) +
           d.r * (a.to - a.from));
      const Eigen::Vector2d end = point(a, a.to);
      double nearest = std::numeric_limits<double>::max();
      for (std::size_t n = 0; n < arcs.size(); ++n) {
        const double gap = (point(arcs[n], arcs[n].from) - end).squaredNorm();
        if (gap < nearest) {
          nearest = gap;
          k = n;
        }
      }
    }
    if (area > 0) total += length;
  }
  return total;
}

/// The clump seen along n: its spheres' centres in the plane z = 0, each circle once.
Clump flattened(const Clump& c, const Vector3d& n)
{
  const Vector3d w = n.normalized(), u = w.unitOrthogonal(), v = w.cross(u);
  Clump flat;
  for (const auto& s : c) {
    const Vector3d at(u.dot(s.x), v.dot(s.x), 0);
    const bool seen = std::any_of(flat.begin(), flat.end(),
                                  [&](const ClumpSphere& t) { return (t.x - at).norm() + s.r <= t.r * (1 + 1e-9); });
    if (!seen) flat.push_back({at, s.r});
  }
  return flat;
}

/// Evenly spread directions of one hemisphere.
std::vector<Vector3d> directions(int n)
{
  std::vector<Vector3d> list;
  for (int k = 0; k < n; ++k) {
    const double z = (k + 0.5) / n, t = k * pi * (3 - std::sqrt(5.0)), s = std::sqrt(1 - z * z);
    list.push_back(Vector3d(s * std::cos(t), s * std::sin(t), z));
  }
  return list;
}

constexpr int side = 33;  // nodes of the table along a cube's edge; odd: the axes are nodes

Eigen::Matrix<double, 6, 1> squares(const Vector3d& n)
{
  Eigen::Matrix<double, 6, 1> q;
  q << n.x() * n.x(), n.y() * n.y(), n.z() * n.z(), n.x() * n.y(), n.y() * n.z(), n.z() * n.x();
  return q;
}

/// The last term of Hoelzer and Sommerfeld without the crosswise sphericity.
double holzerNewton(double sphericity)
{
  const double log = std::max(0.0, -std::log10(sphericity));
  return 0.42 * std::pow(10.0, 0.4 * std::pow(log, 0.2));
}

}  // namespace

ShapeLaw shapeLaw(const std::string& name)
{
  if (name == "holzerSommerfeld") return ShapeLaw::holzerSommerfeld;
  if (name == "ganser") return ShapeLaw::ganser;
  if (name == "tranCong") return ShapeLaw::tranCong;
  throw std::invalid_argument("unknown shape law '" + name + "', must be holzerSommerfeld, ganser or tranCong");
}

double holzerSommerfeldFactor(double Re, double sphericity, double lengthwise, double crosswise)
{
  const double stokes = 8 / std::sqrt(lengthwise) + 16 / std::sqrt(sphericity);
  return 1 + (3 * std::sqrt(Re) / std::pow(sphericity, 0.75) + holzerNewton(sphericity) * Re / crosswise) / stokes;
}

double holzerSommerfeldDrag(double Re, double sphericity, double lengthwise, double crosswise)
{
  return (8 / std::sqrt(lengthwise) + 16 / std::sqrt(sphericity)) / Re *
      holzerSommerfeldFactor(Re, sphericity, lengthwise, crosswise);
}

double ganserK2(double sphericity)
{
  return std::pow(10.0, 1.8148 * std::pow(std::max(0.0, -std::log10(sphericity)), 0.5743));
}

double ganserFactor(double Re, double K1, double K2)
{
  const double x = Re * K1 * K2;
  return 1 + 0.1118 * std::pow(x, 0.6567) + 0.4305 * x * x / (24 * (x + 3305));
}

double ganserDrag(double Re, double K1, double K2) { return 24 / (Re * K1) * ganserFactor(Re, K1, K2); }

double tranCongFactor(double Re, double diameterRatio, double circularity)
{
  const double x = Re * diameterRatio, p = std::pow(x, 1.16);
  return 1 + (0.15 * std::pow(x, 0.687) + 0.42 * x / 24 * p / (p + 4.25e4)) / std::sqrt(circularity);
}

double tranCongDrag(double Re, double diameterRatio, double circularity)
{
  return 24 / Re * diameterRatio * tranCongFactor(Re, diameterRatio, circularity);
}

double shapeDragFactor(ShapeLaw law, double Re, const ShapeFactors& s)
{
  switch (law) {
  case ShapeLaw::holzerSommerfeld:
    return holzerSommerfeldFactor(Re, s.sphericity, s.lengthwise, s.crosswise);
  case ShapeLaw::ganser:
    return ganserFactor(Re, 1 / s.stokes, ganserK2(s.sphericity));
  case ShapeLaw::tranCong:
    return tranCongFactor(Re, s.diameterRatio, s.circularity);
  }
  throw std::logic_error("shapeDragFactor: a law without a formula");
}

Shadow shadow(const Clump& clump, const Vector3d& direction)
{
  const Clump flat = flattened(clump, direction);
  std::vector<Disc> discs;
  // spheres that touch join by a hair, so that their borders make one line
  for (const auto& s : flat) discs.push_back({s.x.x(), s.x.y(), s.r * (1 + 1e-7)});
  return {cut(flat, 0).a, outline(discs)};
}

double unionSurface(const Clump& input)
{
  // askew, so that no circle where two spheres meet lies in a slice
  Clump clump = input;
  const Matrix3d askew = Eigen::AngleAxisd(1.0, Vector3d(3, 2, 1).normalized()).toRotationMatrix();
  for (auto& s : clump) s.x = askew * s.x;

  // on a sphere, area is radius times height times angle (Archimedes)
  double total = 0;
  const int slices = 2000;
  for (std::size_t i = 0; i < clump.size(); ++i) {
    const ClumpSphere& s = clump[i];
    const bool twin = std::any_of(clump.begin(), clump.begin() + i, [&](const ClumpSphere& t) {
      return (s.x - t.x).norm() + std::abs(s.r - t.r) < 1e-9 * s.r;
    });
    if (twin) continue;
    for (int k = 0; k < slices; ++k) {
      // denser near the poles, where the circles are short
      const double t = pi * (k + 0.5) / slices, z = s.x.z() - s.r * std::cos(t);
      std::vector<Disc> discs{{s.x.x(), s.x.y(), s.r * std::sin(t)}};
      for (std::size_t j = 0; j < clump.size(); ++j) {
        const double dz = z - clump[j].x.z(), r2 = clump[j].r * clump[j].r - dz * dz;
        const bool same = (clump[j].x - s.x).norm() + std::abs(clump[j].r - s.r) < 1e-9 * s.r;
        if (!same && r2 > 0) discs.push_back({clump[j].x.x(), clump[j].x.y(), std::sqrt(r2)});
      }
      std::vector<Arc> arcs;
      openArcs(discs, 0, arcs);
      double angle = 0;
      for (const Arc& a : arcs) angle += a.to - a.from;
      total += s.r * s.r * angle * std::sin(t) * pi / slices;
    }
  }
  return total;
}

ClumpShape::ClumpShape(const Clump& clump, double volume) : clump_(clump)
{
  if (clump.empty()) throw std::invalid_argument("ClumpShape: the clump has no spheres");
  volume_ = volume > 0 ? volume : unionOfSpheres(clump).volume;
  surface_ = unionSurface(clump);
  diameter_ = std::cbrt(6 * volume_ / pi);
  sphericity_ = std::min(1.0, pi * diameter_ * diameter_ / surface_);

  for (int n = 0; n < 3 * side * side; ++n) {
    const Shadow s = shadow(clump_, nodeDirection(n));
    area_.push_back(s.area);
    perimeter_.push_back(s.perimeter);
  }
  // the mean over all side views hardly varies: a quadratic form will do
  const std::vector<Vector3d> at = directions(120);
  Eigen::MatrixXd basis(at.size(), 6);
  Eigen::VectorXd values(at.size());
  for (std::size_t k = 0; k < at.size(); ++k) {
    basis.row(k) = squares(at[k]).transpose();
    values[k] = sideArea(at[k]);
  }
  side_ = (basis.transpose() * basis).ldlt().solve(basis.transpose() * values);

  for (std::size_t k = 0; k < at.size(); ++k) {
    const Shadow s = shadow(clump_, at[k]);
    const ShapeFactors exact = assemble(s.area, values[k], s.perimeter), table = factors(at[k]);
    for (ShapeLaw law : {ShapeLaw::holzerSommerfeld, ShapeLaw::tranCong})
      fitError_ =
          std::max(fitError_, std::abs(shapeDragFactor(law, 100, table) / shapeDragFactor(law, 100, exact) - 1));
  }
}

// The table covers three faces of a cube; a direction and its opposite are alike.
ClumpShape::Place ClumpShape::place(const Vector3d& n)
{
  int face = 0;
  n.cwiseAbs().maxCoeff(&face);
  const double u = n[(face + 1) % 3] / n[face], v = n[(face + 2) % 3] / n[face];
  const double p = 0.5 * (u + 1) * (side - 1), q = 0.5 * (v + 1) * (side - 1);
  const int i = std::min(side - 2, int(p)), j = std::min(side - 2, int(q));
  const double s = p - i, t = q - j;
  const int first = (face * side + i) * side + j;
  return {{first, first + 1, first + side, first + side + 1}, {(1 - s) * (1 - t), (1 - s) * t, s * (1 - t), s * t}};
}

Vector3d ClumpShape::nodeDirection(int node)
{
  const int face = node / (side * side), i = node / side % side, j = node % side;
  Vector3d n;
  n[face] = 1;
  n[(face + 1) % 3] = 2.0 * i / (side - 1) - 1;
  n[(face + 2) % 3] = 2.0 * j / (side - 1) - 1;
  return n.normalized();
}

double ClumpShape::sideArea(const Vector3d& n) const
{
  const Vector3d u = n.unitOrthogonal(), v = n.normalized().cross(u);
  const int turns = 24;
  double sum = 0;
  for (int k = 0; k < turns; ++k) {
    const double t = pi * (k + 0.5) / turns;
    sum += cut(flattened(clump_, std::cos(t) * u + std::sin(t) * v), 0).a;
  }
  return sum / turns;
}

ShapeFactors ClumpShape::assemble(double area, double sides, double perimeter) const
{
  const double sphere = 0.25 * pi * diameter_ * diameter_, seen = std::sqrt(4 * area / pi);
  ShapeFactors f;
  f.sphericity = sphericity_;
  f.crosswise = sphere / area;
  f.lengthwise = sphere / (0.5 * surface_ - sides);
  f.circularity = std::min(1.0, pi * seen / perimeter);
  f.diameterRatio = seen / diameter_;
  return f;
}

ShapeFactors ClumpShape::factors(const Vector3d& direction) const
{
  const Vector3d n = direction.normalized();
  const Place p = place(n);
  double area = 0, perimeter = 0;
  for (int c = 0; c < 4; ++c) {
    area += p.weight[c] * area_[p.node[c]];
    perimeter += p.weight[c] * perimeter_[p.node[c]];
  }
  return assemble(area, squares(n).dot(side_), perimeter);
}

ShapeFactors ClumpShape::exactFactors(const Vector3d& direction) const
{
  const Shadow s = shadow(clump_, direction);
  return assemble(s.area, sideArea(direction), s.perimeter);
}

}  // namespace clay
