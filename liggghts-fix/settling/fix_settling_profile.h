/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   fix ID all settling/profile N file FILE keyword value ...
   Writes what the particles of a column do over its height, stresses among
   it, while the run goes on.
------------------------------------------------------------------------- */

#ifdef FIX_CLASS

FixStyle(settling/profile,FixSettlingProfile)

#else

#ifndef LMP_FIX_SETTLING_PROFILE_H
#define LMP_FIX_SETTLING_PROFILE_H

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "clumps/script_gravity.h"
#include "fix.h"
#include "settling/column_profile.h"

namespace LAMMPS_NS {

class FixSettlingProfile : public Fix {
 public:
  FixSettlingProfile(class LAMMPS *, int, char **);
  ~FixSettlingProfile();

  int setmask();
  void init();
  void setup(int);
  void end_of_step();
  double compute_vector(int);

  /// As last measured, on the first processor the sums of all.
  const clay::ColumnProfile &profile() const { return *profile_; }

 private:
  // a clump, or a sphere of none: sent as numbers
  struct Body {
    double key;  // a clump's tag, -1 less a sphere's
    double x[3], v[3], mass, axis[3];
    double has_axis;
  };
  // two bodies: whether they touch, and the energy of their charges [J]; who knows it
  struct Link {
    double first, second, touch, energy;
    int by;
  };

  void parse(int narg, char **arg, bool &append);
  void measure();
  void find_bodies();
  void share_bodies();
  void add_spheres();
  void add_loads();
  void add_contacts();
  void add_charges();
  void add_walls();
  void add_clusters();
  Body body_of(int i);
  double friction(int itype, int jtype) const;
  void link(const Body &a, const Body &b, double touch, double energy);
  std::vector<Link> pooled_links();
  std::vector<Body> asked_for(const std::vector<double> &keys);
  void write_rows();

  FILE *file_;
  std::string name_;
  int bins_;
  double area_, bottom_, fluid_density_;
  bool area_given_, bottom_given_;

  class FixMultisphere *multisphere_;
  class FixPropertyGlobal *friction_;
  std::unique_ptr<class PairListener> listener_;
  ScriptGravity gravity_;
  std::unique_ptr<clay::ColumnProfile> profile_;
  std::vector<Body> clumps_, loose_;  // this processor's
  std::vector<Body> seen_;            // clumps of which it has a sphere, ghosts too
  std::unordered_map<int, int> place_;
  std::vector<Body> named_;  // bodies whose keys name it
  std::unordered_map<long, int> named_place_;
  std::vector<Link> links_;
  bigint measured_, written_;
  double clusters_[2];  // largest, in touch and bound
};

}

#endif
#endif
