// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "clumps/clump_slice.h"

#include <algorithm>
#include <cmath>

#include "clumps/hidden_arcs.h"

namespace clay {
namespace {

constexpr double pi = 3.14159265358979323846;

struct Disc {
  double x, y, r2, r;
  int sphere;
};

// the half-plane nx X + ny Y <= c of points nearer, by power, to a disc than to another
struct HalfPlane {
  double nx, ny, c;
};

// Primitives of products of cos and sin. The moments over a region are line
// integrals along its border (Green): a = 1/2 (x dy - y dx), xx = 1/3 x3 dy, ...
void addArc(Slice& s, double& cell, const Disc& d, double t0, double t1)
{
  const double r = d.r, a = d.x, b = d.y;
  const double c0 = std::cos(t0), s0 = std::sin(t0), c1 = std::cos(t1), s1 = std::sin(t1);
  const auto diff = [](double f0, double f1) { return f1 - f0; };
  const double t = t1 - t0;
  const double C = diff(s0, s1), S = c0 - c1;
  const double CC = 0.5 * t + 0.5 * diff(s0 * c0, s1 * c1);
  const double SS = 0.5 * t - 0.5 * diff(s0 * c0, s1 * c1);
  const double CCC = diff(s0 - s0 * s0 * s0 / 3, s1 - s1 * s1 * s1 / 3);
  const double SSS = diff(c0 * c0 * c0 / 3 - c0, c1 * c1 * c1 / 3 - c1);
  const double sin2 = 0.25 * (std::sin(2 * t1) - std::sin(2 * t0));
  const double sin4 = (std::sin(4 * t1) - std::sin(4 * t0)) / 32;
  const double CCCC = 0.375 * t + sin2 + sin4, SSSS = 0.375 * t - sin2 + sin4;
  const double CS = 0.5 * diff(s0 * s0, s1 * s1);
  const double CCS = -diff(c0 * c0 * c0, c1 * c1 * c1) / 3;
  const double CCCS = -diff(c0 * c0 * c0 * c0, c1 * c1 * c1 * c1) / 4;

  const double area = 0.5 * r * (a * C + b * S + r * t);
  cell += area;
  s.a += area;
  s.x += 0.5 * r * (a * a * C + 2 * a * r * CC + r * r * CCC);
  s.y += 0.5 * r * (b * b * S + 2 * b * r * SS + r * r * SSS);
  s.xx += r / 3 * (a * a * a * C + 3 * a * a * r * CC + 3 * a * r * r * CCC + r * r * r * CCCC);
  s.yy += r / 3 * (b * b * b * S + 3 * b * b * r * SS + 3 * b * r * r * SSS + r * r * r * SSSS);
  s.xy +=
      0.5 * r * (b * (a * a * C + 2 * a * r * CC + r * r * CCC) + r * (a * a * CS + 2 * a * r * CCS + r * r * CCCS));
}

// the part of the chord n.x = c of a disc that lies in all half-planes but its own
double chordArea(const Disc& d, const std::vector<HalfPlane>& planes, std::size_t own)
{
  const HalfPlane& h = planes[own];
  const double nn = h.nx * h.nx + h.ny * h.ny, n = std::sqrt(nn);
  const double off = (h.c - h.nx * d.x - h.ny * d.y) / n;
  if (std::abs(off) >= d.r) return 0;
  const double half = std::sqrt(d.r2 - off * off);
  const double ux = -h.ny / n, uy = h.nx / n;  // border of the cell, counter-clockwise
  const double px = d.x + h.nx / n * off, py = d.y + h.ny / n * off;
  double lo = -half, hi = half;
  for (std::size_t k = 0; k < planes.size(); ++k) {
    if (k == own) continue;
    const HalfPlane& g = planes[k];
    const double slope = g.nx * ux + g.ny * uy, room = g.c - g.nx * px - g.ny * py;
    if (std::abs(slope) < 1e-14 * (std::abs(g.nx) + std::abs(g.ny))) {
      // the same line twice belongs to the first of the two
      const double tiny = 1e-13 * n * d.r;
      if (room < -tiny || (std::abs(room) <= tiny && k < own)) return 0;
      continue;
    }
    if (slope > 0) hi = std::min(hi, room / slope);
    else lo = std::max(lo, room / slope);
  }
  if (hi <= lo) return 0;
  return 0.5 * (hi - lo) * (px * uy - py * ux);
}

}  // namespace

Slice cut(const Clump& clump, double z)
{
  Slice s;
  s.share.assign(clump.size(), 0.0);

  std::vector<Disc> discs;
  for (std::size_t i = 0; i < clump.size(); ++i) {
    const double dz = z - clump[i].x.z(), r2 = clump[i].r * clump[i].r - dz * dz;
    if (r2 > 0) discs.push_back({clump[i].x.x(), clump[i].x.y(), r2, std::sqrt(r2), int(i)});
  }

  std::vector<HalfPlane> planes;
  Arcs hidden;
  for (std::size_t i = 0; i < discs.size(); ++i) {
    const Disc& d = discs[i];
    planes.clear();
    hidden.clear();
    bool covered = false;

    for (std::size_t j = 0; j < discs.size() && !covered; ++j) {
      if (j == i) continue;
      const Disc& e = discs[j];
      const double dx = e.x - d.x, dy = e.y - d.y, dist2 = dx * dx + dy * dy;
      const double dist = std::sqrt(dist2);
      if (dist >= d.r + e.r) continue;
      if (dist < 1e-14 * (d.r + e.r)) {
        // concentric: the larger owns all, of two alike the first
        covered = e.r2 > d.r2 || (e.r2 == d.r2 && j < i);
        continue;
      }
      const double mid = 0.5 * (d.r2 - e.r2 + dist2) / dist;  // radical line, from d
      if (mid <= -d.r) {
        covered = true;
        continue;
      }
      if (mid >= d.r) continue;
      planes.push_back({dx, dy, dx * d.x + dy * d.y + mid * dist});
      hide(hidden, std::atan2(dy, dx), std::acos(mid / d.r));
    }
    if (covered) continue;

    double& cell = s.share[d.sphere];
    std::sort(hidden.begin(), hidden.end());
    double at = -pi;
    for (const auto& h : hidden) {
      if (h.first > at) addArc(s, cell, d, at, h.first);
      at = std::max(at, h.second);
    }
    if (at < pi) addArc(s, cell, d, at, pi);
    for (std::size_t k = 0; k < planes.size(); ++k) cell += chordArea(d, planes, k);
  }
  return s;
}

}  // namespace clay
