// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file test_damage_runs.cpp
/// True runs of two programs in which one message is damaged: both halves end soon, with
/// one line that says why. CLAYFOAM_DAMAGE=all takes every one, else a sample is taken.
#include <gtest/gtest.h>

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
};

struct Damaged {
  std::string what, variable;
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
                              {"shared values", "cfd", 7406, 2, 2, false}};
  std::vector<Damaged> all;
  for (const auto& m : messages) {
    const auto add = [&](const std::string& way, bool leftOver = false, bool lost = false) {
      const std::string key = std::string(m.half) + " " + std::to_string(m.tag) + " " +
                              std::to_string(m.number) + " " + way;
      all.push_back(
          {std::string(m.name) + ": " + key, "TEST_DAMAGE='" + key + "'", leftOver, lost});
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
    if (!m.words)
      for (int b : {0, 1, 7, 20, 40, 100}) add("byte " + std::to_string(b));
    for (const char* n : {"-1", "-8", "-40", "-1000000", "1", "8", "4000"})
      add(std::string("length ") + n);
    // of a second state nobody is told: its sender waits for it to be taken
    add("twice", m.leftOver, m.tag == 7404);
    add("tag 7777");
    add("lost", false, true);
  }
  return all;
}

bool everyOne() {
  const char* value = std::getenv("CLAYFOAM_DAMAGE");
  return value && std::string(value) == "all";
}

}  // namespace

TEST(DamagedOnItsWay, AMessageEndsBothHalvesWithALine) {
  const auto all = table();
  EXPECT_GE(all.size(), 300u);
  const std::size_t step = everyOne() ? 1 : 37;
  int done = 0;
  for (std::size_t i = 0; i < all.size(); i += step) {
    const auto& d = all[i];
    const Outcome o = run("resume", 2, 2, d.variable + (d.lost ? " CLAYFOAM_TIMEOUT=2" : ""));
    ++done;
    if (d.leftOver && o.code == 0) continue;
    EXPECT_NE(o.code, 0) << d.what << "\n" << o.text;
    EXPECT_LT(o.seconds, 40) << d.what << "\n" << o.text;
    EXPECT_FALSE(o.says("NOT TRUE")) << d.what << "\n" << o.text;
    EXPECT_FALSE(o.says("exited on signal")) << d.what << "\n" << o.text;
    // either half has its say, or is told why; one that has closed is done
    EXPECT_TRUE(o.says("test_dem_half: ") || o.says("DEM half")) << d.what << "\n" << o.text;
    EXPECT_TRUE(o.says("test_cfd_half: ") || o.says("CFD half: ")) << d.what << "\n" << o.text;
    if (everyOne())
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
