// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file world_wrappers.h
/// What the wrappers of both files share; internal to exchange/.
#pragma once

#define OMPI_SKIP_MPICXX 1
#include <mpi.h>

#include "exchange/world.h"

namespace clay {

/// The half where a host code says MPI_COMM_WORLD, any other communicator as it is.
inline MPI_Comm confined(MPI_Comm comm) {
  if (comm != MPI_COMM_WORLD) return comm;
  const World& world = World::instance();
  return world.ready() ? world.half() : comm;
}

}  // namespace clay

/// Defines MPI_name, which calls PMPI_name.
#define CLAY_WRAP(name, parameters, arguments) \
  extern "C" int MPI_##name parameters { return PMPI_##name arguments; }

#define CLAY_UNPACK(...) __VA_ARGS__

/// Defines the blocking call and its non-blocking twin, which takes a request as well.
#define CLAY_WRAP_BOTH(name, twin, parameters, arguments)            \
  CLAY_WRAP(name, (CLAY_UNPACK parameters), (CLAY_UNPACK arguments)) \
  CLAY_WRAP(twin, (CLAY_UNPACK parameters, MPI_Request * request), (CLAY_UNPACK arguments, request))
