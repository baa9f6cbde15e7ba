// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coul_kernel.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "clones.h"
#include "inv_sqrt.h"

namespace clay {

double CoulombLaw::forceOverDistance(double qq, double r) const
{
  if (r >= cutoff) return 0;
  return k * qq * (1 / (r * r) - (shifted ? 1 / (cutoff * cutoff) : 0)) / r;
}

double CoulombLaw::energy(double qq, double r) const
{
  if (r >= cutoff) return 0;
  return k * qq * (1 / r - 1 / cutoff + (shifted ? (r - cutoff) / (cutoff * cutoff) : 0));
}

void ChargeGroups::clear()
{
  for (auto* v : {&x, &y, &z, &q}) v->clear();
  groups.clear();
}

void ChargeGroups::add(double px, double py, double pz, double charge)
{
  x.push_back(px);
  y.push_back(py);
  z.push_back(pz);
  q.push_back(charge);
}

void ChargeGroups::close(long body, bool acted)
{
  Group g{groups.empty() ? 0 : groups.back().end, int(x.size()), body, acted, 0, 0, 0, 0};
  const int n = g.end - g.begin;
  if (n == 0) return;
  for (int i = g.begin; i < g.end; ++i) {
    g.x += x[i] / n;
    g.y += y[i] / n;
    g.z += z[i] / n;
  }
  for (int i = g.begin; i < g.end; ++i)
    g.r = std::max(g.r, std::hypot(x[i] - g.x, y[i] - g.y, z[i] - g.z));
  groups.push_back(g);
}

std::vector<std::pair<int, int>> pairsInReach(const ChargeGroups& c, const CoulombLaw& law)
{
  std::vector<std::pair<int, int>> pairs;

  // a sweep along z: of two groups, the upper looks down no farther than it reaches
  std::vector<int> order(c.groups.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&c](int a, int b) { return c.groups[a].z < c.groups[b].z; });
  double widest = 0;
  for (const auto& g : c.groups) widest = std::max(widest, g.r);

  for (std::size_t a = 0; a < order.size(); ++a) {
    const ChargeGroups::Group& A = c.groups[order[a]];
    if (A.body < 0 && A.acted) pairs.emplace_back(order[a], order[a]);
    for (std::size_t b = a; b-- > 0;) {
      const ChargeGroups::Group& B = c.groups[order[b]];
      const double dz = A.z - B.z;
      if (dz > law.cutoff + A.r + widest) break;
      if (!A.acted && !B.acted) continue;
      if (A.body >= 0 && A.body == B.body) continue;
      const double dx = A.x - B.x, dy = A.y - B.y, reach = law.cutoff + A.r + B.r;
      if (dx * dx + dy * dy + dz * dz < reach * reach) pairs.emplace_back(order[a], order[b]);
    }
  }
  return pairs;
}

namespace {

constexpr int LANES = ChargeGroups::Lanes::WIDTH;

int wholeLanes(int n) { return (n + LANES - 1) / LANES * LANES; }

void fillLanes(ChargeGroups& c)
{
  ChargeGroups::Lanes& s = c.lanes;
  s.begin.clear();
  int n = 0;
  for (const auto& g : c.groups) {
    s.begin.push_back(n);
    n += wholeLanes(g.end - g.begin);
  }
  for (auto* v : {&s.x, &s.y, &s.z, &s.q, &s.fx, &s.fy, &s.fz}) v->assign(n, 0.0);
  for (auto* v : {&s.sx, &s.sy, &s.sz}) v->assign(n * LANES, 0.0);
  s.reaching.resize(n);
  for (std::size_t k = 0; k < s.begin.size(); ++k) {
    const auto& g = c.groups[k];
    for (int i = g.begin, l = s.begin[k]; i < g.end; ++i, ++l) {
      s.x[l] = c.x[i];
      s.y[l] = c.y[i];
      s.z[l] = c.z[i];
      s.q[l] = c.q[i];
    }
  }
}

// the spheres of each pair's first group on those of its second, and back
CLAY_CLONES void act(ChargeGroups& c, const CoulombLaw& law, const std::vector<std::pair<int, int>>& pairs)
{
  ChargeGroups::Lanes& s = c.lanes;
  const double cut2 = law.cutoff * law.cutoff, shift = law.shifted ? 1 / cut2 : 0;
  const double least = 1e-12 * cut2;  // spheres that coincide push with a finite force
  double *const fx = s.fx.data(), *const fy = s.fy.data(), *const fz = s.fz.data();
  const double *const x = s.x.data(), *const y = s.y.data(), *const z = s.z.data(), *const q = s.q.data();
  int *const reaching = s.reaching.data();

  for (const auto& p : pairs) {
    const ChargeGroups::Group &A = c.groups[p.first], &B = c.groups[p.second];
    const int a = s.begin[p.first], b = s.begin[p.second], n = wholeLanes(B.end - B.begin);
    // a group of loose spheres with itself meets each pair twice
    const double back = p.first == p.second ? 0 : 1, near2 = (law.cutoff + B.r) * (law.cutoff + B.r);

    int count = 0;
    for (int i = a; i < a + A.end - A.begin; ++i) {
      const double ex = x[i] - B.x, ey = y[i] - B.y, ez = z[i] - B.z;
      reaching[count] = i;
      count += ex * ex + ey * ey + ez * ez < near2;
    }
    for (int k = 0; k < count; ++k) {
      const int i = reaching[k];
      const double xi = x[i], yi = y[i], zi = z[i], kqi = law.k * q[i];
      double *const sx = &s.sx[i * LANES], *const sy = &s.sy[i * LANES], *const sz = &s.sz[i * LANES];
      for (int j = b; j < b + n; j += LANES) {
#pragma omp simd simdlen(8)
        for (int l = 0; l < LANES; ++l) {
          const double dx = xi - x[j + l], dy = yi - y[j + l], dz = zi - z[j + l];
          const double r2 = dx * dx + dy * dy + dz * dz;
          const double inv = invSqrt(r2 > least ? r2 : least);
          const double uncut = kqi * q[j + l] * (inv * inv - shift) * inv;
          const double w = r2 < cut2 ? uncut : 0.0;
          sx[l] += w * dx;
          sy[l] += w * dy;
          sz[l] += w * dz;
          fx[j + l] -= back * w * dx;
          fy[j + l] -= back * w * dy;
          fz[j + l] -= back * w * dz;
        }
      }
    }
  }
}

}  // namespace

void coulombForces(ChargeGroups& c, const CoulombLaw& law)
{
  fillLanes(c);
  act(c, law, pairsInReach(c, law));
  const ChargeGroups::Lanes& s = c.lanes;

  for (auto* f : {&c.fx, &c.fy, &c.fz}) f->resize(c.x.size());
  for (std::size_t k = 0; k < c.groups.size(); ++k)
    for (int i = c.groups[k].begin, l = s.begin[k]; i < c.groups[k].end; ++i, ++l) {
      const double *sx = &s.sx[l * LANES], *sy = &s.sy[l * LANES], *sz = &s.sz[l * LANES];
      c.fx[i] = std::accumulate(sx, sx + LANES, s.fx[l]);
      c.fy[i] = std::accumulate(sy, sy + LANES, s.fy[l]);
      c.fz[i] = std::accumulate(sz, sz + LANES, s.fz[l]);
    }
}

}  // namespace clay
