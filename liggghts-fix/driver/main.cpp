// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
// liggghts-clay: LIGGGHTS with the styles of this folder. It takes LIGGGHTS's
// own options; without a coupling fix in the script it is LIGGGHTS.
#include <mpi.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
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

volatile sig_atomic_t coupled = 0;  // the mpirun has a CFD half

// Nothing in a handler may allocate: LIGGGHTS's own do, and hang when the signal
// comes within malloc.

// before the first exchange of a coupled run there is nothing to keep, nor after it;
// SIGTERM is mpirun's way to end what is left when a half has said why it ended
void end_early(int signal)
{
  if (signal == SIGTERM) _exit(128 + signal);
  static const char text[] = "liggghts-clay: ended by a signal outside of its coupled run\n";
  if (write(STDERR_FILENO, text, sizeof text - 1) < 0) _exit(1);
  _exit(128 + signal);
}

// as LIGGGHTS does, where no coupled run listens: write a restart on the first
// signal and quit, quit at once on the second
void on_stop(int signal)
{
  if (clay::note_stop(signal)) return;
  if (coupled) end_early(signal);
  if (SignalHandler::request_quit) _exit(1);
  SignalHandler::request_write_restart = SignalHandler::enable_restart_writing;
  SignalHandler::request_quit = true;
}

void on_save(int signal)
{
  if (clay::note_stop(signal)) return;
  if (coupled) end_early(signal);
  SignalHandler::request_write_restart = SignalHandler::enable_restart_writing;
}

void handle_signals()
{
  struct sigaction stop, save, before;
  std::memset(&stop, 0, sizeof stop);
  std::memset(&save, 0, sizeof save);
  stop.sa_handler = on_stop;
  save.sa_handler = on_save;
  sigaction(SIGINT, &stop, nullptr);
  sigaction(SIGTERM, &stop, nullptr);
  sigaction(SIGUSR1, &save, nullptr);
  // but nohup means what it says
  if (sigaction(SIGHUP, nullptr, &before) == 0 && before.sa_handler != SIG_IGN) sigaction(SIGHUP, &stop, nullptr);
}

}

int main(int argc, char **argv)
{
  std::signal(SIGINT, SIG_DFL);  // also where a shell has a background job ignore it
  // one that is ended from outside keeps its lines
  setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  MPI_Init(&argc, &argv);
  coupled = clay::World::instance().hasOtherHalf();
  handle_signals();

  LAMMPS *lammps = new LAMMPS(argc, argv, MPI_COMM_WORLD);
  register_clay_styles(lammps);
  offer_lean_contacts(lammps);
  lammps->input->file();
  delete lammps;

  MPI_Finalize();
  return 0;
}
