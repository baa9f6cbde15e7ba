// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file fuzz_decode.cpp
/// libFuzzer's target: any bytes as any message of the wire. What is refused is thrown;
/// what is taken must be safe to use. The first byte chooses the message and whether its
/// seals are made to fit, which no change by chance would.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "exchange/decode.h"
#include "exchange/packing.h"
#include "exchange/terms.h"

namespace {

namespace wire = clay::wire;
using clay::Field;

void must(bool holds) {
  if (!holds) std::abort();
}

// The header's words, then the state's
void state(std::vector<double> words, bool sealed) {
  const clay::FieldSet fields{Field::position, Field::radius, Field::tag, Field::body};
  const int me = 1, ranks = 4;
  wire::Known known;
  known.exchange = 1;
  known.end = 1;
  known.step = 1e-3;
  known.width = fields.width();
  wire::Header h;
  if (words.size() < wire::Header::doubles) return;
  std::memcpy(&h, words.data(), sizeof h);
  const double* state = words.data() + wire::Header::doubles;
  const std::size_t n = words.size() - wire::Header::doubles;
  if (sealed) {
    h.stateSeal = n ? wire::seal(state, n) : 0;
    wire::sealHeader(h);
  }
  wire::checkHeader(h, known);
  wire::checkAlike(h, h);
  if (h.count == 0) return;
  wire::checkState(state, static_cast<std::ptrdiff_t>(n), h, known.width, me, ranks);
  clay::Particles list(fields);
  list.resize(static_cast<int>(h.count));
  clay::unpackFields(state, fields, list.size(), list, 0);
  const clay::Astray astray = clay::firstAstray(list);
  if (astray.particle >= 0) {
    must(!clay::describe(astray, list, list).empty());
    return;
  }
  for (int i = 0; i < list.size(); ++i) {
    const int tag = static_cast<int>(list[Field::tag][i]);
    must(tag >= 0 && std::fabs(list[Field::position][3 * i]) < 1e100);
  }
  // what SharedParticles::add() casts
  const double* at = state + n - static_cast<std::size_t>(h.shares);
  while (at < state + n) {
    must(static_cast<int>(*at++) < list.size());
    for (int k = static_cast<int>(*at++); k > 0; --k) must(static_cast<int>(*at++) < ranks);
  }
}

void answer(std::vector<double> words, bool sealed) {
  const std::size_t sent = 6;
  if (sealed && !words.empty()) words.back() = wire::seal(words.data(), words.size() - 1);
  const auto parts =
      wire::readAnswer(words.data(), static_cast<std::ptrdiff_t>(words.size()), sent, 2, 3);
  must(parts.count <= sent);
  for (std::size_t a = 0; a < parts.count; ++a) {
    must(static_cast<std::size_t>(parts.place[a]) < sent);
    must(parts.fields + 2 * a + 1 < words.data() + words.size());
  }
}

void boxes(std::string bytes, bool sealed) {
  if (sealed) {
    const std::uint64_t sum = wire::digest(bytes);
    bytes.append(reinterpret_cast<const char*>(&sum), sizeof sum);
  }
  clay::Box none;
  for (const auto& rank : wire::decodeBoxes(bytes, 2, none))
    for (const clay::Box& box : rank) must(!std::isnan(box.lo[0] + box.hi[2]));
}

void verdict(std::string text, bool sealed) {
  if (sealed && text.size() >= 16) {
    const wire::Verdict v{text.size(), 7, text};
    must(wire::decodeVerdict(wire::encode(v)).line == text);
  }
  wire::decodeVerdict(text);
}

void stop(std::vector<double> words, bool sealed) {
  if (sealed && !words.empty()) words.back() = wire::seal(words.data(), words.size() - 1);
  const int signal = wire::readStop(words.data(), static_cast<std::ptrdiff_t>(words.size()), 100);
  must(signal > 0 && signal <= 64);
}

void terms(const std::string& text) {
  const auto cut = text.find('\n');
  const auto dem = clay::decodeDem(text.substr(0, cut));
  const auto again = clay::decodeDem(clay::encode(dem));
  must(again.interval == dem.interval || dem.wire != clay::wireVersion);
  const auto cfd = clay::decodeCfd(cut == std::string::npos ? "" : text.substr(cut + 1));
  if (clay::disagreement(dem, cfd).empty()) must(std::isfinite(dem.endTime + cfd.startTime));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const bool sealed = data[0] & 8;
  const int kind = data[0] & 7;
  const std::string bytes(reinterpret_cast<const char*>(data + 1), size - 1);
  std::vector<double> words(bytes.size() / sizeof(double));
  if (!words.empty()) std::memcpy(words.data(), bytes.data(), words.size() * sizeof(double));
  try {
    if (kind == 0) state(std::move(words), sealed);
    if (kind == 1) answer(std::move(words), sealed);
    if (kind == 2) boxes(bytes, sealed);
    if (kind == 3) verdict(bytes, sealed);
    if (kind == 4) terms(bytes);
    if (kind == 6) stop(std::move(words), sealed);
    if (kind == 5 && !words.empty())
      wire::checkShared(words.data(), static_cast<std::ptrdiff_t>(words.size()), words.size() - 1);
  } catch (const wire::Damaged&) {
  } catch (const clay::Refusal&) {
  }
  return 0;
}

// Half of the changes put words into place that a sender might send: a state's header alone
// has ten that must fit together
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t*, std::size_t, std::size_t);
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
  if (seed % 2 || size < 17) return LLVMFuzzerMutate(data, size, most);
  const double likely[] = {0, 1, 2, 3, -1, 0.5, 1e-3, 4, 1e18, std::nan(""), 1e300, 6};
  const std::size_t word = seed / 2 % ((size - 1) / 8);
  std::memcpy(data + 1 + 8 * word, &likely[seed / 64 % 12], 8);
  return size;
}
