// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "settling/column_profile.h"

using clay::Clusters;
using clay::ColumnProfile;

// a ball of 1 around 0.5 in slices of 0.5: caps of height 0.5 have 5/32 of its volume
TEST(ColumnProfile, spheresAreCutByTheSlices)
{
  ColumnProfile p(-1, 2, 6);
  p.addSphere(0.5, 1, 4, -2);
  const double cap = 5.0 / 32;
  for (int k = 0; k < 6; ++k) {
    const double share = k == 1 || k == 4 ? cap : k == 2 || k == 3 ? 0.5 - cap : 0;
    EXPECT_NEAR(p.get(ColumnProfile::VOLUME, k), 4 * share, 1e-14) << k;
    EXPECT_NEAR(p.get(ColumnProfile::FLUX, k), -8 * share, 1e-14) << k;
  }
  EXPECT_NEAR(p.height(1), 0.75, 1e-15);
}

// the mean over a slice of the force across its planes
TEST(ColumnProfile, forcesCrossThePlanesBetween)
{
  ColumnProfile p(0, 1, 10);
  p.addAcross(ColumnProfile::CONTACT, 0.15, 0.42, 3);   // what is above is pushed up
  p.addAcross(ColumnProfile::CONTACT, 0.42, 0.15, -3);  // said of the lower one
  const double share[10] = {0, 0.5, 1, 1, 0.2, 0, 0, 0, 0, 0};
  for (int k = 0; k < 10; ++k) EXPECT_NEAR(p.get(ColumnProfile::CONTACT, k), 6 * share[k], 1e-12) << k;
  p.addAcross(ColumnProfile::COULOMB, 0.8, 1.4, 2);  // ends with the column
  EXPECT_NEAR(p.get(ColumnProfile::COULOMB, 9), 2, 1e-12);
  p.addAcross(ColumnProfile::COULOMB, 0.3, 0.3, 5);  // no plane is between
  EXPECT_NEAR(p.get(ColumnProfile::COULOMB, 3), 0, 1e-12);
}

TEST(ColumnProfile, loadsCountBelow)
{
  ColumnProfile p(0, 1, 4);
  p.addAbove(ColumnProfile::WEIGHT, 0.375, 8);
  const double wanted[4] = {8, 4, 0, 0};
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(p.get(ColumnProfile::WEIGHT, k), wanted[k], 1e-12) << k;
  EXPECT_EQ(p.imbalance(), 1);
  p.addAcross(ColumnProfile::CONTACT, 0, 0.375, 5);
  p.addAbove(ColumnProfile::WALL, 0.375, 2);
  EXPECT_NEAR(p.imbalance(), 1.0 / 8, 1e-12);
  p.addAcross(ColumnProfile::COULOMB, 0, 0.375, 0.25);
  p.addAbove(ColumnProfile::FLUID, 0.375, 0.75);
  EXPECT_NEAR(p.imbalance(), 0, 1e-12);
  p.clear();
  EXPECT_EQ(p.imbalance(), 0);
}

TEST(ColumnProfile, takesAnyNumber)
{
  for (double z : {std::nan(""), HUGE_VAL, -HUGE_VAL, 1e300, -1e300}) {
    ColumnProfile p(0, 1, 10);
    p.addSphere(z, 0.1, 1, 0);
    p.addAbove(ColumnProfile::WEIGHT, z, 1);
    p.addAcross(ColumnProfile::CONTACT, z, 0.5, 1);
    p.addAt(ColumnProfile::BODIES, z, 1);
    EXPECT_EQ(p.sums().size(), 10u * ColumnProfile::SUMS);
  }
}

TEST(ColumnProfile, axesOfPlatesAndRods)
{
  const double plate[3] = {1, 2, 1.02}, rod[3] = {2, 2.01, 0.3}, ball[3] = {1, 1.001, 1};
  EXPECT_EQ(clay::axisOf(plate), 1);
  EXPECT_EQ(clay::axisOf(rod), 2);
  EXPECT_EQ(clay::axisOf(ball), -1);

  ColumnProfile p(0, 1, 1);
  const double n[3] = {0.6, 0, 0.8};
  p.addAxis(0.5, n);
  EXPECT_NEAR(p.get(ColumnProfile::XX, 0), 0.36, 1e-15);
  EXPECT_NEAR(p.get(ColumnProfile::ZZ, 0), 0.64, 1e-15);
  EXPECT_NEAR(p.get(ColumnProfile::XZ, 0), 0.48, 1e-15);
  EXPECT_EQ(p.get(ColumnProfile::YY, 0) + p.get(ColumnProfile::XY, 0) + p.get(ColumnProfile::YZ, 0), 0);
  EXPECT_EQ(p.get(ColumnProfile::AXES, 0), 1);
}

TEST(ColumnProfile, facesAndEdgesThatMeet)
{
  const double up[3] = {0, 0, 1}, side[3] = {1, 0, 0}, line[3] = {0.1, 0.1, -3};
  EXPECT_EQ(clay::meeting(up, up, line), ColumnProfile::FACE_FACE);
  EXPECT_EQ(clay::meeting(side, up, line), ColumnProfile::EDGE_FACE);
  EXPECT_EQ(clay::meeting(side, side, line), ColumnProfile::EDGE_EDGE);
}

TEST(Clusters, membersThatLinksJoin)
{
  Clusters c(6);
  c.join(0, 1);
  c.join(3, 4);
  c.join(1, 0);
  c.join(4, 0);
  for (int k : {0, 1, 3, 4}) EXPECT_EQ(c.size(k), 4) << k;
  EXPECT_EQ(c.size(2), 1);
  EXPECT_EQ(c.size(5), 1);
}
