// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "rest/rest_watch.h"

using clay::RestLimits;
using clay::RestSight;
using clay::RestTrack;
using clay::RestWatch;
using clay::RestWeights;

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

/// A particle's places over the windows of a rest, with their weights.
struct Seen {
  RestTrack track;
  RestWeights weights;

  Seen() { track.create(); }
  void see(double x, double y = 0)
  {
    const double at[] = {x, y, 0};
    track.see(at);
    weights.next();
  }
  double drift(int k = 0) const
  {
    double way[3];
    track.drift(weights, way);
    return way[k];
  }
  double allowed() const { return track.allowed(weights, 0.5); }
};

/// Of one that rolls by `way` in a window and rocks with that amplitude.
Seen seen(int n, double way, double amplitude)
{
  Seen s;
  s.track.begin();
  for (int i = 1; i <= n; i++) s.see(i * way + amplitude * std::sin(2.1 * i * i), amplitude * std::cos(1.3 * i * i));
  return s;
}

TEST(RestWeights, areSumsOverThePlaces)
{
  RestWeights w;
  double sum[3] = {0, 0, 0};
  for (int n = 0; n < 40; n++) w.next();
  for (int age = 0; age <= 40; age++)
    for (int k = 0; k < 3; k++) sum[k] += std::pow(RestWeights::KEPT, age) * std::pow(age, k);
  EXPECT_NEAR(w.places(), sum[0], 1e-11);
  EXPECT_NEAR(w.age(), sum[1] / sum[0], 1e-11);
  EXPECT_NEAR(w.spread(), sum[2] - sum[1] * sum[1] / sum[0], 1e-9);
}

TEST(RestTrack, findsASteadyWay)
{
  const Seen steady = seen(5, 0.01, 0);
  EXPECT_NEAR(steady.drift(0), 0.01, 1e-12);
  EXPECT_NEAR(steady.drift(1), 0, 1e-12);
  EXPECT_NEAR(steady.allowed(), 12.5, 1e-6);
  EXPECT_NEAR(seen(1, 0.01, 0).drift(), 0.01, 1e-12);
  EXPECT_NEAR(seen(200, 0.01, 0).drift(), 0.01, 1e-12);
}

TEST(RestTrack, rockingIsNoWay)
{
  const Seen rocks = seen(20, 0, 0.02);
  EXPECT_LT(std::hypot(rocks.drift(0), rocks.drift(1)), 3e-4);
  EXPECT_GT(rocks.allowed(), 400);
  // one that goes on while it rocks is not taken for one that rocks
  const Seen both = seen(40, 0.01, 0.02);
  EXPECT_NEAR(both.drift(), 0.01, 4e-3);
  EXPECT_LT(both.allowed(), 25);
}

TEST(RestTrack, forgetsAMovementThatDiedAway)
{
  Seen s;
  s.track.begin();
  double x = 0;
  for (int n = 0; n < 100; n++) s.see(x += 0.01 * std::exp(-n / 8.));
  // of 0.01 a window at first 4e-8 is left; over all hundred windows the mean way is 9e-4
  EXPECT_LT(s.drift(), 1e-4);
  EXPECT_GT(s.allowed(), 1000);
}

TEST(RestTrack, addsUpWhatItMissed)
{
  Seen s = seen(4, 0.01, 0);
  s.track.charge(s.weights, 20);
  EXPECT_NEAR(s.track.missed[0], 0.2, 1e-12);
  s.track.begin();
  s.weights.begin();
  s.see(-0.01);
  EXPECT_NEAR(s.allowed(), 0.25 * (0.5 + 0.2) / 0.01, 1e-6);  // on its way back
  s.track.charge(s.weights, 10);                              // and back
  EXPECT_NEAR(s.track.missed[0], 0.1, 1e-12);
  Seen spent = seen(4, 0.01, 0);
  spent.track.charge(spent.weights, 60);
  EXPECT_EQ(spent.allowed(), 0);
  spent.track.begin();
  spent.weights.begin();
  spent.see(spent.track.begun[0]);  // it has come to rest
  EXPECT_GT(spent.allowed(), 1e6);
}

/// A rest in which windows are left out as allowed: what is really missed stays below the bound.
TEST(RestTrack, aParticleThatRollsMissesNoMoreThanTheBound)
{
  Seen s;
  s.track.begin();
  double x = 0, missed = 0;
  for (int n = 0; n < 1000; n++) {
    s.see(x += 0.01);
    const int out = static_cast<int>(std::min(32., s.allowed()));
    s.track.charge(s.weights, out);
    missed += out * 0.01;
  }
  EXPECT_LE(missed, 0.5);
  EXPECT_GT(missed, 0.4);
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
  w.windows(still(), false);
  for (int n = 0; n < 4; n++) w.windows(still(), true);
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
  EXPECT_EQ(w.windows(still(1e-4, 0.49999), true), 1);
  w.only(0.25);
  w.windows(still(1e-4, 0.49998), true);
  w.only(0);
  EXPECT_NEAR(w.missed(), 0.25e-5, 1e-12);
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
  EXPECT_EQ(w.windows(still(1e-4, 0.49999), true), 1);
  EXPECT_EQ(w.windows(still(1e-4, 0.49998), true), 2);
  w.only(1.0);  // woken halfway through the two, at 10 um in a window
  w.wake();
  EXPECT_NEAR(w.missed(), 2e-5, 1e-12);
  // what was inserted lies high up
  w.windows(still(0, 0.7), false);
  w.windows(still(1e-4, 0.7), true);
  EXPECT_NEAR(w.missed(), 2e-5, 1e-12);
}

TEST(RestWatch, forgetsASettlingThatIsOver)
{
  RestLimits limits;
  limits.quiet = 1;
  RestWatch w;
  w.restart(limits);
  double mean = 0.5;
  w.windows(still(1e-4, mean), false);
  for (int n = 0; n < 30; n++) w.windows(still(1e-4, mean -= n < 5 ? 1e-5 : 0), true);
  const double before = w.missed();
  for (int n = 0; n < 100; n++) w.windows(still(1e-4, mean), true);
  // 3200 windows later; 0.2 of the mean way over the thirty would be 1e-3
  EXPECT_NEAR(w.missed(), before, 2e-5);
}

TEST(RestWatch, leavesOutNoMoreThanAllowed)
{
  RestLimits limits;
  limits.quiet = 1;
  RestWatch w;
  w.restart(limits);
  w.windows(still(0.01), false);
  int most = 0;
  for (int n = 1; n <= 20; n++) {
    RestSight s = still(0.01);
    s.allowed = 5.9;
    most = std::max(most, w.windows(s, true));
  }
  EXPECT_EQ(most, 5);
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
