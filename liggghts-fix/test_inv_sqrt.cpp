// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "inv_sqrt.h"

// relative error over four octaves of every size that lengths here have
TEST(InvSqrt, rightToRounding)
{
  double worst = 0;
  for (double size : {1e-24, 1e-12, 1e-6, 1.0, 1e12})
    for (double s = size; s < 16 * size; s *= 1 + 1e-5)
      worst = std::max(worst, std::abs(clay::invSqrt(s) * std::sqrt(s) - 1));
  EXPECT_LT(worst, 4.5e-16);
}
