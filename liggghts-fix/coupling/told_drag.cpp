// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/told_drag.h"

namespace clay {

double clump_reynolds(const ClumpDrag &drag, const Eigen::Vector3d &slip, double rho, double mu)
{
  return rho * drag.diameter() * slip.norm() / mu;
}

ToldDrag told_drag(const ClumpDrag &drag, const Eigen::Vector3d &slip, double Re, double volume)
{
  ToldDrag told;
  told.growth = Re < 0 ? 1 : drag.growth(slip, Re);
  told.factor = drag.stokes(slip) * told.growth * drag.diameter() * drag.diameter() / (18 * volume);
  return told;
}

double answered_scale(const ClumpDrag &drag, const ToldDrag &told, double volume, double K, const Eigen::Vector3d &slip,
                      double Re)
{
  const double creeping = told.factor * 18 * volume / (drag.diameter() * drag.diameter()) / told.growth;
  return K / creeping / told.growth * drag.growth(slip, Re);
}

}  // namespace clay
