// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file near_pairs.h
/// Pairs of points within the sum of their reaches, by a grid of cells.
#ifndef LMP_NEAR_PAIRS_H
#define LMP_NEAR_PAIRS_H

#include <utility>
#include <vector>

namespace clay {

/// Pairs i < j with |xi - xj| < reach_i + reach_j [m] of which i is among the first `owned`
/// of n points: each pair of owned points once, and each owned point with each other one.
void near_pairs(const double *const *x, const double *reach, int owned, int n, std::vector<std::pair<int, int>> &pairs);

}  // namespace clay

#endif
