// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file inv_sqrt.h
/// 1/sqrt(s) out of products and sums, for loops that work on several at once.
#pragma once

#include <cstdint>
#include <cstring>

#include "simd/clones.h"

namespace clay {

/// 1/sqrt(s) for a normal s > 0, to 4e-16: the processor's own root and
/// division take several times as long. The start halves the exponent, which is
/// right to 3.5 %; with e = 1 - s y2, 1/sqrt(s) = y (1 - e)^(-1/2). The first
/// cubic in e is the one nearest to that for |e| < 0.07, to 7.5e-7; then two
/// terms of its series leave less than rounding does.
CLAY_INLINE double invSqrt(double s)
{
  std::uint64_t bits;
  std::memcpy(&bits, &s, sizeof s);
  bits = 0x5fe6eb50c7b537a9ULL - (bits >> 1);
  double y;
  std::memcpy(&y, &bits, sizeof y);
  double e = 1 - s * y * y;
  y *= 0.9999992536221862 + e * (0.5000004234436741 + e * (0.37627901195582136 + e * 0.3130540602774731));
  e = 1 - s * y * y;
  return y + y * e * (0.5 + 0.375 * e);
}

/// Numbers in a register of so many bytes, and whole numbers of their size.
template <class Real, int BYTES>
struct Pack {
  static constexpr int SIZE = BYTES / sizeof(Real);
  typedef Real Numbers __attribute__((vector_size(BYTES), may_alias));
  typedef decltype(Numbers() < Numbers()) Bits;
};

/// The same for several at once.
template <int BYTES>
CLAY_INLINE void invSqrt(const typename Pack<double, BYTES>::Numbers& s, typename Pack<double, BYTES>::Numbers& y)
{
  typedef typename Pack<double, BYTES>::Numbers Numbers;
  typedef typename Pack<double, BYTES>::Bits Bits;
  y = (Numbers)(0x5fe6eb50c7b537a9LL - ((Bits)s >> 1));
  Numbers e = 1 - s * y * y;
  y *= 0.9999992536221862 + e * (0.5000004234436741 + e * (0.37627901195582136 + e * 0.3130540602774731));
  e = 1 - s * y * y;
  y += y * e * (0.5 + 0.375 * e);
}

/// In single precision, to 2.5e-7: there one quartic, nearest for -0.0702 < e < 0.0685
/// to 2.5e-8, is enough.
template <int BYTES>
CLAY_INLINE void invSqrt(const typename Pack<float, BYTES>::Numbers& s, typename Pack<float, BYTES>::Numbers& y)
{
  typedef typename Pack<float, BYTES>::Numbers Numbers;
  typedef typename Pack<float, BYTES>::Bits Bits;
  y = (Numbers)(0x5f375a86 - ((Bits)s >> 1));
  const Numbers e = 1 - s * y * y;
  y *= 1.0f + e * (0.49999822f + e * (0.37500096f + e * (0.31398256f + e * 0.27399567f)));
}

}  // namespace clay
