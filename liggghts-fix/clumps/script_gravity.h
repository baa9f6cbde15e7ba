// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file script_gravity.h
/// The gravity of a script: all of its fixes gravity, whatever makes them change.
#ifndef LMP_SCRIPT_GRAVITY_H
#define LMP_SCRIPT_GRAVITY_H

#include <vector>

#include "clumps/group_gravity.h"
#include "pointers.h"

namespace LAMMPS_NS {

class FixGravity;

class ScriptGravity : protected Pointers {
 public:
  explicit ScriptGravity(class LAMMPS *lmp) : Pointers(lmp) {}

  /// Looks for them in the script, when a run is initialised.
  void find();

  /// Gives variables the value of this step, which fix gravity does when forces are
  /// computed: before that in a run. On all processors.
  void evaluate();

  bool any() const { return !fixes_.empty(); }

  /// True when one changes by a variable.
  bool changes() const;

  /// True when one changes, or acts on a group other than all and this one.
  bool differs(int group) const;

  /// As it is now.
  clay::GroupGravity now() const;

 private:
  std::vector<FixGravity *> fixes_;
};

}  // namespace LAMMPS_NS

#endif
