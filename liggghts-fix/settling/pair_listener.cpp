// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "settling/pair_listener.h"

#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "atom.h"
#include "fix_wall_gran.h"
#include "lammps.h"
#include "pair_gran.h"
#include "update.h"

using namespace LAMMPS_NS;

/* ----------------------------------------------------------------------
   LIGGGHTS makes these computes before the first step only
------------------------------------------------------------------------- */

PairListener *PairListener::make(LAMMPS *lmp)
{
  std::string words[] = {"settling_profile", "all", "pair/gran/local", "force"};
  char *arg[4];
  for (int k = 0; k < 4; k++) arg[k] = &words[k][0];
  int iarg = 3;
  const bigint now = lmp->update->ntimestep;
  lmp->update->ntimestep = 0;
  PairListener *made = new PairListener(lmp, iarg, 4, arg);
  lmp->update->ntimestep = now;
  return made;
}

/* ---------------------------------------------------------------------- */

void PairListener::each(PairGran *pair, const Pair &visit)
{
  visit_ = &visit;
  ComputePairGranLocal *other = pair->cpl();
  int numbers;
  if (other) pair->unregister_compute_pair_local(other);
  pair->register_compute_pair_local(this, numbers);
  pair->compute_pgl(0, 0);
  pair->unregister_compute_pair_local(this);
  if (other) pair->register_compute_pair_local(other, numbers);
}

void PairListener::add_pair(int i, int j, double fx, double fy, double fz, double, double, double, double *,
                            const double *const)
{
  if (j >= atom->nlocal && atom->tag[i] <= atom->tag[j]) return;
  const double f[3] = {fx, fy, fz};
  (*visit_)(i, j, f);
}

/* ---------------------------------------------------------------------- */

void LAMMPS_NS::limit_friction(double *f, const double *n, double coefficient)
{
  double n2 = 0.0, along = 0.0, f2 = 0.0;
  for (int d = 0; d < 3; d++) {
    n2 += n[d] * n[d];
    along += f[d] * n[d];
    f2 += f[d] * f[d];
  }
  if (n2 == 0.0) return;
  const double normal2 = along * along / n2, most2 = coefficient * coefficient * normal2, side2 = f2 - normal2;
  if (side2 <= most2) return;
  const double part = std::sqrt(most2 / side2);
  for (int d = 0; d < 3; d++) f[d] = along / n2 * n[d] + part * (f[d] - along / n2 * n[d]);
}

/* ----------------------------------------------------------------------
   as in a set-up, which leaves the history alone, and into arrays that are empty
------------------------------------------------------------------------- */

void LAMMPS_NS::each_wall_force(LAMMPS *lmp, FixWallGran *wall,
                                const std::function<void(int i, const double *f)> &visit)
{
  const Atom &atom = *lmp->atom;
  const std::size_t numbers = 3 * static_cast<std::size_t>(atom.nlocal);
  if (numbers == 0) return;
  std::vector<double> f(atom.f[0], atom.f[0] + numbers), torque(atom.torque[0], atom.torque[0] + numbers);
  std::memset(atom.f[0], 0, numbers * sizeof(double));
  const int setup = lmp->update->setupflag;
  lmp->update->setupflag = 1;
  wall->post_force(0);
  lmp->update->setupflag = setup;
  for (int i = 0; i < atom.nlocal; i++) {
    const double *on = atom.f[i];
    if (on[0] != 0.0 || on[1] != 0.0 || on[2] != 0.0) visit(i, on);
  }
  std::memcpy(atom.f[0], f.data(), numbers * sizeof(double));
  std::memcpy(atom.torque[0], torque.data(), numbers * sizeof(double));
}
