// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
//
// The loop runs over blocks of pairs. What depends on the two spheres is put
// side by side first; then all of the arithmetic is done on several pairs at
// once, with masks in place of branches; then the forces are handed out.
#include "contacts/contact_kernel.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "simd/clones.h"
#include "simd/inv_sqrt.h"

namespace clay {

void ContactPairs::clear() { resize(0); }

void ContactPairs::resize(int n)
{
  i.resize(n);
  j.resize(n);
  for (auto *v : {&ri, &rj, &kn, &kt, &gamman, &gammat, &friction, &softness, &sx, &sy, &sz, &touched}) v->resize(n);
}

void ContactPairs::add(int a, int b, double ra, double rb, const ContactLaw &law, const double *shear, bool t)
{
  i.push_back(a);
  j.push_back(b);
  ri.push_back(ra);
  rj.push_back(rb);
  kn.push_back(law.kn);
  kt.push_back(law.kt);
  gamman.push_back(law.gamman);
  gammat.push_back(law.gammat);
  friction.push_back(law.friction);
  softness.push_back(1 / law.kt);
  sx.push_back(shear[0]);
  sy.push_back(shear[1]);
  sz.push_back(shear[2]);
  touched.push_back(t ? 1 : 0);
}

ContactLaw hookeLaw(double radius, double mass, double modulus, double speed, double restitution_log)
{
  const double hard = std::sqrt(radius) * modulus, e2 = restitution_log * restitution_log;
  ContactLaw law;
  law.kn = law.kt = 16.0 / 15.0 * hard * std::pow(15.0 * mass * speed * speed / (16.0 * hard), 0.2);
  law.gamman = law.gammat = std::sqrt(4.0 * mass * law.kn * e2 / (e2 + M_PI * M_PI));
  return law;
}

double WallShape::gap(const double *x) const
{
  if (!cylinder) return std::fabs(x[axis] - at);
  const double a = x[(axis + 1) % 3] - centre[0], b = x[(axis + 2) % 3] - centre[1];
  return std::fabs(std::sqrt(a * a + b * b) - at);
}

namespace {

constexpr int BLOCK = 64;

// of i against j: distance and velocity; the spin of both; then the force on
// i and the torques on both
struct Block {
  double x[3][BLOCK], v[3][BLOCK], wi[3][BLOCK], wj[3][BLOCK];
  double f[3][BLOCK], ti[3][BLOCK], tj[3][BLOCK];
  double s[3][BLOCK], touched[BLOCK];  // at walls
};

// the arrays of one block of pairs
struct Slice {
  const int *i, *j;
  const double *ri, *rj, *kn, *kt, *gamman, *gammat, *friction, *softness;
  double *sx, *sy, *sz, *touched;
};

// two numbers at once, which every processor of this kind can do
using Two = double __attribute__((vector_size(16)));

CLAY_INLINE Two two(const double *p)
{
  Two t;
  std::memcpy(&t, p, sizeof t);
  return t;
}

CLAY_INLINE void put(double *p, Two t) { std::memcpy(p, &t, sizeof t); }

// three numbers of one sphere, or their difference to those of another
struct Three {
  Two xy;
  double z;
};

CLAY_INLINE Three three(const double *p) { return {two(p), p[2]}; }
CLAY_INLINE Three three(const double *p, const double *q) { return {two(p) - two(q), p[2] - q[2]}; }

CLAY_INLINE void put(double (&to)[3][BLOCK], int k, Three a, Three b)
{
  put(&to[0][k], Two{a.xy[0], b.xy[0]});
  put(&to[1][k], Two{a.xy[1], b.xy[1]});
  put(&to[2][k], Two{a.z, b.z});
}

CLAY_INLINE void gather(Block &b, const ContactSpheres &s, const Slice &p, int n)
{
  for (int k = 0; k < n; k += 2) {
    const int l = std::min(k + 1, n - 1);  // an odd one out fills the next place as well
    const std::size_t ia = 3 * static_cast<std::size_t>(p.i[k]), ja = 3 * static_cast<std::size_t>(p.j[k]);
    const std::size_t ib = 3 * static_cast<std::size_t>(p.i[l]), jb = 3 * static_cast<std::size_t>(p.j[l]);
    put(b.x, k, three(s.x + ia, s.x + ja), three(s.x + ib, s.x + jb));
    put(b.v, k, three(s.v + ia, s.v + ja), three(s.v + ib, s.v + jb));
    put(b.wi, k, three(s.omega + ia), three(s.omega + ib));
    put(b.wj, k, three(s.omega + ja), three(s.omega + jb));
  }
}

// of i against the point of the wall that is nearest to it
CLAY_INLINE void gather(Block &b, const ContactSpheres &s, const Slice &p, const WallShape &wall, const double *history,
                        int n)
{
  const Three none = {Two{0, 0}, 0};
  for (int k = 0; k < n; k += 2) {
    const int l = std::min(k + 1, n - 1);
    const std::size_t i = 3 * static_cast<std::size_t>(p.i[k]), j = 3 * static_cast<std::size_t>(p.i[l]);
    put(b.x, k, three(s.x + i), three(s.x + j));
    put(b.v, k, three(s.v + i), three(s.v + j));
    put(b.wi, k, three(s.omega + i), three(s.omega + j));
    put(b.wj, k, none, none);
    put(b.s, k, three(history + i), three(history + j));
    put(&b.touched[k], Two{0, 0});
  }
  double *x = b.x[wall.axis], *y = b.x[(wall.axis + 1) % 3], *z = b.x[(wall.axis + 2) % 3];
  if (!wall.cylinder) {
#pragma omp simd simdlen(8)
    for (int k = 0; k < n; ++k) {
      x[k] -= wall.at;
      y[k] = z[k] = 0;
    }
    return;
  }
#pragma omp simd simdlen(8)
  for (int k = 0; k < n; ++k) {
    const double dy = y[k] - wall.centre[0], dz = z[k] - wall.centre[1];
    const double r2 = dy * dy + dz * dz, r = std::sqrt(r2 > 1e-200 ? r2 : 1e-200), part = (r - wall.at) / r;
    x[k] = 0;
    y[k] = dy * part;
    z[k] = dz * part;
  }
}

CLAY_INLINE void act(Block &b, const Slice &s, double dt, double fresh, double least, int n)
{
#pragma omp simd simdlen(8)
  for (int k = 0; k < n; ++k) {
    const double dx = b.x[0][k], dy = b.x[1][k], dz = b.x[2][k];
    const double r2 = dx * dx + dy * dy + dz * dz, reach = s.ri[k] + s.rj[k];
    const double rinv = invSqrt(r2), r = r2 * rinv, delta = reach - r;
    const bool touch = r2 < reach * reach;
    const double nx = dx * rinv, ny = dy * rinv, nz = dz * rinv;

    // velocity at the contact, normal and tangential
    const double vx = b.v[0][k], vy = b.v[1][k], vz = b.v[2][k];
    const double vn = vx * nx + vy * ny + vz * nz, half = 0.5 * delta;
    const double ci = s.ri[k] - half, cj = s.rj[k] - half;
    const double wx = ci * b.wi[0][k] + cj * b.wj[0][k];
    const double wy = ci * b.wi[1][k] + cj * b.wj[1][k];
    const double wz = ci * b.wi[2][k] + cj * b.wj[2][k];
    const double tx = vx - vn * nx - (nz * wy - ny * wz);
    const double ty = vy - vn * ny - (nx * wz - nz * wx);
    const double tz = vz - vn * nz - (ny * wx - nx * wy);

    const double pull = s.kn[k] * delta - s.gamman[k] * vn;
    const double fn = pull > least ? pull : least;

    // tangential displacement
    const double ox = s.sx[k], oy = s.sy[k], oz = s.sz[k];
    const double gx = ox + tx * dt, gy = oy + ty * dt, gz = oz + tz * dt;
    const double out = fresh * (gx * nx + gy * ny + gz * nz);
    const double hx = gx - out * nx, hy = gy - out * ny, hz = gz - out * nz;
    const double h2 = hx * hx + hy * hy + hz * hz;
    const double hinv = invSqrt(h2 > 1e-200 ? h2 : 1e-200);
    const double spring = s.kt[k] * (h2 * hinv), limit = s.friction[k] * std::fabs(fn);
    const bool slide = spring > limit;
    const double part = limit * hinv * s.softness[k];
    const double share = slide ? part : 1.0, damp = slide ? 0.0 : s.gammat[k];
    const double ax = share * hx, ay = share * hy, az = share * hz;
    const double ux = -s.kt[k] * ax - damp * tx;
    const double uy = -s.kt[k] * ay - damp * ty;
    const double uz = -s.kt[k] * az - damp * tz;

    const bool keep = !touch || fresh == 0.0;
    s.sx[k] = keep ? ox : ax;
    s.sy[k] = keep ? oy : ay;
    s.sz[k] = keep ? oz : az;
    s.touched[k] = touch ? 1.0 : s.touched[k];

    const double qx = ny * uz - nz * uy, qy = nz * ux - nx * uz, qz = nx * uy - ny * ux;
    const double fx = fn * nx + ux, fy = fn * ny + uy, fz = fn * nz + uz;
    b.f[0][k] = touch ? fx : 0.0;
    b.f[1][k] = touch ? fy : 0.0;
    b.f[2][k] = touch ? fz : 0.0;
    const double mi = touch ? -ci : 0.0, mj = touch ? -cj : 0.0;
    b.ti[0][k] = mi * qx;
    b.ti[1][k] = mi * qy;
    b.ti[2][k] = mi * qz;
    b.tj[0][k] = mj * qx;
    b.tj[1][k] = mj * qy;
    b.tj[2][k] = mj * qz;
  }
}

CLAY_INLINE void add(double *to, const double (&from)[3][BLOCK], int k, double sign)
{
  put(to, two(to) + sign * Two{from[0][k], from[1][k]});
  to[2] += sign * from[2][k];
}

CLAY_INLINE void scatter(const Block &b, const ContactSpheres &s, const Slice &p, int n)
{
  for (int k = 0; k < n; ++k) {
    const std::size_t i = 3 * static_cast<std::size_t>(p.i[k]), j = 3 * static_cast<std::size_t>(p.j[k]);
    add(s.f + i, b.f, k, 1);
    add(s.torque + i, b.ti, k, 1);
    if (p.j[k] >= s.owned) continue;
    add(s.f + j, b.f, k, -1);
    add(s.torque + j, b.tj, k, 1);
  }
}

// returns how many touch
CLAY_INLINE int scatter(const Block &b, const ContactSpheres &s, const Slice &p, double *history, int n)
{
  double touching = 0;
  for (int k = 0; k < n; ++k) {
    const std::size_t i = 3 * static_cast<std::size_t>(p.i[k]);
    add(s.f + i, b.f, k, 1);
    add(s.torque + i, b.ti, k, 1);
    put(history + i, b.touched[k] * Two{b.s[0][k], b.s[1][k]});
    history[i + 2] = b.touched[k] * b.s[2][k];
    touching += b.touched[k];
  }
  return static_cast<int>(touching);
}

CLAY_CLONES int everyBlockAtWall(const ContactSpheres &spheres, ContactPairs &p, const WallShape &wall, double *history,
                                 double dt, double fresh, double least)
{
  alignas(64) Block b;
  const int size = p.size();
  int touching = 0;
  for (int k = 0; k < size; k += BLOCK) {
    const int n = std::min(BLOCK, size - k);
    const Slice s = {&p.i[k],      &p.j[k],        &p.ri[k],       &p.rj[k], &p.kn[k], &p.kt[k], &p.gamman[k],
                     &p.gammat[k], &p.friction[k], &p.softness[k], b.s[0],   b.s[1],   b.s[2],   b.touched};
    gather(b, spheres, s, wall, history, n);
    act(b, s, dt, fresh, least, n);
    touching += scatter(b, spheres, s, history, n);
  }
  return touching;
}

CLAY_CLONES void everyBlock(const ContactSpheres &spheres, ContactPairs &p, double dt, double fresh, double least)
{
  alignas(64) Block b;
  const int size = p.size();
  for (int k = 0; k < size; k += BLOCK) {
    const int n = std::min(BLOCK, size - k);
    const Slice s = {&p.i[k],      &p.j[k],        &p.ri[k],       &p.rj[k], &p.kn[k], &p.kt[k], &p.gamman[k],
                     &p.gammat[k], &p.friction[k], &p.softness[k], &p.sx[k], &p.sy[k], &p.sz[k], &p.touched[k]};
    gather(b, spheres, s, n);
    act(b, s, dt, fresh, least, n);
    scatter(b, spheres, s, n);
  }
}

// square of the longest way of any of n points
CLAY_CLONES double farthest(const double *x, const double *was, int n)
{
  double most = 0;
#pragma omp simd reduction(max : most)
  for (int k = 0; k < n; ++k) {
    const double dx = x[3 * k] - was[3 * k], dy = x[3 * k + 1] - was[3 * k + 1], dz = x[3 * k + 2] - was[3 * k + 2];
    most = std::max(most, dx * dx + dy * dy + dz * dz);
  }
  return most;
}

}  // namespace

bool stayed(const double *x, const double *was, int n, double reach) { return farthest(x, was, n) < reach * reach; }

void contactForces(const ContactSpheres &spheres, ContactPairs &pairs, double dt, bool update, bool limit)
{
  everyBlock(spheres, pairs, update ? dt : 0.0, update ? 1.0 : 0.0, limit ? 0.0 : -HUGE_VAL);
}

int wallForces(const ContactSpheres &spheres, ContactPairs &pairs, const WallShape &wall, double *history, double dt,
               bool update, bool limit)
{
  return everyBlockAtWall(spheres, pairs, wall, history, update ? dt : 0.0, update ? 1.0 : 0.0,
                          limit ? 0.0 : -HUGE_VAL);
}

}  // namespace clay
