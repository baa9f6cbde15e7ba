// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coulomb/dlvo_law.h"

#include <algorithm>

namespace clay {

double DlvoLaw::force(double yy, double R, double h) const
{
  if (h >= gap) return 0;
  h = std::max(h, contact);
  const double late = retardation > 0 ? 1 + gregory * h / retardation : 1;
  return R * (repulsion(yy) * std::exp(-h / debye) - hamaker / (6 * h * h * late));
}

double DlvoLaw::uncut(double yy, double R, double h) const
{
  const double late = retardation > 0 ? gregory / retardation * std::log1p(retardation / (gregory * h)) : 0;
  return R * (repulsion(yy) * debye * std::exp(-h / debye) - hamaker / 6 * (1 / h - late));
}

double DlvoLaw::energy(double yy, double R, double h) const
{
  if (h >= gap) return 0;
  const double outside = std::max(h, contact);
  return uncut(yy, R, outside) - uncut(yy, R, gap) + force(yy, R, contact) * (outside - h);
}

double effectivePotential(double psi, double temperature)
{
  const double thermal = 1.380649e-23 * temperature / 1.602176634e-19;
  return 4 * thermal * std::tanh(psi / (4 * thermal));
}

}  // namespace clay
