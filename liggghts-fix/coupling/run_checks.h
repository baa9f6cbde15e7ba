// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file run_checks.h
/// The largest stable DEM step of a LIGGGHTS run, from its contact model.
#ifndef LMP_RUN_CHECKS_H
#define LMP_RUN_CHECKS_H

#include <string>
#include <vector>

#include "contacts/contact_limit.h"
#include "coupling/moving_groups.h"
#include "contacts/granular_script.h"

namespace LAMMPS_NS {

class LAMMPS;

/// The granular pair style's normal model and its coefficients.
class ContactModel {
 public:
  explicit ContactModel(LAMMPS *lmp);

  /// False when the model is neither hooke nor hooke/stiffness.
  bool known() const { return known_; }

  /// Coefficients for two atom types, effective mass [kg] and radius [m].
  clay::ContactCoefficients between(int itype, int jtype, double mass, double radius) const;

 private:
  double global(const char *name, const char *kind, int i = 0, int j = 0) const;

  LAMMPS *lmp_;
  bool known_, stiffness_;
};

/// The script's fixes, in its order.
std::vector<clay::FixEntry> script_fixes(LAMMPS *lmp);

/// Which particles follow the forces on them.
clay::MovingGroups moving_groups(LAMMPS *lmp);

/// Largest stable step [s] for a clump of any clay template, or a free sphere
/// there is, that lies in the foot of a column with the like of itself on top;
/// infinite without particles or with another contact model. `which` says what
/// it is: "a clump 'ID'", "a sphere of type 1".
/// To be called after init, on all processors.
double resting_step_limit(LAMMPS *lmp, std::string *which = nullptr);

/// Rayleigh time [s] of the smallest and lightest spheres that move, clumps' and clay templates'
/// among them, each with the stiffest of the script's materials; infinite without particles or
/// where the contact model is neither hertz nor hertz/stiffness. `which` says whose it is. To be
/// called after init, on all processors.
double rayleigh_step(LAMMPS *lmp, std::string *which = nullptr);

/// Two types whose charges, or double layers and van der Waals forces, press their spheres into each other.
struct ChargedContact {
  double overlap = 0;    ///< at rest, over the diameter; infinite when nothing holds them
  double impact = 0;     ///< likewise of two that come from afar without drag
  double stiffness = 0;  ///< [N/m] of their contact
  double wanted = 0;     ///< [N/m] that would keep the impact below 0.1
  int first = 0, second = 0;
  std::string by = "the charges";  ///< what presses
};

/// The worst of all types under pair coul/clump and dlvo/clump, by the smallest spheres there
/// are of each; zeros without. On all processors.
ChargedContact charged_contact(LAMMPS *lmp);

/// Largest stable step [s] by the contacts there are now, and the number of
/// contacts of the body it is due to. Bodies whose cheap bound is no hindrance
/// are not looked at closer. Each processor looks at its own bodies and spheres, and
/// is sent what those of its bodies' spheres touch that others own. On all processors.
double present_step_limit(LAMMPS *lmp, int *contacts = nullptr);

}

#endif
