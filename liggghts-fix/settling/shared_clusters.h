// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file shared_clusters.h
/// Clusters of bodies whose links lie on several processors.
#pragma once

#include <mpi.h>

#include <unordered_map>
#include <utility>
#include <vector>

namespace clay {

/// The processor that a body's key names: the tag of a clump, or -1 less that of a sphere.
int rankNamedBy(long key, int ranks);

/// Sizes of the clusters that links make, numbers of bodies: of all that have a link and whose key names this
/// processor. links: those that this processor knows, by the keys of two bodies; more than one may know the same. No
/// processor holds more than its links and what it is named by. Collective; it takes as many rounds as a cluster
/// crosses processors.
std::unordered_map<long, int> clusterSizes(const std::vector<std::pair<long, long>> &links, MPI_Comm comm);

}  // namespace clay
