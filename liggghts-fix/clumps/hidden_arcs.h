// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file hidden_arcs.h
/// Parts of a circle that others cover.
#pragma once

#include <utility>
#include <vector>

namespace clay {

/// Pieces of the angles from -pi to pi [rad], each from its first to its second.
using Arcs = std::vector<std::pair<double, double>>;

/// Hides the angles within `open`, at most pi, of `at`, in two pieces where they pass pi.
inline void hide(Arcs& hidden, double at, double open)
{
  constexpr double pi = 3.14159265358979323846;
  double t0 = at - open, t1 = at + open;
  if (t0 < -pi) {
    hidden.push_back({t0 + 2 * pi, pi});
    t0 = -pi;
  }
  if (t1 > pi) {
    hidden.push_back({-pi, t1 - 2 * pi});
    t1 = pi;
  }
  hidden.push_back({t0, t1});
}

}  // namespace clay
