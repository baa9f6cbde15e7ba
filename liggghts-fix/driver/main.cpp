// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
// liggghts-clay: LIGGGHTS with the styles of this folder. It takes LIGGGHTS's
// own options; without a coupling fix in the script it is LIGGGHTS.
#include <mpi.h>

#include <csignal>
#include <cstring>

#include "coupling/stop_signals.h"
#include "exchange/world.h"
#include "input.h"
#include "lammps.h"
#include "driver/register_styles.h"
#include "signal_handling.h"

using namespace LAMMPS_NS;

const clay::Half clay::programHalf = clay::Half::dem;

namespace {

// as LIGGGHTS does, where no coupled run listens: write a restart on the first
// signal, quit on the second
void on_stop(int signal)
{
  if (!clay::note_stop(signal)) SignalHandler::int_handler(signal);
}

void on_save(int signal)
{
  if (!clay::note_stop(signal)) SignalHandler::usr1_handler(signal);
}

void handle_signals()
{
  struct sigaction stop, save, before;
  std::memset(&stop, 0, sizeof stop);
  std::memset(&save, 0, sizeof save);
  stop.sa_handler = on_stop;
  save.sa_handler = on_save;
  // also where a shell has a background job ignore it
  sigaction(SIGINT, &stop, nullptr);
  sigaction(SIGTERM, &stop, nullptr);
  sigaction(SIGUSR1, &save, nullptr);
  // but nohup means what it says
  if (sigaction(SIGHUP, nullptr, &before) == 0 && before.sa_handler != SIG_IGN) sigaction(SIGHUP, &stop, nullptr);
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
