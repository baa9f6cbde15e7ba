// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "resistance/clump_drag.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

using namespace clay;
using Eigen::Vector3d;

namespace {

Clump doublet(double a) { return {{{0, 0, -a}, a}, {{0, 0, a}, a}}; }

/// A folder of its own for each test, removed after it.
class KeptResistance : public ::testing::Test {
 protected:
  void SetUp() override
  {
    char name[] = "kept-XXXXXX";
    ASSERT_NE(::mkdtemp(name), nullptr);
    folder = name;
  }
  void TearDown() override { EXPECT_EQ(std::system(("rm -r " + folder).c_str()), 0); }

  std::string file()
  {
    std::string from;
    keptResistance(doublet(1e-3), folder, from, -1);
    const auto at = from.find("kept in ");
    return at == std::string::npos ? "" : from.substr(at + 8);
  }
  std::string folder;
};

}  // namespace

TEST(ClumpDrag, NamesItsKinds)
{
  EXPECT_EQ(clumpDragKind("sphereSum"), ClumpDragKind::sphereSum);
  EXPECT_EQ(clumpDragKind(name(ClumpDragKind::resistance)), ClumpDragKind::resistance);
  try {
    clumpDragKind("sum");
    FAIL();
  } catch (const std::invalid_argument &e) {
    EXPECT_STREQ(e.what(), "'sum'; it must be sphereSum or resistance");
  }
}

TEST(ClumpDrag, OfADoublet)
{
  const double a = 1e-3;
  const Clump clump = doublet(a);
  std::string from;
  const ClumpDrag drag(clump, keptResistance(clump, "", from).R, ShapeLaw::tranCong);
  EXPECT_NE(from.find("computed in"), std::string::npos);
  EXPECT_NEAR(drag.diameter(), 2 * a * std::cbrt(2.0), 1e-9 * a);
  const double unit = 6 * M_PI * a;
  EXPECT_NEAR(drag.stokes(Vector3d(0, 0, 3)) / unit, 1.2905, 0.002);
  EXPECT_NEAR(drag.stokes(Vector3d(0, -1e-3, 0)) / unit, 1.4490, 0.002);
  EXPECT_NEAR(drag.stokes(Vector3d::Zero()) / unit, (1.2905 + 2 * 1.4490) / 3, 0.002);
  EXPECT_EQ(drag.growth(Vector3d(0, 0, 1), 0), 1);
  EXPECT_NEAR(drag.growth(Vector3d(0, 0, 1), 1e-6), 1, 1e-4);
  ShapeFactors along = ClumpShape(clump).factors(Vector3d(0, 0, 1));
  EXPECT_NEAR(drag.growth(Vector3d(0, 0, 5), 40), shapeDragFactor(ShapeLaw::tranCong, 40, along), 1e-12);
  EXPECT_GT(drag.growth(Vector3d(0, 0, 1), 40), 1.5);
}

TEST(ClumpDrag, GivesGansersLawTheClumpsOwnStokesDrag)
{
  const Clump clump = doublet(1e-3);
  std::string from;
  const ClumpDrag drag(clump, keptResistance(clump, "", from).R, ShapeLaw::ganser);
  ShapeFactors along = ClumpShape(clump).factors(Vector3d(0, 0, 1));
  along.stokes = volumeDragRatio(drag.resistance(), drag.volume(), Vector3d(0, 0, 1));
  EXPECT_NEAR(drag.growth(Vector3d(0, 0, 1), 40), shapeDragFactor(ShapeLaw::ganser, 40, along), 1e-9);
}

TEST_F(KeptResistance, IsReadBackAsItWasAndForTheSameClumpInAnotherSize)
{
  const std::string kept = file();
  ASSERT_FALSE(kept.empty());
  std::string from;
  const StokesResistance again = keptResistance(doublet(1e-3), folder, from);
  EXPECT_EQ(from, "read from " + kept);
  const StokesResistance fresh = stokesResistance(doublet(1e-3), Vector3d::Zero());
  EXPECT_LT((again.R - fresh.R).norm(), 1e-14 * fresh.R.norm());
  EXPECT_EQ(again.report(), fresh.report());
  const StokesResistance large = keptResistance(doublet(0.5), folder, from);
  EXPECT_EQ(from, "read from " + kept);
  EXPECT_NEAR(large.R(2, 2), 500 * fresh.R(2, 2), 1e-9 * large.R(2, 2));
  EXPECT_NEAR(large.R(5, 5), std::pow(500, 3) * fresh.R(5, 5), 1e-9 * large.R(5, 5));
}

TEST_F(KeptResistance, IsComputedWhenTheFileIsOfAnotherClumpOrBroken)
{
  const std::string kept = file();
  std::string from, key;
  keptResistance({{{0, 0, -1}, 1}, {{0, 0, 0.9}, 1}}, folder, from);
  EXPECT_NE(from.find("computed in"), std::string::npos);
  std::getline(std::ifstream(kept) >> std::ws, key);
  for (const std::string &text : {std::string("other\n"), key + "\n1 2\n1 24 1\n2 84", key + "\n1 -4"}) {
    std::ofstream(kept) << text;
    const StokesResistance r = keptResistance(doublet(1e-3), folder, from);
    EXPECT_NE(from.find("computed in"), std::string::npos) << text;
    EXPECT_NEAR(r.R(2, 2) / (6e-3 * M_PI), 1.2905, 0.002);
  }
}

TEST_F(KeptResistance, DoesWithoutAFolderThatCannotBeWritten)
{
  std::string from;
  keptResistance(doublet(1e-3), "/proc/no/such/folder", from, -1);
  EXPECT_EQ(from.find("kept"), std::string::npos);
  keptResistance(doublet(1e-3), folder, from);  // not worth it
  EXPECT_EQ(from.find("kept"), std::string::npos);
}

TEST(CacheFolder, IsWhatTheEnvironmentNames)
{
  ::setenv("CLAYFOAM_CACHE", "none", 1);
  EXPECT_EQ(cacheFolder(), "");
  ::setenv("CLAYFOAM_CACHE", "here", 1);
  EXPECT_EQ(cacheFolder(), "here");
  ::unsetenv("CLAYFOAM_CACHE");
  ::setenv("XDG_CACHE_HOME", "/a/b", 1);
  EXPECT_EQ(cacheFolder(), "/a/b/clayfoam");
  ::unsetenv("XDG_CACHE_HOME");
  ::setenv("HOME", "/h", 1);
  EXPECT_EQ(cacheFolder(), "/h/.cache/clayfoam");
}
