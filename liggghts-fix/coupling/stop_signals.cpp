// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/stop_signals.h"

#include <signal.h>
#include <unistd.h>

#include <cstdio>

namespace clay {

namespace {

volatile sig_atomic_t listening = 0, noted = 0;

}  // namespace

void listen_for_stops(bool listens) { listening = listens; }

bool note_stop(int signal)
{
  if (!listening) return false;
  if (noted) _exit(128 + signal);
  noted = signal;
  return true;
}

int noted_stop() { return noted; }

void forget_stop() { noted = 0; }

std::string signal_name(int signal)
{
  switch (signal) {
  case SIGHUP:
    return "SIGHUP";
  case SIGINT:
    return "SIGINT";
  case SIGTERM:
    return "SIGTERM";
  case SIGUSR1:
    return "SIGUSR1";
  default:
    return "signal " + std::to_string(signal);
  }
}

std::string stop_reason(int signal, double time, double end)
{
  char at[80];
  snprintf(at, sizeof at, " at %.6g s of %.6g s", time, end);
  if (signal < 0) return "ended by " + signal_name(-signal) + " to the CFD half" + at;
  return (signal ? "ended by " + signal_name(signal) : std::string("the run was cut short")) + at;
}

}  // namespace clay
