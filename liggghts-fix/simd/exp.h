// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file exp.h
/// exp(x) out of products and sums, for loops that work on several at once.
#pragma once

#include "simd/inv_sqrt.h"

namespace clay {

/// exp(x) for x <= 700, to 3e-16; below -708 that of -708. Whole powers of two are
/// taken out by adding a number so large that only they are left of x/ln 2; the
/// rest, at most ln 2/2 either way, has Taylor's series to the 13th power, whose
/// next term is below 5e-18 there. ln 2 in two parts keeps that rest exact.
template <int BYTES>
CLAY_INLINE void expOf(const typename Pack<double, BYTES>::Numbers& wanted, typename Pack<double, BYTES>::Numbers& y)
{
  typedef typename Pack<double, BYTES>::Numbers Numbers;
  typedef typename Pack<double, BYTES>::Bits Bits;
  const Numbers least = Numbers{} - 708.0, x = wanted > least ? wanted : least;
  const double whole = 6755399441055744.0;  // 1.5 * 2^52
  const Numbers t = x * 1.4426950408889634 + whole, n = t - whole;
  const Numbers f = (x - n * 0.693147180369123816490) - n * 1.90821492927058770002e-10;
  Numbers p = Numbers{} + 1.0 / 6227020800;
  for (double term : {1.0 / 479001600, 1.0 / 39916800, 1.0 / 3628800, 1.0 / 362880, 1.0 / 40320, 1.0 / 5040, 1.0 / 720,
                      1.0 / 120, 1.0 / 24, 1.0 / 6, 0.5, 1.0, 1.0})
    p = p * f + term;
  y = (Numbers)((Bits)p + ((Bits)t << 52));
}

/// In single precision, for x <= 80 and to 1.5e-7, and below -87 that of -87: there the series ends
/// with the 7th power.
template <int BYTES>
CLAY_INLINE void expOf(const typename Pack<float, BYTES>::Numbers& wanted, typename Pack<float, BYTES>::Numbers& y)
{
  typedef typename Pack<float, BYTES>::Numbers Numbers;
  typedef typename Pack<float, BYTES>::Bits Bits;
  const Numbers least = Numbers{} - 87.0f, x = wanted > least ? wanted : least;
  const float whole = 12582912.0f;  // 1.5 * 2^23
  const Numbers t = x * 1.44269504f + whole, n = t - whole;
  const Numbers f = (x - n * 0.693359375f) + n * 2.12194440e-4f;
  Numbers p = Numbers{} + 1.0f / 5040;
  for (float term : {1.0f / 720, 1.0f / 120, 1.0f / 24, 1.0f / 6, 0.5f, 1.0f, 1.0f}) p = p * f + term;
  y = (Numbers)((Bits)p + ((Bits)t << 23));
}

}  // namespace clay
