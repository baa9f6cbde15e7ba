// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file test_waiting.cpp
/// Whether the ranks of a node have a core each, as a rank finds it.
#include <gtest/gtest.h>
#include <sched.h>

#include <cstdlib>
#include <string>

#include "exchange/waiting.h"

namespace {

// Ends a process of two ranks that sees one core with 1 where it takes them for too many
void endOnOneCore(const char* launcher) {
  for (const char* name : {"OMPI_MCA_mpi_oversubscribe", "OMPI_MCA_mpi_yield_when_idle",
                           "OMPI_MCA_orte_bound_at_launch", "PRTE_LAUNCHED"})
    unsetenv(name);
  setenv("OMPI_COMM_WORLD_LOCAL_SIZE", "2", 1);
  if (*launcher) setenv(launcher, "1", 1);
  cpu_set_t all, one;
  CPU_ZERO(&one);
  if (sched_getaffinity(0, sizeof all, &all) != 0) std::_Exit(2);
  int core = 0;
  while (!CPU_ISSET(core, &all)) ++core;
  CPU_SET(core, &one);
  if (sched_setaffinity(0, sizeof one, &one) != 0) std::_Exit(2);
  std::_Exit(clay::oversubscribed());
}

TEST(Waiting, ARankThatMpirunHasBoundLooksAtTheCoresOfAll) {
  cpu_set_t all;
  ASSERT_EQ(sched_getaffinity(0, sizeof all, &all), 0);
  if (CPU_COUNT(&all) < 2) GTEST_SKIP() << "one core";
  EXPECT_EXIT(endOnOneCore("OMPI_MCA_orte_bound_at_launch"), testing::ExitedWithCode(0), "");
  EXPECT_EXIT(endOnOneCore("PRTE_LAUNCHED"), testing::ExitedWithCode(0), "");
}

TEST(Waiting, ARankOfARunOnOneCoreIsOneOfTooMany) {
  EXPECT_EXIT(endOnOneCore(""), testing::ExitedWithCode(1), "");
}

}  // namespace
