// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "rest/rest_watch.h"

#include <algorithm>
#include <cmath>

namespace clay {

namespace {

double length(const double a[3]) { return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]); }

}  // namespace

void RestWeights::begin() { *this = RestWeights(); }

void RestWeights::next()
{
  // each is older by one and counts less; the new one has no age
  waa_ = KEPT * (waa_ + 2 * wa_ + w_);
  wa_ = KEPT * (wa_ + w_);
  w_ = KEPT * w_ + 1;
}

/* ---------------------------------------------------------------------- */

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
    y[k] = ay[k] = 0;
  }
  yy = 0;
}

void RestTrack::see(const double *x)
{
  const double kept = RestWeights::KEPT;
  yy *= kept;
  for (int k = 0; k < 3; k++) {
    const double way = x[k] - begun[k];
    ay[k] = kept * (ay[k] + y[k]);
    y[k] = kept * y[k] + way;
    yy += way * way;
  }
}

void RestTrack::drift(const RestWeights &weights, double way[3]) const
{
  const double m = weights.places(), saa = weights.spread();
  double explained = 0, scatter = yy;
  for (int k = 0; k < 3; k++) {
    way[k] = saa > 0 ? (weights.age() * y[k] - ay[k]) / saa : 0;
    explained += way[k] * way[k] * saa;
    scatter -= y[k] * y[k] / m;
  }
  if (m < 2.5) return;  // two places tell of no scatter
  const double error = std::sqrt(std::max(0., scatter - explained) / ((m - 2) * saa)), size = length(way);
  const double part = size > 2 * error ? 1 - 2 * error / size : 0;
  for (int k = 0; k < 3; k++) way[k] *= part;
}

double RestTrack::allowed(const RestWeights &weights, double most) const
{
  double way[3];
  drift(weights, way);
  const double speed = length(way);
  if (speed <= 1e-5 * most) return 1e300;
  // until missed + n way has the length `most`; that is farther off where it leads back
  double along = 0, beyond = -most * most;
  for (int k = 0; k < 3; k++) {
    along += missed[k] * way[k] / speed;
    beyond += missed[k] * missed[k];
  }
  const double left = std::max(0., -along + std::sqrt(std::max(0., along * along - beyond)));
  // a part of it may be spent at once, so that there is something left for later
  return 0.25 * left / speed;
}

void RestTrack::charge(const RestWeights &weights, double left_out)
{
  double way[3];
  drift(weights, way);
  for (int k = 0; k < 3; k++) missed[k] += left_out * way[k];
}

/* ---------------------------------------------------------------------- */

double RestWatch::missed() const { return std::fabs(missed_way()); }

double RestWatch::missed_way() const
{
  RestTrack now = mean_;
  now.charge(weights_, out_);
  return now.missed[0];
}

RestWeights RestWatch::weights_with_next() const
{
  RestWeights weights = resting() ? weights_ : RestWeights();
  weights.next();
  return weights;
}

void RestWatch::charge()
{
  mean_.charge(weights_, out_);
  out_ = 0;
}

void RestWatch::wake()
{
  charge();
  quiet_ = 0;
  row_ = 1;
  weights_.begin();
  mean_.begin();
}

void RestWatch::restart(const RestLimits &limits)
{
  limits_ = limits;
  wake();
}

int RestWatch::windows(const RestSight &sight, bool whole)
{
  const bool probe = out_ > 0, still = whole && sight.farthest <= limits_.move;
  const int row = row_;
  charge();
  if (!still) {
    wake();
    // other particles, maybe: nothing is known of them
    if (whole) row_ = std::max(1, row / 4);
    mean_.last[0] = sight.mean;
    return 0;
  }
  if (!resting()) mean_.begin();
  weights_ = weights_with_next();
  const double at[] = {sight.mean, 0, 0};
  mean_.see(at);
  mean_.last[0] = sight.mean;
  if (++quiet_ < limits_.quiet) return 0;
  if (probe) row_ = std::min(2 * row_, limits_.longest);

  out_ =
      static_cast<int>(std::min({double(row_), sight.allowed, mean_.allowed(weights_, limits_.error * sight.height)}));
  return out_;
}

}  // namespace clay
