/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   pair_style coul/clump cutoff [sharp|shifted] [permittivity eps_r]
                         [screened lambda [spheres|points]]
                         [every N [impulse|hold]] [double|single]
   Coulomb forces between the charged spheres of different bodies.
------------------------------------------------------------------------- */

#ifdef PAIR_CLASS

PairStyle(coul/clump,PairCoulClump)

#else

#ifndef LMP_PAIR_COUL_CLUMP_H
#define LMP_PAIR_COUL_CLUMP_H

#include "coulomb/pair_clump.h"

namespace LAMMPS_NS {

class PairCoulClump : public PairClump {
 public:
  PairCoulClump(class LAMMPS *);

  void init_style();
  double single(int, int, int, int, double, double, double, double &);

  void write_restart_settings(FILE *);
  void read_restart_settings(FILE *, const int, const int);

  double cutoff() const { return law_.cutoff; }
  const clay::CoulombLaw &law() const { return law_; }
  /// Charge of a sphere of an atom type [C].
  double charge(int type) const { return value_[type]; }

 protected:
  void parse(int, char **);
  double strength(int i) const;
  bool takes_part(int type) const { return value_[type] != 0.0; }
  void evaluate() { groups_.act(law_); }
  double between(int a, int b, double r, double &f) const;

 private:
  clay::CoulombLaw law_;
  double permittivity_;
};

}

#endif
#endif
