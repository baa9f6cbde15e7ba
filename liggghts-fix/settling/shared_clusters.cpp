// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "settling/shared_clusters.h"

#include <algorithm>

#include "clumps/to_ranks.h"
#include "settling/column_profile.h"

namespace clay {

namespace {

struct Labelled {
  long key, label;
  int by;
};

struct Counted {
  long label;
  int members, by;
};

}  // namespace

int rankNamedBy(long key, int ranks) { return static_cast<int>((key < 0 ? -1 - key : key) % ranks); }

std::unordered_map<long, int> clusterSizes(const std::vector<std::pair<long, long>> &links, MPI_Comm comm)
{
  int me, ranks;
  MPI_Comm_rank(comm, &me);
  MPI_Comm_size(comm, &ranks);

  // this processor's, labelled by their least keys
  std::unordered_map<long, int> place;
  std::vector<long> keys;
  const auto at = [&](long key) {
    const auto found = place.emplace(key, static_cast<int>(keys.size()));
    if (found.second) keys.push_back(key);
    return found.first->second;
  };
  std::vector<std::pair<int, int>> pairs;
  for (const auto &l : links) {
    const int a = at(l.first), b = at(l.second);
    pairs.push_back({a, b});
  }
  Clusters here(static_cast<int>(keys.size()));
  for (const auto &p : pairs) here.join(p.first, p.second);
  std::vector<long> label(keys);
  for (std::size_t k = 0; k < keys.size(); k++) {
    long &root = label[here.root(static_cast<int>(k))];
    root = std::min(root, keys[k]);
  }

  // the least label of each body, by way of the processor that it names, until none changes
  std::unordered_map<long, long> named;
  for (int changed = 1; changed;) {
    std::vector<std::vector<Labelled>> told(ranks), answers(ranks);
    for (std::size_t k = 0; k < keys.size(); k++)
      told[rankNamedBy(keys[k], ranks)].push_back({keys[k], label[here.root(static_cast<int>(k))], me});
    const std::vector<Labelled> heard = sendToRanks(told, comm);
    for (const Labelled &l : heard) {
      long &least = named.emplace(l.key, l.label).first->second;
      least = std::min(least, l.label);
    }
    for (const Labelled &l : heard) answers[l.by].push_back({l.key, named.at(l.key), me});
    changed = 0;
    for (const Labelled &l : sendToRanks(answers, comm)) {
      long &root = label[here.root(place.at(l.key))];
      if (l.label >= root) continue;
      root = l.label;
      changed = 1;
    }
    MPI_Allreduce(MPI_IN_PLACE, &changed, 1, MPI_INT, MPI_MAX, comm);
  }

  // members, counted where their label names
  std::unordered_map<long, int> mine, whole, sizes;
  for (const auto &n : named) mine[n.second]++;
  std::vector<std::vector<Counted>> counts(ranks), totals(ranks);
  for (const auto &m : mine) counts[rankNamedBy(m.first, ranks)].push_back({m.first, m.second, me});
  const std::vector<Counted> counted = sendToRanks(counts, comm);
  for (const Counted &c : counted) whole[c.label] += c.members;
  for (const Counted &c : counted) totals[c.by].push_back({c.label, whole.at(c.label), me});
  for (const Counted &c : sendToRanks(totals, comm)) mine[c.label] = c.members;
  for (const auto &n : named) sizes[n.first] = mine.at(n.second);
  return sizes;
}

}  // namespace clay
