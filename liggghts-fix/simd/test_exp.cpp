// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "simd/exp.h"

namespace {

template <class Real, int BYTES>
double worstOf(double most, double least)
{
  typedef clay::Pack<Real, BYTES> Pack;
  double worst = 0, x = most;
  while (x > least) {
    typename Pack::Numbers in, out;
    for (int l = 0; l < Pack::SIZE; ++l) in[l] = static_cast<Real>(x -= 7.3e-4);
    clay::expOf<BYTES>(in, out);
    for (int l = 0; l < Pack::SIZE; ++l) {
      if (in[l] < least) continue;
      const long double right = std::exp(static_cast<long double>(in[l]));
      worst = std::max(worst, static_cast<double>(std::abs(out[l] / right - 1)));
    }
  }
  return worst;
}

template <int BYTES>
void ends()
{
  typedef clay::Pack<double, BYTES> Twofold;
  typedef clay::Pack<float, BYTES> Single;
  for (double x : {-708.0, -1e3, -1e300, -std::numeric_limits<double>::infinity()}) {
    typename Twofold::Numbers two = {}, y;
    two += x;
    clay::expOf<BYTES>(two, y);
    EXPECT_NEAR(y[0] / std::exp(-708.0), 1, 3e-16) << x;
  }
  for (float x : {-87.0f, -1e3f, -1e30f, -std::numeric_limits<float>::infinity()}) {
    typename Single::Numbers one = {}, y;
    one += x;
    clay::expOf<BYTES>(one, y);
    EXPECT_NEAR(y[0] / std::exp(-87.0), 1, 1.5e-7) << x;
  }
  typename Twofold::Numbers none = {}, y;
  clay::expOf<BYTES>(none, y);
  EXPECT_EQ(y[0], 1);
}

}  // namespace

TEST(Exp, rightToRounding)
{
  EXPECT_LT((worstOf<double, 16>(700, -708)), 3e-16);
  EXPECT_LT((worstOf<double, 32>(700, -708)), 3e-16);
  EXPECT_LT((worstOf<double, 64>(700, -708)), 3e-16);
}

TEST(Exp, inSinglePrecision)
{
  EXPECT_LT((worstOf<float, 16>(80, -87)), 1.5e-7);
  EXPECT_LT((worstOf<float, 32>(80, -87)), 1.5e-7);
  EXPECT_LT((worstOf<float, 64>(80, -87)), 1.5e-7);
}

TEST(Exp, oneAtZeroAndNoLessThanItsLeast)
{
  ends<16>();
  ends<32>();
  ends<64>();
}
