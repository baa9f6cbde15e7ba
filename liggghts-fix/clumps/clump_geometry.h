// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file clump_geometry.h
/// Shapes of clumps, and the exact volume, centre of mass and inertia of a
/// union of overlapping spheres.
#pragma once

#include <Eigen/Dense>
#include <vector>

namespace clay {

/// A sphere of a clump.
struct ClumpSphere {
  Eigen::Vector3d x;     ///< centre [m]
  double r;              ///< radius [m]
  bool positive = true;  ///< carries the positive charge
};

using Clump = std::vector<ClumpSphere>;

/// Volume, centre and moments of a body of density one.
struct BodyGeometry {
  double volume = 0;                                  ///< [m3]
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();   ///< centre of mass [m]
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< about the centre [m5]
  std::vector<double> share;                          ///< fraction of the volume a sphere stands for
};

/// Each sphere counts in full, overlap or not.
BodyGeometry sumOfSpheres(const Clump&);

/// Overlaps count once; to about 1e-12 of the result. A sphere's share is the
/// part of the union that is nearer to it than to the others, by power
/// distance d2 - r2.
BodyGeometry unionOfSpheres(const Clump&);

/// Principal moments, ascending, and the axes as columns, right-handed.
struct PrincipalAxes {
  Eigen::Vector3d moments;
  Eigen::Matrix3d axes;
};
PrincipalAxes principalAxes(const Eigen::Matrix3d& inertia);

/// A ball that holds all the spheres; close to the smallest one.
ClumpSphere boundingBall(const Clump&);

/// Plates of hexagonal layers, seven spheres each, axis along z.
struct PlateShape {
  double radius = 0;        ///< of the spheres [m]
  double spacing = 0;       ///< of neighbours within a layer [m]
  double layerSpacing = 0;  ///< of the layers' planes [m]
  int layers = 2;
};

/// Faces of unlike charge: every other layer is positive, from the lowest.
Clump illitePlate(const PlateShape&);

/// Edge and faces alike, axis unlike: centre spheres positive, the rest negative.
Clump kaolinitePlate(const PlateShape&);

}  // namespace clay
