// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file test_damage_runs.cpp
/// True runs of two programs in which one message is damaged: both halves end soon, with
/// one line that says why. CLAYFOAM_DAMAGE=all takes every one, 100:150 those from the
/// 100th on to before the 150th, else a sample is taken.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "exchange/test_shell.h"
#include "exchange/wire.h"

namespace {

struct Message {
  const char* name;
  const char* half;
  int tag, number;
  int words;      ///< doubles at its begin that are changed one by one; 0: a text
  bool leftOver;  ///< nobody takes a second one: it does no harm
  const char* scenario = "resume";
};

struct Damaged {
  std::string what, variable, scenario;
  bool leftOver, lost;
};

std::vector<Damaged> table() {
  // tags: terms 7401, boxes, header, state, answer, shared, ..., verdict 7410
  const Message messages[] = {{"terms", "DEM", 7401, 0, 0, false},
                              {"terms", "CFD", 7401, 0, 0, true},
                              {"terms", "DEM", 7401, 1, 0, true},
                              {"verdict", "DEM", 7410, 0, 0, false},
                              {"verdict", "CFD", 7410, 0, 0, false},
                              {"verdict", "CFD", 7410, 1, 0, true},
                              {"boxes", "CFD", 7402, 0, 0, true},
                              {"terms handed on", "dem", 7401, 0, 0, false},
                              {"terms handed on", "cfd", 7401, 1, 0, false},
                              {"verdict handed on", "cfd", 7410, 0, 0, false},
                              {"boxes handed on", "dem", 7402, 0, 0, true},
                              {"header", "DEM", 7403, 0, 12, false},
                              {"header", "DEM", 7403, 3, 12, false},
                              {"resuming header", "DEM", 7403, 6, 12, false},
                              {"closing header", "DEM", 7403, 13, 12, true},
                              {"state", "DEM", 7404, 0, 2, false},
                              {"state", "DEM", 7404, 4, 2, false},
                              {"answer", "CFD", 7405, 0, 2, false},
                              {"answer", "CFD", 7405, 4, 2, false},
                              {"shared values", "cfd", 7406, 2, 2, false},
                              {"asking for the end", "CFD", 7411, 0, 3, false, "asked"}};
  std::vector<Damaged> all;
  for (const auto& m : messages) {
    const auto add = [&](const std::string& way, bool leftOver = false, bool lost = false) {
      const std::string key = std::string(m.half) + " " + std::to_string(m.tag) + " " +
                              std::to_string(m.number) + " " + way;
      all.push_back({std::string(m.name) + ": " + key, "TEST_DAMAGE='" + key + "'", m.scenario,
                     leftOver, lost});
    };
    for (int w = 0; w < m.words; ++w)
      for (const char* x : {"nan", "-1.5", "1e18", "7"}) add("word " + std::to_string(w) + " " + x);
    if (m.words == 12)
      for (const char* wx : {"0 5", "1 1000", "2 nan", "3 1", "4 0.5", "5 1e18", "6 -1", "8 inf"})
        add(std::string("sealedWord ") + wx);
    if (m.words == 2)
      for (int w : {-1, -2, -3, -4}) add("word " + std::to_string(w) + " 0.25");
    if (m.words == 2 && m.tag == 7405)
      for (const char* wx : {"0 nan", "0 1e18", "1 -1", "20 nan", "-2 77", "-3 5", "-4 nan"})
        add(std::string("sealedWord ") + wx);
    if (m.tag == 7411)
      for (const char* wx : {"0 0", "0 99", "0 1.5", "1 -1", "1 77"})
        add(std::string("sealedWord ") + wx);
    if (!m.words)
      for (int b : {0, 1, 7, 20, 40, 100}) add("byte " + std::to_string(b));
    for (const char* n : {"-1", "-8", "-40", "-1000000", "1", "8", "4000"})
      add(std::string("length ") + n);
    // of a second state nobody is told: its sender waits for it to be taken
    add("twice", m.leftOver || m.tag == 7411, m.tag == 7404);
    // one that nobody hears asks for nothing
    add("tag 7777", m.tag == 7411);
    add("lost", m.tag == 7411, true);
  }
  return all;
}

struct Choice {
  std::size_t first, end, step;
};

Choice choice(std::size_t all) {
  const char* value = std::getenv("CLAYFOAM_DAMAGE");
  const std::string text = value ? value : "";
  if (text == "all") return {0, all, 1};
  const auto colon = text.find(':');
  if (colon == std::string::npos) return {0, all, 37};
  return {std::stoul(text.substr(0, colon)), std::min(all, std::stoul(text.substr(colon + 1))), 1};
}

}  // namespace

TEST(DamagedOnItsWay, AMessageEndsBothHalvesWithALine) {
  const auto all = table();
  EXPECT_GE(all.size(), 300u);
  const Choice chosen = choice(all.size());
  int done = 0;
  for (std::size_t i = chosen.first; i < chosen.end; i += chosen.step) {
    const auto& d = all[i];
    const Outcome o = run(d.scenario, 2, 2, d.variable + (d.lost ? " CLAYFOAM_TIMEOUT=2" : ""));
    ++done;
    if (d.leftOver && o.code == 0) continue;
    EXPECT_NE(o.code, 0) << d.what << "\n" << o.text;
    EXPECT_LT(o.seconds, 40) << d.what << "\n" << o.text;
    EXPECT_FALSE(o.says("NOT TRUE")) << d.what << "\n" << o.text;
    EXPECT_FALSE(o.says("exited on signal")) << d.what << "\n" << o.text;
    // either half has its say, or is told why; one that has closed is done
    EXPECT_TRUE(o.says("test_dem_half: ") || o.says("DEM half")) << d.what << "\n" << o.text;
    EXPECT_TRUE(o.says("test_cfd_half: ") || o.says("CFD half: ")) << d.what << "\n" << o.text;
    if (chosen.step == 1)
      std::printf("%zu %s: %d, %.1f s, %s\n", i, d.what.c_str(), o.code, o.seconds,
                  o.text.substr(0, o.text.find('\n')).c_str());
  }
  std::printf("%d of %zu damaged messages\n", done, all.size());
}

// too long or too short, of the first and of a later exchange: its size is what is said of it
TEST(DamagedOnItsWay, AnAnnouncementOfAnotherSizeIsNamed) {
  const int whole = 8 * clay::wire::Header::doubles;
  for (const auto& [number, more] : {std::pair{0, -8}, {3, 4000}}) {
    const std::string damage =
        "DEM 7403 " + std::to_string(number) + " length " + std::to_string(more);
    const Outcome o = run("resume", 2, 2, "TEST_DAMAGE='" + damage + "' CLAYFOAM_TIMEOUT=20");
    const std::string reason = "the announcement of DEM rank 0: it holds " +
                               std::to_string(whole + more) + " bytes of " + std::to_string(whole);
    EXPECT_NE(o.code, 0) << o.text;
    EXPECT_TRUE(o.says("test_cfd_half: " + reason)) << o.text;
    EXPECT_TRUE(o.says("test_dem_half: stopped: the CFD half ended: " + reason)) << o.text;
  }
}
