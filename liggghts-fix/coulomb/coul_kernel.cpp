// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coulomb/coul_kernel.h"

#include <algorithm>
#include <cmath>

#include "simd/near_pairs.h"

namespace clay {

double CoulombLaw::weight(double a) const
{
  return debye > 0 && spheres ? std::exp((a - 0.5 * near) / debye) / (1 + a / debye) : 1;
}

double CoulombLaw::forceOverDistance(double qq, double r) const
{
  if (r >= cutoff) return 0;
  return k * qq * (slope(r) - (shifted ? slope(cutoff) : 0)) / r;
}

double CoulombLaw::energy(double qq, double r) const
{
  if (r >= cutoff) return 0;
  return k * qq * (screening(r) / r - screening(cutoff) / cutoff + (shifted ? (r - cutoff) * slope(cutoff) : 0));
}

// ---- spheres and groups

void ChargeGroups::clear()
{
  for (auto* v : {&x, &y, &z, &q, &radius}) v->clear();
  groups.clear();
  was_.clear();
}

void ChargeGroups::add(double px, double py, double pz, double charge)
{
  x.push_back(px);
  y.push_back(py);
  z.push_back(pz);
  q.push_back(charge);
}

namespace {

void centre(const ChargeGroups& c, ChargeGroup& g)
{
  double s[3] = {0, 0, 0};
  for (int i = g.begin; i < g.end; ++i) {
    s[0] += c.x[i];
    s[1] += c.y[i];
    s[2] += c.z[i];
  }
  const double part = 1.0 / (g.end - g.begin);
  g.x = part * s[0];
  g.y = part * s[1];
  g.z = part * s[2];
}

void ball(const ChargeGroups& c, ChargeGroup& g)
{
  double r2 = 0;
  for (int i = g.begin; i < g.end; ++i) {
    const double dx = c.x[i] - g.x, dy = c.y[i] - g.y, dz = c.z[i] - g.z;
    r2 = std::max(r2, dx * dx + dy * dy + dz * dz);
  }
  g.r = std::sqrt(r2) * (1 + 1e-6);
}

}  // namespace

void ChargeGroups::close(long body, bool acted)
{
  ChargeGroup g = {};
  g.begin = groups.empty() ? 0 : groups.back().end;
  g.end = static_cast<int>(x.size());
  g.body = body;
  g.acted = acted;
  if (g.begin == g.end) return;
  centre(*this, g);
  ball(*this, g);
  groups.push_back(g);
}

void ChargeGroups::moved()
{
  for (ChargeGroup& g : groups) {
    centre(*this, g);
    ball(*this, g);
  }
}

// ---- who acts on whom

std::vector<std::pair<int, int>> pairsInReach(const ChargeGroups& c, double range)
{
  const int n = static_cast<int>(c.groups.size());
  std::vector<double> reach(n);
  std::vector<const double*> at(n);
  for (int g = 0; g < n; ++g) {
    at[g] = &c.groups[g].x;
    reach[g] = c.groups[g].r + 0.5 * range;
  }
  std::vector<std::pair<int, int>> pairs;
  near_pairs(at.data(), reach.data(), n, n, pairs);
  pairs.erase(std::remove_if(pairs.begin(), pairs.end(),
                             [&c](const std::pair<int, int>& p) {
                               const ChargeGroup &A = c.groups[p.first], &B = c.groups[p.second];
                               return (!A.acted && !B.acted) || (!A.loose() && A.body == B.body);
                             }),
              pairs.end());
  for (int g = 0; g < n; ++g)
    if (c.groups[g].loose() && c.groups[g].acted) pairs.emplace_back(g, g);
  return pairs;
}

void ChargeGroups::list(double range)
{
  std::vector<std::pair<int, int>> pairs = pairsInReach(*this, range);
  const std::size_t found = pairs.size();
  for (std::size_t p = 0; p < found; ++p) {
    const auto one = pairs[p];
    const bool a = groups[one.first].loose(), b = groups[one.second].loose();
    if (a && b && one.first != one.second) pairs.emplace_back(one.second, one.first);
    if (a && !b) pairs[p] = {one.second, one.first};
  }
  pairs_.first.assign(groups.size() + 1, 0);
  for (const auto& p : pairs) ++pairs_.first[p.first + 1];
  for (std::size_t g = 0; g < groups.size(); ++g) pairs_.first[g + 1] += pairs_.first[g];
  std::vector<int> next(pairs_.first.begin(), pairs_.first.end() - 1);
  pairs_.second.resize(pairs.size());
  for (const auto& p : pairs) pairs_.second[next[p.first]++] = p.second;

  was_.clear();
  for (const auto& g : groups) was_.insert(was_.end(), {g.x, g.y, g.z, g.r});
  largest_ = 0;
  for (double charge : q) largest_ = std::max(largest_, std::abs(charge));
  if (largest_ == 0) largest_ = 1;
  if (single) floats_.build(groups, q, largest_);
  else doubles_.build(groups, q, largest_);
  if (!radius.empty()) doubles_.takeRadii(groups, radius);
}

bool ChargeGroups::listHolds(double skin) const
{
  if (was_.size() != 4 * groups.size()) return false;
  for (std::size_t k = 0; k < groups.size(); ++k) {
    const ChargeGroup& g = groups[k];
    const double *w = &was_[4 * k], dx = g.x - w[0], dy = g.y - w[1], dz = g.z - w[2];
    const double left = 0.5 * skin - std::max(0.0, g.r - w[3]);
    if (left <= 0 || dx * dx + dy * dy + dz * dz > left * left) return false;
  }
  return true;
}

void ChargeGroups::refresh(double cutoff)
{
  const double skin = 0.1 * cutoff;
  wrenches.resize(groups.size());
  for (auto* f : {&fx, &fy, &fz}) f->resize(x.size());
  if (!listHolds(skin)) list(cutoff + skin);
}

void ChargeGroups::act(const CoulombLaw& law)
{
  refresh(law.cutoff);
  const double decay = law.debye > 0 ? law.cutoff / law.debye : 0;
  const double near = law.near / law.cutoff;
  const double shift = law.shifted ? std::exp(decay * (near - 1)) * (1 + decay) : 0;
  const TileLaw scaled = {law.cutoff, shift, law.k * largest_ * largest_ / (law.cutoff * law.cutoff), decay, near};
  const Places at = {x.data(), y.data(), z.data()};
  const Forces f = {fx.data(), fy.data(), fz.data()};
  if (single) clay::act(pairs_, scaled, groups, at, floats_, wrenches, f);
  else clay::act(pairs_, scaled, groups, at, doubles_, wrenches, f);
}

void ChargeGroups::act(const DlvoLaw& law)
{
  refresh(law.cutoff);
  const double most = law.repulsion(largest_ * largest_) * law.cutoff, pull = law.hamaker / (6 * law.cutoff);
  DlvoTileLaw scaled;
  scaled.cutoff = law.cutoff;
  scaled.shift = 0;
  scaled.force = most + pull;
  scaled.decay = law.cutoff / law.debye;
  if (scaled.force > 0) {
    scaled.repulsion = most / scaled.force;
    scaled.attraction = pull / scaled.force;
  }
  scaled.retardation = law.retardation > 0 ? DlvoLaw::gregory * law.cutoff / law.retardation : 0;
  scaled.contact = law.contact / law.cutoff;
  scaled.gap = law.gap / law.cutoff;
  clay::act(pairs_, scaled, groups, {x.data(), y.data(), z.data()}, doubles_, wrenches,
            {fx.data(), fy.data(), fz.data()});
}

}  // namespace clay
