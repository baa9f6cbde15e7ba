// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coul_kernel.h"

#include <algorithm>
#include <cmath>
#include <numeric>

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

namespace {

// one sphere at (xi, yi, zi) on n others; all in contiguous arrays, no branch
// inside, so that the compiler works on several at a time
inline void row(double xi, double yi, double zi, double kqi, double cut2, double shift,
                int n, const double* x, const double* y, const double* z, const double* q,
                double* fx, double* fy, double* fz, double* f)
{
  double sx = 0, sy = 0, sz = 0;
  const double least = 1e-12 * cut2;  // spheres that coincide push with a finite force
#pragma omp simd reduction(+ : sx, sy, sz)
  for (int j = 0; j < n; ++j) {
    const double dx = xi - x[j], dy = yi - y[j], dz = zi - z[j];
    const double r2 = dx * dx + dy * dy + dz * dz;
    const double s2 = r2 > least ? r2 : least;
    const double inv = 1 / std::sqrt(s2);
    const double w = r2 < cut2 ? kqi * q[j] * (inv * inv - shift) * inv : 0.0;
    sx += w * dx;
    sy += w * dy;
    sz += w * dz;
    fx[j] -= w * dx;
    fy[j] -= w * dy;
    fz[j] -= w * dz;
  }
  f[0] += sx;
  f[1] += sy;
  f[2] += sz;
}

}  // namespace

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

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
__attribute__((target_clones("avx2", "default")))
#endif
void coulombForces(ChargeGroups& c, const CoulombLaw& law)
{
  c.fx.assign(c.x.size(), 0.0);
  c.fy.assign(c.x.size(), 0.0);
  c.fz.assign(c.x.size(), 0.0);
  const double cut2 = law.cutoff * law.cutoff, shift = law.shifted ? 1 / cut2 : 0;
  const double *x = c.x.data(), *y = c.y.data(), *z = c.z.data(), *q = c.q.data();
  double *fx = c.fx.data(), *fy = c.fy.data(), *fz = c.fz.data();

  for (const auto& p : pairsInReach(c, law)) {
    const ChargeGroups::Group &A = c.groups[p.first], &B = c.groups[p.second];
    const int b = B.begin;
    const double near = law.cutoff + B.r;
    for (int i = A.begin; i < A.end; ++i) {
      const double ex = x[i] - B.x, ey = y[i] - B.y, ez = z[i] - B.z;
      if (ex * ex + ey * ey + ez * ez >= near * near) continue;  // out of B's reach
      const int n = (p.first == p.second ? i : B.end) - b;
      double f[3] = {0, 0, 0};
      row(x[i], y[i], z[i], law.k * q[i], cut2, shift, n, x + b, y + b, z + b, q + b,
          fx + b, fy + b, fz + b, f);
      fx[i] += f[0];
      fy[i] += f[1];
      fz[i] += f[2];
    }
  }
}

}  // namespace clay
