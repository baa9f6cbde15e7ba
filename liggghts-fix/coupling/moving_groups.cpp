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
  }
  return found;
}

int frozen_above(const std::vector<FixEntry> &fixes, int mine)
{
  int groups = 0;
  for (int i = 0; i < mine; i++)
    if (fixes[i].style == "freeze") groups |= fixes[i].group;
  return groups;
}

}  // namespace clay
