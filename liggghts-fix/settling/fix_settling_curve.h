/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   fix ID group settling/curve N file FILE keyword value ...
   Writes the settling curve while the run goes on.
------------------------------------------------------------------------- */

#ifdef FIX_CLASS

FixStyle(settling/curve,FixSettlingCurve)

#else

#ifndef LMP_FIX_SETTLING_CURVE_H
#define LMP_FIX_SETTLING_CURVE_H

#include <memory>
#include <string>

#include "fix.h"
#include "settling/settling_profile.h"

namespace LAMMPS_NS {

class FixSettlingCurve : public Fix {
 public:
  FixSettlingCurve(class LAMMPS *, int, char **);
  ~FixSettlingCurve();

  int setmask();
  void init();
  void setup(int);
  void end_of_step();
  double compute_vector(int);

 private:
  void parse(int narg, char **arg, bool &append);
  void stop(int i);
  void measure();
  void write_row();
  double largest_overlap() const;

  FILE *file_;
  std::string name_;
  double scale_, quantile_, bed_fraction_;
  double area_, bottom_;
  bool area_given_, bottom_given_;

  class FixMultisphere *multisphere_;
  std::unique_ptr<clay::SettlingProfile> profile_;
  double diameter_;
  bigint measured_, written_;
  double interface_, bed_, mean_, overlap_, volume_;
};

}

#endif
#endif
