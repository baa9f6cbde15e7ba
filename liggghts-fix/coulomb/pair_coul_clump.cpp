/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   Settings, start and restart; the forces are in pair_clump.cpp.
------------------------------------------------------------------------- */

#include "coulomb/pair_coul_clump.h"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>

#include "atom.h"
#include "script/values.h"

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

PairCoulClump::PairCoulClump(LAMMPS *lmp) : PairClump(lmp, "coul/clump", "charge"), permittivity_(1.0) {}

/* ---------------------------------------------------------------------- */

void PairCoulClump::parse(int narg, char **arg)
{
  if (narg < 1) throw std::invalid_argument("the cut-off is missing (m)");
  law_ = clay::CoulombLaw();
  permittivity_ = 1.0;
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
    } else if (word == "every" && i + 1 < narg) parse_every(narg, arg, i);
    else if (word == "double") groups_.single = false;
    else if (word == "single") groups_.single = true;
    else
      throw std::invalid_argument("'" + word +
                                  "' is not understood: sharp, shifted, permittivity EPS, "
                                  "screened LAMBDA [spheres|points], every N [impulse|hold], double or single may "
                                  "follow the cut-off");
  }
  law_.k /= permittivity_;
}

/* ---------------------------------------------------------------------- */

void PairCoulClump::init_style()
{
  check();
  char text[256];
  bool charged = false;
  for (int t = 1; t <= atom->ntypes; t++) charged = charged || value_[t] != 0.0;
  const double largest = largest_radius();
  if (charged && law_.cutoff <= 2.0 * largest) {
    snprintf(text, sizeof text, "cut-off %g is not beyond contact of the largest spheres, %g apart (m)", law_.cutoff,
             2.0 * largest);
    refuse(text);
  }
  law_.near = 0.0;
  if (charged && law_.debye > 0.0 && law_.spheres && atom->radius_flag) {
    const double smallest = smallest_radius();
    if (largest - smallest > 30.0 * law_.debye) {
      snprintf(text, sizeof text,
               "radii of %g to %g m differ by more than 30 Debye lengths of %g m; take a longer "
               "one, or 'screened %g points'",
               smallest, largest, law_.debye, law_.debye);
      refuse(text);
    }
    law_.near = 2.0 * smallest;
  }
  start(charged);
}

/* ---------------------------------------------------------------------- */

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
  double kept[7] = {};
  read_numbers(fp, kept, 6);
  if (kept[1] >= 2.0) read_numbers(fp, kept + 6, 1);
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
  return value_[atom->type[i]] * law_.weight(a);
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
  const double r = sqrt(rsq), qq = value_[itype] * law_.weight(ai) * value_[jtype] * law_.weight(aj);
  fforce = law_.forceOverDistance(qq, r);
  return law_.energy(qq, r);
}
