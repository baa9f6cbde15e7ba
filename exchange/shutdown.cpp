// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/shutdown.h"

#include <errno.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <thread>
#include <utility>

#include "exchange/wire.h"

namespace clay {

namespace {

using Clock = std::chrono::steady_clock;

// Seconds. Their sum stays below the 10 s in which both halves must have ended.
constexpr double deliveryGrace = 2.5;  // until the other half listens
constexpr double savingGrace = 5.0;    // until the other half has saved

struct State {
  Stage stage = Stage::uncoupled;
  bool watching = false, mayFinalize = false;
  std::atomic<bool> ending{false};
  std::function<void(const std::string&)> save;
  std::string explained, lastWords;
};

State& state() {
  // never destroyed: it is still needed while the program exits
  static State* s = new State;
  return *s;
}

class Deadline {
 public:
  explicit Deadline(double seconds) : seconds_(seconds), start_(Clock::now()) {}
  bool over() const {
    return std::chrono::duration<double>(Clock::now() - start_).count() > seconds_;
  }

 private:
  double seconds_;
  Clock::time_point start_;
};

void nap() { std::this_thread::sleep_for(std::chrono::microseconds(300)); }

bool mpiRuns() {
  int started = 0, over = 0;
  PMPI_Initialized(&started);
  if (started) PMPI_Finalized(&over);
  return started && !over;
}

bool coupledRun() {
  return mpiRuns() && World::instance().ready() && World::instance().hasOtherHalf();
}

// As one line of letters that a terminal can show, not too long
std::string oneLine(std::string text) {
  constexpr std::size_t longest = 4000;
  if (text.size() > longest) text.replace(longest, std::string::npos, " ...");
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = ' ';
  return text;
}

// Receives a message of shutdown, if there is one
bool receiveShutdown(std::string& reason) {
  MPI_Comm whole = World::instance().whole();
  int there = 0;
  MPI_Status status;
  PMPI_Iprobe(MPI_ANY_SOURCE, wire::tagShutdown, whole, &there, &status);
  if (!there) return false;
  int length = 0;
  PMPI_Get_count(&status, MPI_CHAR, &length);
  reason.assign(static_cast<std::size_t>(length), ' ');
  PMPI_Recv(&reason[0], length, MPI_CHAR, status.MPI_SOURCE, wire::tagShutdown, whole,
            MPI_STATUS_IGNORE);
  reason = oneLine(reason);
  return true;
}

// Tells every rank of the other half why this half ends, and waits until the
// other half ends both, or until it had time enough.
void tellOtherHalf(const std::string& reason) {
  const auto& world = World::instance();
  std::vector<MPI_Request> requests(world.remoteRanks().size());
  for (std::size_t i = 0; i < requests.size(); ++i)
    PMPI_Issend(reason.data(), static_cast<int>(reason.size()), MPI_CHAR, world.remoteRanks()[i],
                wire::tagShutdown, world.whole(), &requests[i]);
  const Deadline delivery(deliveryGrace), saving(deliveryGrace + savingGrace);
  int delivered = 0;
  std::string theirs;
  while (!saving.over()) {
    PMPI_Testall(static_cast<int>(requests.size()), requests.data(), &delivered,
                 MPI_STATUSES_IGNORE);
    // both halves may end at the same time
    if (receiveShutdown(theirs)) return;
    if (!delivered && delivery.over() && world.rank() == 0) return;
    nap();
  }
}

void say(const std::string& line) {
  std::cout.flush();
  const std::string whole = programName() + ": " + line + "\n";
  std::fputs(whole.c_str(), stderr);
  std::fflush(stderr);
}

// The other half has ended: save what there is, all ranks, then end.
[[noreturn]] void follow(const std::string& reason) {
  const auto& world = World::instance();
  auto& s = state();
  if (world.rank() == 0) {
    const Half other = world.which() == Half::dem ? Half::cfd : Half::dem;
    say(std::string("stopped: the ") + name(other) + " half ended: " + reason);
  }
  const bool saves = static_cast<bool>(s.save);
  const Deadline deadline(saves ? savingGrace : 1.0);
  if (saves) try {
      s.save(reason);
    } catch (const std::exception& e) {
      say(std::string("the state could not be saved: ") + e.what());
    } catch (...) {
      say("the state could not be saved");
    }
  char done = 1;
  if (world.rank() == 0) {
    int missing = world.size() - 1;
    while (missing > 0 && !deadline.over()) {
      int there = 0;
      MPI_Status status;
      PMPI_Iprobe(MPI_ANY_SOURCE, wire::tagSaved, world.whole(), &there, &status);
      if (there) {
        PMPI_Recv(&done, 1, MPI_CHAR, status.MPI_SOURCE, wire::tagSaved, world.whole(),
                  MPI_STATUS_IGNORE);
        --missing;
      } else {
        nap();
      }
    }
  } else {
    MPI_Request request;
    PMPI_Isend(&done, 1, MPI_CHAR, world.localRanks()[0], wire::tagSaved, world.whole(), &request);
    const Deadline limit(deliveryGrace + savingGrace);
    int sent = 0;
    while (!limit.over()) {
      if (!sent) PMPI_Test(&request, &sent, MPI_STATUS_IGNORE);
      nap();
    }
  }
  endAll(1);
}

// Before this half ends both: the other half is told, or, when it knows already
// that the run is over, may come to its own end
void tellAndWait(const std::string& reason) {
  if (!coupledRun()) return;
  if (state().stage == Stage::closed)
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
  else
    tellOtherHalf(reason);
}

// When many ranks of a half fail at the same time, the first one speaks for all
// and ends them.
bool firstRankSpeaks() {
  if (!mpiRuns() || !World::instance().ready()) return false;
  const auto& world = World::instance();
  const int tag = wire::tagSpeaks;
  if (world.rank() == 0) {
    static char word = 0;
    static std::vector<MPI_Request> requests(world.localRanks().size());
    for (std::size_t r = 1; r < requests.size(); ++r)
      PMPI_Isend(&word, 1, MPI_CHAR, world.localRanks()[r], tag, world.whole(), &requests[r]);
    return false;
  }
  int speaks = 0;
  for (const Deadline limit(0.2); !speaks && !limit.over(); nap())
    PMPI_Iprobe(world.localRanks()[0], tag, world.whole(), &speaks, MPI_STATUS_IGNORE);
  for (const Deadline limit(deliveryGrace + savingGrace); speaks && !limit.over();) nap();
  return speaks != 0;
}

// Once: what ends the run may have said them itself
std::string withLastWords(const std::string& reason) {
  const std::string& words = state().lastWords;
  return reason.find(words) == std::string::npos ? reason + words : reason;
}

std::string explained() {
  return state().explained.empty() ? "" : ": " + oneLine(state().explained);
}

std::string tooEarly() {
  return withLastWords(programName() +
                       (state().stage == Stage::uncoupled ? " ended without ever coupling"
                                                          : " ended before the coupled run did") +
                       explained());
}

void atExit() {
  auto& s = state();
  if (s.ending || !mpiRuns()) return;
  if (coupledRun() && s.stage != Stage::closed) {
    s.ending = true;
    const std::string reason = tooEarly();
    if (World::instance().rank() == 0) say(reason);
    tellOtherHalf(reason);
    endAll(1);
  }
  if (s.mayFinalize) {
    s.ending = true;
    World::instance().giveBack();
    PMPI_Finalize();
  }
}

[[noreturn]] void onTerminate() {
  std::string reason = "ended by an uncaught exception";
  if (auto e = std::current_exception()) try {
      std::rethrow_exception(e);
    } catch (const std::exception& x) {
      reason += std::string(": ") + x.what();
    } catch (...) {
    }
  abandon(reason);
}

}  // namespace

void endAll(int code) {
  if (code == 0) code = 1;
  std::cout.flush();
  std::cerr.flush();
  std::fflush(nullptr);
  // Open MPI's mpirun ends the other processes when one fails. The message that
  // goes with MPI_Abort at times makes mpirun 4.1 crash or hang.
  const bool mpirun = std::getenv("OMPI_MCA_orte_launch") || std::getenv("PRTE_LAUNCHED");  // 4, 5
  if (mpiRuns() && !mpirun) PMPI_Abort(MPI_COMM_WORLD, code);
  _exit(code);
}

std::string programName() { return program_invocation_short_name; }

void setStage(Stage stage) { state().stage = stage; }

Stage stage() { return state().stage; }

void onShutdown(std::function<void(const std::string&)> save) { state().save = std::move(save); }

void checkShutdown() {
  // one that has refused by itself needs nobody's word any more
  if (state().ending || !coupledRun() || state().stage == Stage::closed) return;
  std::string reason;
  if (!receiveShutdown(reason)) return;
  state().ending = true;
  follow(reason);
}

void explainEnd(const std::string& reason) { state().explained = reason; }

void setLastWords(const std::string& words) { state().lastWords = words; }

void beforeFinalize() {
  auto& s = state();
  if (s.ending) endAll(1);
  if (!coupledRun() || s.stage == Stage::closed) return;
  s.ending = true;
  if (World::instance().rank() == 0) {
    const std::string reason = tooEarly();
    say(reason);
    tellOtherHalf(reason);
  } else {
    // the first rank speaks for this half and ends it
    const Deadline limit(deliveryGrace + savingGrace);
    while (!limit.over()) nap();
  }
  endAll(1);
}

void abortBoth(int code) {
  if (!state().ending.exchange(true))
    tellAndWait(withLastWords(programName() + " called MPI_Abort with code " +
                              std::to_string(code) + explained()));
  endAll(code);
}

void abandon(const std::string& reason) {
  if (!state().ending.exchange(true) && !firstRankSpeaks()) {
    const std::string all = withLastWords(reason);
    say(all);
    tellAndWait(all);
  }
  endAll(1);
}

void watchExit(bool mayFinalize) {
  auto& s = state();
  s.mayFinalize = s.mayFinalize || mayFinalize;
  if (s.watching) return;
  s.watching = true;
  std::atexit(atExit);
  if (World::instance().hasOtherHalf()) std::set_terminate(onTerminate);
}

}  // namespace clay
