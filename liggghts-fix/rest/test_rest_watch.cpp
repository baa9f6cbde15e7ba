// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "rest/rest_watch.h"

using clay::RestLimits;
using clay::RestSight;
using clay::RestTrack;
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

/// Places of a particle that rolls by `way` in a window and rocks with that amplitude.
RestTrack seen(int n, double way, double amplitude)
{
  RestTrack t;
  t.create();
  t.begin();
  for (int i = 1; i <= n; i++) {
    const double x[] = {i * way + amplitude * std::sin(2.1 * i * i), amplitude * std::cos(1.3 * i * i), 0};
    t.see(x, i);
  }
  return t;
}

TEST(RestTrack, findsASteadyWay)
{
  double way[3];
  seen(5, 0.01, 0).drift(5, way);
  EXPECT_NEAR(way[0], 0.01, 1e-12);
  EXPECT_NEAR(way[1], 0, 1e-12);
  EXPECT_NEAR(seen(5, 0.01, 0).allowed(5, 0.5), 12.5, 1e-6);
  seen(1, 0.01, 0).drift(1, way);
  EXPECT_NEAR(way[0], 0.01, 1e-12);
}

TEST(RestTrack, rockingIsNoWay)
{
  double way[3];
  seen(20, 0, 0.02).drift(20, way);
  EXPECT_LT(std::hypot(way[0], way[1]), 3e-4);
  EXPECT_GT(seen(20, 0, 0.02).allowed(20, 0.5), 1000);
  // one that goes on while it rocks is not taken for one that rocks
  seen(40, 0.01, 0.02).drift(40, way);
  EXPECT_NEAR(way[0], 0.01, 2e-3);
}

TEST(RestTrack, addsUpWhatItMissed)
{
  RestTrack t = seen(4, 0.01, 0);
  t.charge(4, 20);
  EXPECT_NEAR(t.missed[0], 0.2, 1e-12);
  t.begin();
  const double x[] = {-0.01, 0, 0};
  t.see(x, 1);
  EXPECT_NEAR(t.allowed(1, 0.5), 7.5, 1e-6);
  RestTrack spent = seen(4, 0.01, 0);
  spent.charge(4, 60);
  EXPECT_EQ(spent.allowed(4, 0.5), 0);
  spent.begin();
  spent.see(spent.begun, 1);  // it has come to rest
  EXPECT_GT(spent.allowed(1, 0.5), 1e6);
  t.charge(1, 10);  // and back
  EXPECT_NEAR(t.missed[0], 0.1, 1e-12);
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
  limits.error = 1e-2;  // of 0.5 m: 5 mm
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
    s.allowed = 50;  // 0.5 radii, at 0.01 in a window
    out += w.windows(s, true);
  }
  EXPECT_EQ(out, 50);
}

TEST(RestWatch, aSingleMovementDoesNotBeginFromOne)
{
  RestLimits limits;
  limits.quiet = 1;
  RestWatch w;
  w.restart(limits);
  w.windows(still(), false);
  for (int n = 0; n < 10; n++) w.windows(still(), true);
  EXPECT_EQ(w.windows(still(2 * limits.move), true), 0);
  EXPECT_EQ(w.windows(still(), true), limits.longest / 4);
  w.wake();
  EXPECT_EQ(w.windows(still(), true), 1);
}
