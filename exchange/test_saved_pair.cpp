// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file test_saved_pair.cpp
/// A pair of saved states is complete or does not exist.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "exchange/saved_pair.h"

namespace fs = std::filesystem;
using clay::SavedPair;

namespace {

class Pairs : public testing::Test {
 protected:
  void SetUp() override { clay::makeEmpty(folder); }
  void TearDown() override { fs::remove_all(folder); }

  // writes both parts of a pair
  void write(const SavedPair& pair) {
    for (const char* half : {"dem", "cfd"}) {
      const std::string part = clay::unfinishedPair(folder, pair) + "/" + half;
      clay::makeEmpty(part);
      clay::makeEmpty(part + "/more");
      std::ofstream(part + "/state") << half << pair.step;
      std::ofstream(part + "/more/field") << pair.step;
      clay::writeSums(part, pair);
    }
  }
  std::string part(const SavedPair& pair) const { return clay::pairFolder(folder, pair) + "/dem"; }
  bool there(double step) const { return fs::exists(clay::pairFolder(folder, {0, step})); }

  const std::string folder = fs::temp_directory_path() / ("pairs" + std::to_string(::getpid()));
};

TEST_F(Pairs, StandInTheirPlaceOnlyWhenComplete) {
  const SavedPair pair{77, 1200};
  write(pair);
  EXPECT_FALSE(there(1200));
  clay::completePair(folder, pair);
  EXPECT_TRUE(there(1200));
  EXPECT_EQ(clay::damage(part(pair), pair), "");
  EXPECT_FALSE(fs::exists(clay::unfinishedPair(folder, pair)));
}

TEST_F(Pairs, TheLastTwoAreKept) {
  for (double step : {900., 1000., 2000., 1e9}) {
    write({step, step});
    clay::completePair(folder, {step, step});
  }
  EXPECT_FALSE(there(900));
  EXPECT_FALSE(there(1000));
  EXPECT_TRUE(there(2000));
  EXPECT_TRUE(there(1e9));
}

TEST_F(Pairs, OneOfTheSameStepTakesThePlaceOfTheOther) {
  write({5, 100});
  clay::completePair(folder, {5, 100});
  write({6, 100});
  clay::completePair(folder, {6, 100});
  EXPECT_EQ(clay::damage(part({6, 100}), {6, 100}), "");
}

TEST_F(Pairs, WhatIsTornMissingOrOfAnotherPairIsNamed) {
  const SavedPair pair{77, 1200};
  write(pair);
  clay::completePair(folder, pair);
  EXPECT_NE(clay::damage(part(pair), {78, 1200}).find("is of pair 77"), std::string::npos);

  std::ofstream(part(pair) + "/state") << "dem120";
  EXPECT_NE(clay::damage(part(pair), pair).find("state: is not what was written"),
            std::string::npos);
  std::ofstream(part(pair) + "/state") << "dem1201";
  EXPECT_NE(clay::damage(part(pair), pair).find("state: is not what was written"),
            std::string::npos);
  std::ofstream(part(pair) + "/state") << "dem1200";
  fs::remove(part(pair) + "/more/field");
  EXPECT_NE(clay::damage(part(pair), pair).find("more/field: is missing"), std::string::npos);
  std::ofstream(part(pair) + "/more/field") << 1200.;
  fs::remove(part(pair) + "/state");
  EXPECT_NE(clay::damage(part(pair), pair).find("state: is missing"), std::string::npos);
  fs::remove(part(pair) + "/sums");
  EXPECT_NE(clay::damage(part(pair), pair).find("has no sums"), std::string::npos);
}

TEST_F(Pairs, AFolderThatCannotBeMadeIsNamed) {
  std::ofstream(folder + "/file") << "x";
  try {
    clay::makeEmpty(folder + "/file/in");
    FAIL();
  } catch (const std::runtime_error& e) {
    EXPECT_NE(std::string(e.what()).find("cannot make folder " + folder + "/file/in"),
              std::string::npos);
  }
}

TEST_F(Pairs, WhatWasWrittenOfOneCanBeDropped) {
  write({7, 300});
  clay::dropPair(folder, {7, 300});
  EXPECT_FALSE(fs::exists(clay::unfinishedPair(folder, {7, 300})));
}

// as Python's zlib reads it (cases/lib/run/saved_pairs.py)
TEST(Checksum, IsThatOfZlib) {
  const fs::path folder = fs::temp_directory_path() / ("clay_sums_" + std::to_string(getpid()));
  fs::create_directories(folder);
  std::ofstream(folder / "digits") << "123456789";
  clay::writeSums(folder.string(), {7, 20});
  std::ifstream in(folder / "sums");
  std::string first, second;
  std::getline(in, first);
  std::getline(in, second);
  fs::remove_all(folder);
  EXPECT_EQ(first, "pair 7 step 20");
  EXPECT_EQ(second, "cbf43926 9 digits");
}

TEST(PairNumber, LiesAboveNoneAndBelowWhatADoubleCountsTo) {
  EXPECT_EQ(clay::pairNumber(0), 1);
  EXPECT_EQ(clay::pairNumber(~std::uint64_t{0}), 9007199254740991.);
  EXPECT_EQ(clay::pairNumber(std::uint64_t{1} << 12), 3);
}

TEST(PairNumber, IsWholeAndDiffersFromOthers) {
  const double a = clay::newPairNumber(), b = clay::newPairNumber();
  EXPECT_NE(a, b);
  EXPECT_EQ(a, std::floor(a));
  EXPECT_GT(a, 0);
  EXPECT_LT(a, 9007199254740992.);
}

}  // namespace
