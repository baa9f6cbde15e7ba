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
  return (atom->nmax * (Row::SIZE + clay::ShownRow::SIZE + (more_ ? (int)More::SIZE : 0) + (kept_ ? (int)KEPT : 0)) +
          size_local_rows * clay::ShownBody::SIZE) *
      sizeof(double);
}

void FixCoupleFoam::grow_arrays(int nmax)
{
  memory->grow(fluid_, nmax, (int)Row::SIZE, "couple/foam:fluid");
  if (more_) memory->grow(more_, nmax, (int)More::SIZE, "couple/foam:more");
  if (kept_) memory->grow(kept_, nmax, (int)KEPT, "couple/foam:kept");
  // made anew where it is read, and does not go along with the atoms
  memory->grow(array_atom, nmax, (int)clay::ShownRow::SIZE, "couple/foam:array_atom");
  std::fill_n(array_atom[0], nmax * clay::ShownRow::SIZE, 0.);
}

void FixCoupleFoam::copy_arrays(int i, int j, int)
{
  std::copy(fluid_[i], fluid_[i] + Row::SIZE, fluid_[j]);
  if (more_) std::copy(more_[i], more_[i] + More::SIZE, more_[j]);
  if (kept_) std::copy(kept_[i], kept_[i] + KEPT, kept_[j]);
}

void FixCoupleFoam::set_arrays(int i)
{
  report_->inserted();
  std::fill(fluid_[i], fluid_[i] + Row::SIZE, 0.);
  fluid_[i][Row::SLOT] = -1;
  fluid_[i][Row::RELAX] = 1.;
  if (more_) std::fill(more_[i], more_[i] + More::SIZE, 0.);
  if (kept_) std::fill(kept_[i], kept_[i] + KEPT, 0.);
}

int FixCoupleFoam::pack_exchange(int i, double *buf)
{
  double *end = std::copy(fluid_[i], fluid_[i] + Row::SIZE, buf);
  if (more_) end = std::copy(more_[i], more_[i] + More::SIZE, end);
  if (kept_) end = std::copy(kept_[i], kept_[i] + KEPT, end);
  return static_cast<int>(end - buf);
}

int FixCoupleFoam::unpack_exchange(int nlocal, double *buf)
{
  const double *from = buf;
  std::copy(from, from + Row::SIZE, fluid_[nlocal]);
  from += Row::SIZE;
  if (more_) {
    std::copy(from, from + More::SIZE, more_[nlocal]);
    from += More::SIZE;
  }
  if (kept_) {
    std::copy(from, from + KEPT, kept_[nlocal]);
    from += KEPT;
  }
  return static_cast<int>(from - buf);
}

/* ----------------------------------------------------------------------
   what the fluid does to a sphere, between its owner and its ghosts
------------------------------------------------------------------------- */

int FixCoupleFoam::pack_comm(int n, int *list, double *buf, int, int *)
{
  for (int m = 0; m < n; m++) buf = std::copy_n(fluid_[list[m]] + Row::DRAG, comm_forward, buf);
  return comm_forward;
}

void FixCoupleFoam::unpack_comm(int n, int first, double *buf)
{
  for (int i = first; i < first + n; i++, buf += comm_forward)
    std::copy(buf, buf + comm_forward, fluid_[i] + Row::DRAG);
}

int FixCoupleFoam::pack_reverse_comm(int n, int first, double *buf)
{
  if (showing_) {
    std::copy_n(array_atom[first], n * clay::ShownRow::SIZE, buf);
    return clay::ShownRow::SIZE;
  }
  for (int i = first; i < first + n; i++) buf = std::copy_n(fluid_[i] + Row::DRAG, comm_reverse, buf);
  return comm_reverse;
}

void FixCoupleFoam::unpack_reverse_comm(int n, int *list, double *buf)
{
  if (showing_) {
    for (int m = 0; m < n; m++)
      for (int k = 0; k < clay::ShownRow::SIZE; k++) array_atom[list[m]][k] += *buf++;
    return;
  }
  for (int m = 0; m < n; m++)
    for (int k = Row::DRAG; k < Row::DRAG + comm_reverse; k++) fluid_[list[m]][k] += *buf++;
}
