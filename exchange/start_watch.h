// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file start_watch.h
/// A time limit on the start of MPI, which needs no other program of the mpirun.
#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>

namespace clay {

/// While it lives, silenceLimit() seconds end this process with one line that says so:
/// MPI_Init waits for all programs without limit, also for one that is stopped.
/// \warning  Its thread calls nothing of MPI, whose level of threads the host chooses.
class StartWatch {
 public:
  StartWatch();
  ~StartWatch();
  StartWatch(const StartWatch&) = delete;
  StartWatch& operator=(const StartWatch&) = delete;

 private:
  std::mutex mutex_;
  std::condition_variable ended_;
  bool over_ = false;
  std::thread thread_;
};

}  // namespace clay
