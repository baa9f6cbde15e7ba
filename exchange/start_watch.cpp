// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/start_watch.h"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "exchange/shutdown.h"
#include "exchange/waiting.h"

namespace clay {

namespace {

// The first rank speaks first, if it runs; mpirun then ends the others
double startLimit() {
  const char* rank = std::getenv("OMPI_COMM_WORLD_RANK");
  const double longest = 1e8;  // [s], which the clock can count
  return std::min(silenceLimit(), longest) + (rank && std::strcmp(rank, "0") != 0 ? 1 : 0);
}

}  // namespace

StartWatch::StartWatch() {
  const double limit = startLimit();
  // the host's handlers run in the host's thread
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, &before);
  thread_ = std::thread([this, limit] {
    std::unique_lock<std::mutex> lock(mutex_);
    if (ended_.wait_for(lock, std::chrono::duration<double>(limit), [this] { return over_; }))
      return;
    char seconds[32];
    std::snprintf(seconds, sizeof seconds, "%.4g", silenceLimit());
    const std::string line =
        programName() + ": waited " + seconds +
        " s for all programs of this mpirun to start MPI; one of them is stopped, or never does; "
        "CLAYFOAM_TIMEOUT (seconds) sets how long a half waits\n";
    std::fputs(line.c_str(), stderr);
    _exit(1);
  });
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

StartWatch::~StartWatch() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    over_ = true;
  }
  ended_.notify_one();
  thread_.join();
}

}  // namespace clay
