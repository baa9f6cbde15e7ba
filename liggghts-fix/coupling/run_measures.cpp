// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/run_measures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace clay {

std::string RunMeasures::json() const
{
  nlohmann::ordered_json j;
  j["program"] = program;
  j["ranks"] = ranks;
  j["simulated_s"] = simulated;
  j["wall_s"] = wall;
  j["dem_s"] = wall - rankExchange - rankWaiting - rankOutput;
  j["exchange_s"] = exchange;
  j["waiting_s"] = waiting;
  j["output_s"] = output;
  j["dem_cpu_s"] = cpu;
  j["dem_steps"] = steps;
  if (rest) {
    j["dem_steps_left_out"] = (*rest)[0];
    j["rest_height_missed_m"] = (*rest)[1];
    j["rest_wakings"] = (*rest)[2];
  }
  j["exchanges"] = exchanges;
  j["bytes_sent"] = bytesSent;
  j["particles"] = particles.now();
  j["particles_at_start"] = particles.atStart;
  j["particles_inserted"] = particles.inserted;
  j["particles_left"] = particles.left;
  j["particles_deleted"] = particles.deleted;
  j["particles_lost"] = particles.lost;
  j["particles_beyond_the_fluid"] = particles.away;
  j["clumps"] = clumps;
  j["max_overlap_over_d"] = overlap;
  j["max_wall_overlap_over_d"] = wallOverlap;
  j["settings"] = {
      {"timestep_s", timestep}, {"coupling_interval_steps", interval}, {"coupling_interval_s", timestep * interval}};
  for (const auto &s : settings) j["settings"][s.first] = s.second;
  j["warnings"] = warnings;
  return j.dump(2) + '\n';
}

/* ---------------------------------------------------------------------- */

std::string Progress::line() const
{
  const long eta = done > 0. ? std::lround(spent * (1. - done) / done) : 0;
  char text[256];
  int n =
      std::snprintf(text, sizeof text, "t = %.4f s  %5.1f %%  ETA %ld:%02ld", time, 100. * done, eta / 60, eta % 60);
  if (interface) n += std::snprintf(text + n, sizeof text - n, "  interface %.4f m", *interface);
  std::snprintf(text + n, sizeof text - n, "  overlap/d %.2e  momentum %.1e", overlap, momentum);
  return text;
}

/* ---------------------------------------------------------------------- */

Overlap largest_overlap(const NeighbourList &list, double *const *x, const double *radius, const int *groups,
                        const MovingGroups &moving, const int *tag, const Overlap &before)
{
  Overlap worst = before;
  worst.depth = 0.;
  for (int ii = 0; ii < list.n; ii++) {
    const int i = list.spheres[ii];
    const int *neighbours = list.neighbours[i];
    for (int jj = 0; jj < list.counts[i]; jj++) {
      const int j = neighbours[jj] & list.mask;
      const double dx = x[i][0] - x[j][0], dy = x[i][1] - x[j][1], dz = x[i][2] - x[j][2];
      const double sum = radius[i] + radius[j], r2 = dx * dx + dy * dy + dz * dz;
      if (r2 >= sum * sum || !(moving.moves(groups[i]) || moving.moves(groups[j]))) continue;
      const double depth = 0.5 * (sum - std::sqrt(r2)) / std::min(radius[i], radius[j]);
      if (depth > worst.depth) worst = {depth, tag[i], tag[j]};
    }
  }
  return worst;
}

}  // namespace clay
