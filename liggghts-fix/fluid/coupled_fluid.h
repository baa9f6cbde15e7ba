// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file coupled_fluid.h
/// What other styles may ask of the fix that couples this run to a fluid. It
/// stands below both, so that neither needs the other.
#pragma once

#include <vector>

#include "fix.h"
#include "modify.h"

namespace LAMMPS_NS {

class CoupledFluid {
 public:
  virtual ~CoupledFluid() {}

  /// Viscosity of the fluid at the start of the run [Pa s]; 0 before the handshake.
  virtual double fluid_viscosity() const = 0;

  /// Drag coefficient of local atom i, as last answered [kg/s].
  virtual double drag_coefficient(int i) const = 0;

  /// All that the fluid did to particles along z in the last step [N]: to this processor's bodies,
  /// in fix multisphere's order, and to its atoms, 0 for those of bodies.
  virtual void vertical_forces(std::vector<double> &bodies, std::vector<double> &atoms) = 0;

  /// The one of this script, or null when nothing couples it to a fluid.
  static CoupledFluid *find(Modify *modify)
  {
    return dynamic_cast<CoupledFluid *>(modify->find_fix_style("couple/foam", 0));
  }
};

}
