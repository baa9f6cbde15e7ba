// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file decode.h
/// What comes in is looked at here before it is used: every length, count, index
/// and number of a message. Knows nothing of MPI; internal to exchange/.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "exchange/fields.h"
#include "exchange/wire.h"

namespace clay::wire {

/// A message that is not what it must be; the text says what and why.
class Damaged : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A figure of n doubles, a whole number below 2^53, that goes with them: another
/// one shows that they did not come as they went.
double seal(const double* values, std::size_t n);

/// The same of a text.
std::uint64_t digest(const std::string& text);

/// Fills in a header's own seal.
void sealHeader(Header&);

/// What a CFD rank knows of the run before the next header comes.
struct Known {
  long exchange = 0;  ///< number of the next exchange
  double time = 0;    ///< of the last state, or the start [s]
  double end = 0;     ///< of this run [s]
  double step = 0;    ///< of the DEM half [s]
  bool over = false;  ///< the last state was this run's last
  int width = 0;      ///< doubles a particle has in a state
};

/// Throws Damaged unless the header can stand where it came.
void checkHeader(const Header&, const Known&);

/// Throws Damaged unless two DEM ranks announce the same.
void checkAlike(const Header& first, const Header& other);

/// Throws Damaged unless a message of that many doubles is the announced state: its
/// length, its seal, and its list of sharers, of which `me` of `ranks` is one.
void checkState(const double* state, std::ptrdiff_t doubles, const Header&, int width, int me,
                int ranks);

/// An answer's parts, in its message.
struct AnswerParts {
  std::size_t count = 0;           ///< particles answered
  const double* place = nullptr;   ///< of each in the list that was sent, ascending
  const double* fields = nullptr;  ///< field by field
  double reported = 0;
  bool late = false;
};

/// \param sent      particles that this rank got
/// \param width     doubles a particle has in the answer
/// \throws Damaged  when it is no answer to these
AnswerParts readAnswer(const double* message, std::ptrdiff_t doubles, std::size_t sent, int width,
                       long exchange);

/// Closes an answer's message, whose last answerEnd doubles are free.
void endAnswer(std::vector<double>& message, double reported, bool late, long exchange);

/// A message that asks for the run's end, because of that signal.
std::array<double, stopDoubles> stopMessage(int signal, long exchanges);

/// The signal of such a message.
/// \throws Damaged  when it is none, or of more exchanges than there were
int readStop(const double* message, std::ptrdiff_t doubles, long exchanges);

/// Values of particles that ranks share, with their seal behind them.
/// \throws Damaged  when these are not n values and their seal
void checkShared(const double* message, std::ptrdiff_t doubles, std::size_t n);

/// The boxes of CFD ranks as bytes, and back.
/// \param mesh      bounds of the whole mesh, in which each rank's first box lies
/// \throws Damaged  when they are not those of so many ranks, or a box is inverted or no number
std::string encodeBoxes(const std::vector<RankBoxes>&);
std::vector<RankBoxes> decodeBoxes(const std::string& bytes, std::size_t ranks, const Box& mesh);

/// What a half makes of both halves' terms.
struct Verdict {
  std::uint64_t dem = 0, cfd = 0;  ///< digests of the terms that it has
  std::string line;                ///< why it refuses them, or empty
};
std::string encode(const Verdict&);
/// \throws Damaged  when it is none
Verdict decodeVerdict(const std::string&);

}  // namespace clay::wire
