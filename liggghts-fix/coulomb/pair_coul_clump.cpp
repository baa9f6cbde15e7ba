/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   Settings, start and restart; the forces are in pair_coul_clump_compute.cpp.
------------------------------------------------------------------------- */

#include "coulomb/pair_coul_clump.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <climits>
#include <cstring>
#include <stdexcept>
#include <string>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_multisphere.h"
#include "force.h"
#include "memory.h"
#include "modify.h"
#include "neighbor.h"
#include "script/values.h"

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

PairCoulClump::PairCoulClump(LAMMPS *lmp) :
  Pair(lmp), permittivity_(1.0), every_(1), hold_(false), charged_(false), centred_(false), multisphere_(NULL),
  laid_out_(-1), nall_(-1), evaluated_(-1), evaluations_(0)
{
  no_virial_fdotr_compute = 1;
}

PairCoulClump::~PairCoulClump()
{
  if (allocated) {
    memory->destroy(setflag);
    memory->destroy(cutsq);
  }
}

/* ---------------------------------------------------------------------- */

void PairCoulClump::allocate()
{
  allocated = 1;
  const int n = atom->ntypes;
  memory->create(setflag, n + 1, n + 1, "pair:setflag");
  memory->create(cutsq, n + 1, n + 1, "pair:cutsq");
  for (int i = 0; i <= n; i++)
    for (int j = 0; j <= n; j++) {
      setflag[i][j] = 0;
      cutsq[i][j] = 0.0;
    }
  charge_.assign(n + 1, 0.0);
  given_.assign(n + 1, 0);
}

/* ---------------------------------------------------------------------- */

void PairCoulClump::settings(int narg, char **arg)
{
  try {
    parse(narg, arg);
  } catch (const std::invalid_argument &e) {
    error->all(FLERR, (std::string("Pair style coul/clump: ") + e.what()).c_str());
  }
}

void PairCoulClump::parse(int narg, char **arg)
{
  if (narg < 1) throw std::invalid_argument("the cut-off is missing (m)");
  law_ = clay::CoulombLaw();
  permittivity_ = 1.0;
  every_ = 1;
  hold_ = false;
  groups_.single = false;
  law_.cutoff = clay::positiveNumber("cut-off", arg[0]);

  for (int i = 1; i < narg; i++) {
    const std::string word = arg[i];
    if (word == "sharp") law_.shifted = false;
    else if (word == "shifted") law_.shifted = true;
    else if (word == "permittivity" && i + 1 < narg) permittivity_ = clay::positiveNumber(word, arg[++i]);
    else if (word == "screened" && i + 1 < narg) law_.debye = clay::positiveNumber(word, arg[++i]);
    else if (word == "every" && i + 1 < narg) {
      every_ = static_cast<int>(clay::wholeNumber(word, arg[++i], 1, INT_MAX));
      if (i + 1 < narg && strcmp(arg[i + 1], "impulse") == 0) {
        hold_ = false;
        i++;
      } else if (i + 1 < narg && strcmp(arg[i + 1], "hold") == 0) {
        hold_ = true;
        i++;
      }
    } else if (word == "double") groups_.single = false;
    else if (word == "single") groups_.single = true;
    else
      throw std::invalid_argument("'" + word +
                                  "' is not understood: sharp, shifted, permittivity EPS, "
                                  "screened LAMBDA, every N [impulse|hold], double or single may follow the cut-off");
  }
  law_.k /= permittivity_;
}

/* ----------------------------------------------------------------------
   pair_coeff T T q: the charge of the spheres of a type
------------------------------------------------------------------------- */

void PairCoulClump::coeff(int narg, char **arg)
{
  if (narg != 3 || strcmp(arg[0], arg[1]) != 0)
    error->all(FLERR, "Pair coeff for coul/clump: a charge belongs to one type: pair_coeff T T charge");
  const bool number = strspn(arg[0], "0123456789") == strlen(arg[0]);
  if (number && (atoi(arg[0]) < 1 || atoi(arg[0]) > atom->ntypes)) {
    char text[128];
    snprintf(text, sizeof text, "Pair coeff for coul/clump: atom type %s has a charge, but the box has types 1 to %d",
             arg[0], atom->ntypes);
    error->all(FLERR, text);
  }
  if (!allocated) allocate();

  int lo, hi;
  force->bounds(arg[0], atom->ntypes, lo, hi);
  const double q = force->numeric(FLERR, arg[2]);
  for (int t = lo; t <= hi; t++) {
    charge_[t] = q;
    given_[t] = 1;
  }
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) setflag[i][j] = 1;  // init_style looks for what is missing
}

/* ---------------------------------------------------------------------- */

