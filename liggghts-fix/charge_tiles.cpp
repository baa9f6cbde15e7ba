// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "charge_tiles.h"

#include <algorithm>
#include <cstdint>
#include <type_traits>

#include "clones.h"
#include "inv_sqrt.h"

namespace clay {

template <class Real>
void ChargeTiles<Real>::build(const std::vector<ChargeGroup>& groups, const std::vector<double>& q, double largest)
{
  tiles.clear();
  begin.clear();
  for (const auto& group : groups) {
    begin.push_back(static_cast<int>(tiles.size()));
    for (int i = group.begin; i < group.end; i += LANES) {
      tiles.push_back(Tile());
      Tile& t = tiles.back();
      t.used = std::min(LANES, group.end - i);
      for (int l = 0; l < t.used; ++l) t.q[l] = static_cast<Real>(q[i + l] / largest);
    }
  }
  begin.push_back(static_cast<int>(tiles.size()));
}

template struct ChargeTiles<float>;
template struct ChargeTiles<double>;

namespace {

template <class Real>
union alignas(64) Lane {
  typename ChargeTiles<Real>::Lanes all;
  Real at[ChargeTiles<Real>::LANES];
};

template <class Real>
union alignas(64) Flag {
  typename ChargeTiles<Real>::Flags all;
  std::conditional_t<sizeof(Real) == 4, std::int32_t, std::int64_t> at[ChargeTiles<Real>::LANES];
};

template <class Real>
CLAY_INLINE double sum(const typename ChargeTiles<Real>::Lanes& v)
{
  Lane<Real> s;
  s.all = v;
  for (int half = ChargeTiles<Real>::LANES / 2; half > 0; half /= 2)
#pragma omp simd
    for (int l = 0; l < half; ++l) s.at[l] += s.at[l + half];
  return s.at[0];
}

// spheres that coincide push with a finite force; to all others it is nothing
constexpr float leastOf(float) { return 1e-14f; }
constexpr double leastOf(double) { return 1e-30; }

template <class Real>
CLAY_INLINE void place(const std::vector<ChargeGroup>& groups, const TileLaw& law, Places x, ChargeTiles<Real>& c)
{
  constexpr int N = ChargeTiles<Real>::LANES;
  const double length = 1 / law.cutoff;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const ChargeGroup& group = groups[g];
    for (int k = c.begin[g], i = group.begin; k < c.begin[g + 1]; ++k, i += N) {
      auto& t = c.tiles[k];
      Lane<Real> u, v, w;
      u.all = v.all = w.all = t.fx = t.fy = t.fz = typename ChargeTiles<Real>::Lanes{};
#pragma omp simd
      for (int l = 0; l < t.used; ++l) {
        u.at[l] = static_cast<Real>(length * (x.x[i + l] - group.x));
        v.at[l] = static_cast<Real>(length * (x.y[i + l] - group.y));
        w.at[l] = static_cast<Real>(length * (x.z[i + l] - group.z));
      }
      t.x = u.all;
      t.y = v.all;
      t.z = w.all;
    }
  }
}

// A row is a sphere of the first group, which meets all of a tile of the second
// at once. Only the forces on the second are kept, lane by lane: those on the
// first are the opposite, with the same lever.
template <class Real>
CLAY_INLINE void actOn(const PairsInReach& pairs, const TileLaw& law, const std::vector<ChargeGroup>& groups,
                       ChargeTiles<Real>& c, std::vector<Wrench>& wrenches, Forces f)
{
  typedef typename ChargeTiles<Real>::Lanes Lanes;
  typedef typename ChargeTiles<Real>::Tile Tile;
  constexpr int N = ChargeTiles<Real>::LANES;
  const Lanes zero = {};
  const Real shift = static_cast<Real>(law.shift), least = leastOf(Real());
  const double length = 1 / law.cutoff, torque = law.force * law.cutoff;

  Lane<Real> ux, uy, uz, q;
  Flag<Real> near;
  int row[N];

  for (std::size_t a = 0; a < groups.size(); ++a) {
    const ChargeGroup& A = groups[a];
    Lanes Fx = zero, Fy = zero, Fz = zero, Tx = zero, Ty = zero, Tz = zero;

    for (int p = pairs.first[a]; p < pairs.first[a + 1]; ++p) {
      const int b = pairs.second[p];
      const ChargeGroup& B = groups[b];
      const double dx = B.x - A.x, dy = B.y - A.y, dz = B.z - A.z, d2 = dx * dx + dy * dy + dz * dz;
      const double outer = law.cutoff + A.r + B.r, inner = law.cutoff - A.r - B.r;
      if (d2 >= outer * outer) continue;
      const bool whole = inner > 0 && d2 < inner * inner;
      const Real Dx = Real(length * dx), Dy = Real(length * dy), Dz = Real(length * dz);
      // a sphere farther from B than this has none of it within the cut-off
      const double reach = 1.00001 * (1 + length * B.r);
      const Real near2 = Real(whole ? 1e30 : reach * reach);

      for (int ta = c.begin[a]; ta < c.begin[a + 1]; ++ta) {
        const Tile& one = c.tiles[ta];
        ux.all = one.x - Dx;
        uy.all = one.y - Dy;
        uz.all = one.z - Dz;
        q.all = one.q;
        near.all = ux.all * ux.all + uy.all * uy.all + uz.all * uz.all < near2;
        int rows = 0;
        for (int i = 0; i < one.used; ++i) {
          row[rows] = i;
          rows -= static_cast<int>(near.at[i]);
        }

        for (int tb = c.begin[b]; tb < c.begin[b + 1]; ++tb) {
          Tile& other = c.tiles[tb];
          Lanes fx = zero, fy = zero, fz = zero;
          for (int k = 0; k < rows; ++k) {
            const int i = row[k];
            const Lanes ex = other.x - ux.at[i], ey = other.y - uy.at[i], ez = other.z - uz.at[i];
            const Lanes r2 = ex * ex + (ey * ey + (ez * ez + least));
            Lanes inv;
            invSqrt(r2, inv);
            const Lanes uncut = (inv * inv - shift) * (inv * q.at[i]);
            const Lanes w = r2 < Real(1) ? uncut : zero;
            fx += w * ex;
            fy += w * ey;
            fz += w * ez;
          }
          fx *= other.q;
          fy *= other.q;
          fz *= other.q;
          other.fx += fx;
          other.fy += fy;
          other.fz += fz;
          if (A.loose()) continue;
          const Lanes lx = other.x + Dx, ly = other.y + Dy, lz = other.z + Dz;
          Fx -= fx;
          Fy -= fy;
          Fz -= fz;
          Tx -= ly * fz - lz * fy;
          Ty -= lz * fx - lx * fz;
          Tz -= lx * fy - ly * fx;
        }
      }
    }
    if (!A.loose())
      wrenches[a] = {{sum<Real>(Fx), sum<Real>(Fy), sum<Real>(Fz)}, {sum<Real>(Tx), sum<Real>(Ty), sum<Real>(Tz)}};
  }

  for (std::size_t a = 0; a < groups.size(); ++a) {
    const ChargeGroup& A = groups[a];
    Wrench& w = wrenches[a];
    for (int k = c.begin[a], i = A.begin; k < c.begin[a + 1]; ++k, i += N) {
      const Tile& t = c.tiles[k];
      if (A.loose()) {
        for (int l = 0; l < t.used; ++l) {
          f.x[i + l] = law.force * t.fx[l];
          f.y[i + l] = law.force * t.fy[l];
          f.z[i + l] = law.force * t.fz[l];
        }
        continue;
      }
      w.f[0] += sum<Real>(t.fx);
      w.f[1] += sum<Real>(t.fy);
      w.f[2] += sum<Real>(t.fz);
      w.t[0] += sum<Real>(t.y * t.fz - t.z * t.fy);
      w.t[1] += sum<Real>(t.z * t.fx - t.x * t.fz);
      w.t[2] += sum<Real>(t.x * t.fy - t.y * t.fx);
    }
    if (!A.loose())
      for (int d = 0; d < 3; ++d) w.f[d] *= law.force, w.t[d] *= torque;
  }
}

}  // namespace

CLAY_CLONES void act(const PairsInReach& pairs, const TileLaw& law, const std::vector<ChargeGroup>& groups, Places x,
                     ChargeTiles<float>& c, std::vector<Wrench>& wrenches, Forces f)
{
  place(groups, law, x, c);
  actOn(pairs, law, groups, c, wrenches, f);
}

CLAY_CLONES void act(const PairsInReach& pairs, const TileLaw& law, const std::vector<ChargeGroup>& groups, Places x,
                     ChargeTiles<double>& c, std::vector<Wrench>& wrenches, Forces f)
{
  place(groups, law, x, c);
  actOn(pairs, law, groups, c, wrenches, f);
}

}  // namespace clay
