// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file packing.cpp
#include "exchange/packing.h"

#include <algorithm>
#include <numeric>

namespace clay {

const double* unpackFields(const double* from, const FieldSet& set, int n, Particles& list,
                           int first) {
  for (unsigned k = 0; k < fieldCount; ++k) {
    const auto f = static_cast<Field>(k);
    if (!set.has(f)) continue;
    const int width = components(f);
    std::copy(from, from + width * n, list[f] + width * first);
    from += width * n;
  }
  return from;
}

void packAnswers(const Particles& answers, const std::vector<char>& owned, const FieldSet& set,
                 int first, int n, int end, std::vector<double>& message) {
  const char* mine = owned.data() + first;
  const auto answered =
      static_cast<std::size_t>(n - std::count(mine, mine + n, static_cast<char>(0)));
  const bool all = answered == static_cast<std::size_t>(n);
  message.resize(answered * (1 + static_cast<std::size_t>(set.width())) +
                 static_cast<std::size_t>(end));

  double* to = message.data();
  if (all) {
    std::iota(to, to + n, 0.0);
    to += n;
  } else {
    for (int i = 0; i < n; ++i)
      if (mine[i]) *to++ = i;
  }

  for (unsigned k = 0; k < fieldCount; ++k) {
    const auto f = static_cast<Field>(k);
    if (!set.has(f)) continue;
    const int width = components(f);
    const double* from = answers[f] + width * first;
    if (all) {
      to = std::copy(from, from + width * n, to);
      continue;
    }
    for (int i = 0; i < n; ++i)
      if (mine[i]) to = std::copy(from + width * i, from + width * (i + 1), to);
  }
}

}  // namespace clay
