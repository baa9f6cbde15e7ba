// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "settling/settling_profile.h"

#include <algorithm>
#include <cmath>

namespace clay {

double capShare(double t)
{
  t = std::clamp(t, -1.0, 1.0);
  return 0.25 * (t + 1) * (t + 1) * (2 - t);
}

SettlingProfile::SettlingProfile(double lo, double hi, double thickness) : lo_(lo)
{
  const int n = std::max(1, static_cast<int>(std::ceil((hi - lo) / thickness)));
  width_ = (hi - lo) / n;
  per_width_ = 1 / width_;
  sums_.assign(n + 1, 0.0);
}

void SettlingProfile::clear() { std::fill(sums_.begin(), sums_.end(), 0.0); }

void SettlingProfile::add(double z, double r, double volume)
{
  sums_.back() += volume * z;
  const auto bin = [this](double h) {
    const double at = (h - lo_) * per_width_;
    return at > 0 ? static_cast<int>(std::min(at, bins() - 1.0)) : 0;  // the first for NaN, too
  };
  const int first = bin(z - r), last = bin(z + r);
  const double per_radius = 1 / r;
  double before = 0;
  for (int k = first; k < last; ++k) {
    const double now = capShare((lo_ + (k + 1) * width_ - z) * per_radius);
    sums_[k] += volume * (now - before);
    before = now;
  }
  sums_[last] += volume * (1 - before);
}

double SettlingProfile::volume() const
{
  double v = 0;
  for (int k = 0; k < bins(); ++k) v += sums_[k];
  return v;
}

double SettlingProfile::quantile(double q) const
{
  const double wanted = q * volume();
  double v = 0;
  for (int k = 0; k < bins(); ++k) {
    if (sums_[k] > 0 && v + sums_[k] >= wanted) return lo_ + (k + (wanted - v) / sums_[k]) * width_;
    v += sums_[k];
  }
  return lo_ + bins() * width_;
}

double SettlingProfile::interface(double q, double radius, double width) const
{
  const double upper = quantile(q), lower = quantile(q - width);
  return upper + (upper - lower) / width * (1 - q) + radius;
}

double SettlingProfile::below(double height) const
{
  const double place = (height - lo_) / width_, at = place > 0 ? std::min(place, double(bins())) : 0.0;
  const int k = std::min(bins() - 1, static_cast<int>(at));
  return cumulated_[k] + (at - k) * sums_[k];
}

double SettlingProfile::bed(double area, double threshold, double window) const
{
  cumulated_.assign(1, 0.0);
  for (int k = 0; k < bins(); ++k) cumulated_.push_back(cumulated_.back() + sums_[k]);

  const double top = lo_ + bins() * width_;
  const auto fraction = [&](double h) { return (below(h + 0.5 * window) - below(h - 0.5 * window)) / (area * window); };
  double lower = fraction(lo_ + 0.5 * window);
  if (lower < threshold) return lo_;
  for (double h = lo_ + 0.5 * window + width_; h <= top; h += width_) {
    const double upper = fraction(h);
    if (upper < threshold) return h - width_ * (threshold - upper) / (lower - upper);
    lower = upper;
  }
  return top;
}

double SettlingProfile::mean() const
{
  const double v = volume();
  return v > 0 ? sums_.back() / v : lo_;
}

}  // namespace clay
