/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   The contact models of lean_model.h of pair_style gran, in a loop of its own.
   All else, from settings to restart, is gran's.
------------------------------------------------------------------------- */

#ifdef PAIR_CLASS

PairStyle(gran/lean,PairGranLean)

#else

#ifndef LMP_PAIR_GRAN_LEAN_H
#define LMP_PAIR_GRAN_LEAN_H

#include <string>
#include <vector>

#include "contacts/contact_kernel.h"
#include "contacts/lean_coefficients.h"
#include "contacts/lean_model.h"
#include "pair_gran_proxy.h"

namespace LAMMPS_NS {

class PairGranLean : public PairGranProxy {
 public:
  /// offered: as pair_style gran, which runs gran's own loop where this one cannot
  explicit PairGranLean(class LAMMPS *, bool offered = false);

  void settings(int, char **);
  void init_style();
  void init_granular();
  void compute_force(int eflag, int vflag, int addflag);
  double memory_usage();

  /// Puts the tangential displacements where gran and its fix contacthistory
  /// look for them, and makes the next force begin from there.
  void hand_back_history();

  /// Pairs that are looked at each step.
  int near_pairs() const { return pairs_.size(); }
  /// Whether the script wants this loop; of gran, by its word `lean`.
  clay::LeanUse use() const { return use_; }
  /// Number of times these pairs were sought since the start.
  bigint searches() const { return searches_; }

 private:
  [[noreturn]] void refuse(const std::string &why) const;
  std::string unfit() const;
  void say();
  void make_history();
  bool lean_step(int eflag, int vflag, int addflag) const;
  bool pairs_hold();
  void seek_pairs();
  const clay::ContactLaw &law(int i, int j);

  bool offered_;
  clay::LeanUse use_;
  std::string odd_;    // what of the settings this loop cannot do
  std::string unfit_;  // why gran's own loop runs, empty when it need not
  std::string said_;

  clay::LeanModel model_;
  LeanCoefficients coefficients_;
  bool flags_read_;  // somebody reads from the lists which pairs touch

  // the last law, and of which types, radii and mass
  clay::ContactLaw law_;
  int law_types_[2];
  double law_sizes_[3];

  clay::ContactPairs pairs_;
  std::vector<double *> kept_;                            // where gran keeps each pair's displacement
  std::vector<int *> flag_;                               // and that it has touched
  std::vector<double> seen_x_, seen_radius_, seen_mass_;  // of all atoms at the last search
  double margin_;                                         // gap up to which pairs were taken [m]
  bool sought_;                                           // the pairs are those of the present list
  bigint built_;                                          // time step of the list they are of
  int inum_;                                              // and its size
  bigint searches_;
};

}

#endif
#endif
