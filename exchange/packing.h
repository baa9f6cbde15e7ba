// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file packing.h
/// Particles to and from the doubles of a message, field by field; internal to exchange/.
#pragma once

#include <vector>

#include "exchange/fields.h"

namespace clay {

/// Takes n particles of the set's fields out of a message, to the list's
/// particles from first on; returns where the message goes on.
const double* unpackFields(const double* from, const FieldSet& set, int n, Particles& list,
                           int first);

/// Fills a message with the answers to those of n particles from first on that
/// are owned: their places 0..n-1, then field by field, then `end` doubles of
/// room. The buffer keeps its memory.
void packAnswers(const Particles& answers, const std::vector<char>& owned, const FieldSet& set,
                 int first, int n, int end, std::vector<double>& message);

}  // namespace clay
