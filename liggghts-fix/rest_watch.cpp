// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "rest_watch.h"

#include <algorithm>
#include <cmath>

namespace clay {

double RestPlaces::farthest(const double *x, const double *radius) const
{
  double most = 0;
  const int n = size();
  for (int i = 0; i < n; i++) {
    const double dx = x[3 * i] - x_[3 * i], dy = x[3 * i + 1] - x_[3 * i + 1], dz = x[3 * i + 2] - x_[3 * i + 2];
    most = std::max(most, (dx * dx + dy * dy + dz * dz) / (radius[i] * radius[i]));
  }
  return std::sqrt(most);
}

// of this rest
double RestWatch::here() const
{
  return computed_ > 0 ? std::fabs(mean_ - first_) / computed_ * left_out_ : 0;
}

void RestWatch::wake()
{
  left_out_ += out_;
  out_ = 0;
  missed_ += here();
  if (computed_ > 0) behind_ += gone_ * left_out_ / computed_;
  gone_ = 0;
  quiet_ = 0;
  row_ = 1;
  computed_ = left_out_ = 0;
}

void RestWatch::restart(const RestLimits &limits)
{
  limits_ = limits;
  wake();
}

int RestWatch::windows(const RestSight &sight, bool whole)
{
  if (!whole) {  // other particles, maybe: their mean height tells nothing of the rest before
    wake();
    mean_ = sight.mean;
    return 0;
  }
  const bool probe = out_ > 0, still = sight.farthest <= limits_.move;
  if (quiet_ == 0) first_ = mean_;
  mean_ = sight.mean;
  computed_++;
  left_out_ += out_;
  out_ = 0;
  if (still) gone_ = sight.gone;
  if (!still) {
    wake();
    return 0;
  }
  if (++quiet_ < limits_.quiet) return 0;
  if (probe) row_ = std::min(2 * row_, limits_.longest);

  const double drift = std::fabs(mean_ - first_) / computed_, left = limits_.error * sight.height - missed();
  int n = row_;
  if (n * drift > left) n = left > 0 ? static_cast<int>(left / drift) : 0;
  // n + left_out_ times a particle's way in a window
  const double may = (limits_.behind - behind_) * computed_;
  if ((n + left_out_) * gone_ > may) n = may > 0 ? std::max(0, static_cast<int>(may / gone_ - left_out_)) : 0;
  out_ = n;
  return n;
}

}  // namespace clay
