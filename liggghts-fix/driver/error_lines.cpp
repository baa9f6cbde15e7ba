// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
// Errors of this program, in place of the library's: one line, of
// which the other half hears. The library's print some bytes of freed memory behind it.
#include <mpi.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "compute.h"
#include "error.h"
#include "exchange/world.h"
#include "fix.h"

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
   of a fix or a compute, which the line names
------------------------------------------------------------------------- */

void Error::fix_error(const char *file, int line, Fix *fix, const char *str)
{
  all(file, line, (std::string("Fix ") + fix->style + " (id " + fix->id + "): " + str).c_str());
}

void Error::fix_error(const char *file, int line, Fix *fix, const char *name, const char *str)
{
  all(file, line, (std::string("Fix ") + name + " (id " + fix->id + "): " + str).c_str());
}

void Error::compute_error(const char *file, int line, Compute *compute, const char *str)
{
  all(file, line, (std::string("Compute ") + compute->style + " (id " + compute->id + "): " + str).c_str());
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
