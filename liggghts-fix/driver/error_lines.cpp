// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
// Error::all() and Error::one() of this program, in place of the library's: one line, of
// which the other half hears. The library's print some bytes of freed memory behind it.
#include <mpi.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "error.h"
#include "exchange/world.h"

using namespace LAMMPS_NS;

namespace {

void print(FILE *to, const std::string &line)
{
  if (!to) return;
  fputs(line.c_str(), to);
  fflush(to);
}

}

/* ----------------------------------------------------------------------
   all processors come here
------------------------------------------------------------------------- */

void Error::all(const char *file, int line, const char *str)
{
  int rank = 0;
  MPI_Barrier(world);
  MPI_Comm_rank(world, &rank);
  if (rank == 0) {
    const std::string text = std::string("ERROR: ") + str + " (" + file + ":" + std::to_string(line) + ")\n";
    print(screen, text);
    print(logfile, text);
  }
  clay::explainEnd(str);
  MPI_Finalize();
  exit(1);
}

/* ----------------------------------------------------------------------
   this one alone does
------------------------------------------------------------------------- */

void Error::one(const char *file, int line, const char *str)
{
  int rank = 0;
  MPI_Comm_rank(world, &rank);
  const std::string text =
      "ERROR on proc " + std::to_string(rank) + ": " + str + " (" + file + ":" + std::to_string(line) + ")\n";
  print(screen ? screen : stderr, text);
  print(logfile, text);
  clay::explainEnd(str);
  MPI_Abort(world, 1);
  exit(1);
}
