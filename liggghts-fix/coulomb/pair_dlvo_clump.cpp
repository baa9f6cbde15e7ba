/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   Settings, start and restart; the forces are in pair_clump.cpp.
------------------------------------------------------------------------- */

#include "coulomb/pair_dlvo_clump.h"

#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "atom.h"
#include "script/values.h"

using namespace LAMMPS_NS;

static const double vacuum = 8.8541878128e-12;  // F/m

/* ---------------------------------------------------------------------- */

PairDlvoClump::PairDlvoClump(LAMMPS *lmp) :
  PairClump(lmp, "dlvo/clump", "potential"), relative_(78.4), temperature_(298.15)
{
}

/* ---------------------------------------------------------------------- */

void PairDlvoClump::parse(int narg, char **arg)
{
  if (narg < 1) throw std::invalid_argument("the largest gap is missing (m)");
  law_ = clay::DlvoLaw();
  relative_ = 78.4;
  temperature_ = 298.15;
  law_.gap = clay::positiveNumber("gap", arg[0]);
  bool hamaker = false;

  for (int i = 1; i < narg; i++) {
    const std::string word = arg[i];
    if (i + 1 == narg) throw std::invalid_argument("'" + word + "' is not understood, or its value is missing");
    if (word == "every") {
      parse_every(narg, arg, i);
      continue;
    }
    const std::string value = arg[++i];
    if (word == "debye") law_.debye = clay::positiveNumber(word, value);
    else if (word == "hamaker") {
      law_.hamaker = clay::number(word, value);
      if (law_.hamaker < 0) throw std::invalid_argument("hamaker is '" + value + "'; it must be a number of 0 or more");
      hamaker = true;
    } else if (word == "contact") law_.contact = clay::positiveNumber(word, value);
    else if (word == "retarded") law_.retardation = clay::positiveNumber(word, value);
    else if (word == "permittivity") relative_ = clay::positiveNumber(word, value);
    else if (word == "temperature") temperature_ = clay::positiveNumber(word, value);
    else
      throw std::invalid_argument("'" + word +
                                  "' is not understood: debye L, hamaker A, contact H, retarded W, permittivity EPS, "
                                  "temperature T, every N [impulse|hold] may follow the gap");
  }
  if (law_.debye == 0) throw std::invalid_argument("'debye' is missing: the Debye length (m)");
  if (!hamaker) throw std::invalid_argument("'hamaker' is missing: the Hamaker constant (J), 0 for none");
  if (law_.contact == 0) throw std::invalid_argument("'contact' is missing: the gap below which forces stay (m)");
  if (law_.contact >= law_.gap) {
    char text[128];
    snprintf(text, sizeof text, "contact is '%g'; it must be below the largest gap, %g (m)", law_.contact, law_.gap);
    throw std::invalid_argument(text);
  }
  law_.permittivity = vacuum * relative_;
}

/* ---------------------------------------------------------------------- */

double PairDlvoClump::value_of(const char *word) const
{
  const double psi = PairClump::value_of(word);
  if (std::fabs(psi) > 1.0)
    throw std::invalid_argument("potential is '" + std::string(word) + "'; it must be from -1 to 1 (V)");
  return psi;
}

/* ---------------------------------------------------------------------- */

void PairDlvoClump::init_style()
{
  check();
  if (!atom->radius_flag) refuse("atoms have no radii; it needs them");
  bool any = false;
  for (int t = 1; t <= atom->ntypes; t++) any = any || takes_part(t);
  law_.cutoff = law_.gap + 2.0 * largest_radius();
  start(any);
}

/* ---------------------------------------------------------------------- */

double PairDlvoClump::effective(int type) const { return clay::effectivePotential(value_[type], temperature_); }

double PairDlvoClump::strength(int i) const { return effective(atom->type[i]); }

double PairDlvoClump::of_two(double yy, double ri, double rj, double r, double &f) const
{
  const double R = ri * rj / (ri + rj), h = r - ri - rj;
  f = law_.force(yy, R, h) / r;
  return law_.energy(yy, R, h);
}

double PairDlvoClump::between(int a, int b, double r, double &f) const
{
  return of_two(groups_.q[a] * groups_.q[b], groups_.radius[a], groups_.radius[b], r, f);
}

double PairDlvoClump::single(int i, int j, int itype, int jtype, double rsq, double, double, double &fforce)
{
  fforce = 0.0;
  if (one_body(i, j) || !takes_part(itype) || !takes_part(jtype)) return 0.0;
  return of_two(effective(itype) * effective(jtype), atom->radius[i], atom->radius[j], sqrt(rsq), fforce);
}

/* ---------------------------------------------------------------------- */

void PairDlvoClump::write_restart_settings(FILE *fp)
{
  const double kept[9] = {law_.gap,  law_.debye,   law_.hamaker,   law_.contact,     law_.retardation,
                          relative_, temperature_, double(every_), hold_ ? 1.0 : 0.0};
  fwrite(kept, sizeof(double), 9, fp);
}

void PairDlvoClump::read_restart_settings(FILE *fp, const int, const int)
{
  double kept[9];
  read_numbers(fp, kept, 9);
  law_ = clay::DlvoLaw();
  law_.gap = kept[0];
  law_.debye = kept[1];
  law_.hamaker = kept[2];
  law_.contact = kept[3];
  law_.retardation = kept[4];
  relative_ = kept[5];
  temperature_ = kept[6];
  every_ = static_cast<int>(kept[7]);
  hold_ = kept[8] != 0.0;
  law_.permittivity = vacuum * relative_;
}
