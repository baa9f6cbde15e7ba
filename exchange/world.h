// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file world.h
/// Which half of the mpirun this process belongs to, and who the others are.
#pragma once

#include <mpi.h>

#include <functional>
#include <string>
#include <vector>

namespace clay {

/// The two halves of one coupled mpirun; each may be started in several parts.
enum class Half { dem, cfd };

/// "DEM" or "CFD", as it stands in messages.
const char* name(Half half);

/// Which half this program is. Every program that is linked with clay_world defines
/// it, once, at namespace scope: `const clay::Half clay::programHalf = clay::Half::dem;`.
extern const Half programHalf;

/// This program's half of MPI_COMM_WORLD.
///
/// Right after MPI_Init the wrappers of world_wrappers.cpp split the world by
/// programHalf, so that neither host code ever sees the other's ranks. How the
/// programs were started does not matter. A host code that splits the world by
/// itself needs no wrappers: it calls adopt() with the communicator it made.
class World {
 public:
  /// The world of this process; MPI must be initialised.
  static World& instance();

  /// Starts MPI where the host code does not (a serial OpenFOAM), in a program
  /// that is linked with clay_world.
  static void init(int& argc, char**& argv);

  /// Splits MPI_COMM_WORLD by the halves that its ranks name; called by the
  /// wrappers of MPI_Init.
  void split(Half mine);

  /// Frees what split() has made; on every rank of the half, ahead of MPI's end. Collective.
  void giveBack();

  /// Takes a half that the host code has made by itself.
  /// The ranks of each half must keep the order they have in MPI_COMM_WORLD.
  void adopt(MPI_Comm half, Half which);

  /// Which half this is.
  Half which() const { return which_; }

  /// The communicator of this half; MPI_COMM_WORLD of the host code means it.
  MPI_Comm half() const { return half_; }

  /// The communicator of both halves, the true MPI_COMM_WORLD.
  MPI_Comm whole() const { return whole_; }

  /// Rank and size within this half.
  int rank() const { return rank_; }
  int size() const { return size_; }

  /// True when the mpirun holds the other half as well.
  bool hasOtherHalf() const { return !remoteRanks_.empty(); }

  /// Ranks of the other half in whole(), ordered by their rank in that half.
  const std::vector<int>& remoteRanks() const { return remoteRanks_; }

  /// Ranks of this half in whole(), ordered by their rank in this half.
  const std::vector<int>& localRanks() const { return localRanks_; }

  /// True once split() or adopt() was called.
  bool ready() const { return ready_; }

  /// True when whole() carries the exchange's messages and no others: the host's stay in
  /// its half, by the wrappers.
  bool wrapped() const { return wrapped_; }

 private:
  World() = default;
  void setHalf(MPI_Comm half, Half which);

  MPI_Comm half_ = MPI_COMM_NULL;
  MPI_Comm whole_ = MPI_COMM_NULL;
  Half which_ = Half::dem;
  int rank_ = 0, size_ = 1;
  std::vector<int> remoteRanks_, localRanks_;
  bool ready_ = false, wrapped_ = false;
};

/// Ends both halves now with a non-zero exit and one line that says why. The
/// other half is told first, and has a few seconds to save its state.
[[noreturn]] void abandon(const std::string& reason);

/// Why this program is about to end by MPI_Finalize, MPI_Abort or exit(): what the other
/// half is told when the coupled run is not over.
void explainEnd(const std::string& reason);

/// What stands behind each reason for which this half ends the run from now on: which
/// saved state is left, for one.
void setLastWords(const std::string& words);

/// What the host does on every rank when the other half has ended too early,
/// before this half ends as well: saving its state, for one. It has 5 s.
void onShutdown(std::function<void(const std::string& reason)> save);

}  // namespace clay
