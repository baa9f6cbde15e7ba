// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file session.h
/// One coupled run from handshake to close, seen from either half.
///
/// Exchange k, at time t_k: the DEM half sends a state (send), the CFD half
/// takes it in (next), maps it and answers (answer); the DEM half picks the
/// answer up when it needs it (receive) and marches to t_k+1, while the CFD
/// half solves the same interval. Waiting is done with back-off. A wait ends
/// at once, by abandon(), when the other half has failed or gone.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "exchange/fields.h"
#include "exchange/terms.h"
#include "exchange/world.h"

namespace clay {

/// Seconds this rank spent in the exchange.
struct Timing {
  double exchange = 0;   ///< packing, sending, receiving, unpacking
  double waiting = 0;    ///< idle, for the other half
  long exchanges = 0;    ///< states sent or taken in
  double bytesSent = 0;  ///< payload of this rank's messages
};

/// A pair of saved states, one of each half, of the same exchange.
struct SavedPair {
  double number = 0;  ///< what tells it from all others; 0: no pair
  double step = 0;    ///< the DEM half's step
};

/// The DEM half's side. Collective over the half, except where stated.
class DemSession {
 public:
  /// Shakes hands; throws Refusal on both halves when the terms do not fit.
  explicit DemSession(const DemTerms& mine);
  ~DemSession();

  const CfdTerms& remoteTerms() const;
  /// Fields the CFD half needs or this one brings: those and no others are sent.
  const FieldSet& sends() const;
  /// Fields of the answer.
  const FieldSet& receives() const;

  /// Sends this rank's particles, each to the CFD ranks whose box it touches;
  /// does not wait. The particles must stay untouched until receive().
  /// time [s] is this exchange's; last says that this is a run's last state;
  /// impulse [N s] is what the fluid has given to this rank's particles since
  /// the session began, summed by this half for the balance of momentum.
  /// With a pair, this half has saved its state as it is before this exchange, and
  /// the CFD half is to save its own.
  void send(const Particles& particles, double time, bool last,
            const std::array<double, 3>& impulse, const SavedPair& pair = SavedPair());

  /// True when the answer to the last send() has come in (local).
  bool answered();

  /// Waits for the answer and hands it over in the order of the sent particles.
  /// A particle that was found in no cell ends both halves, by abandon(), with
  /// its number and position.
  void receive(Particles& answer);

  /// Starts a further run after a state marked as last.
  void resume(const DemTerms& terms);

  /// Tells the other half that the coupled run is over.
  void close();

  /// The last figure that the CFD half has reported with an answer to this
  /// rank; 0 before the first.
  double reported() const;

  /// The signal because of which the CFD half asks for the run's end, 0 for none;
  /// known to the first rank (local). It may come at any time.
  int asked();

  /// Number of particles sent from this rank that the last answer found beyond an open side of
  /// the mesh: their answers are zeros.
  int away() const;
  /// True when the last answer was given after the fluid of its interval was solved,
  /// by what this rank has heard.
  bool late() const;

  const Timing& timing() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The CFD half's side.
class CfdSession {
 public:
  /// What next() brought.
  enum class Event { state, resumed, closed };

  /// mine.box is the whole mesh; boxes begin with this rank's part of it.
  CfdSession(const CfdTerms& mine, const RankBoxes& boxes);
  ~CfdSession();

  const DemTerms& remoteTerms() const;
  const FieldSet& receives() const;
  const FieldSet& sends() const;

  /// Waits for what the DEM half does next; a state fills the particles. A
  /// particle that touches several ranks' boxes comes to each of them.
  Event next(Particles& particles);

  /// Time of the last state [s], and whether it was marked as a run's last.
  double time() const;
  bool last() const;

  /// The pair that this half's state, as it was before the last state came in,
  /// is to be saved for.
  const SavedPair& pair() const;

  /// Time between the last state and the one before it, or the start [s].
  double interval() const;

  /// The DEM half's own sum of the impulse given to particles so far [N s],
  /// over its ranks (the same on every CFD rank).
  std::array<double, 3> impulse() const;

  /// Sums a value per particle over all ranks that hold the particle:
  /// values[stride*i + c]. Particles of this rank alone are left as they are.
  void sumShared(std::vector<double>& values, int stride);

  /// Of all ranks that hold a particle, the one with the smallest claim owns
  /// it (ties: the lowest rank); a claim above 1e299 is none. Returns 1 for
  /// particles owned here.
  std::vector<char> own(const std::vector<double>& claims);

  /// Answers the last state: the fields of sends() for every particle of this
  /// rank; only those owned here are sent.
  void answer(const Particles& answers, const std::vector<char>& owned);

  /// For the DEM half, goes with every answer from now on: the largest relative
  /// residual of momentum, and whether answers come after the fluid was solved.
  void report(double momentumResidual, bool late);

  /// Asks the DEM half to end the run in order at its next exchange, as if it had been
  /// sent that signal itself. The first rank's word counts, and the first one.
  void askStop(int signal);

  void close();

  const Timing& timing() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace clay