void PairCoulClump::init_style()
{
  char text[256];
  for (int t = 1; t <= atom->ntypes; t++)
    if (!allocated || !given_[t]) {
      snprintf(text, sizeof text, "Pair style coul/clump: atom type %d has no charge: pair_coeff %d %d [coul/clump] Q",
               t, t, t);
      error->all(FLERR, text);
    }
  if (force->newton_pair) error->all(FLERR, "Pair style coul/clump requires newton off");
  if (modify->n_fixes_style("multisphere") > 1) error->all(FLERR, "Pair style coul/clump: at most one fix multisphere");
  multisphere_ = static_cast<FixMultisphere *>(modify->find_fix_style("multisphere", 0));

  charged_ = false;
  for (int t = 1; t <= atom->ntypes; t++) charged_ = charged_ || charge_[t] != 0.0;

  double largest = 0.0, smallest = 0.0;
  if (atom->radius_flag) {
    modify->max_min_rad(largest, smallest);
    double mine = 0.0, all = 0.0;
    for (int i = 0; i < atom->nlocal; i++) mine = std::max(mine, atom->radius[i]);
    MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_MAX, world);
    largest = std::max(largest, all);
  }
  if (charged_ && law_.cutoff <= 2.0 * largest) {
    snprintf(text, sizeof text,
             "Pair style coul/clump: cut-off %g is not beyond contact of the largest spheres, %g apart (m)",
             law_.cutoff, 2.0 * largest);
    error->all(FLERR, text);
  }

  // With granular atom styles LIGGGHTS hands each processor only the ghosts
  // within half of its cut-off, which is enough for contacts. Here both
  // processors of a pair need the other's atom: twice the range is asked for.
  if (charged_) {
    const double range = 2.0 * law_.cutoff + neighbor->skin;
    comm->cutghostuser = std::max(comm->cutghostuser, range);
  }
  // where they will be then is foreseen by their velocities, which ghosts have only on request
  const bool ghosts = comm->nprocs > 1 || domain->xperiodic || domain->yperiodic || domain->zperiodic;
  centred_ = hold_ && every_ > 1 && (comm->ghost_velocity || !ghosts);
  laid_out_ = evaluated_ = nall_ = -1;
}

/* ----------------------------------------------------------------------
   no list is used, so none is made longer
------------------------------------------------------------------------- */

double PairCoulClump::init_one(int i, int j)
{
  if (setflag[i][j] == 0) error->all(FLERR, "All pair coeffs are not set");
  return 0.0;
}

/* ---------------------------------------------------------------------- */

void PairCoulClump::write_restart(FILE *fp)
{
  write_restart_settings(fp);
  fwrite(&charge_[0], sizeof(double), atom->ntypes + 1, fp);
}

void PairCoulClump::read_restart(FILE *fp, const int major, const int minor)
{
  read_restart_settings(fp, major, minor);
  if (!allocated) allocate();
  if (comm->me == 0 &&
      fread(&charge_[0], sizeof(double), atom->ntypes + 1, fp) != static_cast<size_t>(atom->ntypes + 1))
    error->one(FLERR, "Pair style coul/clump: the restart file ends too early");
  MPI_Bcast(&charge_[0], atom->ntypes + 1, MPI_DOUBLE, 0, world);
  for (int i = 1; i <= atom->ntypes; i++) {
    given_[i] = 1;
    for (int j = i; j <= atom->ntypes; j++) setflag[i][j] = 1;
  }
}

void PairCoulClump::write_restart_settings(FILE *fp)
{
  // bits of the form: 1 shifted, 2 screened, whose Debye length follows
  const double form = (law_.shifted ? 1.0 : 0.0) + (law_.debye > 0.0 ? 2.0 : 0.0);
  const double kept[7] = {
      law_.cutoff, form, permittivity_, static_cast<double>(every_), hold_ ? 1.0 : 0.0, groups_.single ? 1.0 : 0.0,
      law_.debye};
  fwrite(kept, sizeof(double), law_.debye > 0.0 ? 7 : 6, fp);
}

void PairCoulClump::read_restart_settings(FILE *fp, const int, const int)
{
  double kept[7];
  kept[6] = 0.0;
  if (comm->me == 0 &&
      (fread(kept, sizeof(double), 6, fp) != 6 || (kept[1] >= 2.0 && fread(&kept[6], sizeof(double), 1, fp) != 1)))
    error->one(FLERR, "Pair style coul/clump: the restart file ends too early");
  MPI_Bcast(kept, 7, MPI_DOUBLE, 0, world);
  law_ = clay::CoulombLaw();
  law_.cutoff = kept[0];
  law_.shifted = kept[1] == 1.0 || kept[1] == 3.0;
  law_.debye = kept[6];
  permittivity_ = kept[2];
  law_.k /= permittivity_;
  every_ = static_cast<int>(kept[3]);
  hold_ = kept[4] != 0.0;
  groups_.single = kept[5] != 0.0;
}

/* ---------------------------------------------------------------------- */

double PairCoulClump::memory_usage()
{
  return Pair::memory_usage() + order_.size() * (sizeof(int) + 11.0 * sizeof(double));
}
