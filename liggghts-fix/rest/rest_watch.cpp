// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "rest/rest_watch.h"

#include <algorithm>
#include <cmath>

namespace clay {

namespace {

double length(const double a[3]) { return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]); }

}  // namespace

void RestTrack::create() { *this = RestTrack(); }

double RestTrack::moved2(const double *x) const
{
  double sum = 0;
  for (int k = 0; k < 3; k++) sum += (x[k] - last[k]) * (x[k] - last[k]);
  return sum;
}

void RestTrack::begin()
{
  for (int k = 0; k < 3; k++) {
    begun[k] = last[k];
    y[k] = ty[k] = 0;
  }
  yy = 0;
}

void RestTrack::see(const double *x, int n)
{
  for (int k = 0; k < 3; k++) {
    const double way = x[k] - begun[k];
    y[k] += way;
    ty[k] += n * way;
    yy += way * way;
  }
}

void RestTrack::drift(int n, double way[3]) const
{
  // n + 1 places, of which the first is the beginning
  const double m = n + 1, t = 0.5 * n * m, stt = t * (2 * n + 1) / 3 - t * t / m;
  double explained = 0, scatter = yy;
  for (int k = 0; k < 3; k++) {
    way[k] = stt > 0 ? (ty[k] - t * y[k] / m) / stt : 0;
    explained += way[k] * way[k] * stt;
    scatter -= y[k] * y[k] / m;
  }
  if (n < 2) return;
  const double error = std::sqrt(std::max(0., scatter - explained) / ((m - 2) * stt)), size = length(way);
  const double part = size > 2 * error ? 1 - 2 * error / size : 0;
  for (int k = 0; k < 3; k++) way[k] *= part;
}

double RestTrack::allowed(int n, double most) const
{
  double way[3];
  drift(n, way);
  const double speed = length(way), left = std::max(0., most - length(missed));
  // a rest may spend a part of what is left, so that there is something left for the next one
  return speed > 1e-5 * most ? 0.25 * left / speed : 1e300;
}

void RestTrack::charge(int n, double left_out)
{
  double all[3];
  missed_with(n, left_out, all);
  std::copy(all, all + 3, missed);
}

void RestTrack::missed_with(int n, double left_out, double all[3]) const
{
  std::copy(missed, missed + 3, all);
  if (n < 1 || left_out <= 0) return;
  double way[3];
  drift(n, way);
  for (int k = 0; k < 3; k++) all[k] += left_out * way[k];
}

/* ---------------------------------------------------------------------- */

// of this rest
double RestWatch::here() const { return computed_ > 0 ? (mean_ - first_) / computed_ * left_out_ : 0; }

double RestWatch::missed() const { return std::fabs(missed_way()); }

double RestWatch::missed_way() const { return missed_ + here(); }

void RestWatch::wake()
{
  left_out_ += out_;
  out_ = 0;
  missed_ += here();
  quiet_ = 0;
  row_ = 1;
  computed_ = 0;
  left_out_ = 0;
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
  if (!still) {
    const int row = row_;
    wake();
    row_ = std::max(1, row / 4);
    return 0;
  }
  if (++quiet_ < limits_.quiet) return 0;
  if (probe) row_ = std::min(2 * row_, limits_.longest);

  const double drift = std::fabs(mean_ - first_) / computed_, left = limits_.error * sight.height - missed();
  int n = row_;
  if (n * drift > left) n = left > 0 ? static_cast<int>(left / drift) : 0;
  const double may = sight.allowed - left_out_;
  if (n > may) n = may > 0 ? static_cast<int>(may) : 0;
  out_ = n;
  return n;
}

}  // namespace clay
