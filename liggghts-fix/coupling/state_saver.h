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

  /// Step of the last one written here, below 0 for none.
  bigint saved() const { return saved_; }

  /// The pair that is being written, 0 for none; for the restart file.
  double number() const { return pair_.number; }

 private:
  void write_file(const std::string &part);
  void check_end(const std::string &file, int atoms) const;

  std::string folder_, why_;
  const double seconds_;
  const int steps_;
  double last_;  // wall time of the last one [s]
  bigint saved_ = -1;
  clay::SavedPair pair_;
};

}  // namespace LAMMPS_NS

#endif
