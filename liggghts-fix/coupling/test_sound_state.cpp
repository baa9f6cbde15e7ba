// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/sound_state.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <vector>

#include "sphere_store.h"

using namespace clay;

namespace {

const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
const double dt = 1e-3;
const int columns = 9;

// three spheres of radius 1, of which the last one is changed
bool sound_with(const std::function<void(SphereStore &, RowStore &)> &change, int n = 3)
{
  SphereStore s(3);
  RowStore kept(3, columns);
  change(s, kept);
  return is_sound(s.arrays(), n, dt, kept.rows(), columns);
}

}  // namespace

TEST(SoundState, atRestAndAtAnySpeedBelowADiameterAStep)
{
  EXPECT_TRUE(sound_with([](SphereStore &, RowStore &) {}));
  EXPECT_TRUE(sound_with([](SphereStore &s, RowStore &) { s.v[2][1] = -0.999 * 2 / dt; }));
  EXPECT_FALSE(sound_with([](SphereStore &s, RowStore &) { s.v[2][1] = -1.001 * 2 / dt; }));
  // by its own diameter, along all axes
  EXPECT_FALSE(sound_with([](SphereStore &s, RowStore &) {
    s.radius[2] = 0.5;
    s.v[2][0] = s.v[2][1] = s.v[2][2] = 0.6 / dt;
  }));
  EXPECT_TRUE(sound_with([](SphereStore &s, RowStore &) {
    s.radius[2] = 0.5;
    s.v[2][0] = s.v[2][1] = s.v[2][2] = 0.57 / dt;
  }));
}

TEST(SoundState, NoNumberOfItIsNaNOrInfinite)
{
  for (const double x : {nan, inf, -inf}) {
    for (int k = 0; k < 3; k++) {
      EXPECT_FALSE(sound_with([&](SphereStore &s, RowStore &) { s.x[2][k] = x; })) << k;
      EXPECT_FALSE(sound_with([&](SphereStore &s, RowStore &) { s.v[2][k] = x; })) << k;
      EXPECT_FALSE(sound_with([&](SphereStore &s, RowStore &) { s.omega[2][k] = x; })) << k;
    }
    for (int k = 0; k < columns; k++)
      EXPECT_FALSE(sound_with([&](SphereStore &, RowStore &kept) { kept[2][k] = x; })) << k;
  }
}

TEST(SoundState, GhostsDoNotCount)
{
  EXPECT_TRUE(sound_with([](SphereStore &s, RowStore &) { s.x[2][0] = nan; }, 2));
  EXPECT_TRUE(sound_with([](SphereStore &s, RowStore &) { s.x[2][0] = nan; }, 0));
}
