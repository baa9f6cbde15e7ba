// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file column_profile.h
/// What a column's particles do, by slices of its height: the sums that processors add up, and
/// the means that are read from them.
#pragma once

#include <array>
#include <vector>

namespace clay {

/// Sums in each slice. Stresses are means over a slice's height of the force that
/// crosses a horizontal plane: at every plane the forces between what is above it and what is
/// below, and those on what is above, make up the weight above, at rest.
class ColumnProfile {
 public:
  enum Sum {
    VOLUME,    ///< of solids [m3]
    FLUX,      ///< times their velocity upwards [m4/s]
    CONTACT,   ///< force upwards that contacts carry across [N]
    COULOMB,   ///< likewise charges, double layers, van der Waals forces
    WALL,      ///< force upwards of the walls on bodies above [N]
    FLUID,     ///< likewise of the fluid, without buoyancy
    WEIGHT,    ///< weight of the bodies above, less buoyancy [N]
    BODIES,    ///< whose centres are in the slice
    CONTACTS,  ///< bodies that they touch
    TOUCHING,  ///< bodies of the clusters in touch they are in
    BOUND,     ///< of the clusters in touch or bound
    AXES,      ///< bodies that have an axis
    XX,
    YY,
    ZZ,
    XY,
    XZ,
    YZ,  ///< products of their axes
    FACE_FACE,
    EDGE_FACE,
    EDGE_EDGE,  ///< contacts of two of these, by the middle of their centres
    SUMS
  };

  /// So many slices from height lo to hi [m].
  ColumnProfile(double lo, double hi, int slices);

  int slices() const { return slices_; }
  double thickness() const { return width_; }
  /// Middle of a slice above the lowest one's foot [m].
  double height(int slice) const { return (slice + 0.5) * width_; }
  void clear();

  /// A sphere of radius r [m] around height z that stands for a volume [m3] and rises at w [m/s].
  void addSphere(double z, double r, double volume, double w);
  /// A force [N] upwards on what is at height `upper` by what is at `lower`; the other way round if upper < lower.
  void addAcross(Sum sum, double lower, double upper, double force);
  /// A force [N] on a body at height z: it counts at all planes below.
  void addAbove(Sum sum, double z, double force);
  /// A number that goes with a body or pair at height z.
  void addAt(Sum sum, double z, double value);
  void addAxis(double z, const double *axis);

  double get(Sum sum, int slice) const { return sums_[slice * SUMS + sum]; }
  /// What processors add up.
  std::vector<double> &sums() { return sums_; }

  /// Largest part of the whole weight that contacts, charges, walls and fluid lack or have too
  /// much at any height; 0 without weight.
  double imbalance() const;

 private:
  int slice(double z) const;
  double &at(Sum sum, int slice) { return sums_[slice * SUMS + sum]; }
  // adds a force that acts between two heights
  void spread(Sum sum, double from, double to, double force);

  double lo_, width_;
  int slices_;
  std::vector<double> sums_;
};

/// How two bodies with axes touch: faces are where the line between the centres is within 45
/// degrees of the axis.
ColumnProfile::Sum meeting(const double *axis_i, const double *axis_j, const double *between);

/// The axis of a body with principal moments of inertia: that of the one that differs most from
/// the middle one; -1 when all are alike to 1 %.
int axisOf(const double *moments);

/// Sizes of clusters: numbers of members that links join, directly or not.
class Clusters {
 public:
  explicit Clusters(int members);
  void join(int a, int b);
  int size(int member) { return size_[root(member)]; }
  /// The member that stands for its cluster.
  int root(int member);

 private:
  std::vector<int> up_, size_;
};

}  // namespace clay
