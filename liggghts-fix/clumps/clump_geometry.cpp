// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "clumps/clump_geometry.h"

#include <algorithm>
#include <cmath>

#include "clumps/clump_slice.h"

namespace clay {
namespace {

constexpr double pi = 3.14159265358979323846;
using Eigen::Matrix3d;
using Eigen::Vector3d;

double ballVolume(double r) { return 4.0 / 3.0 * pi * r * r * r; }

// Heights at which the cut changes its kind: ends of spheres, ends of the
// circles where two spheres meet, points where three meet. Between two of them
// every moment of the cut is an analytic function of the height.
std::vector<double> breaks(const Clump& c)
{
  std::vector<double> z;
  double size = 0;
  for (const auto& s : c) {
    z.push_back(s.x.z() - s.r);
    z.push_back(s.x.z() + s.r);
    size = std::max(size, s.r);
  }
  for (std::size_t i = 0; i < c.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Vector3d d = c[j].x - c[i].x;
      const double dist = d.norm();
      if (dist >= c[i].r + c[j].r || dist <= std::abs(c[i].r - c[j].r)) continue;
      const double along = 0.5 * (dist * dist + c[i].r * c[i].r - c[j].r * c[j].r) / dist;
      const Vector3d n = d / dist, centre = c[i].x + along * n;
      const double rho2 = c[i].r * c[i].r - along * along;
      const double reach = std::sqrt(std::max(0.0, rho2 * (1 - n.z() * n.z())));
      z.push_back(centre.z() - reach);
      z.push_back(centre.z() + reach);
      for (std::size_t k = 0; k < j; ++k) {
        // the circle against the third sphere: its plane's distance from that centre
        const Vector3d e = c[k].x - centre;
        const Vector3d inPlane = e - e.dot(n) * n;
        const double w = inPlane.norm();
        if (w < 1e-12 * size) continue;
        const Vector3d u = inPlane / w, v = n.cross(u);
        const double h = 0.5 * (rho2 + e.squaredNorm() - c[k].r * c[k].r) / w;
        if (h * h >= rho2) continue;
        const double g = std::sqrt(rho2 - h * h);
        z.push_back((centre + h * u + g * v).z());
        z.push_back((centre + h * u - g * v).z());
      }
    }
  std::sort(z.begin(), z.end());
  z.erase(std::unique(z.begin(), z.end(), [size](double a, double b) { return b - a < 1e-11 * size; }), z.end());
  return z;
}

// Nodes and weights of tanh-sinh quadrature on (-1, 1), which does not mind the
// square roots at the ends of an interval.
struct Node {
  double x, gap, w;
};
const std::vector<Node>& nodes()
{
  static const std::vector<Node> table = [] {
    std::vector<Node> t;
    const double h = 0.125;
    for (int k = -27; k <= 27; ++k) {
      const double s = 0.5 * pi * std::sinh(k * h), c = std::cosh(s);
      const double w = h * 0.5 * pi * std::cosh(k * h) / (c * c);
      const double gap = std::exp(-std::abs(s)) / c;  // 1 - |x|, without cancellation
      t.push_back({std::tanh(s), gap, w});
    }
    return t;
  }();
  return table;
}

}  // namespace

BodyGeometry sumOfSpheres(const Clump& clump)
{
  BodyGeometry g;
  for (const auto& s : clump) {
    const double v = ballVolume(s.r);
    g.volume += v;
    g.centre += v * s.x;
    g.share.push_back(v);
  }
  g.centre /= g.volume;
  for (const auto& s : clump) {
    const double v = ballVolume(s.r);
    const Vector3d d = s.x - g.centre;
    g.inertia += v * ((0.4 * s.r * s.r + d.squaredNorm()) * Matrix3d::Identity() - d * d.transpose());
  }
  for (double& v : g.share) v /= g.volume;
  return g;
}

BodyGeometry unionOfSpheres(const Clump& input)
{
  // about the sum's centre, in units of the largest radius: no cancellation
  const Vector3d origin = sumOfSpheres(input).centre;
  double unit = 0;
  for (const auto& s : input) unit = std::max(unit, s.r);
  Clump clump = input;
  for (auto& s : clump) {
    s.x = (s.x - origin) / unit;
    s.r /= unit;
  }

  BodyGeometry g;
  g.share.assign(clump.size(), 0.0);
  Vector3d first = Vector3d::Zero();
  Matrix3d second = Matrix3d::Zero();
  const std::vector<double> z = breaks(clump);
  for (std::size_t k = 0; k + 1 < z.size(); ++k) {
    const double half = 0.5 * (z[k + 1] - z[k]);
    for (const Node& n : nodes()) {
      const double at = n.x < 0 ? z[k] + half * n.gap : z[k + 1] - half * n.gap;
      const double w = half * n.w;
      const Slice s = cut(clump, at);
      g.volume += w * s.a;
      first += w * Vector3d(s.x, s.y, s.a * at);
      Matrix3d m;
      m << s.xx, s.xy, s.x * at, s.xy, s.yy, s.y * at, s.x * at, s.y * at, s.a * at * at;
      second += w * m;
      for (std::size_t i = 0; i < clump.size(); ++i) g.share[i] += w * s.share[i];
    }
  }
  const Vector3d c = first / g.volume;
  second -= g.volume * c * c.transpose();
  g.inertia = second.trace() * Matrix3d::Identity() - second;

  double total = 0;
  for (double v : g.share) total += v;
  for (double& v : g.share) v /= total;
  g.centre = origin + unit * c;
  g.volume *= unit * unit * unit;
  g.inertia *= std::pow(unit, 5);
  return g;
}

PrincipalAxes principalAxes(const Matrix3d& inertia)
{
  Eigen::SelfAdjointEigenSolver<Matrix3d> solver(inertia);
  PrincipalAxes p{solver.eigenvalues(), solver.eigenvectors()};
  if (p.axes.determinant() < 0) p.axes.col(2) *= -1;
  return p;
}

ClumpSphere boundingBall(const Clump& clump)
{
  const auto reach = [&clump](const Vector3d& c) {
    double r = 0;
    for (const auto& s : clump) r = std::max(r, (s.x - c).norm() + s.r);
    return r;
  };
  // walk towards the farthest sphere in ever smaller steps (Badoiu, Clarkson)
  Vector3d at = sumOfSpheres(clump).centre, best = at;
  double least = reach(at);
  for (int k = 1; k < 2000; ++k) {
    const ClumpSphere* far = &clump.front();
    for (const auto& s : clump)
      if ((s.x - at).norm() + s.r > (far->x - at).norm() + far->r) far = &s;
    at += (far->x - at) / (k + 1.0);
    const double r = reach(at);
    if (r < least * (1 - 1e-12)) {
      least = r;
      best = at;
    }
  }
  return {best, least * (1 + 1e-12), true};
}

namespace {

Clump plate(const PlateShape& p, bool chargesByLayer)
{
  Clump c;
  for (int l = 0; l < p.layers; ++l) {
    const double z = (l - 0.5 * (p.layers - 1)) * p.layerSpacing;
    const bool even = l % 2 == 0;
    c.push_back({Vector3d(0, 0, z), p.radius, chargesByLayer ? even : true});
    for (int k = 0; k < 6; ++k) {
      const double t = k * pi / 3;
      c.push_back(
          {Vector3d(p.spacing * std::cos(t), p.spacing * std::sin(t), z), p.radius, chargesByLayer ? even : false});
    }
  }
  return c;
}

}  // namespace

Clump illitePlate(const PlateShape& p) { return plate(p, true); }

Clump kaolinitePlate(const PlateShape& p) { return plate(p, false); }

}  // namespace clay
