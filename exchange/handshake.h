// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file handshake.h
/// The steps with which a session starts; internal to exchange/.
#pragma once

#include <string>
#include <vector>

#include "exchange/terms.h"
#include "exchange/world.h"

namespace clay {

/// Both halves' terms, as every rank of both halves has them.
struct BothTerms {
  DemTerms dem;
  CfdTerms cfd;
};

/// Exchanges the terms; throws Refusal on every rank when they do not fit. Of
/// the ranks of a half, the first one's terms count. Both halves tell each other what
/// they make of the terms, so that both refuse them or none, and each then ends by itself.
BothTerms shakeHands(Half half, const std::string& myTerms);

/// The same for a further run, to which the DEM half brings new terms.
/// \param both  the terms that stood so far; those of the CFD half go on
void shakeHandsAgain(Half half, const std::string& demTerms, BothTerms& both);

/// CFD half: tells the DEM half every CFD rank's box.
void sendBoxes(const RankBoxes& mine, const Box& mesh);

/// DEM half: the boxes of the CFD ranks, in their order.
std::vector<RankBoxes> receiveBoxes(const Box& mesh);

/// Fields of the state and of the answer.
FieldSet stateFields(const BothTerms&);
FieldSet answerFields(const BothTerms&);

}  // namespace clay
