// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file moving_groups.h
/// What the script's fixes do to spheres, by the bits of their groups.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace clay {

/// A fix of the script.
struct FixEntry {
  std::string id, style;
  bool forces = true;  ///< acts in post_force
  int group = 1;       ///< bit of its group
  int sets = 0;        ///< bits of the axes along which it sets the force: setforce, lineforce, planeforce
  /// Why that cannot be told by group and axis; else empty.
  std::string odd;
};

/// Groups along x, y, z.
struct AxisGroups {
  std::array<int, 3> along{};

  /// Bits of the axes that a sphere of these groups has.
  int axes(int groups) const
  {
    int bits = 0;
    for (int k = 0; k < 3; k++)
      if (groups & along[k]) bits |= 1 << k;
    return bits;
  }
};

/// Which spheres follow the forces on them.
struct MovingGroups {
  int movers = 0;   ///< that some fix moves by their forces
  int holders = 0;  ///< whose forces come to nothing: fix freeze, fix move
  AxisGroups set;   ///< whose force is set along an axis, whatever the others are

  /// Bits of the axes along which a sphere does not follow the forces on it.
  int held(int groups) const { return (groups & movers) && !(groups & holders) ? set.axes(groups) : 7; }
  bool moves(int groups) const { return held(groups) != 7; }
};

/// Of a script's fixes. Styles nve... and multisphere... move, but those with
/// noforce or stationary in their names.
MovingGroups moving_groups(const std::vector<FixEntry> &fixes);

/// Groups that a fix above place `mine` of the script has taken the forces from: fix freeze,
/// or one that sets them.
AxisGroups frozen_above(const std::vector<FixEntry> &fixes, int mine);

}  // namespace clay
