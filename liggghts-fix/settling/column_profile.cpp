// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "settling/column_profile.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "settling/settling_profile.h"

namespace clay {

ColumnProfile::ColumnProfile(double lo, double hi, int slices) : lo_(lo), width_((hi - lo) / slices), slices_(slices)
{
  sums_.assign(static_cast<std::size_t>(slices) * SUMS, 0.0);
}

void ColumnProfile::clear() { std::fill(sums_.begin(), sums_.end(), 0.0); }

int ColumnProfile::slice(double z) const
{
  const double at = (z - lo_) / width_;
  return at > 0 ? static_cast<int>(std::min(at, slices_ - 1.0)) : 0;  // the first for NaN, too
}

void ColumnProfile::addSphere(double z, double r, double volume, double w)
{
  const int first = slice(z - r), last = slice(z + r);
  double before = 0;
  for (int k = first; k <= last; ++k) {
    const double now = k < last ? capShare((lo_ + (k + 1) * width_ - z) / r) : 1;
    at(VOLUME, k) += volume * (now - before);
    at(FLUX, k) += volume * (now - before) * w;
    before = now;
  }
}

void ColumnProfile::spread(Sum sum, double from, double to, double force)
{
  const double top = lo_ + slices_ * width_;
  from = std::clamp(from, lo_, top);
  to = std::clamp(to, lo_, top);
  const int first = slice(from), last = slice(to);
  for (int k = first; k <= last; ++k) {
    const double low = std::max(from, lo_ + k * width_), high = std::min(to, lo_ + (k + 1) * width_);
    if (high > low) at(sum, k) += force * (high - low) / width_;
  }
}

void ColumnProfile::addAcross(Sum sum, double lower, double upper, double force)
{
  spread(sum, std::min(lower, upper), std::max(lower, upper), upper > lower ? force : -force);
}

void ColumnProfile::addAbove(Sum sum, double z, double force) { spread(sum, lo_, z, force); }

void ColumnProfile::addAt(Sum sum, double z, double value) { at(sum, slice(z)) += value; }

void ColumnProfile::addAxis(double z, const double *n)
{
  const int k = slice(z);
  at(AXES, k) += 1;
  at(XX, k) += n[0] * n[0];
  at(YY, k) += n[1] * n[1];
  at(ZZ, k) += n[2] * n[2];
  at(XY, k) += n[0] * n[1];
  at(XZ, k) += n[0] * n[2];
  at(YZ, k) += n[1] * n[2];
}

double ColumnProfile::imbalance() const
{
  double whole = 0, worst = 0;
  for (int k = 0; k < slices_; ++k) {
    whole = std::max(whole, get(WEIGHT, k));
    const double carried = get(CONTACT, k) + get(COULOMB, k) + get(WALL, k) + get(FLUID, k);
    worst = std::max(worst, std::fabs(carried - get(WEIGHT, k)));
  }
  return whole > 0 ? worst / whole : 0;
}

ColumnProfile::Sum meeting(const double *ni, const double *nj, const double *between)
{
  double length2 = 0, i = 0, j = 0;
  for (int d = 0; d < 3; ++d) {
    length2 += between[d] * between[d];
    i += ni[d] * between[d];
    j += nj[d] * between[d];
  }
  const int faces = (2 * i * i > length2) + (2 * j * j > length2);
  return faces == 2 ? ColumnProfile::FACE_FACE : faces == 1 ? ColumnProfile::EDGE_FACE : ColumnProfile::EDGE_EDGE;
}

int axisOf(const double *moments)
{
  int order[3] = {0, 1, 2};
  std::sort(order, order + 3, [moments](int a, int b) { return moments[a] < moments[b]; });
  const double below = moments[order[1]] - moments[order[0]], above = moments[order[2]] - moments[order[1]];
  if (std::max(below, above) <= 0.01 * moments[order[2]]) return -1;
  return above >= below ? order[2] : order[0];
}

Clusters::Clusters(int members) : up_(members), size_(members, 1) { std::iota(up_.begin(), up_.end(), 0); }

int Clusters::root(int member)
{
  while (up_[member] != member) member = up_[member] = up_[up_[member]];
  return member;
}

void Clusters::join(int a, int b)
{
  a = root(a);
  b = root(b);
  if (a == b) return;
  if (size_[a] < size_[b]) std::swap(a, b);
  up_[b] = a;
  size_[a] += size_[b];
}

}  // namespace clay
