// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file lubrication_law.h
/// Resistance of the thin film between two spheres, or a sphere and a wall.
#ifndef LMP_LUBRICATION_LAW_H
#define LMP_LUBRICATION_LAW_H

namespace clay {

/// A film's resistance to the three motions that shear or squeeze it. With n the unit
/// vector from j to i and t standing for the part across n:
///   squeeze: force on i -squeeze (vi - vj).n n
///   shear:   force on i -shear u, u = (vi - vj - (armI wi + armJ wj) x n)_t, applied
///            at the arms' ends, -armI n from i and armJ n from j
///   roll:    couple on i -roll (wi - wj)_t, the opposite on j
/// None of them sees a rigid motion of the pair, and each takes energy.
struct Film {
  double squeeze = 0;         ///< [kg/s]
  double shear = 0;           ///< [kg/s]
  double roll = 0;            ///< [kg m2/s]
  double armI = 0, armJ = 0;  ///< [m]
  bool acts() const { return squeeze > 0 || shear > 0 || roll > 0; }
};

/// Lubrication of Stokes flow: the terms in 1/xi and ln(1/xi) for the gap xi, which is
/// that of the surfaces over the mean radius, and over the sphere's own at a wall.
/// Spheres: Jeffrey and Onishi, J. Fluid Mech. 139 (1984) 261; Kim and Karrila,
/// Microhydrodynamics (1991), ch. 11. Wall: Cox and Brenner, Chem. Eng. Sci. 22 (1967)
/// 1753; Goldman, Cox and Brenner, Chem. Eng. Sci. 22 (1967) 637.
struct LubricationLaw {
  double viscosity = 0;   ///< of the fluid, dynamic [Pa s]
  double outer = 0.5;     ///< gap xi beyond which nothing acts
  double inner = 1e-3;    ///< gap xi below which the film resists as at it: roughness
  bool logarithm = true;  ///< the terms in ln(1/xi), besides 1/xi
  bool shear = true;      ///< shear and roll
  bool shifted = true;    ///< less their value at the outer gap
  bool contact = false;   ///< acts on where the surfaces overlap

  /// Between spheres of radii a and b [m], their surfaces h apart [m].
  Film spheres(double a, double b, double h) const;

  /// Between a sphere of radius a [m] and a wall h away [m], flat or a cylinder of
  /// radius R [m] with the sphere inside (R > 0) or outside (R < 0); 0 is flat. The
  /// cylinder's curvature is in the term in 1/xi alone.
  Film wall(double a, double h, double R = 0) const;

 private:
  bool terms(double xi, double &inverse, double &log) const;
};

}  // namespace clay

#endif
