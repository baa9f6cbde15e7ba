// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "placing/places_file.h"

using clay::readPlaces;

namespace {

const std::vector<clay::PlaceKind> kinds = {{"ill", true}, {"kao", true}, {"grain", false}};

std::string refusal(const std::string& text)
{
  try {
    readPlaces(text, "list", kinds);
  } catch (const std::runtime_error& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST(PlacesFile, particlesInTheirOrder)
{
  const auto p = readPlaces("# a comment\n\nkao 1 2 3 0.6 0 -0.8 0 # turned\n1 1e-3 0 0 1 0 0 0\n"
                            "  grain 4 5 6\r\n3 7 8 9 0.25",
                            "list", kinds);
  ASSERT_EQ(p.size(), 4u);
  EXPECT_EQ(p[0].kind, 1);
  EXPECT_EQ(p[0].line, 3);
  EXPECT_DOUBLE_EQ(p[0].x[2], 3);
  EXPECT_DOUBLE_EQ(p[0].q[0], 0.6);
  EXPECT_DOUBLE_EQ(p[0].q[2], -0.8);
  EXPECT_EQ(p[1].kind, 0);
  EXPECT_DOUBLE_EQ(p[1].x[0], 1e-3);
  EXPECT_EQ(p[2].kind, 2);
  EXPECT_EQ(p[2].radius, 0);
  EXPECT_DOUBLE_EQ(p[3].radius, 0.25);
}

TEST(PlacesFile, partsOfAFileCountOn)
{
  EXPECT_TRUE(readPlaces("", "list", kinds).empty());
  EXPECT_TRUE(readPlaces("# nothing\n\n", "list", kinds).empty());
  const auto p = readPlaces("# still nothing\ngrain 4 5 6\n", "list", kinds, 1001);
  ASSERT_EQ(p.size(), 1u);
  EXPECT_EQ(p[0].line, 1002);
  try {
    readPlaces("grain 1 2\n", "list", kinds, 1003);
    FAIL();
  } catch (const std::runtime_error& e) {
    EXPECT_EQ(std::string(e.what()), "file list, line 1003: 3 words; needed are 4 or 5: template x y z [radius]");
  }
}

TEST(PlacesFile, quaternionsAreMadeUnit)
{
  const auto p = readPlaces("ill 0 0 0 0.5 0.5 0.5 0.5000001", "list", kinds);
  double norm = 0;
  for (double c : p[0].q) norm += c * c;
  EXPECT_NEAR(norm, 1, 1e-15);
}

TEST(PlacesFile, refusalsNameFileAndLine)
{
  EXPECT_EQ(refusal("grain 1 2 3\nmica 0 0 0 1 0 0 0"),
            "file list, line 2: template 'mica' is not known; known are 1 = ill, 2 = kao, 3 = grain");
  EXPECT_EQ(refusal("4 0 0 0"), "file list, line 1: template '4' is not known; known are 1 = ill, 2 = kao, 3 = grain");
  EXPECT_EQ(refusal("ill 0 0 0"), "file list, line 1: 4 words; needed are 8: template x y z q0 q1 q2 q3");
  EXPECT_EQ(refusal("grain 0 0"), "file list, line 1: 3 words; needed are 4 or 5: template x y z [radius]");
  EXPECT_EQ(refusal("ill 0 0 high 1 0 0 0"), "file list, line 1: a coordinate is 'high'; it must be a number");
  EXPECT_EQ(refusal("ill 0 0 nan 1 0 0 0"), "file list, line 1: a coordinate is 'nan'; it must be a number");
  EXPECT_EQ(refusal("ill 0 0 0 1 0 0 1"), "file list, line 1: the quaternion has length 1.41421: 1 is needed");
  EXPECT_EQ(refusal("grain 0 0 0 -1"), "file list, line 1: the radius is '-1'; it must be a number greater than 0");
}
