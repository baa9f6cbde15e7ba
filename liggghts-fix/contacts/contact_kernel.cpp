// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
//
// The loop runs over blocks of pairs. What depends on the two spheres is put
// side by side first; then all of the arithmetic is done on several pairs at
// once (contact_act.cpp); then the forces are handed out.
#include "contacts/contact_kernel.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "contacts/contact_block.h"
#include "simd/clones.h"

namespace clay {

bool ContactLaw::operator==(const ContactLaw &o) const
{
  return kn == o.kn && kt == o.kt && gamman == o.gamman && gammat == o.gammat && friction == o.friction &&
      rolling == o.rolling && radius == o.radius && cohesion == o.cohesion;
}

void ContactPairs::clear()
{
  i.clear();
  j.clear();
  for (auto *v : {&ri, &rj, &kn, &kt, &gamman, &gammat, &friction, &softness, &reach, &rolling, &cohesion, &sx, &sy,
                  &sz, &qx, &qy, &qz, &touched})
    v->clear();
  alike_ = true;
}

void ContactPairs::putLaw(double ra, double rb, const ContactLaw &law, int times)
{
  const auto put = [times](std::vector<double> &v, double value) { v.insert(v.end(), times, value); };
  put(ri, ra);
  put(rj, rb);
  put(kn, law.kn);
  put(kt, law.kt);
  put(gamman, law.gamman);
  put(gammat, law.gammat);
  put(friction, law.friction);
  put(softness, 1 / law.kt);
  if (kind.rolling != RollingTorque::none) {
    put(reach, law.radius);
    put(rolling, law.rolling);
  }
  if (kind.cohesion) put(cohesion, law.cohesion);
}

void ContactPairs::add(int a, int b, double ra, double rb, const ContactLaw &law, const double *history, bool t)
{
  if (i.empty()) {
    first_[0] = ra;
    first_[1] = rb;
    law_ = law;
    putLaw(ra, rb, law, CONTACT_BLOCK);
  } else if (alike_ && (ra != first_[0] || rb != first_[1] || !(law == law_))) {
    alike_ = false;
    for (auto *v : {&ri, &rj, &kn, &kt, &gamman, &gammat, &friction, &softness, &reach, &rolling, &cohesion})
      v->clear();
    putLaw(first_[0], first_[1], law_, size());
  }
  if (!alike_) putLaw(ra, rb, law, 1);
  i.push_back(a);
  j.push_back(b);
  touched.push_back(t ? 1 : 0);
  if (kind.shears())
    for (auto *v : {&sx, &sy, &sz}) v->push_back(*history++);
  if (kind.rolling == RollingTorque::sprung)
    for (auto *v : {&qx, &qy, &qz}) v->push_back(*history++);
}

void ContactPairs::tell(int k, double *history) const
{
  if (kind.shears())
    for (auto *v : {&sx, &sy, &sz}) *history++ = (*v)[k];
  if (kind.rolling == RollingTorque::sprung)
    for (auto *v : {&qx, &qy, &qz}) *history++ = (*v)[k];
}

ContactLaw hookeLaw(double radius, double mass, double modulus, double speed, double restitution_log)
{
  const double hard = std::sqrt(radius) * modulus, e2 = restitution_log * restitution_log;
  ContactLaw law;
  law.kn = law.kt = 16.0 / 15.0 * hard * std::pow(15.0 * mass * speed * speed / (16.0 * hard), 0.2);
  law.gamman = law.gammat = std::sqrt(4.0 * mass * law.kn * e2 / (e2 + M_PI * M_PI));
  return law;
}

ContactLaw hertzLaw(double radius, double mass, double modulus, double shear_modulus, double beta)
{
  const double root = std::sqrt(radius), damp = -2.0 * std::sqrt(5.0 / 6.0) * beta;
  ContactLaw law;
  law.kn = 4.0 / 3.0 * modulus * root;
  law.kt = 8.0 * shear_modulus * root;
  law.gamman = damp * std::sqrt(2.0 * modulus * root * mass);
  law.gammat = damp * std::sqrt(law.kt * mass);
  return law;
}

double WallShape::gap(const double *x) const
{
  if (!cylinder) return std::fabs(x[axis] - at);
  const double a = x[(axis + 1) % 3] - centre[0], b = x[(axis + 2) % 3] - centre[1];
  return std::fabs(std::sqrt(a * a + b * b) - at);
}

namespace {

constexpr int BLOCK = CONTACT_BLOCK;
typedef ContactBlock Block;
typedef ContactSlice Slice;

// where there is no cohesion
const double nothing[BLOCK] = {};

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

CLAY_CLONES void gather(Block &b, const ContactSpheres &s, const Slice &p, int n)
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
CLAY_CLONES void gatherAtWall(Block &b, const ContactSpheres &s, const Slice &p, const WallShape &wall, int n)
{
  const Three none = {Two{0, 0}, 0};
  for (int k = 0; k < n; k += 2) {
    const int l = std::min(k + 1, n - 1);
    const std::size_t i = 3 * static_cast<std::size_t>(p.i[k]), j = 3 * static_cast<std::size_t>(p.i[l]);
    put(b.x, k, three(s.x + i), three(s.x + j));
    put(b.v, k, three(s.v + i), three(s.v + j));
    put(b.wi, k, three(s.omega + i), three(s.omega + j));
    put(b.wj, k, none, none);
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

CLAY_INLINE void add(double *to, const double (&from)[3][BLOCK], int k, double sign)
{
  put(to, two(to) + sign * Two{from[0][k], from[1][k]});
  to[2] += sign * from[2][k];
}

CLAY_CLONES void scatter(const Block &b, const ContactSpheres &s, const Slice &p, int n)
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
int scatterAtWall(const Block &b, const ContactSpheres &s, const Slice &p, double *history, int width, int n)
{
  double touching = 0;
  for (int k = 0; k < n; ++k) {
    const std::size_t i = 3 * static_cast<std::size_t>(p.i[k]);
    add(s.f + i, b.f, k, 1);
    add(s.torque + i, b.ti, k, 1);
    double *row = history + static_cast<std::size_t>(width) * p.i[k];
    for (int d = 0; d < width; ++d) row[d] = b.touched[k] * b.s[d][k];
    touching += b.touched[k];
  }
  return static_cast<int>(touching);
}

Slice slice(ContactPairs &p, int k)
{
  const auto from = [k](std::vector<double> &v) { return v.empty() ? nullptr : &v[k]; };
  const auto law = [at = p.alike() ? 0 : k](const std::vector<double> &v) { return v.empty() ? nullptr : &v[at]; };
  Slice s = {&p.i[k],      &p.j[k],        law(p.ri),       law(p.rj),       law(p.kn),
             law(p.kt),    law(p.gamman),  law(p.gammat),   law(p.friction), law(p.softness),
             law(p.reach), law(p.rolling), law(p.cohesion), from(p.sx),      from(p.sy),
             from(p.sz),   from(p.qx),     from(p.qy),      from(p.qz),      &p.touched[k]};
  if (!s.cohesion) s.cohesion = nothing;
  return s;
}

ContactStep stepOf(const ContactKind &kind, double dt, bool update, bool wall)
{
  ContactStep s;
  s.dt = update ? dt : 0.0;
  s.roll = dt;
  s.fresh = update ? 1.0 : 0.0;
  s.least = kind.limit ? 0.0 : -HUGE_VAL;
  s.reduce = kind.reduce ? 1.0 : 0.0;
  s.still = kind.torsion ? 0.0 : 1.0;
  s.wall = wall;
  return s;
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

void contactForces(const ContactSpheres &spheres, ContactPairs &pairs, double dt, bool update)
{
  alignas(64) Block b;
  const ContactAct act = contactAct(pairs.kind), roll = rollingAct(pairs.kind);
  const ContactStep step = stepOf(pairs.kind, dt, update, false);
  const int size = pairs.size();
  for (int k = 0; k < size; k += BLOCK) {
    const int n = std::min(BLOCK, size - k);
    const Slice s = slice(pairs, k);
    gather(b, spheres, s, n);
    act(b, s, step, n);
    if (roll) roll(b, s, step, n);
    scatter(b, spheres, s, n);
  }
}

int wallForces(const ContactSpheres &spheres, ContactPairs &pairs, const WallShape &wall, double *history, double dt,
               bool update)
{
  alignas(64) Block b;
  const ContactAct act = contactAct(pairs.kind), roll = rollingAct(pairs.kind);
  const ContactStep step = stepOf(pairs.kind, dt, update, true);
  const int size = pairs.size(), shears = pairs.kind.shears(), width = pairs.kind.history();
  int touching = 0;
  for (int k = 0; k < size; k += BLOCK) {
    const int n = std::min(BLOCK, size - k);
    Slice s = slice(pairs, k);
    s.sx = b.s[0];
    s.sy = b.s[1];
    s.sz = b.s[2];
    s.qx = b.s[shears];
    s.qy = b.s[shears + 1];
    s.qz = b.s[shears + 2];
    s.touched = b.touched;
    for (int d = 0; d < width; ++d)
      for (int c = 0; c < n; ++c) b.s[d][c] = history[static_cast<std::size_t>(width) * s.i[c] + d];
    std::fill_n(b.touched, n, 0.0);
    gatherAtWall(b, spheres, s, wall, n);
    act(b, s, step, n);
    if (roll) roll(b, s, step, n);
    touching += scatterAtWall(b, spheres, s, history, width, n);
  }
  return touching;
}

}  // namespace clay
