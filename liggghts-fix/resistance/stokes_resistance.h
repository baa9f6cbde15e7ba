// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file stokes_resistance.h
/// Stokes resistance of a rigid clump of touching or overlapping spheres.
#pragma once

#include <string>
#include <vector>

#include "resistance/blob_sphere.h"
#include "clumps/clump_geometry.h"

namespace clay {

/// How far the resistance is refined.
struct StokesOptions {
  double tolerance = 3e-3;  ///< largest relative change from one level to the next
  int maxUnknowns = 6000;   ///< of the dense solve; memory is 8 bytes times its square
  int maxFrequency = 8;     ///< of the largest sphere's blobs
  bool extrapolate = true;  ///< over the last two levels, second order in the blobs' spacing
};

/// One step of the refinement.
struct StokesLevel {
  int frequency = 0;  ///< of the largest sphere's blobs
  int blobs = 0;      ///< in all
  double change = 0;  ///< relative, from the level before, in the worst direction; 1 at first
};

/// Resistance for unit viscosity and its convergence.
struct StokesResistance {
  /// The fluid's wrench on the clump that moves with y = (v, omega) is -mu R y;
  /// forces in rows 0-2 [m, m2], torques in rows 3-5 [m2, m3].
  Matrix6d R = Matrix6d::Zero();
  std::vector<StokesLevel> levels;
  bool converged = false;

  /// One line: levels, blobs and changes.
  std::string report() const;
  /// Says that the refinement ended before its tolerance, and how far off it was; empty otherwise.
  std::string warning() const;
};

/// Resistance of the clump about a point, in the axes its spheres are given in.
/// Throws std::invalid_argument on a clump without spheres, with a radius that
/// is not positive, or too large for maxUnknowns. Kept in memory: the same
/// clump is computed once.
StokesResistance stokesResistance(const Clump&, const Eigen::Vector3d& about, const StokesOptions& = {});

/// The tensor in other axes; the columns of Q are the old axes in the new ones.
Matrix6d rotated(const Matrix6d& R, const Eigen::Matrix3d& Q);

/// The tensor about a point that is `shift` away from the present one.
Matrix6d movedTo(const Matrix6d& R, const Eigen::Vector3d& shift);

/// Drag along a direction without turning, over that of the sphere of the same
/// volume: K_ve = n.R n / (6 pi r_ve).
double volumeDragRatio(const Matrix6d& R, double volume, const Eigen::Vector3d& n);

/// Resistance 3/trace(mobility) of a body that is turned at random [m].
double meanResistance(const Matrix6d& R);

}  // namespace clay
