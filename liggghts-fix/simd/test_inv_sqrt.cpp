// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "simd/inv_sqrt.h"

// relative error over four octaves of every size that lengths here have
TEST(InvSqrt, rightToRounding)
{
  double worst = 0;
  for (double size : {1e-24, 1e-12, 1e-6, 1.0, 1e12})
    for (double s = size; s < 16 * size; s *= 1 + 1e-5)
      worst = std::max(worst, std::abs(clay::invSqrt(s) * std::sqrt(s) - 1));
  EXPECT_LT(worst, 4.5e-16);
}

template <int BYTES>
void severalAtOnce()
{
  typedef clay::Pack<double, BYTES> Twofold;
  typedef clay::Pack<float, BYTES> Single;
  double twofold = 0, single = 0;
  for (double size : {1e-12, 1.0, 1e12})
    for (double s = size; s < 16 * size; s *= 1 + 1e-4) {
      typename Twofold::Numbers two = {}, root;
      typename Single::Numbers one = {}, other;
      two += s;
      one += static_cast<float>(s);
      clay::invSqrt<BYTES>(two, root);
      clay::invSqrt<BYTES>(one, other);
      for (int l = 0; l < Twofold::SIZE; ++l) twofold = std::max(twofold, std::abs(root[l] * std::sqrt(s) - 1));
      for (int l = 0; l < Single::SIZE; ++l)
        single = std::max(single, std::abs(other[l] * std::sqrt(static_cast<double>(one[l])) - 1));
    }
  EXPECT_LT(twofold, 4.5e-16);
  EXPECT_LT(single, 2.5e-7);
}

TEST(InvSqrt, severalAtOnce)
{
  severalAtOnce<16>();
  severalAtOnce<32>();
  severalAtOnce<64>();
}
