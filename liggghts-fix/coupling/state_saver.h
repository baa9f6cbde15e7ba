// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file state_saver.h
/// When this half's state is saved for a pair of both halves, and how.
#ifndef LMP_STATE_SAVER_H
#define LMP_STATE_SAVER_H

#include <string>

#include "coupling/couple_settings.h"
#include "exchange/saved_pair.h"
#include "pointers.h"

namespace LAMMPS_NS {

class StateSaver : protected Pointers {
 public:
  StateSaver(class LAMMPS *lmp, const clay::CoupleSettings &settings);

  /// Folder of the pairs, from the root of the file system.
  const std::string &folder() const { return folder_; }

  /// Wall time counts from now.
  void start();

  /// Is a state to be saved at this exchange; the same on all processors. Collective.
  bool due();

  /// Writes a restart file of LIGGGHTS for a new pair; number 0 when that failed,
  /// which is said in why(). Collective.
  clay::SavedPair write();

  /// Why the last one was not written; empty when it was.
  const std::string &why() const { return why_; }

  /// Whether the other half has finished the last one: it stands in its place then. Collective.
  void look_for_it();

  /// "; the last saved state is that of step N" for the last words of a run, empty for none.
  std::string last_words() const;

  /// The pair that is being written, 0 for none; for the restart file.
  double number() const { return pair_.number; }

 private:
  void write_file(const std::string &part);
  void check_end(const std::string &file, int atoms) const;

  std::string folder_, why_;
  const double seconds_;
  const int steps_;
  double last_;                       // wall time of the last one [s]
  bigint written_ = -1, saved_ = -1;  // steps of what this half has written, and of what stands
  clay::SavedPair pair_;
};

}  // namespace LAMMPS_NS

#endif
