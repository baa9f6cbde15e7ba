// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/world.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <numeric>
#include <thread>

#include "exchange/shutdown.h"

namespace clay {

namespace {

// [s] for all ranks to take part in the split, right after MPI_Init, which they
// leave at the same time
constexpr int splitTimeout = 60;

[[noreturn]] void refuse(const std::string& why) {
  std::fprintf(stderr, "%s: %s\n", programName().c_str(), why.c_str());
  endAll(1);
}

// What MPI finds wrong with a message, as one that is longer than its place
void onMpiError(MPI_Comm*, int* code, ...) {
  char text[MPI_MAX_ERROR_STRING] = "";
  int length = 0;
  PMPI_Error_string(*code, text, &length);
  abandon(std::string("a message between the halves cannot be taken in: ") + text);
}

// A host that has its own way with errors of MPI_COMM_WORLD keeps it
void hearOfErrors(MPI_Comm whole) {
  MPI_Errhandler present, mine;
  PMPI_Comm_get_errhandler(whole, &present);
  if (present != MPI_ERRORS_ARE_FATAL) return;
  PMPI_Comm_create_errhandler(onMpiError, &mine);
  PMPI_Comm_set_errhandler(whole, mine);
  // the communicator keeps it
  PMPI_Errhandler_free(&mine);
}

// The halves of all ranks. A program that is no half of a coupled run never
// answers: it must not be waited for for ever.
std::vector<int> gatherHalves(Half mine, int ranks) {
  const int number = static_cast<int>(mine);
  std::vector<int> halves(static_cast<std::size_t>(ranks));
  MPI_Request request;
  PMPI_Iallgather(&number, 1, MPI_INT, halves.data(), 1, MPI_INT, MPI_COMM_WORLD, &request);
  const auto start = std::chrono::steady_clock::now();
  for (int done = 0, tests = 0;; ++tests) {
    PMPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (done) return halves;
    if (tests > 100) std::this_thread::sleep_for(std::chrono::microseconds(100));
    if (std::chrono::steady_clock::now() - start > std::chrono::seconds(splitTimeout))
      refuse("a program of this mpirun is no half of a coupled run, or it is stopped");
  }
}

}  // namespace

const char* name(Half half) { return half == Half::dem ? "DEM" : "CFD"; }

World& World::instance() {
  static World* world = new World;  // still needed while the program exits
  return *world;
}

void World::init(int& argc, char**& argv) {
  int started = 0;
  PMPI_Initialized(&started);
  if (!started) {
    int provided = 0;
    // the wrapper's, which splits the world
    MPI_Init_thread(&argc, &argv, MPI_THREAD_SINGLE, &provided);
  }
  if (!instance().ready()) refuse("this program is not linked with clay_world");
  watchExit(!started);
}

void World::split(Half mine) {
  if (ready_) return;
  int ranks = 1;
  PMPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const std::vector<int> halves = gatherHalves(mine, ranks);
  std::vector<int> members;
  for (int r = 0; r < ranks; ++r)
    if (halves[static_cast<std::size_t>(r)] == static_cast<int>(mine)) members.push_back(r);
  MPI_Comm half = MPI_COMM_WORLD;
  if (static_cast<int>(members.size()) < ranks) {
    MPI_Group all, group;
    PMPI_Comm_group(MPI_COMM_WORLD, &all);
    PMPI_Group_incl(all, static_cast<int>(members.size()), members.data(), &group);
    PMPI_Comm_create_group(MPI_COMM_WORLD, group, 0, &half);
    PMPI_Comm_set_name(half, "MPI_COMM_WORLD of this half");
    PMPI_Group_free(&group);
    PMPI_Group_free(&all);
  }
  wrapped_ = true;
  setHalf(half, mine);
}

void World::giveBack() {
  if (wrapped_ && half_ != MPI_COMM_WORLD && half_ != MPI_COMM_NULL) PMPI_Comm_free(&half_);
}

void World::adopt(MPI_Comm half, Half which) { setHalf(half, which); }

void World::setHalf(MPI_Comm half, Half which) {
  whole_ = MPI_COMM_WORLD;
  half_ = half;
  which_ = which;
  PMPI_Comm_rank(half_, &rank_);
  PMPI_Comm_size(half_, &size_);

  int ranks = 1;
  PMPI_Comm_size(whole_, &ranks);
  MPI_Group all, group;
  PMPI_Comm_group(whole_, &all);
  PMPI_Comm_group(half_, &group);
  std::vector<int> inHalf(static_cast<std::size_t>(size_));
  std::iota(inHalf.begin(), inHalf.end(), 0);
  localRanks_.assign(inHalf.size(), 0);
  PMPI_Group_translate_ranks(group, size_, inHalf.data(), all, localRanks_.data());
  PMPI_Group_free(&group);
  PMPI_Group_free(&all);

  std::vector<int> sorted = localRanks_;
  std::sort(sorted.begin(), sorted.end());
  remoteRanks_.clear();
  for (int r = 0; r < ranks; ++r)
    if (!std::binary_search(sorted.begin(), sorted.end(), r)) remoteRanks_.push_back(r);
  ready_ = true;
  if (!hasOtherHalf()) return;
  hearOfErrors(whole_);
  watchExit(false);
}

}  // namespace clay
