/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   What fix couple/foam keeps for each sphere, on its way between arrays and
   processors.
------------------------------------------------------------------------- */

#include "coupling/fix_couple_foam.h"

#include <algorithm>

#include "atom.h"
#include "coupling/coupling_report.h"
#include "memory.h"

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

double FixCoupleFoam::memory_usage()
{
  return atom->nmax * (Row::SIZE + (more_ ? (int)More::SIZE : 0)) * sizeof(double);
}

void FixCoupleFoam::grow_arrays(int nmax)
{
  memory->grow(fluid_, nmax, (int)Row::SIZE, "couple/foam:fluid");
  if (more_) memory->grow(more_, nmax, (int)More::SIZE, "couple/foam:more");
}

void FixCoupleFoam::copy_arrays(int i, int j, int)
{
  std::copy(fluid_[i], fluid_[i] + Row::SIZE, fluid_[j]);
  if (more_) std::copy(more_[i], more_[i] + More::SIZE, more_[j]);
}

void FixCoupleFoam::set_arrays(int i)
{
  report_->inserted();
  std::fill(fluid_[i], fluid_[i] + Row::SIZE, 0.);
  fluid_[i][Row::SLOT] = -1;
  fluid_[i][Row::RELAX] = 1.;
  if (more_) std::fill(more_[i], more_[i] + More::SIZE, 0.);
}

int FixCoupleFoam::pack_exchange(int i, double *buf)
{
  std::copy(fluid_[i], fluid_[i] + Row::SIZE, buf);
  if (!more_) return Row::SIZE;
  std::copy(more_[i], more_[i] + More::SIZE, buf + Row::SIZE);
  return Row::SIZE + More::SIZE;
}

int FixCoupleFoam::unpack_exchange(int nlocal, double *buf)
{
  std::copy(buf, buf + Row::SIZE, fluid_[nlocal]);
  if (!more_) return Row::SIZE;
  std::copy(buf + Row::SIZE, buf + Row::SIZE + More::SIZE, more_[nlocal]);
  return Row::SIZE + More::SIZE;
}

/* ----------------------------------------------------------------------
   what the fluid does to a sphere, between its owner and its ghosts
------------------------------------------------------------------------- */

int FixCoupleFoam::pack_comm(int n, int *list, double *buf, int, int *)
{
  for (int m = 0; m < n; m++) buf = std::copy(fluid_[list[m]] + Row::DRAG, fluid_[list[m]] + Row::FORCE, buf);
  return comm_forward;
}

void FixCoupleFoam::unpack_comm(int n, int first, double *buf)
{
  for (int i = first; i < first + n; i++, buf += comm_forward)
    std::copy(buf, buf + comm_forward, fluid_[i] + Row::DRAG);
}

int FixCoupleFoam::pack_reverse_comm(int n, int first, double *buf)
{
  for (int i = first; i < first + n; i++) buf = std::copy(fluid_[i] + Row::DRAG, fluid_[i] + Row::FORCE, buf);
  return comm_reverse;
}

void FixCoupleFoam::unpack_reverse_comm(int n, int *list, double *buf)
{
  for (int m = 0; m < n; m++)
    for (int k = Row::DRAG; k < Row::FORCE; k++) fluid_[list[m]][k] += *buf++;
}
