// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file couple_settings.h
/// What the command of fix couple/foam says.
#pragma once

#include <string>
#include <vector>

#include "resistance/clump_drag.h"

namespace clay {

struct CoupleSettings {
  int interval = 0;          ///< DEM steps between two exchanges
  int lag = 0;               ///< steps of an interval that go on with the answer before
  std::string stats;         ///< file of the run's measures, empty for none
  double progress = 1.0;     ///< wall time between two progress lines, 0 for none [s]
  bool contactLimit = true;  ///< refuse a step above the contact limit
  bool watch = true;         ///< end a run that goes astray
  ClumpDragKind clumpDrag = ClumpDragKind::sphereSum;
  std::string shapeLaw;  ///< with clumpDrag resistance, else empty

  std::string checkpoint;        ///< folder of the pairs of saved states; empty: none are saved
  double checkpointEvery = 600;  ///< wall time between two of them [s]
  int checkpointSteps = 0;       ///< DEM steps between two of them instead, 0 for none

  /// Of the words behind the style's name; throws std::invalid_argument with one
  /// line that says what is wrong and what is possible.
  static CoupleSettings parse(const std::vector<std::string> &words);
};

}  // namespace clay
