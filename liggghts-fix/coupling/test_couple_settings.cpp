// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/couple_settings.h"

#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>

using clay::ClumpDragKind;
using clay::CoupleSettings;

namespace {

CoupleSettings parse(const std::string &line)
{
  std::istringstream in(line);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return CoupleSettings::parse(words);
}

// what is said of a line that is wrong
std::string said(const std::string &line)
{
  try {
    parse(line);
  } catch (const std::invalid_argument &e) {
    return e.what();
  }
  return "nothing";
}

}  // namespace

TEST(CoupleSettings, defaults)
{
  const CoupleSettings s = parse("every 20");
  EXPECT_EQ(s.interval, 20);
  EXPECT_EQ(s.lag, 0);
  EXPECT_EQ(s.stats, "");
  EXPECT_EQ(s.progress, 1.0);
  EXPECT_TRUE(s.contactLimit);
  EXPECT_TRUE(s.watch);
  EXPECT_EQ(s.clumpDrag, ClumpDragKind::sphereSum);
  EXPECT_EQ(s.shapeLaw, "");
}

TEST(CoupleSettings, allKeywordsInAnyOrder)
{
  const CoupleSettings s = parse("lag 7 shapeLaw ganser watch no stats a.json progress 2.5 contact_limit no "
                                 "clumpDrag resistance every 8");
  EXPECT_EQ(s.interval, 8);
  EXPECT_EQ(s.lag, 7);
  EXPECT_EQ(s.stats, "a.json");
  EXPECT_EQ(s.progress, 2.5);
  EXPECT_FALSE(s.contactLimit);
  EXPECT_FALSE(s.watch);
  EXPECT_EQ(s.clumpDrag, ClumpDragKind::resistance);
  EXPECT_EQ(s.shapeLaw, "ganser");
}

TEST(CoupleSettings, aResistanceHasAShapeLaw)
{
  EXPECT_EQ(parse("every 1 clumpDrag resistance").shapeLaw, "tranCong");
  EXPECT_EQ(said("every 1 shapeLaw ganser"), "shapeLaw belongs to clumpDrag resistance, which is not set");
  EXPECT_EQ(said("every 1 clumpDrag resistance shapeLaw stokes"),
            "shapeLaw: unknown shape law 'stokes', must be holzerSommerfeld, ganser or tranCong");
}

TEST(CoupleSettings, lagOfAnInterval)
{
  EXPECT_EQ(parse("every 27 lag auto").lag, 6);
  EXPECT_EQ(parse("every 3 lag 2").lag, 2);
  EXPECT_EQ(said("every 3 lag 3"),
            "lag is '3'; it must be auto or a whole number of DEM steps from 0 to 2, below every");
  EXPECT_EQ(said("every 3 lag -1"), said("every 3 lag 3").replace(8, 1, "-1"));
}

TEST(CoupleSettings, whatIsWrongIsSaidInOneLine)
{
  EXPECT_EQ(said(""), "'every N' is missing; N is the number of DEM steps between two exchanges");
  EXPECT_EQ(said("stats a.json"), said(""));
  EXPECT_EQ(said("every"), "keyword 'every' needs a value");
  for (const char *wrong : {"0", "-3", "2.5", "1e3", "ten", "100000001", "99999999999999999999"})
    EXPECT_EQ(said(std::string("every ") + wrong),
              std::string("every is '") + wrong + "'; it must be a whole number of DEM steps from 1 to 100000000");
  EXPECT_EQ(parse("every 100000000").interval, 100000000);
  EXPECT_EQ(said("every 1 watch on"), "watch is 'on'; it must be yes or no");
  EXPECT_EQ(said("every 1 contact_limit 0"), "contact_limit is '0'; it must be yes or no");
  for (const char *wrong : {"-1", "often", "nan"})
    EXPECT_EQ(said(std::string("every 1 progress ") + wrong),
              std::string("progress is '") + wrong + "'; it must be a number of seconds, 0 for no line");
  EXPECT_EQ(said("every 1 clumpDrag sum"), "clumpDrag is 'sum'; it must be sphereSum or resistance");
  EXPECT_EQ(said("every 1 stat a.json"),
            "unknown keyword 'stat'; known are every, lag, stats, progress, "
            "contact_limit, watch, clumpDrag, shapeLaw, checkpoint, checkpoint_every, checkpoint_steps");
}

TEST(CoupleSettings, checkpointsByTimeOrBySteps)
{
  CoupleSettings s = parse("every 20");
  EXPECT_EQ(s.checkpoint, "");
  EXPECT_EQ(s.checkpointEvery, 600);
  EXPECT_EQ(s.checkpointSteps, 0);
  s = parse("checkpoint_steps 60 checkpoint_every 2.5 checkpoint states every 20");
  EXPECT_EQ(s.checkpoint, "states");
  EXPECT_EQ(s.checkpointEvery, 2.5);
  EXPECT_EQ(s.checkpointSteps, 60);
  EXPECT_EQ(parse("every 20 checkpoint states checkpoint_steps 0").checkpointSteps, 0);

  EXPECT_EQ(said("every 20 checkpoint_steps 60"),
            "checkpoint_every and checkpoint_steps belong to checkpoint FOLDER, which is not set");
  for (const char *bad : {"0", "-1", "soon", "inf"})
    EXPECT_EQ(said(std::string("every 20 checkpoint c checkpoint_every ") + bad),
              std::string("checkpoint_every is '") + bad + "'; it must be a number of seconds above 0");
  for (const char *bad : {"50", "10", "-20", "2.5"})
    EXPECT_EQ(said(std::string("every 20 checkpoint c checkpoint_steps ") + bad),
              std::string("checkpoint_steps is '") + bad + "'; it must be 0 or a multiple of every, 20 DEM steps");
}
