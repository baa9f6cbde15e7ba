// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "simd/near_pairs.h"

#include <algorithm>
#include <cmath>

#include "simd/cell_index.h"

namespace clay {

void near_pairs(const double *const *x, const double *reach, int owned, int n, std::vector<std::pair<int, int>> &pairs)
{
  pairs.clear();
  if (owned == 0) return;
  double lo[3], hi[3], largest = 0;
  for (int k = 0; k < 3; k++) lo[k] = hi[k] = x[0][k];
  for (int i = 0; i < n; i++) {
    for (int k = 0; k < 3; k++) {
      lo[k] = std::min(lo[k], x[i][k]);
      hi[k] = std::max(hi[k], x[i][k]);
    }
    largest = std::max(largest, reach[i]);
  }
  // no more cells than points, more or less
  double size = 2 * largest;
  const double volume = (hi[0] - lo[0] + size) * (hi[1] - lo[1] + size) * (hi[2] - lo[2] + size);
  size = std::max(size, std::cbrt(volume / (8.0 * n)));
  int cells[3];
  // of points that are no numbers or far away any cells will do, but few
  const bool sound = std::isfinite(volume);
  for (int k = 0; k < 3; k++) cells[k] = sound ? cell_index((hi[k] - lo[k]) / size, 8 * n) + 1 : 1;
  const auto cell = [&](int i, int k) { return cell_index((x[i][k] - lo[k]) / size, cells[k]); };

  std::vector<int> first(static_cast<std::size_t>(cells[0]) * cells[1] * cells[2], -1), next(n);
  for (int i = n - 1; i >= 0; i--) {
    int &head = first[(cell(i, 2) * cells[1] + cell(i, 1)) * cells[0] + cell(i, 0)];
    next[i] = head;
    head = i;
  }
  for (int i = 0; i < owned; i++) {
    const int at[3] = {cell(i, 0), cell(i, 1), cell(i, 2)};
    for (int c = std::max(0, at[2] - 1); c <= std::min(cells[2] - 1, at[2] + 1); c++)
      for (int b = std::max(0, at[1] - 1); b <= std::min(cells[1] - 1, at[1] + 1); b++)
        for (int a = std::max(0, at[0] - 1); a <= std::min(cells[0] - 1, at[0] + 1); a++)
          for (int j = first[(c * cells[1] + b) * cells[0] + a]; j >= 0; j = next[j]) {
            if (j <= i) continue;
            const double r = reach[i] + reach[j];
            const double dx = x[i][0] - x[j][0], dy = x[i][1] - x[j][1], dz = x[i][2] - x[j][2];
            if (dx * dx + dy * dy + dz * dz < r * r) pairs.emplace_back(i, j);
          }
  }
}

}  // namespace clay
