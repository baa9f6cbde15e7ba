// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file to_ranks.h
/// Records from each processor to the ones it chooses.
#pragma once

#include <mpi.h>

#include <type_traits>
#include <vector>

namespace clay {

/// Sends to[r] to each rank r and returns what the others sent to this one, in the
/// order of their ranks. Collective.
template <class Record>
std::vector<Record> sendToRanks(const std::vector<std::vector<Record>>& to, MPI_Comm comm)
{
  static_assert(std::is_trivially_copyable<Record>::value, "sent as it lies in memory");
  const int ranks = static_cast<int>(to.size());
  std::vector<int> sent(ranks), got(ranks), sentFrom(ranks, 0), gotFrom(ranks, 0);
  std::vector<Record> out;
  for (int r = 0; r < ranks; ++r) {
    sentFrom[r] = static_cast<int>(out.size());
    sent[r] = static_cast<int>(to[r].size());
    out.insert(out.end(), to[r].begin(), to[r].end());
  }
  MPI_Alltoall(sent.data(), 1, MPI_INT, got.data(), 1, MPI_INT, comm);
  for (int r = 1; r < ranks; ++r) gotFrom[r] = gotFrom[r - 1] + got[r - 1];
  std::vector<Record> in(gotFrom.back() + got.back());

  MPI_Datatype record;
  MPI_Type_contiguous(sizeof(Record), MPI_BYTE, &record);
  MPI_Type_commit(&record);
  MPI_Alltoallv(out.data(), sent.data(), sentFrom.data(), record, in.data(), got.data(), gotFrom.data(), record, comm);
  MPI_Type_free(&record);
  return in;
}

}  // namespace clay
