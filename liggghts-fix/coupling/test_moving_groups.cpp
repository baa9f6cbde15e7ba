// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/moving_groups.h"

#include <gtest/gtest.h>

using namespace clay;

namespace {

FixEntry fix(const std::string &style, int group) { return {"id", style, true, group}; }

}  // namespace

TEST(MovingGroups, whatSomeFixMovesByItsForces)
{
  for (const char *style : {"nve", "nve/sphere", "nve/limit", "multisphere", "multisphere/clump"})
    EXPECT_TRUE(moving_groups({fix(style, 2)}).moves(1 | 2)) << style;
  for (const char *style : {"nve/noforce", "nve/asphere/noforce", "nve/sph/stationary", "gravity", "couple/foam"})
    EXPECT_FALSE(moving_groups({fix(style, 2)}).moves(1 | 2)) << style;
  EXPECT_FALSE(moving_groups({fix("nve/sphere", 2)}).moves(1 | 4));
  EXPECT_FALSE(moving_groups({}).moves(1));
}

TEST(MovingGroups, notWhatIsFrozenOrLed)
{
  for (const char *style : {"freeze", "move"}) {
    const MovingGroups found = moving_groups({fix("nve/sphere", 1), fix(style, 4)});
    EXPECT_TRUE(found.moves(1)) << style;
    EXPECT_FALSE(found.moves(1 | 4)) << style;
  }
  EXPECT_TRUE(moving_groups({fix("nve/sphere", 1), fix("move/mesh", 1)}).moves(1));
}

TEST(MovingGroups, alongAnAxisWhoseForceIsSet)
{
  FixEntry up = fix("setforce", 4), all = fix("setforce", 8);
  up.sets = 4;
  all.sets = 7;
  const MovingGroups found = moving_groups({up, fix("nve/sphere", 1), all});
  EXPECT_EQ(found.held(1), 0);
  EXPECT_EQ(found.held(1 | 4), 4);
  EXPECT_TRUE(found.moves(1 | 4));
  EXPECT_EQ(found.held(1 | 8), 7);
  EXPECT_FALSE(found.moves(1 | 8));
  EXPECT_EQ(found.held(2), 7);
}

TEST(MovingGroups, frozenAboveAPlace)
{
  std::vector<FixEntry> fixes = {fix("freeze", 2), fix("setforce", 8), fix("couple/foam", 1), fix("freeze", 4)};
  fixes[1].sets = 5;
  EXPECT_EQ(frozen_above(fixes, 2).axes(2), 7);
  EXPECT_EQ(frozen_above(fixes, 2).axes(8), 5);
  EXPECT_EQ(frozen_above(fixes, 2).axes(4), 0);
  EXPECT_EQ(frozen_above(fixes, 0).axes(2), 0);
}
