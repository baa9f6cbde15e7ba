// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file clump_drag.h
/// Drag of one kind of clump as a whole, from creeping flow to finite Reynolds
/// number, for use in a coupled run.
#pragma once

#include <memory>
#include <string>

#include "resistance/shape_drag.h"
#include "resistance/stokes_resistance.h"

namespace clay {

/// How the drag of clumps is found.
enum class ClumpDragKind {
  sphereSum,  ///< each sphere's own drag, summed
  resistance  ///< the clump's Stokes resistance and a law for its shape
};

/// The kind of that name; throws std::invalid_argument, naming the known ones.
ClumpDragKind clumpDragKind(const std::string& name);
const char* name(ClumpDragKind);

/// One kind of clump, in its body axes about its centre of mass.
class ClumpDrag {
 public:
  /// R: the clump's Stokes resistance for unit viscosity.
  ClumpDrag(const Clump& clump, const Matrix6d& R, ShapeLaw law);

  /// Stokes resistance for unit viscosity, about the centre of mass.
  const Matrix6d& resistance() const { return R_; }
  /// Of the sphere of the same volume as the union of the spheres [m].
  double diameter() const { return shape_.diameter(); }
  double volume() const { return shape_.volume(); }  ///< of the union [m3]
  /// Resistance along a direction [m]; the mean over directions for none.
  double stokes(const Eigen::Vector3d& direction) const;
  /// Factor of the resistance at the Reynolds number of diameter().
  double growth(const Eigen::Vector3d& direction, double Re) const;

 private:
  Matrix6d R_;
  ShapeLaw law_;
  ClumpShape shape_;
};

/// stokesResistance about the origin, kept in a folder from one run to the next
/// when it took longer than `worth` [s] to compute; an empty folder keeps nothing.
/// A file that cannot be read or written does no harm. `from` says where the
/// numbers came from.
StokesResistance keptResistance(const Clump& clump, const std::string& folder, std::string& from, double worth = 1.0);

/// Where to keep results: what CLAYFOAM_CACHE names (none for nowhere), else
/// clayfoam in XDG_CACHE_HOME or in the home folder's .cache; empty for nowhere.
std::string cacheFolder();

}  // namespace clay
