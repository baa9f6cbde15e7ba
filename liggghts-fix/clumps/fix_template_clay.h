/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   fix ID group particletemplate/clay shape seed S keyword value ...
   Clay plates of spheres with two atom types, and their exact volume,
   centre of mass and inertia in place of a Monte Carlo integration.
------------------------------------------------------------------------- */

#ifdef FIX_CLASS

FixStyle(particletemplate/clay,FixTemplateClay)

#else

#ifndef LMP_FIX_TEMPLATE_CLAY_H
#define LMP_FIX_TEMPLATE_CLAY_H

#include <vector>

#include "clumps/clay_settings.h"
#include "fix_template_multisphere.h"

namespace LAMMPS_NS {

class FixTemplateClay : public FixTemplateMultisphere {
 public:
  FixTemplateClay(class LAMMPS *, int, char **);

  void post_create();
  void init();

  void randomize_single();
  void init_ptilist(int, const bool enforce_single = false, FixPropertyAtom *const fix_release = NULL);

  /// The clump about its centre of mass, space axes of the template.
  const clay::Clump &clump() const { return settings_.clump; }
  /// Volume [m3], centre and inertia over density [m5] by the chosen counting.
  const clay::BodyGeometry &geometry() const { return geometry_; }
  /// Atom type of each sphere.
  const std::vector<int> &types() const { return settings_.types; }
  double density() const { return settings_.density; }
  double mass() const { return settings_.density * geometry_.volume; }

 protected:
  void print_info();

 private:
  // the mother class parses the command translated into her own keywords
  class Words;
  FixTemplateClay(class LAMMPS *, const ClaySettings &, char **);
  FixTemplateClay(class LAMMPS *, const ClaySettings &, Words &&);

  ClaySettings settings_;
  clay::BodyGeometry geometry_;
};

}

#endif
#endif
