// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file wire.h
/// Tags and fixed messages of the exchange; internal to exchange/.
#pragma once

#include "exchange/fields.h"

namespace clay::wire {

/// Tags of messages over World::whole().
enum Tag : int {
  tagTerms = 7401,  ///< terms, root to root, then root to its half
  tagBoxes,         ///< boxes of the CFD ranks
  tagHeader,        ///< what a DEM rank does next, to every CFD rank
  tagState,         ///< particles
  tagAnswer,        ///< fields for particles, back
  tagShared,        ///< among CFD ranks: values of shared particles
  tagShutdown,      ///< this half ends before the coupled run does; why
  tagSpeaks,        ///< the first rank of this half says why it ends, for all
  tagSaved,         ///< this rank has saved its state, before it shuts down
  tagVerdict,       ///< what a half makes of the terms, root to root, then root to its half
  tagStop           ///< root to root: the CFD half was sent a signal and asks for the end
};

/// Doubles at the end of an answer: the reported figure, whether it came late, the
/// number of the exchange, the seal of all before it.
constexpr int answerEnd = 4;

/// Doubles of a message that asks for the end: the signal, the exchanges there were, the seal.
constexpr int stopDoubles = 3;

/// What a header announces.
enum class Kind : int { state = 1, resume = 2, close = 3 };

/// Sent by every DEM rank to every CFD rank ahead of anything else.
struct Header {
  double kind = 0;
  double exchange = 0;            ///< number of the exchange
  double time = 0;                ///< [s]
  double interval = 0;            ///< time since the last state [s]
  double last = 0;                ///< 1: a run's last state
  double count = 0;               ///< particles that follow
  double shares = 0;              ///< doubles of the list of sharers that follow
  double impulse[3] = {0, 0, 0};  ///< given to this rank's particles so far [N s]
  double pair = 0;                ///< number of the pair of states to be saved; 0: none
  double step = 0;                ///< its DEM step
  double stateSeal = 0;           ///< of the message that follows, 0 when none does
  double seal = 0;                ///< of this header's other doubles

  static constexpr int doubles = 14;
};
static_assert(sizeof(Header) == Header::doubles * sizeof(double), "no padding");

}  // namespace clay::wire
