/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   Fix contacthistory of pair_style gran/lean, which makes it; in restart
   files the two are one.
------------------------------------------------------------------------- */

#ifdef FIX_CLASS

FixStyle(contacthistory/lean,FixContactHistoryLean)

#else

#ifndef LMP_FIX_CONTACT_HISTORY_LEAN_H
#define LMP_FIX_CONTACT_HISTORY_LEAN_H

#include "fix_contact_history.h"

namespace LAMMPS_NS {

class FixContactHistoryLean : public FixContactHistory {
 public:
  FixContactHistoryLean(class LAMMPS *, int, char **);

  void init();
  void pre_exchange();

  /// The pair style whose contacts these are.
  void serve(class PairGranLean *pair) { lean_ = pair; }

 private:
  class PairGranLean *lean_;
};

}

#endif
#endif
