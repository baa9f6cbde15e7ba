// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/world.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <thread>

#include "exchange/shutdown.h"

namespace clay {

namespace {

// [s] for the other program to take part in the split, right after MPI_Init,
// which both leave at the same time
constexpr int splitPatience = 60;

int appNumber() {
  int* number = nullptr;
  int there = 0;
  PMPI_Comm_get_attr(MPI_COMM_WORLD, MPI_APPNUM, &number, &there);
  return there && number ? *number : 0;
}

// The numbers of all ranks' programs. A program that is no half of a coupled
// run never answers: it must not be waited for for ever.
std::vector<int> gatherNumbers(int mine, int ranks) {
  std::vector<int> numbers(static_cast<std::size_t>(ranks));
  MPI_Request request;
  PMPI_Iallgather(&mine, 1, MPI_INT, numbers.data(), 1, MPI_INT, MPI_COMM_WORLD, &request);
  const auto start = std::chrono::steady_clock::now();
  for (int done = 0, tests = 0;; ++tests) {
    PMPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (done) return numbers;
    if (tests > 100) std::this_thread::sleep_for(std::chrono::microseconds(100));
    if (std::chrono::steady_clock::now() - start > std::chrono::seconds(splitPatience)) {
      std::fprintf(stderr,
                   "%s: the other program of this mpirun is no half of a coupled run\n",
                   programName().c_str());
      endAll(1);
    }
  }
}

}  // namespace

World& World::instance() {
  static World* world = new World;  // still needed while the program exits
  return *world;
}

void World::init(int& argc, char**& argv) {
  int started = 0;
  PMPI_Initialized(&started);
  if (!started) {
    int provided = 0;
    PMPI_Init_thread(&argc, &argv, MPI_THREAD_SINGLE, &provided);
  }
  if (!instance().ready()) instance().split();
  watchExit(!started);
}

void World::split() {
  if (ready_) return;
  whole_ = MPI_COMM_WORLD;
  int myRank = 0, ranks = 1;
  PMPI_Comm_rank(whole_, &myRank);
  PMPI_Comm_size(whole_, &ranks);
  const int mine = appNumber();
  const std::vector<int> numbers = gatherNumbers(mine, ranks);

  std::vector<int> distinct = numbers;
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  programs_ = static_cast<int>(distinct.size());
  if (programs_ > 2) {
    if (myRank == 0) {
      std::fprintf(stderr,
                   "%s: this mpirun starts %d programs; a coupled run has two, the DEM half "
                   "and the CFD half\n",
                   programName().c_str(), programs_);
      endAll(1);
    }
    // the first rank ends all
    std::this_thread::sleep_for(std::chrono::seconds(splitPatience));
    endAll(1);
  }

  for (int r = 0; r < ranks; ++r)
    (numbers[static_cast<std::size_t>(r)] == mine ? mates_ : peers_).push_back(r);
  if (programs_ == 1) {
    half_ = whole_;
  } else {
    MPI_Group all, group;
    PMPI_Comm_group(whole_, &all);
    PMPI_Group_incl(all, static_cast<int>(mates_.size()), mates_.data(), &group);
    PMPI_Comm_create_group(whole_, group, 0, &half_);
    PMPI_Comm_set_name(half_, "MPI_COMM_WORLD of this half");
    PMPI_Group_free(&group);
    PMPI_Group_free(&all);
  }
  PMPI_Comm_rank(half_, &rank_);
  PMPI_Comm_size(half_, &size_);
  ready_ = true;
  if (programs_ == 2) watchExit(false);
}

void World::adopt(MPI_Comm half) {
  whole_ = MPI_COMM_WORLD;
  half_ = half;
  PMPI_Comm_rank(half_, &rank_);
  PMPI_Comm_size(half_, &size_);
  index();
  programs_ = peers_.empty() ? 1 : 2;
  ready_ = true;
  if (programs_ == 2) watchExit(false);
}

void World::index() {
  int ranks = 1;
  PMPI_Comm_size(whole_, &ranks);
  MPI_Group all, group;
  PMPI_Comm_group(whole_, &all);
  PMPI_Comm_group(half_, &group);
  std::vector<int> inHalf(static_cast<std::size_t>(size_));
  for (int r = 0; r < size_; ++r) inHalf[static_cast<std::size_t>(r)] = r;
  mates_.assign(inHalf.size(), 0);
  PMPI_Group_translate_ranks(group, size_, inHalf.data(), all, mates_.data());
  PMPI_Group_free(&group);
  PMPI_Group_free(&all);
  peers_.clear();
  for (int r = 0; r < ranks; ++r)
    if (std::find(mates_.begin(), mates_.end(), r) == mates_.end()) peers_.push_back(r);
}

}  // namespace clay
