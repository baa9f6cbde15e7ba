// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file coupled_clumps.h
/// The clumps of a coupled run whose drag is that of the body as a whole.
#ifndef LMP_COUPLED_CLUMPS_H
#define LMP_COUPLED_CLUMPS_H

#include <memory>
#include <string>
#include <vector>

#include "clumps/body_resistance.h"
#include "coupling/told_drag.h"
#include "pointers.h"

namespace LAMMPS_NS {

class FixMultisphereClump;
class FixTemplateMultisphere;

/// Tells the CFD half what drag to reckon with for each body, and makes of its
/// answer the resistance that the body moves in.
class CoupledClumps : protected Pointers {
 public:
  CoupledClumps(class LAMMPS *lmp, clay::ShapeLaw law) : Pointers(lmp), law_(law) {}

  /// Finds the resistance of every template that is new and hands it to the bodies.
  /// What is to be warned of, on the first processor.
  std::vector<std::string> init(FixMultisphereClump *bodies);

  /// Viscosity [Pa s] and density [kg/m3] of the fluid.
  void fluid(double viscosity, double density)
  {
    mu_ = viscosity;
    rho_ = density;
  }

  /// Works out what to tell of this rank's bodies.
  void prepare();
  double diameter(int ibody) const;                               ///< [m], for the drag law
  double factor(int ibody) const { return told_[ibody].factor; }  ///< by it and the body's volume

  /// Takes in what a body's spheres were answered.
  void set_flow(int ibody, const BodyFlow &flow);

 private:
  const clay::ClumpDrag &drag(int ibody) const;
  std::string add(FixTemplateMultisphere *t);

  clay::ShapeLaw law_;
  FixMultisphereClump *bodies_ = nullptr;
  std::vector<std::unique_ptr<clay::ClumpDrag>> drags_;  // by clump type
  double mu_ = 1, rho_ = 1;
  std::vector<clay::ToldDrag> told_;  // of each body
};

}  // namespace LAMMPS_NS

#endif
