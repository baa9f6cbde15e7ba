// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "clumps/body_spheres.h"

#include <cmath>
#include <gtest/gtest.h>

using LAMMPS_NS::BodySpheres;

namespace {

// axes turned by 90 degrees about z
const double ex[3] = {0, 1, 0}, ey[3] = {-1, 0, 0}, ez[3] = {0, 0, 1};

struct Atoms {
  double x[6][3] = {}, v[6][3] = {}, w[6][3] = {};
};

BodySpheres three_bodies()
{
  // body 1 has no sphere here; atom 5 is an image of atom 0
  BodySpheres s;
  const double a[3] = {1, 0, 0}, b[3] = {0, 2, 0}, c[3] = {0, 0, 3};
  s.clear(3);
  s.add(2, 4, c, true, false);
  s.add(0, 5, a, false, true);
  s.add(0, 0, a, true, false);
  s.add(2, 1, a, true, false);
  s.add(0, 3, b, true, false);
  s.sort();
  return s;
}

}  // namespace

TEST(BodySpheres, AreSortedByBodyWithImagesLast)
{
  const BodySpheres s = three_bodies();
  ASSERT_EQ(s.bodies(), 3);
  EXPECT_EQ(s.begin(0), 0);
  EXPECT_EQ(s.counted(0), 2);
  EXPECT_EQ(s.end(0), 3);
  EXPECT_EQ(s.begin(1), s.end(1));
  EXPECT_EQ(s.counted(1), s.end(1));
  EXPECT_EQ(s.end(2), 5);
  const int atoms[5] = {0, 3, 5, 4, 1};
  for (int n = 0; n < 5; ++n) EXPECT_EQ(s.atom(n), atoms[n]);
  EXPECT_TRUE(s.shifted(0));
  EXPECT_FALSE(s.shifted(2));
  EXPECT_EQ(s.body_place(3)[2], 3);
}

TEST(BodySpheres, AreForgottenWhenCleared)
{
  BodySpheres s = three_bodies();
  s.clear(1);
  s.sort();
  EXPECT_EQ(s.bodies(), 1);
  EXPECT_EQ(s.end(0), 0);
  EXPECT_FALSE(s.shifted(0));
}

TEST(BodySpheres, MoveAsOneRigidBody)
{
  BodySpheres s = three_bodies();
  Atoms a;
  const double centre[3] = {10, 20, 30}, v[3] = {1, 2, 3}, w[3] = {0, 0, 4};
  s.place(0, ex, ey, ez, centre, v, w, a.x[0], a.v[0], a.w[0]);
  // d = (1 0 0) stands at (0 1 0), d = (0 2 0) at (-2 0 0)
  const double place[2][3] = {{10, 21, 30}, {8, 20, 30}}, speed[2][3] = {{-3, 2, 3}, {1, -6, 3}};
  const int atom[3] = {0, 3, 5};
  for (int n = 0; n < 3; ++n)
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(a.x[atom[n]][k], place[n % 2][k]);
      EXPECT_EQ(a.v[atom[n]][k], speed[n % 2][k]);
      EXPECT_EQ(a.w[atom[n]][k], w[k]);
    }
  EXPECT_EQ(a.x[1][0], 0);

  Atoms b;
  s.set_velocity(0, v, w, b.v[0], b.w[0]);
  for (int i : {0, 3, 5})
    for (int k = 0; k < 3; ++k) EXPECT_EQ(b.v[i][k], a.v[i][k]);
}

TEST(BodySpheres, SumForceAndMomentOfThoseThatCount)
{
  BodySpheres s = three_bodies();
  s.turn(0, ex, ey, ez);
  EXPECT_EQ(s.space_place(0)[1], 1);
  Atoms a;
  a.x[0][2] = 5;     // force on atom 0, at (0 1 0): moment (5 0 0)
  a.x[3][1] = 7;     // force on atom 3, at (-2 0 0): moment (0 0 -14)
  a.x[5][0] = 1000;  // its image does not count
  a.w[3][1] = 2;     // torque on atom 3
  double force[3] = {1, 0, 0}, torque[3] = {0, 0, 1};
  s.gather(0, a.x[0], a.w[0], force, torque);
  const double f[3] = {1, 7, 5}, t[3] = {5, 2, -13};
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(force[k], f[k]);
    EXPECT_EQ(torque[k], t[k]);
  }
}
