// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file value_readers.h
/// Who in a script reads a fix's values of each atom: LIGGGHTS does not tell a fix.
#ifndef LMP_VALUE_READERS_H
#define LMP_VALUE_READERS_H

#include <string>
#include <vector>

namespace LAMMPS_NS {

class LAMMPS;

struct ValueReaders {
  bool any = false;     ///< somebody does
  bool within = false;  ///< perhaps in any step, not only where there is output

  /// Those of the fix of that ID: dumps, computes reduce and slice, fixes ave and
  /// store/state, variables, and what stands behind these. Where a style does not
  /// tell what it reads, it is taken to read it. To be called at the start of a run.
  static ValueReaders of(LAMMPS *lmp, const std::string &id);
};

}  // namespace LAMMPS_NS

#endif
