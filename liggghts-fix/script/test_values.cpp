// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <stdexcept>

#include "script/values.h"

using namespace clay;

namespace {

// what a reading is refused with; empty when it is not
template <class Read>
std::string refusal(Read read)
{
  try {
    read();
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST(ScriptValues, numbers)
{
  EXPECT_EQ(number("height", "-2.5e-3"), -2.5e-3);
  EXPECT_EQ(positiveNumber("height", "1e-9"), 1e-9);
  EXPECT_EQ(fraction("share", "0.98"), 0.98);
  for (const char* text : {"", "2mm", "nan", "inf", "1e999", "two"}) {
    EXPECT_EQ(refusal([&] { number("height", text); }), std::string("height is '") + text + "'; it must be a number");
    EXPECT_EQ(refusal([&] { positiveNumber("height", text); }),
              std::string("height is '") + text + "'; it must be a number greater than 0");
  }
  for (const char* text : {"0", "-1", "-1e-300"})
    EXPECT_NE(refusal([&] { positiveNumber("height", text); }), "") << text;
  for (const char* text : {"0", "1", "1.5", "-0.1", "nan"})
    EXPECT_EQ(refusal([&] { fraction("share", text); }),
              std::string("share is '") + text + "'; it must be a number greater than 0 and below 1");
}

TEST(ScriptValues, wholeNumbers)
{
  EXPECT_EQ(wholeNumber("every", "0", 0), 0);
  EXPECT_EQ(wholeNumber("every", "1", 1, 100), 1);
  EXPECT_EQ(wholeNumber("every", "100", 1, 100), 100);
  for (const char* text : {"", "0", "101", "-5", "1.0", "1e1", "ten", "99999999999999999999"})
    EXPECT_EQ(refusal([&] { wholeNumber("every", text, 1, 100); }),
              std::string("every is '") + text + "'; it must be a whole number from 1 to 100");
  for (const char* text : {"-1", "0.5", "99999999999999999999"})
    EXPECT_EQ(refusal([&] { wholeNumber("seed", text, 0); }),
              std::string("seed is '") + text + "'; it must be a whole number of 0 or more");
}

TEST(ScriptValues, words)
{
  EXPECT_TRUE(yesOrNo("walls", "yes"));
  EXPECT_FALSE(yesOrNo("walls", "no"));
  EXPECT_EQ(refusal([] { yesOrNo("walls", "on"); }), "walls is 'on'; it must be yes or no");
  EXPECT_TRUE(choice("volume", "union", "sum", "union"));
  EXPECT_FALSE(choice("volume", "sum", "sum", "union"));
}
