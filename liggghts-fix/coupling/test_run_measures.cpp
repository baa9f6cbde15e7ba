// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/run_measures.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "sphere_store.h"

using namespace clay;

TEST(RunMeasures, file)
{
  RunMeasures m;
  m.program = "liggghts-clay 1.2";
  m.ranks = 3;
  m.simulated = 0.5;
  m.wall = 10;
  m.exchange = 1;
  m.waiting = 2;
  m.output = 3;
  m.rankExchange = 0.5;
  m.rankWaiting = 1.5;
  m.rankOutput = 2.5;
  m.cpu = 7;
  m.steps = 1000;
  m.exchanges = 51;
  m.bytesSent = 4096;
  m.particles.atStart = 60;
  m.particles.inserted = 30;
  m.particles.left = 7;
  m.particles.deleted = 5;
  m.particles.lost = 2;
  m.particles.away = 3;
  m.clumps = 4;
  m.overlap = 0.01;
  m.wallOverlap = 0.02;
  m.timestep = 1e-5;
  m.interval = 20;
  m.settings = {{"clump_drag", "resistance"}};
  m.warnings = {"soft contacts"};
  const auto j = nlohmann::json::parse(m.json());
  EXPECT_EQ(m.json().back(), '\n');
  EXPECT_EQ(j["program"], "liggghts-clay 1.2");
  EXPECT_EQ(j["ranks"], 3);
  EXPECT_EQ(j["simulated_s"], 0.5);
  EXPECT_EQ(j["wall_s"], 10.);
  EXPECT_EQ(j["dem_s"], 10. - 0.5 - 1.5 - 2.5);
  EXPECT_EQ(j["exchange_s"], 1.);
  EXPECT_EQ(j["waiting_s"], 2.);
  EXPECT_EQ(j["output_s"], 3.);
  EXPECT_EQ(j["dem_cpu_s"], 7.);
  EXPECT_EQ(j["dem_steps"], 1000);
  EXPECT_EQ(j["exchanges"], 51);
  EXPECT_EQ(j["bytes_sent"], 4096.);
  EXPECT_EQ(j["particles"], 76);
  EXPECT_EQ(j["particles_at_start"], 60);
  EXPECT_EQ(j["particles_inserted"], 30);
  EXPECT_EQ(j["particles_left"], 7);
  EXPECT_EQ(j["particles_deleted"], 5);
  EXPECT_EQ(j["particles_beyond_the_fluid"], 3);
  EXPECT_EQ(j["particles_lost"], 2);
  EXPECT_EQ(j["clumps"], 4);
  EXPECT_EQ(j["max_overlap_over_d"], 0.01);
  EXPECT_EQ(j["max_wall_overlap_over_d"], 0.02);
  EXPECT_EQ(j["settings"]["timestep_s"], 1e-5);
  EXPECT_EQ(j["settings"]["coupling_interval_steps"], 20);
  EXPECT_DOUBLE_EQ(j["settings"]["coupling_interval_s"], 2e-4);
  EXPECT_EQ(j["settings"]["clump_drag"], "resistance");
  EXPECT_EQ(j["warnings"][0], "soft contacts");
  EXPECT_FALSE(j.contains("rest_wakings"));
}

TEST(RunMeasures, ofABedAtRest)
{
  RunMeasures m;
  m.rest = {{40, 1e-6, 2}};
  const auto j = nlohmann::json::parse(m.json());
  EXPECT_EQ(j["dem_steps_left_out"], 40.);
  EXPECT_EQ(j["rest_height_missed_m"], 1e-6);
  EXPECT_EQ(j["rest_wakings"], 2.);
}

TEST(Progress, line)
{
  Progress p;
  EXPECT_EQ(p.line(), "t = 0.0000 s    0.0 %  ETA 0:00  overlap/d 0.00e+00  momentum 0.0e+00");
  p.time = 1.25;
  p.done = 0.25;
  p.spent = 50;  // three times that is left
  p.interface = 0.03;
  p.overlap = 0.0123;
  p.momentum = 3e-14;
  EXPECT_EQ(p.line(), "t = 1.2500 s   25.0 %  ETA 2:30  interface 0.0300 m  overlap/d 1.23e-02  momentum 3.0e-14");
}

TEST(LargestOverlap, overTheSmallerDiameter)
{
  SphereStore s(4);
  s.radius = {1., 2., 1., 1.};
  s.x[1][0] = 2.7;   // 0.3 deep: 0.15 of d
  s.x[2][1] = -1.8;  // 0.2 deep: 0.1 of d
  s.x[3][2] = 1.;    // 1.0 deep, of two that are held
  s.mask = {2, 1, 1, 2};
  int all[3] = {1, 2 | 1 << 30, 3}, *const neighbours[1] = {all};
  const int spheres[1] = {0}, counts[1] = {3};
  NeighbourList list;
  list.n = 1;
  list.spheres = spheres;
  list.counts = counts;
  list.neighbours = neighbours;
  list.mask = (1 << 30) - 1;
  Overlap worst = largest_overlap(list, s.x.rows(), s.radius.data(), s.mask.data(), {1, 0}, s.tag.data(), {});
  EXPECT_NEAR(worst.depth, 0.15, 1e-12);
  EXPECT_EQ(worst.first, 1);
  EXPECT_EQ(worst.second, 2);
  worst = largest_overlap(list, s.x.rows(), s.radius.data(), s.mask.data(), {3, 0}, s.tag.data(), {});
  EXPECT_NEAR(worst.depth, 0.5, 1e-12);

  // without pairs the tags stay
  list.n = 0;
  worst = largest_overlap(list, s.x.rows(), s.radius.data(), s.mask.data(), {3, 0}, s.tag.data(), worst);
  EXPECT_EQ(worst.depth, 0.);
  EXPECT_EQ(worst.second, 4);
}
