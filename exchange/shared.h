// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file shared.h
/// Particles that several CFD ranks hold at the same time; internal to exchange/.
#pragma once

#include <map>
#include <vector>

#include <mpi.h>

namespace clay {

/// Exchanges values of shared particles among the ranks of the CFD half, point
/// to point. Every rank lists what it shares with another rank in the same
/// order: by DEM rank, then by the particle's place there.
class SharedParticles {
 public:
  /// Forgets all, for the next state.
  void clear();

  /// Takes in one DEM rank's list of sharers, [index, n, n ranks], ... with
  /// indices counted from `first` here.
  void add(const double* list, std::size_t length, int first);

  /// See CfdSession::sumShared(). The sum is taken in the order of the ranks,
  /// so that it is the same, bit by bit, on all of them.
  void sum(std::vector<double>& values, int stride);

  /// See CfdSession::own().
  std::vector<char> own(const std::vector<double>& claims);

 private:
  struct Partner {
    std::vector<int> particles;
    std::vector<double> out, in;
  };
  void swap(const std::vector<double>& values, int stride);

  std::map<int, Partner> partners_;  // by rank in this half; may be idle
  std::vector<int> all_;             // every shared particle here, once
  std::vector<MPI_Request> requests_;
  std::vector<MPI_Status> statuses_;
};

}  // namespace clay
