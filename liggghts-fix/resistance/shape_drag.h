// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file shape_drag.h
/// Drag of bodies that are not spheres at finite Reynolds number, as the factor
/// f(Re) = C_D/C_D,Stokes by which it exceeds the body's own Stokes drag.
///
/// Re is that of the sphere of the same volume, rho_f d_ve |u - v|/mu, and C_D
/// refers to its cross-section. Each factor is 1 at Re = 0.
#pragma once

#include <string>
#include <vector>

#include "clumps/clump_geometry.h"

namespace clay {

/// Laws for the drag of bodies of any shape.
enum class ShapeLaw { holzerSommerfeld, ganser, tranCong };

/// The law of that name (holzerSommerfeld, ganser, tranCong); throws
/// std::invalid_argument, naming the known ones.
ShapeLaw shapeLaw(const std::string& name);

/// What the laws want to know of a body that moves in a given direction.
struct ShapeFactors {
  double sphericity = 1;     ///< surface of the sphere of the same volume / surface
  double crosswise = 1;      ///< cross-section of that sphere / area seen along the motion
  double lengthwise = 1;     ///< that / (half the surface - mean area seen from the sides)
  double circularity = 1;    ///< pi d_A / outline seen along the motion, d_A of like area
  double diameterRatio = 1;  ///< d_A / d_ve
  double stokes = 1;         ///< Stokes drag / that of the sphere of the same volume, K_ve
};

/// Hoelzer and Sommerfeld, Powder Technol. 184 (2008) 361; log is decimal.
double holzerSommerfeldDrag(double Re, double sphericity, double lengthwise, double crosswise);
double holzerSommerfeldFactor(double Re, double sphericity, double lengthwise, double crosswise);

/// Ganser, Powder Technol. 77 (1993) 143, Eq. (18), unbounded: K1 = 1/K_ve.
double ganserDrag(double Re, double K1, double K2);
double ganserFactor(double Re, double K1, double K2);
/// His Newton shape factor, Table 7.
double ganserK2(double sphericity);

/// Tran-Cong, Gay and Michaelides, Powder Technol. 139 (2004) 21, from
/// agglomerates of glued spheres; 0.15 < Re < 1500, 0.8 < d_A/d_ve < 1.5, 0.4 < c <= 1.
double tranCongDrag(double Re, double diameterRatio, double circularity);
double tranCongFactor(double Re, double diameterRatio, double circularity);

/// f(Re) of a law; Re of the sphere of the same volume.
double shapeDragFactor(ShapeLaw law, double Re, const ShapeFactors& shape);

/// Area and outline of a clump's shadow.
struct Shadow {
  double area = 0;       ///< [m2]
  double perimeter = 0;  ///< of its outer border, holes not counted [m]
};

/// Shadow along a direction, exact.
Shadow shadow(const Clump&, const Eigen::Vector3d& direction);

/// Surface of the union of the spheres [m2], to about 1e-5 of it.
double unionSurface(const Clump&);

/// Shape factors of a clump in all directions, tabulated once.
class ClumpShape {
 public:
  /// The volume is the union's unless it is given [m3].
  explicit ClumpShape(const Clump&, double volume = 0);

  double volume() const { return volume_; }      ///< [m3]
  double surface() const { return surface_; }    ///< [m2]
  double diameter() const { return diameter_; }  ///< d_ve [m]
  double sphericity() const { return sphericity_; }
  /// Largest relative error that the table makes in f(100), over 120 directions.
  double fitError() const { return fitError_; }

  /// For motion in a direction of the clump's axes; fast. stokes is left at 1.
  ShapeFactors factors(const Eigen::Vector3d& direction) const;
  /// The same without the table.
  ShapeFactors exactFactors(const Eigen::Vector3d& direction) const;

 private:
  /// A place in the table: four neighbouring nodes and their weights.
  struct Place {
    int node[4];
    double weight[4];
  };
  static Place place(const Eigen::Vector3d& direction);
  static Eigen::Vector3d nodeDirection(int node);
  double sideArea(const Eigen::Vector3d& direction) const;
  ShapeFactors assemble(double area, double side, double perimeter) const;

  Clump clump_;
  double volume_, surface_, diameter_, sphericity_, fitError_ = 0;
  std::vector<double> area_, perimeter_;  ///< at the nodes
  Eigen::Matrix<double, 6, 1> side_;      ///< quadratic form of the direction
};

}  // namespace clay
