// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/insertion_streams.h"

#include <zlib.h>

#include <string>

#include "comm.h"
#include "domain.h"
#include "fix_insert.h"
#include "lammps.h"
#include "modify.h"
#include "random_park.h"
#include "region.h"

using namespace LAMMPS_NS;

namespace {

// their hosts tell nobody where they are
class OpenRegion : public Region {
 public:
  static RanPark *stream(Region *region) { return region->*(&OpenRegion::random); }
};

class OpenInsert : public FixInsert {
 public:
  static RanPark *stream(FixInsert *fix) { return fix->*(&OpenInsert::random); }
};

struct Stream {
  double name;  // as a number
  RanPark *random;
};

std::vector<Stream> all_streams(LAMMPS *lmp)
{
  std::vector<Stream> found;
  const auto add = [&](const std::string &name, RanPark *random) {
    if (random)
      found.push_back(
          {static_cast<double>(crc32_z(0, reinterpret_cast<const Bytef *>(name.data()), name.size())), random});
  };
  for (int r = 0; r < lmp->domain->nregion; r++)
    add(std::string("region ") + lmp->domain->regions[r]->id, OpenRegion::stream(lmp->domain->regions[r]));
  for (int f = 0; f < lmp->modify->nfix; f++)
    if (FixInsert *fix = dynamic_cast<FixInsert *>(lmp->modify->fix[f]))
      add(std::string("fix ") + fix->id, OpenInsert::stream(fix));
  return found;
}

// a state of LIGGGHTS's generator lies below 2^31 - 1
int moved_on(double state, int by)
{
  const long largest = 2147483646;
  return static_cast<int>((static_cast<long>(state) - 1 + by) % largest + 1);
}

}  // namespace

/* ----------------------------------------------------------------------
   the number of processors; for each stream its name, a state of each
------------------------------------------------------------------------- */

std::vector<double> LAMMPS_NS::insertion_streams(LAMMPS *lmp)
{
  std::vector<double> states(lmp->comm->nprocs), all(1, lmp->comm->nprocs);
  for (const Stream &s : all_streams(lmp)) {
    const double mine = s.random->state();
    MPI_Gather(&mine, 1, MPI_DOUBLE, states.data(), 1, MPI_DOUBLE, 0, lmp->world);
    all.push_back(s.name);
    all.insert(all.end(), states.begin(), states.end());
  }
  return all;
}

/* ---------------------------------------------------------------------- */

void LAMMPS_NS::go_on_with_streams(LAMMPS *lmp, const std::vector<double> &saved)
{
  if (saved.empty()) return;
  const int me = lmp->comm->me, ranks = static_cast<int>(saved[0]);
  const std::vector<Stream> streams = all_streams(lmp);
  for (size_t at = 1; at + ranks < saved.size(); at += 1 + ranks) {
    const double *states = &saved[at + 1];
    for (const Stream &s : streams)
      if (s.name == saved[at]) s.random->reset(me < ranks ? static_cast<int>(states[me]) : moved_on(states[0], me));
  }
}
