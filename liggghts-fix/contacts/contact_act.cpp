// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
//
// The forces of a block of pairs, several at once, with masks in place of branches.
// A kind of law has a loop of its own, made of one text.
#include <cmath>

#include "contacts/contact_block.h"
#include "simd/clones.h"
#include "simd/inv_sqrt.h"

namespace clay {

namespace {

constexpr double least = 1e-200;  // whose root is taken in place of 0's

template <NormalForce NORMAL, TangentialForce TANGENTIAL, bool MORE>
CLAY_INLINE void act(ContactBlock &b, const ContactSlice &s, const ContactStep &step, int n)
{
  // numbers of the loop's own: a choice by what stands elsewhere keeps it from working on several pairs at once
  const double dt = step.dt, fresh = step.fresh, least_pull = step.least, reduce = step.reduce;
  const double wall = step.wall ? 1.0 : 0.0;
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

    // stiffness and damping at this overlap
    double kn = s.kn[k], kt = s.kt[k], gamman = s.gamman[k], gammat = s.gammat[k], soft = 1.0;
    if (NORMAL != NormalForce::linear) {
      const double held = delta > least ? delta : least;
      soft = invSqrt(held);
      const double root = held * soft, damp = NORMAL == NormalForce::hertz ? root * invSqrt(root) : root;
      kn *= root;
      kt *= root;
      gamman *= damp;
      gammat *= damp;
    }
    const double elastic = kn * delta, pull = elastic - gamman * vn;
    double fn = pull > least_pull ? pull : least_pull, grip = fn;
    if (MORE) {  // cohesion
      const double gi = r - s.ri[k], gj = r - s.rj[k];
      const double lens = -0.25 * (r - reach) * (gi + s.rj[k]) * (gj + s.ri[k]) * (r + reach) * rinv * rinv;
      const double cap = -gi * (r + s.ri[k]), held = -s.cohesion[k] * M_PI * (wall * cap + (1.0 - wall) * lens);
      fn += held;
      grip += reduce * held;
    }
    const double limit = s.friction[k] * std::fabs(grip);

    double ux = 0.0, uy = 0.0, uz = 0.0;
    if (TANGENTIAL == TangentialForce::damped) {
      const double t2 = tx * tx + ty * ty + tz * tz, tinv = invSqrt(t2 > least ? t2 : least);
      const double most = limit * tinv, damp = most < gammat ? most : gammat;
      ux = -damp * tx;
      uy = -damp * ty;
      uz = -damp * tz;
    }
    if (TANGENTIAL == TangentialForce::sprung) {
      const double ox = s.sx[k], oy = s.sy[k], oz = s.sz[k];
      const double gx = ox + tx * dt, gy = oy + ty * dt, gz = oz + tz * dt;
      const double out = fresh * (gx * nx + gy * ny + gz * nz);
      const double hx = gx - out * nx, hy = gy - out * ny, hz = gz - out * nz;
      const double h2 = hx * hx + hy * hy + hz * hz;
      const double hinv = invSqrt(h2 > least ? h2 : least);
      const bool slide = kt * (h2 * hinv) > limit;
      const double part = limit * hinv * s.softness[k] * soft;
      const double share = slide ? part : 1.0, damp = slide ? 0.0 : gammat;
      const double ax = share * hx, ay = share * hy, az = share * hz;
      ux = -kt * ax - damp * tx;
      uy = -kt * ay - damp * ty;
      uz = -kt * az - damp * tz;

      const bool keep = !touch || fresh == 0.0;
      s.sx[k] = keep ? ox : ax;
      s.sy[k] = keep ? oy : ay;
      s.sz[k] = keep ? oz : az;
    }
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
    if (MORE) {  // for rolling friction
      b.n[0][k] = nx;
      b.n[1][k] = ny;
      b.n[2][k] = nz;
      b.elastic[k] = touch ? elastic : 0.0;
      b.grip[k] = touch ? std::fabs(grip) : -1.0;
      b.kt[k] = kt;
      b.level[k] = ci * rinv;
    }
  }
}

// spin of one against the other, at walls as the contact point sees it
template <RollingTorque ROLLING>
CLAY_INLINE void roll(ContactBlock &b, const ContactSlice &s, const ContactStep &step, int n)
{
  const double turns = step.roll, fresh = step.fresh, still = step.still;
  const double wall = step.wall ? 1.0 : 0.0;
#pragma omp simd simdlen(8)
  for (int k = 0; k < n; ++k) {
    const double nx = b.n[0][k], ny = b.n[1][k], nz = b.n[2][k];
    const double level = wall * b.level[k] + (1.0 - wall);
    double wx = level * (b.wi[0][k] - b.wj[0][k]);
    double wy = level * (b.wi[1][k] - b.wj[1][k]);
    double wz = level * (b.wi[2][k] - b.wj[2][k]);
    const double w2 = wx * wx + wy * wy + wz * wz;
    const double about = still * (wx * nx + wy * ny + wz * nz);
    wx -= about * nx;
    wy -= about * ny;
    wz -= about * nz;

    double tx, ty, tz;
    if (ROLLING == RollingTorque::constant) {
      // a share of the elastic force, against the spin
      const double size = s.rolling[k] * s.reach[k] * b.elastic[k] * invSqrt(w2 > least ? w2 : least);
      tx = size * wx;
      ty = size * wy;
      tz = size * wz;
    } else {
      const double ox = s.qx[k], oy = s.qy[k], oz = s.qz[k];
      const double turn = turns * b.kt[k] * s.reach[k] * s.reach[k];
      const double hx = ox + turn * wx, hy = oy + turn * wy, hz = oz + turn * wz;
      const double h2 = hx * hx + hy * hy + hz * hz;
      const double hinv = invSqrt(h2 > least ? h2 : least), most = b.grip[k] * s.reach[k] * s.rolling[k];
      const double share = h2 * hinv > most ? most * hinv : 1.0;
      tx = share * hx;
      ty = share * hy;
      tz = share * hz;
      const bool touch = b.grip[k] >= 0.0, keep = !touch || fresh == 0.0;
      s.qx[k] = keep ? ox : tx;
      s.qy[k] = keep ? oy : ty;
      s.qz[k] = keep ? oz : tz;
      tx = touch ? tx : 0.0;
      ty = touch ? ty : 0.0;
      tz = touch ? tz : 0.0;
    }
    b.ti[0][k] -= tx;
    b.ti[1][k] -= ty;
    b.ti[2][k] -= tz;
    b.tj[0][k] += tx;
    b.tj[1][k] += ty;
    b.tj[2][k] += tz;
  }
}

// NAME: each loop for several generations of processors
#define CLAY_ACT(NAME, NORMAL, TANGENTIAL, MORE)                                                                       \
  CLAY_CLONES void NAME(ContactBlock &b, const ContactSlice &s, const ContactStep &step, int n)                        \
  {                                                                                                                    \
    act<NormalForce::NORMAL, TangentialForce::TANGENTIAL, MORE>(b, s, step, n);                                        \
  }
#define CLAY_ACTS(NORMAL)                                                                                              \
  CLAY_ACT(NORMAL##None, NORMAL, none, false)                                                                          \
  CLAY_ACT(NORMAL##NoneMore, NORMAL, none, true)                                                                       \
  CLAY_ACT(NORMAL##Damped, NORMAL, damped, false)                                                                      \
  CLAY_ACT(NORMAL##DampedMore, NORMAL, damped, true)                                                                   \
  CLAY_ACT(NORMAL##Sprung, NORMAL, sprung, false)                                                                      \
  CLAY_ACT(NORMAL##SprungMore, NORMAL, sprung, true)

CLAY_ACTS(linear)
CLAY_ACTS(hertz)
CLAY_ACTS(hertzStiffness)

CLAY_CLONES void rollConstant(ContactBlock &b, const ContactSlice &s, const ContactStep &step, int n)
{
  roll<RollingTorque::constant>(b, s, step, n);
}

CLAY_CLONES void rollSprung(ContactBlock &b, const ContactSlice &s, const ContactStep &step, int n)
{
  roll<RollingTorque::sprung>(b, s, step, n);
}

#define CLAY_ROW(NORMAL)                                                                                               \
  {                                                                                                                    \
    NORMAL##None, NORMAL##NoneMore, NORMAL##Damped, NORMAL##DampedMore, NORMAL##Sprung, NORMAL##SprungMore             \
  }
const ContactAct acts[3][6] = {CLAY_ROW(linear), CLAY_ROW(hertz), CLAY_ROW(hertzStiffness)};

}  // namespace

ContactAct contactAct(const ContactKind &kind)
{
  const bool more = kind.cohesion || kind.rolling != RollingTorque::none;
  return acts[static_cast<int>(kind.normal)][2 * static_cast<int>(kind.tangential) + more];
}

ContactAct rollingAct(const ContactKind &kind)
{
  if (kind.rolling == RollingTorque::none) return nullptr;
  return kind.rolling == RollingTorque::constant ? rollConstant : rollSprung;
}

}  // namespace clay
