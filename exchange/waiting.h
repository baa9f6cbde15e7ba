// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file waiting.h
/// Waiting without holding a core: tests with back-off, that end at once when
/// the other half has failed or gone.
#pragma once

#include <mpi.h>

#include <chrono>
#include <string>
#include <vector>

namespace clay {

/// One wait that has not come to its end at the first test.
class Backoff {
 public:
  /// \param forWhat  what is waited for, as it stands in a message
  explicit Backoff(const char* forWhat);

  /// Lets some time pass between two tests: none at first, then sleeps, ever
  /// longer, a small part of the time that was waited already. Ends the
  /// process when the other half shuts down, and both halves after too long a silence.
  void pause();

  /// Time waited so far [s].
  double waited() const;

 private:
  const char* forWhat_;
  std::chrono::steady_clock::time_point start_;
  int pauses_ = 0;
  double nextLook_ = 0.5;  // for messages that nobody takes [s]
};

/// More ranks than cores on this node: waiting must give the core away at once.
bool oversubscribed();

/// Seconds of silence after which a wait is given up: CLAYFOAM_TIMEOUT, or 600.
double silenceLimit();

/// Ends both halves when a wait [s] has outlasted the limit.
void endOnSilence(double waited, const char* forWhat);

/// Waits until done() is true; adds the time to *waited [s] if it is given.
template <class Done>
void waitUntil(Done done, const char* forWhat, double* waited = nullptr) {
  if (done()) return;
  Backoff backoff(forWhat);
  do backoff.pause();
  while (!done());
  if (waited) *waited += backoff.waited();
}

/// True when all the requests have completed.
bool allDone(std::vector<MPI_Request>& requests);

/// Sends to a rank of World::whole() and waits until it has gone.
void sendText(const std::string& text, int rank, int tag, const char* forWhat);

/// Waits for a message of a rank of World::whole().
std::string receiveText(int rank, int tag, const char* forWhat);

}  // namespace clay
