// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
// LIGGGHTS with this project's styles, in a program of one's own.
#include <mpi.h>

#include "driver/register_styles.h"
#include "exchange/world.h"
#include "input.h"
#include "lammps.h"

const clay::Half clay::programHalf = clay::Half::dem;

int main(int argc, char **argv)
{
  MPI_Init(&argc, &argv);
  {
    LAMMPS_NS::LAMMPS lammps(argc, argv, MPI_COMM_WORLD);
    LAMMPS_NS::register_clay_styles(&lammps);
    lammps.input->file();
  }
  MPI_Finalize();
  return 0;
}
