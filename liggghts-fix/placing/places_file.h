// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file places_file.h
/// A list of particles with position and orientation, in plain text.
#pragma once

#include <string>
#include <vector>

namespace clay {

/// What may be placed: a name and how many words its orientation takes.
struct PlaceKind {
  std::string name;
  bool clump;  ///< a clump has an orientation, a sphere may have a radius
};

/// One particle of the list.
struct Place {
  int kind = 0;                ///< index of its kind
  double x[3] = {0, 0, 0};     ///< centre of mass [m]
  double q[4] = {1, 0, 0, 0};  ///< rotation as unit quaternion, scalar part first
  double radius = 0;           ///< of a sphere [m]; 0: that of its template
  int line = 0;                ///< where it stands in the file
};

/// Reads whole lines of such a file, of which the first has number `first`; throws
/// std::runtime_error with one line that names the file and the line when something
/// is wrong.
std::vector<Place> readPlaces(const std::string& text, const std::string& file, const std::vector<PlaceKind>& kinds,
                              int first = 1);

}  // namespace clay
