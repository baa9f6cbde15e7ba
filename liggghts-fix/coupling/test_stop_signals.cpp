// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/stop_signals.h"

#include <gtest/gtest.h>
#include <signal.h>

using namespace clay;

TEST(StopSignals, areNotedWhileACoupledRunListens)
{
  listen_for_stops(false);
  EXPECT_FALSE(note_stop(SIGTERM));
  EXPECT_EQ(noted_stop(), 0);
  listen_for_stops(true);
  EXPECT_TRUE(note_stop(SIGTERM));
  EXPECT_EQ(noted_stop(), SIGTERM);
  forget_stop();
  EXPECT_EQ(noted_stop(), 0);
}

TEST(StopSignals, theSecondOneEndsTheProcess)
{
  EXPECT_EXIT(
      {
        listen_for_stops(true);
        note_stop(SIGINT);
        note_stop(SIGTERM);
      },
      testing::ExitedWithCode(143), "");
}

TEST(StopSignals, theReasonNamesSignalAndTime)
{
  EXPECT_EQ(stop_reason(SIGTERM, 0.117, 0.5), "ended by SIGTERM at 0.117 s of 0.5 s");
  EXPECT_EQ(stop_reason(-SIGUSR1, 0.117, 0.5), "ended by SIGUSR1 to the CFD half at 0.117 s of 0.5 s");
  EXPECT_EQ(stop_reason(99, 1, 2), "ended by signal 99 at 1 s of 2 s");
  EXPECT_EQ(stop_reason(0, 1, 2), "the run was cut short at 1 s of 2 s");
}
