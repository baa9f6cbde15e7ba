// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file saved_pair.h
/// A pair of saved states in its folder: what the DEM half and what the CFD half
/// need to go on from one exchange. It is written beside its place and moved there
/// when both parts are whole, so that a pair is complete or does not exist.
///
///     FOLDER/000012500/dem/   state, sums
///                      cfd/   the fields, sums; processor0/ ... on several ranks
///
/// A file `sums` names the pair, and size and checksum (zlib's crc32) of each file
/// beside it.
#pragma once

#include <cstdint>
#include <string>

#include "exchange/session.h"

namespace clay {

/// Folder of a complete pair, and the one it is written to.
std::string pairFolder(const std::string& folder, const SavedPair& pair);
std::string unfinishedPair(const std::string& folder, const SavedPair& pair);

/// A number for a new pair, whole, above 0 and below 2^53.
double newPairNumber();

/// The same of 64 random bits.
double pairNumber(std::uint64_t random);

/// Makes an empty folder, and those it stands in; throws std::runtime_error with one line.
void makeEmpty(const std::string& folder);

/// Writes `sums` for all files of that folder and those in it; throws std::runtime_error.
void writeSums(const std::string& folder, const SavedPair& pair);

/// Compares a folder with its `sums`; empty when all is there and whole, else what is wrong.
std::string damage(const std::string& folder, const SavedPair& pair);

/// Moves a pair whose parts are whole to its place, and removes what is older than
/// the `kept` last pairs; throws std::runtime_error.
void completePair(const std::string& folder, const SavedPair& pair, int kept = 2);

/// Removes what was written of a pair; throws nothing.
void dropPair(const std::string& folder, const SavedPair& pair);

}  // namespace clay
