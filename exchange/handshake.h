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
/// the ranks of a half, the first one's terms count.
BothTerms shakeHands(Half half, const std::string& myTerms);

/// Throws Refusal when the terms do not fit. Both halves come to the same
/// verdict, so that afterwards each of them ends by itself.
void agree(const DemTerms&, const CfdTerms&);

/// CFD half: tells the DEM half every CFD rank's box.
void sendBoxes(const RankBoxes& mine);

/// DEM half: the boxes of the CFD ranks, in their order.
std::vector<RankBoxes> receiveBoxes();

/// The first rank's text on every rank of this half.
std::string shareText(const std::string& text);

/// A text of the other half's first rank to every rank of this half. The other
/// half sends it with sendText() to World::remoteRanks()[0].
std::string receiveFromOtherHalf(int tag, const char* forWhat);

/// Fields of the state and of the answer.
FieldSet stateFields(const BothTerms&);
FieldSet answerFields(const BothTerms&);

}  // namespace clay
