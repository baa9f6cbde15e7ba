// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file test_clones_main.cpp
/// Runs the kernels' tests on one generation of their clones, CLAY_ONLY_BYTES; where
/// the processor lacks that, says which tests were not run.
#include <gtest/gtest.h>

#include <cstdio>

#include "simd/clones.h"

namespace {

bool runsHere()
{
#if defined(CLAY_WIDEST_NEEDS)
  __builtin_cpu_init();
#if CLAY_ONLY_BYTES == 64
  return __builtin_cpu_supports(CLAY_WIDEST_NEEDS);
#elif CLAY_ONLY_BYTES == 32
  return __builtin_cpu_supports(CLAY_WIDE_NEEDS);
#endif
  return true;
#else
  return CLAY_ONLY_BYTES == 16;
#endif
}

}  // namespace

int main(int argc, char **argv)
{
  testing::InitGoogleTest(&argc, argv);
  if (runsHere()) {
    std::printf("clones for registers of %d bytes\n", CLAY_ONLY_BYTES);
    return RUN_ALL_TESTS();
  }
  const testing::UnitTest &all = *testing::UnitTest::GetInstance();
  for (int s = 0; s < all.total_test_suite_count(); ++s)
    for (int t = 0; t < all.GetTestSuite(s)->total_test_count(); ++t)
      std::printf("NOT RUN, this processor has no clones for registers of %d bytes: %s.%s\n", CLAY_ONLY_BYTES,
                  all.GetTestSuite(s)->name(), all.GetTestSuite(s)->GetTestInfo(t)->name());
  return 0;
}
