/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   pair_style dlvo/clump gap debye L hamaker A contact H [retarded W]
                         [permittivity eps_r] [temperature T]
                         [every N [impulse|hold]]
   Double layers and van der Waals forces between the spheres of different
   bodies.
------------------------------------------------------------------------- */

#ifdef PAIR_CLASS

PairStyle(dlvo/clump,PairDlvoClump)

#else

#ifndef LMP_PAIR_DLVO_CLUMP_H
#define LMP_PAIR_DLVO_CLUMP_H

#include "coulomb/pair_clump.h"

namespace LAMMPS_NS {

class PairDlvoClump : public PairClump {
 public:
  PairDlvoClump(class LAMMPS *);

  void init_style();
  double single(int, int, int, int, double, double, double, double &);

  void write_restart_settings(FILE *);
  void read_restart_settings(FILE *, const int, const int);

  double cutoff() const { return law_.cutoff; }
  const clay::DlvoLaw &law() const { return law_; }
  /// Effective potential of the spheres of an atom type [V].
  double effective(int type) const;

 protected:
  void parse(int, char **);
  double value_of(const char *word) const;
  double strength(int i) const;
  bool takes_part(int type) const { return law_.hamaker > 0.0 || value_[type] != 0.0; }
  bool with_radii() const { return true; }
  void evaluate() { groups_.act(law_); }
  double between(int a, int b, double r, double &f) const;

 private:
  double of_two(double yy, double ri, double rj, double r, double &f) const;

  clay::DlvoLaw law_;
  double relative_, temperature_;
};

}

#endif
#endif
