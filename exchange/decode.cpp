// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/decode.h"

#include <cinttypes>
#include <climits>
#include <cmath>
#include <cstdio>
#include <cstring>

namespace clay::wire {

namespace {

constexpr std::uint64_t odd = 0x9e3779b97f4a7c15u;  // 2^64 over the golden ratio

std::uint64_t turned(std::uint64_t x) { return x << 31 | x >> 33; }

std::uint64_t stirred(std::uint64_t x) {
  x = (x ^ x >> 32) * odd;
  x = (x ^ x >> 29) * odd;
  return x ^ x >> 32;
}

std::string text(double x) {
  char s[32];
  std::snprintf(s, sizeof s, "%.10g", x);
  return s;
}

std::string text(std::ptrdiff_t n) { return std::to_string(n); }

// A whole number of that range, safe to be cast
double whole(double x, double least, double most, const char* what) {
  if (!(x >= least && x <= most) || x != std::floor(x))
    throw Damaged(std::string(what) + " is " + text(x) + "; it must be a whole number from " +
                  text(least) + " to " + text(most));
  return x;
}

void number(double x, const char* what) {
  if (!possible(x)) throw Damaged(std::string(what) + " is " + text(x));
}

[[noreturn]] void notAsSent(const char* what) {
  throw Damaged(std::string(what) + " did not come in as it was sent");
}

void checkSharers(const double* list, std::size_t length, int count, int me, int ranks) {
  int last = -1;
  for (const double* end = list + length; list < end;) {
    if (end - list < 4) throw Damaged("its list of sharers ends in the middle");
    last = static_cast<int>(whole(*list++, last + 1., count - 1., "a shared particle's place"));
    const int n = static_cast<int>(whole(*list++, 2, ranks, "a particle's number of sharers"));
    if (end - list < n) throw Damaged("its list of sharers ends in the middle");
    int before = -1;
    bool here = false;
    for (int k = 0; k < n; ++k) {
      before = static_cast<int>(whole(*list++, before + 1., ranks - 1., "a sharer's rank"));
      here = here || before == me;
    }
    if (!here) throw Damaged("a shared particle came to a rank that is none of its sharers");
  }
}

bool inside(const Box& box, const Box& mesh) {
  for (std::size_t k = 0; k < 3; ++k) {
    const double room = 1e-9 * (mesh.hi[k] - mesh.lo[k]);
    if (box.lo[k] < mesh.lo[k] - room || box.hi[k] > mesh.hi[k] + room) return false;
  }
  return true;
}

// One that holds nothing is as a Box begins
bool holdsNothing(const Box& box) { return box.lo == Box().lo && box.hi == Box().hi; }

void checkBox(const Box& box) {
  if (holdsNothing(box)) return;
  for (std::size_t k = 0; k < 3; ++k)
    if (!possible(box.lo[k]) || !possible(box.hi[k]) || box.lo[k] > box.hi[k])
      throw Damaged(std::string("a box reaches from ") + text(box.lo[k]) + " to " +
                    text(box.hi[k]) + " m along " + "xyz"[k]);
}

}  // namespace

double seal(const double* values, std::size_t n) {
  // four chains, so that no product waits for the one before
  std::uint64_t chain[4] = {n, n + 1, n + 2, n + 3};
  std::size_t i = 0;
  for (std::uint64_t bits[4]; i + 4 <= n; i += 4) {
    std::memcpy(bits, values + i, sizeof bits);
    for (int k = 0; k < 4; ++k) chain[k] = turned((chain[k] ^ bits[k]) * odd);
  }
  for (std::uint64_t bits; i < n; ++i) {
    std::memcpy(&bits, values + i, sizeof bits);
    chain[i % 4] = turned((chain[i % 4] ^ bits) * odd);
  }
  std::uint64_t all = 0;
  for (std::uint64_t c : chain) all = stirred(all ^ c);
  return static_cast<double>(all >> 11);
}

std::uint64_t digest(const std::string& text) {
  std::uint64_t all = text.size();
  for (const char c : text) all = turned((all ^ static_cast<unsigned char>(c)) * odd);
  return stirred(all);
}

void sealHeader(Header& h) { h.seal = seal(&h.kind, Header::doubles - 1); }

void checkHeader(const Header& h, const Known& known) {
  if (!(h.seal == seal(&h.kind, Header::doubles - 1))) notAsSent("the announcement");
  const auto kind = static_cast<Kind>(static_cast<int>(whole(h.kind, 1, 3, "its kind")));
  whole(h.exchange, 0, 1e15, "its exchange");
  if (h.exchange != static_cast<double>(known.exchange))
    throw Damaged("it is at exchange " + text(h.exchange) + ", not at " + text(known.exchange));
  number(h.time, "its time");
  whole(h.last, 0, 1, "the mark of a run's last state");
  whole(h.count, 0, INT_MAX, "its number of particles");
  whole(h.shares, 0, INT_MAX, "the length of its list of sharers");
  if (h.count * known.width + h.shares > INT_MAX)
    throw Damaged("its " + text(h.count) + " particles are too many for one message");
  if (h.count == 0 && (h.shares != 0 || h.stateSeal != 0))
    throw Damaged("it announces the sharers of no particles");
  for (double j : h.impulse) number(j, "its impulse");
  whole(h.pair, 0, largestPairNumber, "its number of a saved pair");
  whole(h.step, 0, 1e15, "the step of its saved pair");
  if (h.pair == 0 && h.step != 0) throw Damaged("it states the step of no saved pair");

  if (kind != Kind::state) {
    if (h.time != known.time || h.count != 0 || h.interval != 0 || h.pair != 0)
      throw Damaged("it ends a run and announces a state");
    if (kind == Kind::resume && !known.over)
      throw Damaged("it begins a further run before the last state of this one");
    return;
  }
  if (known.over) throw Damaged("it announces a state after the run's last");
  if (!(h.time >= known.time && h.interval == h.time - known.time))
    throw Damaged("its time is " + text(h.time) + " s, " + text(h.interval) +
                  " s after the last state, which was at " + text(known.time) + " s");
  if (h.time > known.end + known.step)
    throw Damaged("its time is " + text(h.time) + " s, beyond the run's end at " + text(known.end) +
                  " s");
  if (h.last == 0 && h.time > known.end - 0.5 * known.step)
    throw Damaged("its state at the run's end, " + text(known.end) + " s, is not the last");
}

void checkAlike(const Header& first, const Header& other) {
  if (other.kind != first.kind || other.time != first.time || other.last != first.last ||
      other.exchange != first.exchange || other.pair != first.pair || other.step != first.step)
    throw Damaged("it is not where the first rank is: kind " + text(other.kind) + ", exchange " +
                  text(other.exchange) + ", time " + text(other.time) + " s");
}

void checkState(const double* state, std::ptrdiff_t doubles, const Header& h, int width, int me,
                int ranks) {
  const auto particles = static_cast<std::size_t>(h.count) * static_cast<std::size_t>(width);
  const auto shares = static_cast<std::size_t>(h.shares);
  if (doubles < 0 || static_cast<std::size_t>(doubles) != particles + shares)
    throw Damaged("it holds " + text(doubles) + " doubles; " + std::to_string(particles + shares) +
                  " were announced");
  if (!(h.stateSeal == seal(state, particles + shares))) notAsSent("it");
  checkSharers(state + particles, shares, static_cast<int>(h.count), me, ranks);
}

AnswerParts readAnswer(const double* message, std::ptrdiff_t doubles, std::size_t sent, int width,
                       long exchange) {
  const std::ptrdiff_t each = 1 + width;
  if (doubles < answerEnd || (doubles - answerEnd) % each != 0)
    throw Damaged("it holds " + text(doubles) + " doubles, which is no number of answers");
  AnswerParts parts;
  parts.count = static_cast<std::size_t>((doubles - answerEnd) / each);
  if (parts.count > sent)
    throw Damaged("it answers " + std::to_string(parts.count) + " particles of " +
                  std::to_string(sent));
  const double* end = message + doubles - answerEnd;
  if (!(end[answerEnd - 1] == seal(message, static_cast<std::size_t>(doubles) - 1)))
    notAsSent("it");
  number(end[0], "its residual of momentum");
  parts.reported = end[0];
  parts.late = whole(end[1], 0, 1, "its mark of lateness") != 0;
  if (end[2] != static_cast<double>(exchange))
    throw Damaged("it is of exchange " + text(end[2]) + ", not of " + text(exchange));
  double last = -1;
  for (std::size_t a = 0; a < parts.count; ++a)
    last = whole(message[a], last + 1, static_cast<double>(sent) - 1, "an answer's place");
  parts.place = message;
  parts.fields = message + parts.count;
  return parts;
}

void endAnswer(std::vector<double>& message, double reported, bool late, long exchange) {
  double* end = message.data() + message.size() - answerEnd;
  end[0] = reported;
  end[1] = late;
  end[2] = static_cast<double>(exchange);
  end[3] = seal(message.data(), message.size() - 1);
}

std::array<double, stopDoubles> stopMessage(int signal, long exchanges) {
  std::array<double, stopDoubles> message{double(signal), static_cast<double>(exchanges), 0};
  message.back() = seal(message.data(), message.size() - 1);
  return message;
}

int readStop(const double* message, std::ptrdiff_t doubles, long exchanges) {
  if (doubles != stopDoubles)
    throw Damaged("it holds " + text(doubles) + " doubles of " + std::to_string(stopDoubles));
  if (!(message[2] == seal(message, 2))) notAsSent("it");
  whole(message[1], 0, static_cast<double>(exchanges), "its number of exchanges");
  return static_cast<int>(whole(message[0], 1, 64, "its signal"));
}

void checkShared(const double* message, std::ptrdiff_t doubles, std::size_t n) {
  if (doubles < 0 || static_cast<std::size_t>(doubles) != n + 1)
    throw Damaged("they are " + text(doubles) + " doubles; it must be " + std::to_string(n + 1));
  if (!(message[n] == seal(message, n))) throw Damaged("they did not come in as they were sent");
}

std::string encodeBoxes(const std::vector<RankBoxes>& all) {
  std::string bytes;
  const auto put = [&](const void* from, std::size_t n) {
    if (n) bytes.append(static_cast<const char*>(from), n);
  };
  for (const auto& boxes : all) {
    const std::uint64_t n = boxes.size();
    put(&n, sizeof n);
    put(boxes.data(), boxes.size() * sizeof(Box));
  }
  const std::uint64_t sum = digest(bytes);
  put(&sum, sizeof sum);
  return bytes;
}

std::vector<RankBoxes> decodeBoxes(const std::string& bytes, std::size_t ranks, const Box& mesh) {
  std::uint64_t sum = 0;
  const std::size_t size = bytes.size() < sizeof sum ? 0 : bytes.size() - sizeof sum;
  if (bytes.size() >= sizeof sum) std::memcpy(&sum, bytes.data() + size, sizeof sum);
  if (bytes.size() < sizeof sum || sum != digest(bytes.substr(0, size))) notAsSent("their list");
  std::vector<RankBoxes> all;
  for (std::size_t at = 0; at < size;) {
    std::uint64_t n = 0;
    if (size - at < sizeof n) throw Damaged("their list ends in the middle");
    std::memcpy(&n, bytes.data() + at, sizeof n);
    at += sizeof n;
    if (n == 0 || n > (size - at) / sizeof(Box))
      throw Damaged("a rank states " + std::to_string(n) + " boxes, " + std::to_string(size - at) +
                    " bytes are left for them");
    RankBoxes boxes(static_cast<std::size_t>(n));
    for (Box& box : boxes) {
      std::memcpy(box.lo.data(), bytes.data() + at, sizeof box.lo);
      std::memcpy(box.hi.data(), bytes.data() + at + sizeof box.lo, sizeof box.hi);
      at += sizeof(Box);
      checkBox(box);
    }
    if (!holdsNothing(mesh) && !holdsNothing(boxes[0]) && !inside(boxes[0], mesh))
      throw Damaged("a rank's part of the mesh lies outside of it");
    all.push_back(std::move(boxes));
  }
  if (all.size() != ranks)
    throw Damaged("they are those of " + std::to_string(all.size()) + " ranks, the CFD half has " +
                  std::to_string(ranks));
  return all;
}

std::string encode(const Verdict& v) {
  char sums[40];
  std::snprintf(sums, sizeof sums, "%016" PRIx64 "%016" PRIx64, v.dem, v.cfd);
  const std::string body = sums + v.line;
  char whole[20];
  std::snprintf(whole, sizeof whole, "%016" PRIx64, digest(body));
  return whole + body;
}

Verdict decodeVerdict(const std::string& text) {
  constexpr std::size_t digits = 16;
  std::uint64_t sums[3] = {0, 0, 0};
  if (text.size() < 3 * digits) throw Damaged("it is cut");
  for (std::size_t i = 0; i < 3 * digits; ++i) {
    const char c = text[i];
    if (!((c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'))) throw Damaged("it has no digests");
    sums[i / digits] =
        sums[i / digits] << 4 | static_cast<unsigned>(c <= '9' ? c - '0' : c - 'a' + 10);
  }
  if (sums[0] != digest(text.substr(digits))) notAsSent("it");
  return {sums[1], sums[2], text.substr(3 * digits)};
}

}  // namespace clay::wire
