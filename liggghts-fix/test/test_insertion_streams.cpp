// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>

#include "comm.h"
#include "coupling/insertion_streams.h"
#include "domain.h"
#include "host.h"
#include "region.h"

using LAMMPS_NS::go_on_with_streams;
using LAMMPS_NS::insertion_streams;
using test::Host;

namespace {

// two regions and a feed beside the box, in that order
std::string feed(const std::string &second, const std::string &fix)
{
  return test::opening("f f f", "0 0.03 0 0.03 0 0.03") + test::material("coul/clump 0.01") +
      "pair_coeff * * coul/clump 0.0\nregion first block 0 0.01 0 0.01 0 0.01 units box\nregion " + second +
      " block 0 0.02 0 0.02 0 0.02 units box\n"
      "fix grain all particletemplate/sphere 15485863 atom_type 1 density constant 2600 radius constant 1e-3\n"
      "fix kinds all particledistribution/discrete 15485867 1 grain 1.0\nfix " +
      fix +
      " all insert/rate/region seed 32452843 distributiontemplate kinds nparticles INF particlerate 100 "
      "insert_every 100 overlapcheck yes all_in yes vel constant 0 0 0 region first\n";
}

// a point of the region with that number
std::array<double, 3> draw(Host &host, int region)
{
  std::array<double, 3> x;
  host.lmp->domain->regions[region]->generate_random(x.data(), false);
  return x;
}

// on all processors
std::vector<double> states(Host &host)
{
  std::vector<double> all = insertion_streams(host.lmp.get());
  int n = static_cast<int>(all.size());
  MPI_Bcast(&n, 1, MPI_INT, 0, MPI_COMM_WORLD);
  all.resize(n);
  MPI_Bcast(all.data(), n, MPI_DOUBLE, 0, MPI_COMM_WORLD);
  return all;
}

}  // namespace

TEST(InsertionStreams, goOnWhereTheyWere)
{
  Host host;
  host(feed("second", "feed"));
  draw(host, 1);
  const auto saved = states(host);
  const auto one = draw(host, 1), two = draw(host, 2);
  draw(host, 1);
  // the box is a region, too
  EXPECT_EQ(saved.size(), 1 + 4 * (1u + test::processors()));
  EXPECT_NE(states(host), saved);
  go_on_with_streams(host.lmp.get(), saved);
  EXPECT_EQ(states(host), saved);
  EXPECT_EQ(draw(host, 1), one);
  EXPECT_EQ(draw(host, 2), two);
}

TEST(InsertionStreams, areKnownByTheirNames)
{
  Host host, other;
  host(feed("second", "feed"));
  other(feed("another", "another"));
  const auto saved = states(host);
  const auto first = draw(host, 1);
  draw(other, 1);
  const auto before = states(other);
  go_on_with_streams(other.lmp.get(), saved);
  const auto after = states(other);
  const size_t width = 1 + test::processors(), second = 1 + 2 * width;
  ASSERT_EQ(after.size(), before.size());
  EXPECT_EQ(std::vector<double>(after.begin() + second, after.end()),
            std::vector<double>(before.begin() + second, before.end()));
  EXPECT_EQ(draw(other, 1), first);
  go_on_with_streams(other.lmp.get(), {});
}

// one that was not there goes on by its own number, as LIGGGHTS's fixes let it
TEST(InsertionStreams, onOtherNumbersOfProcessors)
{
  Host host;
  host(feed("second", "feed"));
  const auto saved = states(host);
  const size_t width = 1 + test::processors();
  // as one processor would have saved it, at the largest state there is
  std::vector<double> alone = {1};
  for (size_t at = 1; at < saved.size(); at += width) alone.insert(alone.end(), {saved[at], 2147483646.});
  go_on_with_streams(host.lmp.get(), alone);
  const auto found = states(host);
  ASSERT_EQ(found.size(), 1 + 4 * width);
  for (size_t at = 1; at < found.size(); at += width)
    for (size_t p = 1; p < width; p++) EXPECT_EQ(found[at + p], p == 1 ? 2147483646. : p - 1.);
}
