/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   What pair styles have in common whose forces act between the spheres of
   different bodies over several of their sizes: coul/clump, dlvo/clump.
   A style of its own has its settings, its law and one value by atom type.
------------------------------------------------------------------------- */

#ifndef LMP_PAIR_CLUMP_H
#define LMP_PAIR_CLUMP_H

#include <functional>
#include <string>
#include <vector>

#include "coulomb/coul_kernel.h"
#include "pair.h"

namespace LAMMPS_NS {

class PairClump : public Pair {
 public:
  /// Of a style whose pair_coeff T T gives what is named, in words.
  PairClump(class LAMMPS *, const char *style, const char *value);
  virtual ~PairClump();

  void settings(int, char **);
  void coeff(int, char **);
  void write_restart(FILE *);
  void read_restart(FILE *, const int, const int);
  void compute(int, int);
  double init_one(int, int);
  double memory_usage();

  /// Distance of centres beyond which nothing acts [m].
  virtual double cutoff() const = 0;
  /// Whether a step has the force of several, and the others none.
  bool kicks() const { return every_ > 1 && !hold_; }
  /// Steps between two evaluations.
  int every() const { return every_; }
  /// Force f [N] on atom i, by j, and energy [J]; of two bodies their sums, with a sphere of each.
  /// share is 1, or 1/2 of what another processor, or an image, sees as well.
  typedef std::function<void(int i, int j, double share, const double *f, double energy)> PairVisit;
  /// Visits what acts on each other at present.
  void each_pair(const PairVisit &visit);
  /// Number of evaluations since the start.
  bigint evaluations() const { return evaluations_; }

 protected:
  /// Takes the settings; throws std::invalid_argument.
  virtual void parse(int, char **) = 0;
  /// The value that a word stands for; throws std::invalid_argument.
  virtual double value_of(const char *word) const;
  /// What atom i acts with, in the law's unit.
  virtual double strength(int i) const = 0;
  virtual bool takes_part(int type) const = 0;
  virtual bool with_radii() const { return false; }
  /// Sets the groups' forces.
  virtual void evaluate() = 0;
  /// Energy [J] of spheres a and b of the groups, r apart, and their force over r [N/m].
  virtual double between(int a, int b, double r, double &f) const = 0;

  /// `every N [impulse|hold]` from word i of the settings on; i is then at its last word.
  void parse_every(int narg, char **arg, int &i);
  /// Ends the run with words on this style.
  void refuse(const std::string &words) const;
  /// What every style needs of a run.
  void check();
  double largest_radius() const;
  double smallest_radius() const;
  /// Of a run; active: any sphere acts.
  void start(bool active);
  bool one_body(int i, int j) const;
  /// n numbers of a restart file, for all processors.
  void read_numbers(FILE *, double *to, int n);

  std::vector<double> value_;  // by type
  int every_;
  bool hold_;
  bool active_;
  class FixMultisphere *multisphere_;
  clay::ChargeGroups groups_;

 private:
  void allocate();
  bool same_bodies() const;
  void lay_out();
  void gather(double ahead);
  void take_forces(double factor);
  void add_forces();
  void tally();
  double share(int i, int j) const;

  // on all charges of a body that are this processor's, or on a loose sphere
  struct Held {
    int atom;
    double f[3], torque[3];
  };

  const std::string style_, what_;
  std::vector<char> given_;  // value was given, by type
  bool centred_;             // held forces are those of the middle of their steps
  std::vector<int> order_;   // atoms in the order of the groups
  std::vector<Held> held_;   // forces of the last evaluation
  bigint laid_out_;          // time step of the last lay_out()
  int nall_;                 // atoms seen then
  bigint evaluated_;         // time step the held forces are of
  bigint evaluations_;
};

}

#endif
