/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   Settings, start and restart; the forces are in pair_clump.cpp.
------------------------------------------------------------------------- */

#include "coulomb/pair_coul_clump.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <climits>
#include <cstring>
#include <stdexcept>
#include <string>

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix_multisphere.h"
#include "force.h"
#include "modify.h"
#include "script/values.h"

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

PairCoulClump::PairCoulClump(LAMMPS *lmp) : PairClump(lmp), permittivity_(1.0) {}

/* ---------------------------------------------------------------------- */

void PairCoulClump::allocate()
{
  allocate_tables();
  charge_.assign(atom->ntypes + 1, 0.0);
  given_.assign(atom->ntypes + 1, 0);
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
    else if (word == "screened" && i + 1 < narg) {
      law_.debye = clay::positiveNumber(word, arg[++i]);
      law_.spheres = true;
      if (i + 1 < narg && (!strcmp(arg[i + 1], "spheres") || !strcmp(arg[i + 1], "points")))
        law_.spheres = !strcmp(arg[++i], "spheres");
    } else if (word == "every" && i + 1 < narg) {
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
                                  "screened LAMBDA [spheres|points], every N [impulse|hold], double or single may "
                                  "follow the cut-off");
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

  bool charged = false;
  for (int t = 1; t <= atom->ntypes; t++) charged = charged || charge_[t] != 0.0;
  const double largest = largest_radius();
  if (charged && law_.cutoff <= 2.0 * largest) {
    snprintf(text, sizeof text,
             "Pair style coul/clump: cut-off %g is not beyond contact of the largest spheres, %g apart (m)",
             law_.cutoff, 2.0 * largest);
    error->all(FLERR, text);
  }
  law_.near = 0.0;
  if (charged && law_.debye > 0.0 && law_.spheres && atom->radius_flag) {
    const double smallest = smallest_radius();
    if (largest - smallest > 30.0 * law_.debye) {
      snprintf(text, sizeof text,
               "Pair style coul/clump: radii of %g to %g m differ by more than 30 Debye lengths of %g m; take a longer "
               "one, or 'screened %g points'",
               smallest, largest, law_.debye, law_.debye);
      error->all(FLERR, text);
    }
    law_.near = 2.0 * smallest;
  }
  start(charged);
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
  // bits of the form: 1 shifted, 2 screened, whose Debye length follows, 4 ions stay outside of the spheres
  const double form = (law_.shifted ? 1.0 : 0.0) + (law_.debye > 0.0 ? 2.0 : 0.0) + (law_.spheres ? 4.0 : 0.0);
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
  law_.shifted = static_cast<int>(kept[1]) & 1;
  law_.spheres = static_cast<int>(kept[1]) & 4;
  law_.debye = kept[6];
  permittivity_ = kept[2];
  law_.k /= permittivity_;
  every_ = static_cast<int>(kept[3]);
  hold_ = kept[4] != 0.0;
  groups_.single = kept[5] != 0.0;
}

/* ---------------------------------------------------------------------- */

double PairCoulClump::strength(int i) const
{
  const double a = atom->radius_flag ? atom->radius[i] : 0.0;
  return charge_[atom->type[i]] * law_.weight(a);
}

double PairCoulClump::between(int a, int b, double r, double &f) const
{
  const double qq = groups_.q[a] * groups_.q[b];
  f = law_.forceOverDistance(qq, r);
  return law_.energy(qq, r);
}

/* ---------------------------------------------------------------------- */

double PairCoulClump::single(int i, int j, int itype, int jtype, double rsq, double, double, double &fforce)
{
  fforce = 0.0;
  if (one_body(i, j)) return 0.0;
  const double ai = atom->radius_flag ? atom->radius[i] : 0.0, aj = atom->radius_flag ? atom->radius[j] : 0.0;
  const double r = sqrt(rsq), qq = charge_[itype] * law_.weight(ai) * charge_[jtype] * law_.weight(aj);
  fforce = law_.forceOverDistance(qq, r);
  return law_.energy(qq, r);
}
