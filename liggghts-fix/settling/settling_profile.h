// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file settling_profile.h
/// Solid volume over height, and what is read from it.
#pragma once

#include <vector>

namespace clay {

/// Share of a sphere's volume below its centre's height plus t radii.
double capShare(double t);

/// Solids in thin horizontal slices. Spheres are spread over the slices they
/// cross, by the volumes of their caps: the profile moves smoothly with them.
class SettlingProfile {
 public:
  /// Slices from height lo to hi [m], of about the given thickness [m].
  SettlingProfile(double lo, double hi, double thickness);

  void clear();

  /// A sphere of radius r [m] around height z that stands for a volume [m3].
  /// What lies outside lo to hi counts in the first or last slice.
  void add(double z, double r, double volume);

  /// Volumes of the slices and, last, the sum of volume times height: what
  /// processors add up.
  std::vector<double>& sums() { return sums_; }

  /// Volume of all solids [m3].
  double volume() const;

  /// Height below which a fraction q of the solids lies [m].
  double quantile(double q) const;

  /// Top of the solids [m]: the line through the heights of two quantiles,
  /// q - width and q, drawn on to all of the solids, and a radius [m] more for
  /// the upper halves of the topmost spheres. Of a uniform suspension this is
  /// its top; the part 1 - q that lies highest, strays, has no say.
  double interface(double q, double radius, double width = 0.1) const;

  /// Top of the bed [m]: where, from the bottom up, the solid fraction in
  /// slices of height window [m] first falls below a threshold. area [m2] is
  /// the column's cross-section. lo when there is no bed.
  double bed(double area, double threshold, double window) const;

  /// Mean height of the solid volume [m].
  double mean() const;

 private:
  int bins() const { return static_cast<int>(sums_.size()) - 1; }
  double below(double height) const;

  double lo_, width_, per_width_;
  std::vector<double> sums_;
  mutable std::vector<double> cumulated_;
};

}  // namespace clay
