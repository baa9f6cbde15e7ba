// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
// liggghts-clay: LIGGGHTS with the styles of this folder. It takes LIGGGHTS's
// own options; without a coupling fix in the script it is LIGGGHTS.
#include <mpi.h>

#include <csignal>
#include <cstring>

#include "exchange/world.h"
#include "input.h"
#include "lammps.h"
#include "driver/register_styles.h"
#include "signal_handling.h"

using namespace LAMMPS_NS;

const clay::Half clay::programHalf = clay::Half::dem;

namespace {

// as LIGGGHTS does: write a restart on the first signal, quit on the second
void handle_signals()
{
  struct sigaction stop, save;
  std::memset(&stop, 0, sizeof stop);
  std::memset(&save, 0, sizeof save);
  stop.sa_handler = SignalHandler::int_handler;
  save.sa_handler = SignalHandler::usr1_handler;
  sigaction(SIGINT, &stop, nullptr);
  sigaction(SIGTERM, &stop, nullptr);
  sigaction(SIGUSR1, &save, nullptr);
}

}

int main(int argc, char **argv)
{
  handle_signals();
  MPI_Init(&argc, &argv);

  LAMMPS *lammps = new LAMMPS(argc, argv, MPI_COMM_WORLD);
  register_clay_styles(lammps);
  lammps->input->file();
  delete lammps;

  MPI_Finalize();
  return 0;
}
