// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/routing.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace clay {

namespace {

// Distance squared from a point to a box; of an empty box, infinity
double distance2(const Box& box, const double* x) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    if (box.lo[i] > box.hi[i]) return HUGE_VAL;
    const double d = std::max({box.lo[i] - x[i], 0., x[i] - box.hi[i]});
    sum += d * d;
  }
  return sum;
}

}  // namespace

Routing::Routing(std::vector<RankBoxes> boxes) : boxes_(std::move(boxes)), routes_(boxes_.size()) {}

// Boxes that any of the spheres may touch
void Routing::chooseCandidates(const double* x, const double* r, int n) {
  Box all;
  for (int i = 0; i < n; ++i)
    for (int c = 0; c < 3; ++c) {
      all.lo[c] = std::min(all.lo[c], x[3 * i + c] - r[i]);
      all.hi[c] = std::max(all.hi[c], x[3 * i + c] + r[i]);
    }
  candidates_.clear();
  for (std::size_t p = 0; p < boxes_.size(); ++p)
    for (const Box& box : boxes_[p]) {
      bool apart = false;
      for (int c = 0; c < 3; ++c) apart = apart || box.hi[c] < all.lo[c] || box.lo[c] > all.hi[c];
      if (!apart) candidates_.push_back({static_cast<int>(p), box});
    }
}

int Routing::nearest(const double* x) const {
  int best = 0;
  double least = HUGE_VAL;
  for (std::size_t p = 0; p < boxes_.size(); ++p) {
    const double d = boxes_[p].empty() ? HUGE_VAL : distance2(boxes_[p][0], x);
    if (d < least) {
      least = d;
      best = static_cast<int>(p);
    }
  }
  return best;
}

void Routing::route(const double* x, const double* r, int n) {
  for (auto& route : routes_) {
    route.particles.clear();
    route.shares.clear();
  }
  chooseCandidates(x, r, n);
  for (int i = 0; i < n; ++i) {
    touched_.clear();
    for (const auto& candidate : candidates_)
      if ((touched_.empty() || touched_.back() != candidate.rank) &&
          candidate.box.reaches(x + 3 * i, r[i]))
        touched_.push_back(candidate.rank);
    if (touched_.empty()) touched_.push_back(nearest(x + 3 * i));
    for (int p : touched_) {
      auto& route = routes_[static_cast<std::size_t>(p)];
      if (touched_.size() > 1) {
        route.shares.push_back(static_cast<double>(route.particles.size()));
        route.shares.push_back(static_cast<double>(touched_.size()));
        route.shares.insert(route.shares.end(), touched_.begin(), touched_.end());
      }
      route.particles.push_back(i);
    }
  }
}

}  // namespace clay
