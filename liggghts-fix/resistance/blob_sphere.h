// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file blob_sphere.h
/// A sphere's surface as a shell of small blobs, and the Stokes resistance of
/// any rigid arrangement of blobs.
#pragma once

#include <Eigen/Dense>
#include <vector>

namespace clay {

using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// A small sphere that stands for a piece of a body's surface.
struct Blob {
  Eigen::Vector3d x;  ///< centre [m]
  double a;           ///< hydrodynamic radius [m]
};

/// Points on the unit sphere: corners of an icosahedron whose edges are cut
/// into `frequency` parts; 10 frequency^2 + 2 of them, nearly uniform.
std::vector<Eigen::Vector3d> icosphere(int frequency);

/// Shell of blobs that stands for a sphere of radius one.
struct BlobSphere {
  std::vector<Eigen::Vector3d> points;  ///< directions of the blobs
  double shell;                         ///< radius of the shell they sit on
  double blob;                          ///< their hydrodynamic radius
};

/// Both radii are such that the drag (6 pi mu a) and the torque (8 pi mu a^3)
/// of the sphere are exact. Computed once a frequency, 1 to 12.
const BlobSphere& blobSphere(int frequency);

/// Rotne-Prager-Yamakawa mobility of two blobs of radii a and b at distance d
/// [1/(Pa s m) times the viscosity], overlapping or not: Zuk, Wajnryb,
/// Mizerski, Szymczak, J. Fluid Mech. 741 (2014) R5.
Eigen::Matrix3d rotnePragerYamakawa(const Eigen::Vector3d& d, double a, double b);

/// Resistance of rigidly joined blobs about a point, for unit viscosity:
/// K^T M^-1 K with the blobs' mobility M and their rigid motion K. Forces in
/// rows 0-2 [m, m2], torques in rows 3-5 [m2, m3].
Matrix6d blobResistance(const std::vector<Blob>&, const Eigen::Vector3d& about);

}  // namespace clay
