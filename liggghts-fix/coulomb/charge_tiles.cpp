// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coulomb/charge_tiles.h"

#include <algorithm>

#include "simd/clones.h"
#include "simd/exp.h"
#include "simd/inv_sqrt.h"

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

template <class Real>
void ChargeTiles<Real>::takeRadii(const std::vector<ChargeGroup>& groups, const std::vector<double>& radius)
{
  radii.assign(tiles.size(), Radii());
  for (std::size_t g = 0; g < groups.size(); ++g)
    for (int k = begin[g], i = groups[g].begin; k < begin[g + 1]; ++k, i += LANES)
      for (int l = 0; l < tiles[k].used; ++l) radii[k].r[l] = static_cast<Real>(radius[i + l]);
}

template struct ChargeTiles<float>;
template struct ChargeTiles<double>;

namespace {

template <class Real, int BYTES>
CLAY_INLINE double sum(const typename Pack<Real, BYTES>::Numbers& v)
{
  double s = 0;
  for (int l = 0; l < Pack<Real, BYTES>::SIZE; ++l) s += v[l];
  return s;
}

template <class Numbers, class Real>
CLAY_INLINE Numbers& pack(Real* at)
{
  return *reinterpret_cast<Numbers*>(at);
}

template <class Numbers, class Real>
CLAY_INLINE const Numbers& pack(const Real* at)
{
  return *reinterpret_cast<const Numbers*>(at);
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
      for (int l = 0; l < N; ++l) t.fx[l] = t.fy[l] = t.fz[l] = 0;
#pragma omp simd
      for (int l = 0; l < t.used; ++l) {
        t.x[l] = static_cast<Real>(length * (x.x[i + l] - group.x));
        t.y[l] = static_cast<Real>(length * (x.y[i + l] - group.y));
        t.z[l] = static_cast<Real>(length * (x.z[i + l] - group.z));
      }
    }
  }
}

/// Spheres of a group that a group at D may reach, from its centre.
template <class Real>
struct Rows {
  Real x[ChargeTiles<Real>::LANES], y[ChargeTiles<Real>::LANES], z[ChargeTiles<Real>::LANES];
  int near[ChargeTiles<Real>::LANES], at[ChargeTiles<Real>::LANES], count;

  CLAY_INLINE void choose(const typename ChargeTiles<Real>::Tile& t, const Real* D, Real near2)
  {
    const Real dx = D[0], dy = D[1], dz = D[2];
#pragma omp simd
    for (int i = 0; i < ChargeTiles<Real>::LANES; ++i) {
      x[i] = t.x[i] - dx;
      y[i] = t.y[i] - dy;
      z[i] = t.z[i] - dz;
      near[i] = x[i] * x[i] + y[i] * y[i] + z[i] * z[i] < near2 ? 1 : 0;
    }
    int n = 0;
    for (int i = 0; i < t.used; ++i) {
      at[n] = i;
      n += near[i];
    }
    count = n;
  }
};

enum class Kind { sharp, screened, dlvo };

