// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file clump_slice.h
/// A plane cut through a clump: union of discs, its area and moments.
#pragma once

#include <vector>

#include "clumps/clump_geometry.h"

namespace clay {

/// Area and moments of a union of discs in the plane z = const.
struct Slice {
  double a = 0;                   ///< area
  double x = 0, y = 0;            ///< first moments
  double xx = 0, yy = 0, xy = 0;  ///< second moments
  std::vector<double> share;      ///< area of each disc's power cell
};

/// Cuts the clump at height z.
Slice cut(const Clump&, double z);

}  // namespace clay
