// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file test_shared.cpp
/// Particles that several ranks hold; run by mpirun on three ranks.
#include <gtest/gtest.h>
#include <mpi.h>

#include <vector>

#include "exchange/shared.h"
#include "exchange/world.h"

const clay::Half clay::programHalf = clay::Half::cfd;

namespace {

int me() { return clay::World::instance().rank(); }

/// A particle's sharers as a DEM rank lists them.
struct Shared {
  int here;                // its place on this rank; below 0: not here
  std::vector<int> ranks;  // in ascending order
};

/// Takes in one DEM rank's particles, whose places are counted from first on.
void add(clay::SharedParticles& shared, const std::vector<Shared>& all, int first = 0) {
  std::vector<double> list;
  for (const auto& s : all) {
    if (s.here < 0) continue;
    list.push_back(s.here);
    list.push_back(static_cast<double>(s.ranks.size()));
    list.insert(list.end(), s.ranks.begin(), s.ranks.end());
  }
  shared.add(list.data(), list.size(), first);
}

/// Is the value the same bit by bit on all ranks
bool sameOnAll(double x) {
  double least, most;
  MPI_Allreduce(&x, &least, 1, MPI_DOUBLE, MPI_MIN, MPI_COMM_WORLD);
  MPI_Allreduce(&x, &most, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  return least == x && most == x;
}

}  // namespace

TEST(SharedParticles, AreSummedInTheOrderOfTheRanks) {
  ASSERT_EQ(clay::World::instance().size(), 3);
  clay::SharedParticles shared;
  add(shared, {{0, {0, 1, 2}}});
  // (1 + 1e-16) - 1 is 0, any other order leaves 1e-16 or so
  const double part[] = {1, 1e-16, -1};
  std::vector<double> values{part[me()], 2. * (me() + 1)};
  shared.sum(values, 2);
  EXPECT_EQ(values[0], (part[0] + part[1]) + part[2]);
  EXPECT_TRUE(sameOnAll(values[0]));
  EXPECT_EQ(values[1], 12);
}

TEST(SharedParticles, LeaveThoseOfOneRankAlone) {
  // rank 0 holds particles 0 and 1, rank 1 their second and one of its own,
  // rank 2 shares nothing
  clay::SharedParticles shared;
  add(shared, {{me() == 0 ? 1 : me() == 1 ? 0 : -1, {0, 1}}});
  std::vector<double> values;
  if (me() == 0) values = {5, 7};
  if (me() == 1) values = {11, 13};
  if (me() == 2) values = {17};
  shared.sum(values, 1);
  if (me() == 0) EXPECT_EQ(values, (std::vector<double>{5, 18}));
  if (me() == 1) EXPECT_EQ(values, (std::vector<double>{18, 13}));
  if (me() == 2) EXPECT_EQ(values, (std::vector<double>{17}));
}

TEST(SharedParticles, OfSeveralDemRanksCountFromTheirFirst) {
  // two DEM ranks with two particles each; the second one's first is shared
  clay::SharedParticles shared;
  add(shared, {}, 0);
  add(shared, {{me() < 2 ? 0 : -1, {0, 1}}}, 2);
  std::vector<double> values{1, 1, 1, 1};
  shared.sum(values, 1);
  EXPECT_EQ(values, (me() < 2 ? std::vector<double>{1, 1, 2, 1} : std::vector<double>{1, 1, 1, 1}));
}

TEST(SharedParticles, AreOwnedByTheSmallestClaimThenByTheLowestRank) {
  clay::SharedParticles shared;
  const std::vector<int> all{0, 1, 2};
  add(shared, {{0, all}, {1, all}, {2, all}});
  // the middle rank is nearest; a tie of the last two; nobody has a cell
  const double nearest[] = {0.2, 0.1, 0.3}, tie[] = {1e300, 0, 0};
  const auto owned = shared.own({nearest[me()], tie[me()], 1e300, 0});
  EXPECT_EQ(owned, (std::vector<char>{me() == 1, me() == 1, 0, 1}));
}

TEST(SharedParticles, AreForgotten) {
  clay::SharedParticles shared;
  add(shared, {{0, {0, 1, 2}}});
  shared.clear();
  std::vector<double> values{3. + me()};
  shared.sum(values, 1);
  EXPECT_EQ(values[0], 3 + me());
  // and may be shared anew, by fewer
  add(shared, {{me() > 0 ? 0 : -1, {1, 2}}});
  shared.sum(values, 1);
  EXPECT_EQ(values[0], me() > 0 ? 9 : 3);
}

int main(int argc, char** argv) {
  clay::World::init(argc, argv);
  testing::InitGoogleTest(&argc, argv);
  int result = RUN_ALL_TESTS();
  MPI_Allreduce(MPI_IN_PLACE, &result, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  MPI_Finalize();
  return result;
}
