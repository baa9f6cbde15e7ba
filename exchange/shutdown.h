// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file shutdown.h
/// How a half ends when the coupled run is not over: the other half is told
/// why, may save its state, and both end with a non-zero exit.
#pragma once

#include <string>

#include "exchange/world.h"

namespace clay {

/// How far this half has come.
enum class Stage {
  uncoupled,  ///< no handshake yet
  coupled,    ///< a session is open
  closed      ///< the run is over, or both halves refused it: each ends by itself
};

void setStage(Stage stage);
Stage stage();

/// Ends this process (as the other half asks) when a message of shutdown has come in.
void checkShutdown();

/// Called ahead of MPI_Finalize: ends both halves unless the run is over.
void beforeFinalize();

/// Called instead of MPI_Abort.
[[noreturn]] void abortBoth(int code);

/// Ends all processes of the mpirun, and this one with the code (1 instead of 0).
[[noreturn]] void endAll(int code);

/// Sees to it that neither exit() without MPI_Finalize nor an uncaught
/// exception leaves the other half waiting. mayFinalize: MPI was started by
/// this library, which then ends it as well.
void watchExit(bool mayFinalize);

/// This program's name, as it stands in messages.
std::string programName();

}  // namespace clay