// A row is a sphere of the first group, which meets a register of the second at once.
// Only the forces on the second are kept, lane by lane: those on the first are the
// opposite, with the same lever.
template <class Real, int BYTES, Kind KIND, class Law>
CLAY_INLINE void actOn(const PairsInReach& pairs, const Law& law, const std::vector<ChargeGroup>& groups,
                       ChargeTiles<Real>& c, std::vector<Wrench>& wrenches)
{
  typedef typename ChargeTiles<Real>::Tile Tile;
  typedef typename Pack<Real, BYTES>::Numbers Numbers;
  constexpr int N = ChargeTiles<Real>::LANES, PART = Pack<Real, BYTES>::SIZE;
  const Numbers zero = {};
  const Real shift = static_cast<Real>(law.shift), least = leastOf(Real());
  const Real decay = static_cast<Real>(law.decay), from = static_cast<Real>(law.decay * law.near);
  const double length = 1 / law.cutoff;
  Rows<Real> row;

  for (std::size_t a = 0; a < groups.size(); ++a) {
    const ChargeGroup& A = groups[a];
    Numbers Fx = zero, Fy = zero, Fz = zero, Tx = zero, Ty = zero, Tz = zero;

    for (int p = pairs.first[a]; p < pairs.first[a + 1]; ++p) {
      const int b = pairs.second[p];
      const ChargeGroup& B = groups[b];
      const double dx = B.x - A.x, dy = B.y - A.y, dz = B.z - A.z, d2 = dx * dx + dy * dy + dz * dz;
      const double outer = law.cutoff + A.r + B.r, inner = law.cutoff - A.r - B.r;
      if (d2 >= outer * outer) continue;
      const bool whole = inner > 0 && d2 < inner * inner;
      const Real D[3] = {Real(length * dx), Real(length * dy), Real(length * dz)};
      // a sphere farther from B than this has none of it within the cut-off
      const double reach = 1.00001 * (1 + length * B.r);
      const Real near2 = Real(whole ? 1e30 : reach * reach);

      for (int ta = c.begin[a]; ta < c.begin[a + 1]; ++ta) {
        const Tile& one = c.tiles[ta];
        row.choose(one, D, near2);

        for (int tb = c.begin[b]; tb < c.begin[b + 1]; ++tb)
          for (int part = 0; part < N; part += PART) {
            Tile& other = c.tiles[tb];
            const Numbers x = pack<Numbers>(other.x + part), y = pack<Numbers>(other.y + part),
                          z = pack<Numbers>(other.z + part), q = pack<Numbers>(other.q + part);
            Numbers fx = zero, fy = zero, fz = zero, otherRadii = zero;
            const Real* ownRadii = nullptr;
            if constexpr (KIND == Kind::dlvo) {
              otherRadii = pack<Numbers>(c.radii[tb].r + part);
              ownRadii = c.radii[ta].r;
            }
            for (int k = 0; k < row.count; ++k) {
              const int i = row.at[k];
              const Numbers ex = x - row.x[i], ey = y - row.y[i], ez = z - row.z[i];
              const Numbers r2 = ex * ex + (ey * ey + (ez * ez + least));
              Numbers inv;
              invSqrt<BYTES>(r2, inv);
              if constexpr (KIND == Kind::dlvo) {
                const Numbers ri = zero + length * ownRadii[i], rj = length * otherRadii;
                Numbers h = r2 * inv - ri - rj;
                const Numbers within = h < law.gap ? inv : zero;
                h = h > law.contact ? h : zero + law.contact;
                Numbers layers;
                expOf<BYTES>(-decay * h, layers);
                const Numbers late = h * h * (1 + law.retardation * h);
                const Numbers w =
                    within * (ri * rj / (ri + rj)) * (law.repulsion * one.q[i] * q * layers - law.attraction / late);
                fx += w * ex;
                fy += w * ey;
                fz += w * ez;
                continue;
              }
              Numbers slope = inv * inv;
              if (KIND == Kind::screened) {
                const Numbers power = from - decay * (r2 * inv), most = zero + Real(screeningMost);
                Numbers screening;
                expOf<BYTES>(power < most ? power : most, screening);
                slope = screening * (inv * (inv + decay));
              }
              const Numbers uncut = (slope - shift) * (inv * one.q[i]);
              const Numbers w = r2 < Real(1) ? uncut : zero;
              fx += w * ex;
              fy += w * ey;
              fz += w * ez;
            }
            if constexpr (KIND != Kind::dlvo) {
              fx *= q;
              fy *= q;
              fz *= q;
            }
            pack<Numbers>(other.fx + part) += fx;
            pack<Numbers>(other.fy + part) += fy;
            pack<Numbers>(other.fz + part) += fz;
            if (A.loose()) continue;
            const Numbers lx = x + D[0], ly = y + D[1], lz = z + D[2];
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
      wrenches[a] = {{sum<Real, BYTES>(Fx), sum<Real, BYTES>(Fy), sum<Real, BYTES>(Fz)},
                     {sum<Real, BYTES>(Tx), sum<Real, BYTES>(Ty), sum<Real, BYTES>(Tz)}};
  }
}

template <class Real>
CLAY_INLINE void addUp(const TileLaw& law, const std::vector<ChargeGroup>& groups, const ChargeTiles<Real>& c,
                       std::vector<Wrench>& wrenches, Forces f)
{
  constexpr int N = ChargeTiles<Real>::LANES;
  const double torque = law.force * law.cutoff;
  for (std::size_t a = 0; a < groups.size(); ++a) {
    const ChargeGroup& A = groups[a];
    Wrench& w = wrenches[a];
    for (int k = c.begin[a], i = A.begin; k < c.begin[a + 1]; ++k, i += N) {
      const auto& t = c.tiles[k];
      if (A.loose()) {
        for (int l = 0; l < t.used; ++l) {
          f.x[i + l] = law.force * t.fx[l];
          f.y[i + l] = law.force * t.fy[l];
          f.z[i + l] = law.force * t.fz[l];
        }
        continue;
      }
      double Fx = 0, Fy = 0, Fz = 0, Tx = 0, Ty = 0, Tz = 0;
#pragma omp simd reduction(+ : Fx, Fy, Fz, Tx, Ty, Tz)
      for (int l = 0; l < N; ++l) {
        const double fx = t.fx[l], fy = t.fy[l], fz = t.fz[l];
        Fx += fx;
        Fy += fy;
        Fz += fz;
        Tx += t.y[l] * fz - t.z[l] * fy;
        Ty += t.z[l] * fx - t.x[l] * fz;
        Tz += t.x[l] * fy - t.y[l] * fx;
      }
      const double sum[6] = {Fx, Fy, Fz, Tx, Ty, Tz};
      for (int d = 0; d < 3; ++d) w.f[d] += sum[d], w.t[d] += sum[3 + d];
    }
    if (A.loose()) continue;
    for (int d = 0; d < 3; ++d) w.f[d] *= law.force, w.t[d] *= torque;
  }
}

template <int BYTES, Kind KIND, class Real, class Law>
CLAY_INLINE void allOf(const PairsInReach& pairs, const Law& law, const std::vector<ChargeGroup>& groups, Places x,
                       ChargeTiles<Real>& c, std::vector<Wrench>& wrenches, Forces f)
{
  place(groups, law, x, c);
  actOn<Real, BYTES, KIND>(pairs, law, groups, c, wrenches);
  addUp(law, groups, c, wrenches, f);
}

// a function for each law: what one needs takes no register from the other
#define CLAY_TILES(GENERATION, BYTES, REAL)                                                                            \
  GENERATION static void tiles(const PairsInReach& pairs, const TileLaw& law, const std::vector<ChargeGroup>& groups,  \
                               Places x, ChargeTiles<REAL>& c, std::vector<Wrench>& wrenches, Forces f)                \
  {                                                                                                                    \
    allOf<BYTES, Kind::sharp>(pairs, law, groups, x, c, wrenches, f);                                                  \
  }                                                                                                                    \
  GENERATION static void screened(const PairsInReach& pairs, const TileLaw& law,                                       \
                                  const std::vector<ChargeGroup>& groups, Places x, ChargeTiles<REAL>& c,              \
                                  std::vector<Wrench>& wrenches, Forces f)                                             \
  {                                                                                                                    \
    allOf<BYTES, Kind::screened>(pairs, law, groups, x, c, wrenches, f);                                               \
  }
#define CLAY_TILES_DLVO(GENERATION, BYTES)                                                                             \
  GENERATION static void dlvo(const PairsInReach& pairs, const DlvoTileLaw& law,                                       \
                              const std::vector<ChargeGroup>& groups, Places x, ChargeTiles<double>& c,                \
                              std::vector<Wrench>& wrenches, Forces f)                                                 \
  {                                                                                                                    \
    allOf<BYTES, Kind::dlvo>(pairs, law, groups, x, c, wrenches, f);                                                   \
  }
#ifdef CLAY_GENERATIONS
CLAY_TILES(CLAY_FOR_WIDEST, 64, float)
CLAY_TILES(CLAY_FOR_WIDEST, 64, double)
CLAY_TILES_DLVO(CLAY_FOR_WIDEST, 64)
CLAY_TILES(CLAY_FOR_WIDE, 32, float)
CLAY_TILES(CLAY_FOR_WIDE, 32, double)
CLAY_TILES_DLVO(CLAY_FOR_WIDE, 32)
CLAY_TILES(CLAY_FOR_ANY, 16, float)
CLAY_TILES(CLAY_FOR_ANY, 16, double)
CLAY_TILES_DLVO(CLAY_FOR_ANY, 16)
#else
CLAY_TILES(CLAY_CLONES, CLAY_BYTES, float)
CLAY_TILES(CLAY_CLONES, CLAY_BYTES, double)
CLAY_TILES_DLVO(CLAY_CLONES, CLAY_BYTES)
#endif

}  // namespace

void act(const PairsInReach& pairs, const TileLaw& law, const std::vector<ChargeGroup>& groups, Places x,
         ChargeTiles<float>& c, std::vector<Wrench>& wrenches, Forces f)
{
  if (law.decay > 0) screened(pairs, law, groups, x, c, wrenches, f);
  else tiles(pairs, law, groups, x, c, wrenches, f);
}

void act(const PairsInReach& pairs, const TileLaw& law, const std::vector<ChargeGroup>& groups, Places x,
         ChargeTiles<double>& c, std::vector<Wrench>& wrenches, Forces f)
{
  if (law.decay > 0) screened(pairs, law, groups, x, c, wrenches, f);
  else tiles(pairs, law, groups, x, c, wrenches, f);
}

void act(const PairsInReach& pairs, const DlvoTileLaw& law, const std::vector<ChargeGroup>& groups, Places x,
         ChargeTiles<double>& c, std::vector<Wrench>& wrenches, Forces f)
{
  dlvo(pairs, law, groups, x, c, wrenches, f);
}

}  // namespace clay
