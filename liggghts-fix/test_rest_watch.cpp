// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "rest_watch.h"

using clay::RestLimits;
using clay::RestPlaces;
using clay::RestSight;
using clay::RestWatch;

namespace {

RestSight still(double farthest = 1e-4, double mean = 0.5)
{
  RestSight s;
  s.farthest = farthest;
  s.height = 0.5;
  s.mean = mean;
  return s;
}

}  // namespace

TEST(RestPlaces, measuresTheLargestWayInRadii)
{
  const double before[] = {0, 0, 0, 1, 1, 1}, radius[] = {0.5, 0.1};
  const double after[] = {0.03, 0.04, 0, 1, 1, 1.02};
  RestPlaces p;
  p.keep(before, 2);
  EXPECT_EQ(p.size(), 2);
  EXPECT_NEAR(p.farthest(after, radius), 0.2, 1e-12);
  p.forget();
  EXPECT_EQ(p.size(), 0);
}

TEST(RestWatch, leavesOutMoreAndMore)
{
  RestLimits limits;
  limits.quiet = 2;
  limits.longest = 4;
  RestWatch w;
  w.restart(limits);
  EXPECT_EQ(w.windows(still(), false), 0);
  EXPECT_EQ(w.windows(still(), true), 0);
  EXPECT_EQ(w.windows(still(), true), 1);
  EXPECT_EQ(w.windows(still(), true), 2);
  EXPECT_EQ(w.windows(still(), true), 4);
  EXPECT_EQ(w.windows(still(), true), 4);
}

TEST(RestWatch, beginsAnewAfterAMovement)
{
  RestLimits limits;
  limits.quiet = 2;
  RestWatch w;
  w.restart(limits);
  for (int n = 0; n < 5; n++) w.windows(still(), true);
  EXPECT_EQ(w.windows(still(2 * limits.move), true), 0);
  EXPECT_EQ(w.windows(still(), true), 0);
  EXPECT_EQ(w.windows(still(), true), 1);
  w.wake();
  EXPECT_EQ(w.windows(still(), true), 0);
}

TEST(RestWatch, stopsWhenTheHeightHasMissedTooMuch)
{
  RestLimits limits;
  limits.quiet = 1;
  limits.error = 1e-2;   // of 0.5 m: 5 mm
  RestWatch w;
  w.restart(limits);
  double mean = 0.5;
  w.windows(still(1e-4, mean), false);
  long out = 0;
  for (int n = 0; n < 1000; n++) {
    mean -= 1e-4;
    out += w.windows(still(1e-4, mean), true);
  }
  EXPECT_LE(w.missed(), 5e-3 + 1e-12);
  EXPECT_GT(w.missed(), 4.5e-3);
  EXPECT_LE(out, 51);
}

TEST(RestWatch, countsOnlyWhatWasLeftOut)
{
  RestLimits limits;
  limits.quiet = 1;
  RestWatch w;
  w.restart(limits);
  w.windows(still(1e-4, 0.5), false);
  w.windows(still(1e-4, 0.5), true);
  w.only(0.25);
  w.windows(still(1e-4, 0.49999), true);
  // 10 um in two computed windows, a quarter of one left out
  EXPECT_NEAR(w.missed(), 1.25e-6, 1e-12);
}

TEST(RestWatch, rockingInPlaceIsNoDrift)
{
  RestLimits limits;
  limits.quiet = 1;
  RestWatch w;
  w.restart(limits);
  w.windows(still(1e-4, 0.5), false);
  long out = 0;
  for (int n = 0; n < 1000; n++) out += w.windows(still(1e-4, 0.5 + (n % 2 ? 1e-6 : 0)), true);
  EXPECT_GT(out, 25000);
  EXPECT_LT(w.missed(), 1e-4);
}

TEST(RestWatch, otherParticlesAreNoDrift)
{
  RestLimits limits;
  limits.quiet = 1;
  RestWatch w;
  w.restart(limits);
  w.windows(still(1e-4, 0.5), false);
  w.windows(still(1e-4, 0.5), true);
  w.windows(still(1e-4, 0.49999), true);
  // woken halfway through the two left out; one more before, 10 um in two computed windows
  w.only(1.0);
  w.wake();
  EXPECT_NEAR(w.missed(), 1e-5, 1e-12);
  // what was inserted lies high up
  w.windows(still(0, 0.7), false);
  w.windows(still(1e-4, 0.7), true);
  EXPECT_NEAR(w.missed(), 1e-5, 1e-12);
}

TEST(RestWatch, aParticleThatRollsIsNotLeftBehind)
{
  RestLimits limits;
  limits.quiet = 1;
  RestWatch w;
  w.restart(limits);
  w.windows(still(0.01), false);
  long out = 0;
  for (int n = 1; n <= 1000; n++) {
    RestSight s = still(0.01);
    // lists are built anew every now and then
    s.gone = 0.01 * (n % 20);
    out += w.windows(s, n % 20 != 0);
  }
  EXPECT_GT(out, 30);
  EXPECT_LE(out, 51);  // 0.5 radii, at 0.01 in a window
}
