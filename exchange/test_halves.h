// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file test_halves.h
/// What the two programs of the test runs have in common: the terms, the mesh,
/// and the ways to die. They use MPI as a host code does, unaware of halves.
#pragma once

#include <mpi.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>

#include "exchange/session.h"

namespace halves {

constexpr double step = 1e-5;              // [s]
constexpr long interval = 20;              // steps
constexpr int exchanges = 6;               // in each run
constexpr double size[3] = {1, 0.5, 0.5};  // of the mesh [m]

inline double timeOf(int exchange) { return exchange * interval * step; }

inline clay::Box meshBox() {
  clay::Box b;
  b.lo = {0, 0, 0};
  b.hi = {size[0], size[1], size[2]};
  return b;
}

/// The mesh is cut into slabs in x, one a rank.
inline clay::Box slab(int rank, int ranks) {
  clay::Box b = meshBox();
  b.lo[0] = size[0] * rank / ranks;
  b.hi[0] = size[0] * (rank + 1) / ranks;
  return b;
}

inline clay::FieldSet stateFields() {
  using F = clay::Field;
  return {F::position, F::radius, F::volume, F::velocity, F::tag, F::body};
}

inline clay::DemTerms demTerms() {
  using F = clay::Field;
  clay::DemTerms t;
  t.program = "test DEM";
  t.step = step;
  t.interval = interval;
  t.endTime = timeOf(exchanges - 1);
  t.gravity = {0, 0, -9.81};
  t.hasGravity = true;
  t.box = meshBox();
  t.particles = 1000;
  t.maxRadius = 0.02;
  t.offers = stateFields();
  t.offers.add(F::mass);
  t.offers.add(F::impulse);
  t.needs = {F::dragCoefficient, F::fluidVelocity};
  return t;
}

inline clay::CfdTerms cfdTerms() {
  using F = clay::Field;
  clay::CfdTerms t;
  t.program = "test CFD";
  t.fluidDensity = 1000;
  t.fluidViscosity = 1e-3;
  t.box = meshBox();
  t.needs = stateFields();
  t.offers = {F::dragCoefficient, F::fluidVelocity, F::force};
  return t;
}

/// Ends both halves unless the statement holds.
inline void expect(bool holds, const std::string& statement) {
  if (!holds) clay::abandon("NOT TRUE: " + statement);
}

/// Ends this process in the way that is asked for, as "dem:exit0", if it is this
/// half's turn.
inline void dieAs(const std::string& scenario, const std::string& half) {
  if (scenario.rfind(half + ":", 0) != 0) return;
  const std::string way = scenario.substr(half.size() + 1);
  if (way == "exit0") std::exit(0);
  if (way == "exit3") std::exit(3);
  if (way == "_exit0") _exit(0);
  if (way == "kill") kill(getpid(), SIGKILL);
  if (way == "throw") throw std::runtime_error("no more cheese");
  if (way == "abandon") clay::abandon("no more cheese");
  if (way == "abort") MPI_Abort(MPI_COMM_WORLD, 7);
  if (way == "finalize") {
    MPI_Finalize();
    std::exit(0);
  }
  if (way == "explained") {
    clay::explainEnd("no cheese\nat all");
    MPI_Finalize();
    std::exit(1);
  }
  if (way == "error") {  // as LIGGGHTS does
    MPI_Finalize();
    std::exit(1);
  }
  if (way == "words") {
    clay::setLastWords("; state 7 is left");
    MPI_Abort(MPI_COMM_WORLD, 7);
  }
  if (way == "ownWords") {
    clay::setLastWords("; state 7 is left");
    clay::abandon("no more cheese; state 7 is left");
  }
  if (way == "sleep") sleep(30);
}

/// The host code's own use of MPI: it must see its half alone.
inline void expectOwnWorld(int ranks) {
  int size = 0, one = 1, sum = 0;
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  MPI_Allreduce(&one, &sum, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
  MPI_Barrier(MPI_COMM_WORLD);
  expect(size == ranks && sum == ranks, "MPI_COMM_WORLD is this half");
  int* upperBound = nullptr;
  int there = 0;
  MPI_Comm_get_attr(MPI_COMM_WORLD, MPI_TAG_UB, &upperBound, &there);
  expect(there != 0, "MPI_COMM_WORLD keeps its upper bound of tags");
}

}  // namespace halves
