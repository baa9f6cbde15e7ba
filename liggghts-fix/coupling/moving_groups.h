// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file moving_groups.h
/// What the script's fixes do to spheres, by the bits of their groups.
#pragma once

#include <string>
#include <vector>

namespace clay {

/// A fix of the script.
struct FixEntry {
  std::string id, style;
  bool forces = true;  ///< acts in post_force
  int group = 1;       ///< bit of its group
};

/// Which spheres follow the forces on them.
struct MovingGroups {
  int movers = 0;   ///< that some fix moves by their forces
  int holders = 0;  ///< whose forces come to nothing: fix freeze, fix move

  bool moves(int groups) const { return (groups & movers) && !(groups & holders); }
};

/// Of a script's fixes. Styles nve... and multisphere... move, but those with
/// noforce or stationary in their names.
MovingGroups moving_groups(const std::vector<FixEntry> &fixes);

/// Groups that a fix freeze above place `mine` of the script has taken all forces from.
int frozen_above(const std::vector<FixEntry> &fixes, int mine);

}  // namespace clay
