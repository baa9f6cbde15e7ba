// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file run_measures.h
/// What the DEM half tells of a coupled run, as text.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "coupling/moving_groups.h"

namespace clay {

/// Measures of all runs so far, as they stand in dem.json.
struct RunMeasures {
  std::string program;
  int ranks = 1;
  double simulated = 0;                                      ///< [s]
  double wall = 0;                                           ///< of all [s]
  double exchange = 0, waiting = 0, output = 0;              ///< parts of it on the slowest rank [s]
  double rankExchange = 0, rankWaiting = 0, rankOutput = 0;  ///< parts on the rank that writes [s]
  double cpu = 0;                                            ///< processor time but for waiting [s]
  long steps = 0, exchanges = 0;
  double bytesSent = 0;
  std::optional<std::array<double, 3>> rest;  ///< steps left out, height missed [m], wakings
  struct {
    long atStart = 0, inserted = 0;  ///< at the start of the first run, and since then
    long left = 0;                   ///< through a border of the DEM box
    long deleted = 0;                ///< by the script
    long lost = 0;                   ///< otherwise
    long away = 0;                   ///< of those there are, beyond the fluid
    long now() const { return atStart + inserted - left - deleted - lost; }
  } particles;
  int clumps = 0;
  double overlap = 0, wallOverlap = 0;  ///< largest, over d
  double timestep = 0;                  ///< [s]
  int interval = 0;                     ///< DEM steps between two exchanges
  std::vector<std::pair<std::string, std::string>> settings;
  std::vector<std::string> warnings;

  /// The file, with its last line feed.
  std::string json() const;
};

/// What the progress line tells of a run under way.
struct Progress {
  double time = 0;                  ///< [s]
  double done = 0;                  ///< part of the run's steps
  double spent = 0;                 ///< wall time since its start [s]
  std::optional<double> interface;  ///< height [m]
  double overlap = 0;               ///< largest, over d
  double momentum = 0;              ///< residual

  std::string line() const;
};

/// A half neighbour list.
struct NeighbourList {
  int n = 0;
  const int *spheres = nullptr;      ///< n of them
  const int *counts = nullptr;       ///< by sphere
  int *const *neighbours = nullptr;  ///< by sphere
  int mask = -1;                     ///< bits of a neighbour that are its number
};

/// Two spheres that overlap.
struct Overlap {
  double depth = 0;           ///< over the smaller one's diameter
  int first = 0, second = 0;  ///< their tags
};

/// The largest overlap of the pairs listed, not of two that do not move; `first` and `second` stay as they are in
/// `before` when there is none.
Overlap largest_overlap(const NeighbourList &list, double *const *x, const double *radius, const int *groups,
                        const MovingGroups &moving, const int *tag, const Overlap &before);

}  // namespace clay
