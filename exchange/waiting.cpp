// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/waiting.h"

#include <sched.h>
#include <sys/prctl.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "exchange/shutdown.h"
#include "exchange/wire.h"
#include "exchange/world.h"

namespace clay {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double spinTime = 200e-6;      // [s] of testing alone: most answers come sooner
constexpr double shortestSleep = 10e-6;  // [s]
constexpr double longestSleep = 1e-3;    // [s]
constexpr double sleepPart = 1. / 16;    // of the time waited already

double seconds(Clock::duration d) { return std::chrono::duration<double>(d).count(); }

void sleepFor(double time) {
  // the kernel rounds sleeps up by 50 us unless told otherwise
  static const int sharp = prctl(PR_SET_TIMERSLACK, 1000UL, 0UL, 0UL, 0UL);
  static_cast<void>(sharp);
  timespec t{0, static_cast<long>(time * 1e9)};
  nanosleep(&t, nullptr);
}

bool isSet(const char* variable) {
  const char* value = std::getenv(variable);
  return value && *value && std::strcmp(value, "0") != 0;
}

bool findOversubscribed() {
  if (isSet("OMPI_MCA_mpi_oversubscribe") || isSet("OMPI_MCA_mpi_yield_when_idle")) return true;
  const char* local = std::getenv("OMPI_COMM_WORLD_LOCAL_SIZE");
  const long ranks = local ? std::atol(local) : World::instance().size();
  long cores = sysconf(_SC_NPROCESSORS_ONLN);
  cpu_set_t set;
  // A rank that mpirun has bound sees its own cores alone. Open MPI 4 says so; in 5 mpirun
  // or its daemon, which started the rank, sees those of all.
  if (!isSet("OMPI_MCA_orte_bound_at_launch") &&
      sched_getaffinity(isSet("PRTE_LAUNCHED") ? getppid() : 0, sizeof set, &set) == 0)
    cores = CPU_COUNT(&set);
  return ranks > cores;
}

double findSilenceLimit() {
  const char* text = std::getenv("CLAYFOAM_TIMEOUT");
  if (!text || !*text) return 600;
  char* end = nullptr;
  const double limit = std::strtod(text, &end);
  if (*end || !(limit > 0) || !std::isfinite(limit))
    abandon(std::string("CLAYFOAM_TIMEOUT is '") + text +
            "'; it must be a number of seconds above 0");
  return limit;
}

// May a message of that tag come to a rank of that half, from its own or the other one
bool known(int tag, Half here, bool ofThisHalf) {
  switch (tag) {
    case wire::tagTerms:
    case wire::tagVerdict:
    case wire::tagShutdown:
      return true;
    case wire::tagBoxes:
      return here == Half::dem || ofThisHalf;
    case wire::tagAnswer:
    case wire::tagStop:
      return here == Half::dem && !ofThisHalf;
    case wire::tagHeader:
    case wire::tagState:
      return here == Half::cfd && !ofThisHalf;
    case wire::tagShared:
      return here == Half::cfd && ofThisHalf;
    case wire::tagSpeaks:
    case wire::tagSaved:
      return ofThisHalf;
    default:
      return false;
  }
}

// Ends both halves when a message lies here that nobody will ever take
void endOnStray() {
  const auto& world = World::instance();
  if (!world.wrapped() || !world.hasOtherHalf()) return;
  int there = 0;
  MPI_Status status;
  PMPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, world.whole(), &there, &status);
  if (!there) return;
  const auto& local = world.localRanks();
  const bool mine = std::find(local.begin(), local.end(), status.MPI_SOURCE) != local.end();
  if (known(status.MPI_TAG, world.which(), mine)) return;
  const Half other = world.which() == Half::dem ? Half::cfd : Half::dem;
  abandon("a message with tag " + std::to_string(status.MPI_TAG) + " came from the " +
          name(mine ? world.which() : other) + " half, which is none of the exchange's");
}

}  // namespace

bool oversubscribed() {
  static const bool crowded = findOversubscribed();
  return crowded;
}

double silenceLimit() {
  static const double limit = findSilenceLimit();
  return limit;
}

void endOnSilence(double waited, const char* forWhat) {
  // the first rank speaks first
  if (waited <= silenceLimit() + (World::instance().rank() == 0 ? 0 : 2)) return;
  char text[64];
  std::snprintf(text, sizeof text, "waited %.4g s for ", waited);
  abandon(text + std::string(forWhat) + "; CLAYFOAM_TIMEOUT (seconds) sets how long a half waits");
}

Backoff::Backoff(const char* forWhat) : forWhat_(forWhat), start_(Clock::now()) {}

double Backoff::waited() const { return seconds(Clock::now() - start_); }

void Backoff::pause() {
  const double time = waited();
  // On a crowded node the other half may need this core. A short sleep gives it
  // away and gets it back soon; a yield would come last after all other work.
  const bool spin = time < (oversubscribed() ? 0 : spinTime);
  if (!spin || ++pauses_ % 16 == 0) checkShutdown();
  if (spin) return;
  endOnSilence(time, forWhat_);
  if (time > nextLook_) {
    endOnStray();
    nextLook_ = time + 0.5;
  }
  sleepFor(std::clamp(time * sleepPart, shortestSleep, longestSleep));
}

bool allDone(std::vector<MPI_Request>& requests) {
  int done = 0;
  PMPI_Testall(static_cast<int>(requests.size()), requests.data(), &done, MPI_STATUSES_IGNORE);
  return done;
}

void sendText(const std::string& text, int rank, int tag, const char* forWhat) {
  std::vector<MPI_Request> request(1);
  PMPI_Isend(text.data(), static_cast<int>(text.size()), MPI_CHAR, rank, tag,
             World::instance().whole(), &request[0]);
  waitUntil([&] { return allDone(request); }, forWhat);
}

std::string receiveText(int rank, int tag, const char* forWhat) {
  MPI_Comm whole = World::instance().whole();
  MPI_Status status;
  waitUntil(
      [&] {
        int there = 0;
        PMPI_Iprobe(rank, tag, whole, &there, &status);
        return there != 0;
      },
      forWhat);
  int length = 0;
  PMPI_Get_count(&status, MPI_CHAR, &length);
  std::string text(static_cast<std::size_t>(length), ' ');
  std::vector<MPI_Request> request(1);
  PMPI_Irecv(&text[0], length, MPI_CHAR, rank, tag, whole, &request[0]);
  waitUntil([&] { return allDone(request); }, forWhat);
  return text;
}

}  // namespace clay
