// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file dlvo_law.h
/// Double layers and van der Waals forces between two spheres, after Derjaguin.
#pragma once

#include <cmath>

namespace clay {

/// With h the gap between the surfaces and R = R1 R2/(R1 + R2):
///   double layers   F = 4 pi eps Y1 Y2 R exp(-h/L)/L, Y = (4 kT/e) tanh(e psi/(4 kT)),
///   van der Waals   F = -A R/(6 h2) / (1 + 5.32 h/retardation).
/// Below the contact distance the force stays as it is there. Beyond `gap` nothing acts, and
/// energies are counted from there.
struct DlvoLaw {
  static constexpr double gregory = 5.32;

  double permittivity = 0;  ///< absolute [F/m]
  double debye = 0;         ///< Debye length L [m]
  double hamaker = 0;       ///< A [J]
  double retardation = 0;   ///< characteristic wave length [m]; 0: not retarded
  double contact = 0;       ///< [m]
  double gap = 0;           ///< largest [m]
  double cutoff = 0;        ///< of centres, for the largest spheres [m]

  /// Force of the double layers over R at no gap [N/m], of two effective potentials' product [V2].
  double repulsion(double yy) const { return 4 * M_PI * permittivity * yy / debye; }

  /// Force [N], away from each other, of two spheres of R, h apart.
  double force(double yy, double R, double h) const;
  /// Their energy [J].
  double energy(double yy, double R, double h) const;

 private:
  double uncut(double yy, double R, double h) const;
};

/// Effective potential Y [V] of a surface's potential [V] at a temperature [K], 1:1 salt.
double effectivePotential(double psi, double temperature);

}  // namespace clay
