// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file stop_signals.h
/// Signals that ask a coupled run to end before its time. A handler only notes
/// them; the run looks at each exchange, where all its ranks can agree.
#pragma once

#include <string>

namespace clay {

/// From now on signals are the coupled run's to answer.
void listen_for_stops(bool listens);

/// What a handler does with a signal; safe within one. False when no coupled
/// run listens. The second one ends this process at once, with 128 + signal.
bool note_stop(int signal);

/// The signal that came, 0 for none.
int noted_stop();

/// No signal came (for tests).
void forget_stop();

/// "SIGTERM", or "signal 99".
std::string signal_name(int signal);

/// Why a run ended too early: the signal, below 0 one to the CFD half, or 0, and how far it was [s].
std::string stop_reason(int signal, double time, double end);

}  // namespace clay
