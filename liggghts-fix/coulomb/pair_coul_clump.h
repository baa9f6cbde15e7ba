/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   pair_style coul/clump cutoff [sharp|shifted] [permittivity eps_r]
                         [screened lambda] [every N [impulse|hold]]
                         [double|single]
   Coulomb forces between the charged spheres of different bodies.
------------------------------------------------------------------------- */

#ifdef PAIR_CLASS

PairStyle(coul/clump,PairCoulClump)

#else

#ifndef LMP_PAIR_COUL_CLUMP_H
#define LMP_PAIR_COUL_CLUMP_H

#include <vector>

#include "coulomb/coul_kernel.h"
#include "pair.h"

namespace LAMMPS_NS {

class PairCoulClump : public Pair {
 public:
  PairCoulClump(class LAMMPS *);
  virtual ~PairCoulClump();

  void compute(int, int);
  void settings(int, char **);
  void coeff(int, char **);
  void init_style();
  double init_one(int, int);
  double single(int, int, int, int, double, double, double, double &);

  void write_restart(FILE *);
  void read_restart(FILE *, const int, const int);
  void write_restart_settings(FILE *);
  void read_restart_settings(FILE *, const int, const int);
  double memory_usage();

  double cutoff() const { return law_.cutoff; }
  const clay::CoulombLaw &law() const { return law_; }
  /// Charge of a sphere of an atom type [C].
  double charge(int type) const { return charge_[type]; }
  /// Whether a step has the force of several, and the others none.
  bool kicks() const { return every_ > 1 && !hold_; }
  /// Steps between two evaluations.
  int every() const { return every_; }
  /// Number of evaluations since the start.
  bigint evaluations() const { return evaluations_; }

 private:
  void parse(int, char **);
  void allocate();
  bool same_bodies() const;
  void lay_out();
  void gather(double ahead);
  void take_forces(double factor);
  void add_forces();
  void tally();

  // on all charges of a body that are this processor's, or on a loose sphere
  struct Held {
    int atom;
    double f[3], torque[3];
  };

  clay::CoulombLaw law_;
  double permittivity_;
  int every_;
  bool hold_;

  std::vector<double> charge_;  // by type
  std::vector<char> given_;     // charge was given
  bool charged_;                // any charge that is not zero
  bool centred_;                // held forces are those of the middle of their steps

  class FixMultisphere *multisphere_;
  clay::ChargeGroups groups_;
  std::vector<int> order_;  // atoms in the order of the groups
  std::vector<Held> held_;  // forces of the last evaluation
  bigint laid_out_;         // time step of the last lay_out()
  int nall_;                // atoms seen then
  bigint evaluated_;        // time step the held forces are of
  bigint evaluations_;
};

}

#endif
#endif
