// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/moving_groups.h"

namespace clay {

MovingGroups moving_groups(const std::vector<FixEntry> &fixes)
{
  MovingGroups found;
  for (const FixEntry &fix : fixes) {
    auto begins = [&](const char *with) { return fix.style.rfind(with, 0) == 0; };
    auto holds = [&](const char *word) { return fix.style.find(word) != std::string::npos; };
    if (fix.style == "freeze" || fix.style == "move") found.holders |= fix.group;
    else if ((begins("nve") && !holds("noforce") && !holds("stationary")) || begins("multisphere"))
      found.movers |= fix.group;
    for (int k = 0; k < 3; k++)
      if (fix.sets >> k & 1) found.set.along[k] |= fix.group;
  }
  return found;
}

AxisGroups frozen_above(const std::vector<FixEntry> &fixes, int mine)
{
  AxisGroups found;
  for (int i = 0; i < mine; i++) {
    const int axes = fixes[i].style == "freeze" ? 7 : fixes[i].sets;
    for (int k = 0; k < 3; k++)
      if (axes >> k & 1) found.along[k] |= fixes[i].group;
  }
  return found;
}

}  // namespace clay
