// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "settling/settling_profile.h"

using clay::SettlingProfile;

namespace {

// spheres of radius r at even steps in height, as if uniform from lo to hi
void fill(SettlingProfile& p, double lo, double hi, int n, double r, double volume)
{
  for (int i = 0; i < n; ++i) {
    const double z = lo + r + (hi - lo - 2 * r) * (i + 0.5) / n;
    p.add(z, r, volume / n);
  }
}

}  // namespace

TEST(SettlingProfile, oneSphere)
{
  SettlingProfile p(0, 1, 0.001);
  p.add(0.4, 0.1, 5e-6);
  EXPECT_NEAR(p.volume(), 5e-6, 1e-18);
  EXPECT_DOUBLE_EQ(p.mean(), 0.4);
  EXPECT_NEAR(p.quantile(0.5), 0.4, 1e-6);
  // a cap of height 0.05: (1 - u)2 (2 + u) / 4 with u = 0.5
  EXPECT_NEAR(p.quantile(1 - 0.25 * 0.25 * 2.5), 0.45, 1e-5);
  EXPECT_NEAR(p.quantile(1), 0.5, 1e-3);
}

TEST(SettlingProfile, uniformSuspensionReachesItsTop)
{
  SettlingProfile p(0, 0.2, 2.5e-4);
  fill(p, 0, 0.15, 1890, 1e-3, 7.9e-6);
  EXPECT_NEAR(p.interface(0.98, 1e-3), 0.15, 2e-4);
  EXPECT_NEAR(p.interface(0.99, 1e-3), 0.15, 2e-4);
  EXPECT_NEAR(p.mean(), 0.075, 1e-12);
}

TEST(SettlingProfile, straysDoNotMoveTheInterface)
{
  SettlingProfile p(0, 0.2, 2.5e-4);
  fill(p, 0, 0.05, 1862, 1e-3, 0.9852);
  const double clear = p.interface(0.98, 1e-3);
  p.add(0.18, 1e-3, 0.0148);  // two clumps of 135
  EXPECT_NEAR(p.interface(0.98, 1e-3), clear, 1e-3);
  EXPECT_NEAR(clear, 0.05, 2e-4);
}

TEST(SettlingProfile, bedBelowASuspension)
{
  // solid fraction 0.5 up to 0.04, 0.05 from there to 0.14
  const double area = 8e-4;
  SettlingProfile p(0, 0.15, 2.5e-4);
  fill(p, 0, 0.04, 4000, 1e-3, 0.5 * 0.04 * area);
  fill(p, 0.04, 0.14, 2000, 1e-3, 0.05 * 0.10 * area);
  EXPECT_NEAR(p.bed(area, 0.3, 0.004), 0.04, 2e-3);  // half a window at most
  EXPECT_NEAR(p.interface(0.98, 1e-3), 0.14, 0.01);
  EXPECT_EQ(p.bed(area, 0.6, 0.004), 0);
}

TEST(SettlingProfile, noBedInASuspension)
{
  SettlingProfile p(0.01, 0.15, 2.5e-4);
  fill(p, 0.01, 0.15, 1000, 1e-3, 0.06 * 0.14 * 8e-4);
  EXPECT_EQ(p.bed(8e-4, 0.3, 0.004), 0.01);
}

TEST(SettlingProfile, sumsOfTwoProcessorsAddUp)
{
  SettlingProfile whole(0, 0.1, 1e-3), half(0, 0.1, 1e-3), other(0, 0.1, 1e-3);
  for (int i = 0; i < 100; ++i) {
    const double z = 0.002 + 0.0009 * i;
    whole.add(z, 1e-3, 1e-9);
    (i % 2 ? half : other).add(z, 1e-3, 1e-9);
  }
  for (std::size_t k = 0; k < half.sums().size(); ++k) half.sums()[k] += other.sums()[k];
  EXPECT_NEAR(half.interface(0.98, 1e-3), whole.interface(0.98, 1e-3), 1e-14);
  EXPECT_NEAR(half.mean(), whole.mean(), 1e-14);
  half.clear();
  EXPECT_EQ(half.volume(), 0);
}

TEST(SettlingProfile, solidsOutsideCountAtTheEnds)
{
  SettlingProfile p(0, 0.1, 1e-3);
  p.add(-0.0005, 1e-3, 1.0);
  p.add(0.1005, 1e-3, 1.0);
  EXPECT_NEAR(p.volume(), 2.0, 1e-12);
}

// The first slice for what is no number, the last for what is far: no index from a cast of it
TEST(SettlingProfile, takesAnyNumber)
{
  for (double z : {std::nan(""), HUGE_VAL, -HUGE_VAL, 1e300, -1e300}) {
    SettlingProfile p(0, 1, 0.01);
    p.add(z, 0.1, 1);
    p.add(0.5, 0.1, 2);
    EXPECT_EQ(p.sums().size(), 101u);
    p.quantile(0.5);
    p.interface(0.98, 0.1);
    p.bed(1, 0.2, 0.1);
  }
  SettlingProfile p(0, 1, 0.01);
  p.add(1e300, 0.1, 1);
  EXPECT_EQ(p.sums()[99], 1);
}
