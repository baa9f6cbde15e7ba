// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file told_drag.h
/// What the CFD half is told of a clump's drag, and what its answer means.
#pragma once

#include "resistance/clump_drag.h"

namespace clay {

/// Reynolds number of the sphere of like volume, in a fluid of density rho [kg/m3]
/// and viscosity mu [Pa s].
double clump_reynolds(const ClumpDrag &drag, const Eigen::Vector3d &slip, double rho, double mu);

/// The CFD half makes of a sphere's volume V, the clump's diameter d and the factor c
/// K = c V 18 mu/d2 times the hindrance: over a clump that is to be its drag alone.
struct ToldDrag {
  double factor = 0;  ///< c
  double growth = 1;  ///< its part that is due to the Reynolds number
};

/// Of a clump of this volume [m3] by its slip u - v in body axes [m/s], as far as that
/// is known before the answer: a negative Re for creeping flow.
ToldDrag told_drag(const ClumpDrag &drag, const Eigen::Vector3d &slip, double Re, double volume);

/// Scale [Pa s] of the clump's resistance: the sum K [kg/s] of its spheres' answers
/// over what was told for creeping flow, which is viscosity times hindrance, with the
/// growth of the slip known now.
double answered_scale(const ClumpDrag &drag, const ToldDrag &told, double volume, double K, const Eigen::Vector3d &slip,
                      double Re);

}  // namespace clay
