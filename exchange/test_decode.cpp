// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file test_decode.cpp
/// Damaged messages, one by one: each word of each message in each way, with the seal it
/// was sent with (it changed on its way) and with one that fits (the sender itself is
/// wrong). None may be taken.
#include <gtest/gtest.h>

#include <climits>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "exchange/decode.h"
#include "exchange/packing.h"
#include "exchange/terms.h"
#include "exchange/test_halves.h"

using clay::Field;
using clay::wire::Damaged;
using clay::wire::Header;

namespace {

constexpr double noNumber = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();
constexpr int me = 1, ranks = 3, particles = 4;
const clay::FieldSet fields{Field::position, Field::radius,  Field::velocity, Field::tag,
                            Field::body,     Field::impulse, Field::touched};

/// What a DEM rank sends to CFD rank 1: four particles, two of them shared.
struct Sent {
  Header header;
  std::vector<double> state;
  clay::wire::Known known;

  Sent() {
    known.exchange = 5;
    known.time = 1e-3;
    known.end = 1;
    known.step = 1e-5;
    known.width = fields.width();
    const int n = particles;
    for (int k = 0; k < 3 * n; ++k) state.push_back(0.01 * k);                 // position
    for (int k = 0; k < n; ++k) state.push_back(0.02);                         // radius
    for (int k = 0; k < 3 * n; ++k) state.push_back(-0.1 * k);                 // velocity
    for (int k = 0; k < n; ++k) state.push_back(k + 1);                        // tag
    for (int k = 0; k < n; ++k) state.push_back(-1);                           // body
    for (int k = 0; k < 3 * n; ++k) state.push_back(1e-6 * k);                 // impulse
    for (int k = 0; k < n; ++k) state.push_back(k % 2);                        // touched
    for (double x : {0., 2., 0., 1., 3., 3., 0., 1., 2.}) state.push_back(x);  // sharers
    header.kind = static_cast<int>(clay::wire::Kind::state);
    header.exchange = 5;
    header.time = 1.2e-3;
    header.interval = header.time - known.time;
    header.count = n;
    header.shares = 9;
    header.impulse[2] = 1e-7;
    header.pair = 77;
    header.step = 120;
    header.stateSeal = clay::wire::seal(state.data(), state.size());
    clay::wire::sealHeader(header);
  }

  double* words() { return &header.kind; }

  /// As the CFD half does; throws Damaged.
  void take() const {
    clay::wire::checkHeader(header, known);
    if (header.count == 0) return;
    clay::wire::checkState(state.data(), static_cast<std::ptrdiff_t>(state.size()), header,
                           known.width, me, ranks);
    clay::Particles list(fields);
    list.resize(static_cast<int>(header.count));
    clay::unpackFields(state.data(), fields, list.size(), list, 0);
    const clay::Astray astray = clay::firstAstray(list);
    if (astray.particle >= 0) throw Damaged(clay::describe(astray, list, list));
  }
};

int damagedMessages = 0;

/// The message is refused, by one line.
void expectRefused(const std::function<void()>& take, const std::string& what) {
  ++damagedMessages;
  try {
    take();
    ADD_FAILURE() << "taken: " << what;
  } catch (const std::runtime_error& refusal) {  // Damaged, or a Refusal of terms
    const std::string line = refusal.what();
    EXPECT_FALSE(line.empty()) << what;
    EXPECT_EQ(line.find('\n'), std::string::npos) << what << ": " << line;
  }
}

std::string named(const char* message, std::size_t word, double x) {
  return std::string(message) + " word " + std::to_string(word) + " as " + std::to_string(x);
}

/// Ways to spoil a word, each another value than x.
std::vector<double> spoilt(double x) {
  std::vector<double> all;
  for (double y : {noNumber, inf, -inf, 1e300, 1e18, -1., -x, x + 1, x * (1 + 1e-15), 0.5, 0.})
    if (!(y == x)) all.push_back(y);
  return all;
}

}  // namespace

TEST(DamagedMessages, AreNoneWhenNothingIsDamaged) {
  EXPECT_NO_THROW(Sent().take());
  Sent none;
  none.header.count = none.header.shares = none.header.stateSeal = 0;
  clay::wire::sealHeader(none.header);
  EXPECT_NO_THROW(none.take());
}

TEST(DamagedMessages, OfAHeaderThatChangedOnItsWay) {
  for (std::size_t w = 0; w < Header::doubles; ++w)
    for (double x : spoilt(Sent().words()[w])) {
      Sent s;
      s.words()[w] = x;
      expectRefused([&] { s.take(); }, named("header", w, x));
    }
  EXPECT_GE(damagedMessages, 100);
}

TEST(DamagedMessages, OfAStateThatChangedOnItsWay) {
  const std::size_t n = Sent().state.size();
  for (std::size_t w = 0; w < n; ++w)
    for (double x : {noNumber, Sent().state[w] + 1e-9, -1 - Sent().state[w]}) {
      Sent s;
      if (x == s.state[w]) continue;
      s.state[w] = x;
      expectRefused([&] { s.take(); }, named("state", w, x));
    }
  for (std::size_t length = 0; length < n + 3; ++length) {
    Sent s;
    s.state.resize(length);
    if (length != n) expectRefused([&] { s.take(); }, "state of " + std::to_string(length));
  }
  // neither two words that changed places, nor two signs
  for (std::size_t w = 1; w + 9 < n; ++w) {
    Sent s, t;
    std::swap(s.state[w], s.state[w + 8]);
    if (s.state[w] != s.state[w + 8]) expectRefused([&] { s.take(); }, "swapped words");
    t.state[w] = -t.state[w];
    t.state[w + 4] = -t.state[w + 4];
    if (t.state[w] != 0 || t.state[w + 4] != 0) expectRefused([&] { t.take(); }, "two signs");
  }
}

// The seal fits: each number must be one that can stand there
TEST(DamagedMessages, OfADemRankThatIsWrong) {
  struct Wrong {
    std::size_t word;
    std::vector<double> values;
  };
  const double later = 1.4e-3;
  const Wrong header[] = {{0, {0, 4, 1.5, noNumber, -1, 1e18, inf, 2}},
                          {1, {0, 4, 6, noNumber, -1, 1e18, inf, 5.5}},
                          {2, {noNumber, inf, 1e300, 0, -1, later, 2}},
                          {3, {noNumber, inf, 1e300, -1e-5, 0, 1e-5}},
                          {4, {noNumber, 2, -1, 0.5, 1e18}},
                          {5, {noNumber, -1, 1e18, inf, 0.5, 3, 5, 0, 2147483648.}},
                          {6, {noNumber, -1, 1e18, inf, 0.5, 8, 10, 0, 2147483648.}},
                          {7, {noNumber, inf, 1e300}},
                          {8, {noNumber, -inf, -1e300}},
                          {9, {noNumber, inf, 1e100}},
                          {10, {noNumber, inf, -1, 0.5, 1e16, 0}},
                          {11, {noNumber, inf, -1, 0.5, 1e16}}};
  for (const auto& wrong : header)
    for (double x : wrong.values) {
      Sent s;
      s.words()[wrong.word] = x;
      clay::wire::sealHeader(s.header);
      expectRefused([&] { s.take(); }, named("sealed header", wrong.word, x));
    }

  const std::size_t n = particles, tags = 7 * n, sharers = fields.width() * n;
  const std::vector<double> none{noNumber, inf, -inf, 1e300};
  std::vector<Wrong> state{{0, none}, {3 * n - 1, none}, {4 * n, none}, {9 * n, none}};
  state.push_back({3 * n, {noNumber, -0.02, inf}});
  state.push_back({tags, {noNumber, -1, 0.5, 1e18, 2147483648.}});
  state.push_back({tags + n, {noNumber, -2, 0.5, 1e18}});
  state.push_back({tags + 5 * n, {noNumber, 0.5, 2, -1}});
  const std::vector<double> noIndex{noNumber, inf, -1, 0.5, 1e18, 4};
  for (std::size_t k : {0, 4}) state.push_back({sharers + k, noIndex});
  state.push_back({sharers + 1, {noNumber, 0, 1, 3, 4, -1, 1e18, 0.5}});
  state.push_back({sharers + 2, {noNumber, 1, 2, 3, -1, 1e18, 0.5}});
  state.push_back({sharers + 3, {noNumber, 0, 2, 3, -1, 1e18, 0.5}});
  state.push_back({sharers + 5, {noNumber, 0, 1, 2, 4, -1, 1e18, 0.5}});
  state.push_back({sharers + 7, {noNumber, 0, 2, 3, -1, 0.5}});
  state.push_back({sharers + 4, {0}});
  for (const auto& wrong : state)
    for (double x : wrong.values) {
      Sent s;
      s.state[wrong.word] = x;
      s.header.stateSeal = clay::wire::seal(s.state.data(), s.state.size());
      clay::wire::sealHeader(s.header);
      expectRefused([&] { s.take(); }, named("sealed state", wrong.word, x));
    }
}

TEST(DamagedMessages, OfARunThatIsNotThere) {
  Sent s;
  s.known.over = true;
  expectRefused([&] { s.take(); }, "a state after the last");
  s = Sent();
  s.header.kind = 2;
  clay::wire::sealHeader(s.header);
  expectRefused([&] { s.take(); }, "a further run that brings a state");
  s = Sent();
  s.header = Header{};
  s.header.kind = 2;
  s.header.exchange = 5;
  s.header.time = s.known.time;
  clay::wire::sealHeader(s.header);
  expectRefused([&] { s.take(); }, "a further run before the end of this one");
  s.known.over = true;
  EXPECT_NO_THROW(s.take());
  s = Sent();
  s.known.end = s.header.time;
  expectRefused([&] { s.take(); }, "a state at the end that is not the last");
  s.header.last = 1;
  clay::wire::sealHeader(s.header);
  EXPECT_NO_THROW(s.take());

  const Header first = Sent().header;
  EXPECT_NO_THROW(clay::wire::checkAlike(first, first));
  for (std::size_t w : {0, 1, 2, 4, 10, 11}) {
    Sent other;
    other.words()[w] += 1;
    expectRefused([&] { clay::wire::checkAlike(first, other.header); }, "ranks that differ");
  }
}

TEST(DamagedMessages, OfAnswers) {
  // two of three particles, of 4 doubles each
  const int width = 4;
  const auto good = [] {
    std::vector<double> m{0, 2, 10, 11, 20, 21, 22, 23, 24, 25, 0, 0, 0, 0};
    clay::wire::endAnswer(m, 1e-12, false, 7);
    return m;
  };
  const auto take = [](const std::vector<double>& m) {
    clay::wire::readAnswer(m.data(), static_cast<std::ptrdiff_t>(m.size()), 3, width, 7);
  };
  EXPECT_NO_THROW(take(good()));
  for (std::size_t w = 0; w < good().size(); ++w)
    for (double x : spoilt(good()[w])) {
      auto m = good();
      m[w] = x;
      expectRefused([&] { take(m); }, named("answer", w, x));
    }
  for (std::size_t length = 0; length < 20; ++length) {
    auto m = good();
    m.resize(length, 0.);
    if (length != good().size()) expectRefused([&] { take(m); }, "a length");
  }
  const auto resealed = [&](std::size_t w, double x) {
    auto m = good();
    m[w] = x;
    m.back() = clay::wire::seal(m.data(), m.size() - 1);
    expectRefused([&] { take(m); }, named("sealed answer", w, x));
  };
  for (double x : {noNumber, inf, -1., 0.5, 3., 1e18}) resealed(1, x);
  for (double x : {noNumber, 2., 3., -1., 0.5}) resealed(0, x);
  for (double x : {noNumber, inf, 1e300}) resealed(10, x);
  for (double x : {noNumber, 2., -1., 0.5}) resealed(11, x);
  for (double x : {noNumber, 6., 8., -1., 1e18}) resealed(12, x);
  // more than were asked for
  std::vector<double> m(4 * 5 + clay::wire::answerEnd);
  for (int a = 0; a < 4; ++a) m[static_cast<std::size_t>(a)] = a;
  clay::wire::endAnswer(m, 0, false, 7);
  expectRefused([&] { take(m); }, "four answers to three");
  expectRefused([&] { clay::wire::readAnswer(m.data(), INT_MIN, 3, width, 7); }, "half a double");
}

TEST(DamagedMessages, OfTheWordThatAsksForTheEnd) {
  const auto good = clay::wire::stopMessage(15, 7);
  EXPECT_EQ(clay::wire::readStop(good.data(), good.size(), 7), 15);
  EXPECT_EQ(clay::wire::readStop(clay::wire::stopMessage(1, 0).data(), 3, 7), 1);
  EXPECT_EQ(clay::wire::readStop(clay::wire::stopMessage(64, 0).data(), 3, 7), 64);
  const auto refused = [](std::array<double, 3> m, std::ptrdiff_t n = 3) {
    try {
      clay::wire::readStop(m.data(), n, 7);
      return std::string();
    } catch (const clay::wire::Damaged& damage) {
      return std::string(damage.what());
    }
  };
  EXPECT_EQ(refused(good, 2), "it holds 2 doubles of 3");
  EXPECT_EQ(refused(good, 4), "it holds 4 doubles of 3");
  for (std::size_t k = 0; k < 3; ++k) {
    auto m = good;
    m[k] += 1;
    EXPECT_EQ(refused(m), "it did not come in as it was sent") << k;
  }
  EXPECT_NE(refused(clay::wire::stopMessage(0, 0)).find("its signal is 0"), std::string::npos);
  EXPECT_NE(refused(clay::wire::stopMessage(65, 0)).find("its signal is 65"), std::string::npos);
  EXPECT_NE(refused(clay::wire::stopMessage(15, 8)).find("its number of exchanges is 8"),
            std::string::npos);
}

TEST(DamagedMessages, OfSharedValues) {
  std::vector<double> m{1, 2, 3};
  m.push_back(clay::wire::seal(m.data(), 3));
  EXPECT_NO_THROW(clay::wire::checkShared(m.data(), 4, 3));
  for (std::ptrdiff_t n : {-32766, 0, 1, 3, 5})
    expectRefused([&] { clay::wire::checkShared(m.data(), n, 3); }, "shared values' length");
  for (std::size_t w = 0; w < 4; ++w)
    for (double x : spoilt(m[w])) {
      auto d = m;
      d[w] = x;
      expectRefused([&] { clay::wire::checkShared(d.data(), 4, 3); }, named("shared", w, x));
    }
}

TEST(DamagedMessages, OfBoxes) {
  const clay::Box mesh = halves::meshBox();
  const std::vector<clay::RankBoxes> good{{halves::slab(0, 2), mesh}, {halves::slab(1, 2)}};
  const std::string bytes = clay::wire::encodeBoxes(good);
  const auto take = [&](const std::string& b) { clay::wire::decodeBoxes(b, 2, mesh); };
  const auto back = clay::wire::decodeBoxes(bytes, 2, mesh);
  EXPECT_EQ(back[0][0].hi, good[0][0].hi);
  EXPECT_EQ(back[1][0].lo, good[1][0].lo);
  EXPECT_EQ(back[0].size(), 2u);
  // a rank without cells states the box of nothing
  EXPECT_NO_THROW(take(clay::wire::encodeBoxes({{clay::Box()}, {mesh}})));

  for (std::size_t at = 0; at < bytes.size(); ++at) {
    auto b = bytes;
    b[at] = static_cast<char>(b[at] ^ 0x40);
    expectRefused([&] { take(b); }, "byte " + std::to_string(at) + " of the boxes");
    expectRefused([&] { take(bytes.substr(0, at)); }, "cut boxes");
  }
  expectRefused([&] { take(bytes + "x"); }, "a byte more");
  for (double x : {noNumber, inf, 1e300, -1., 2.})
    for (int side = 0; side < 2; ++side) {
      auto wrong = good;
      (side ? wrong[0][0].hi : wrong[0][0].lo)[0] = side ? x : 1 - x;
      expectRefused([&] { take(clay::wire::encodeBoxes(wrong)); }, "box " + std::to_string(x));
    }
  auto inverted = good;
  std::swap(inverted[1][0].lo, inverted[1][0].hi);
  expectRefused([&] { take(clay::wire::encodeBoxes(inverted)); }, "an inverted box");
  expectRefused([&] { take(clay::wire::encodeBoxes({good[0]})); }, "a rank less");
  expectRefused([&] { take(clay::wire::encodeBoxes({good[0], good[1], good[1]})); }, "a rank more");
  expectRefused([&] { take(clay::wire::encodeBoxes({good[0], {}})); }, "a rank without a box");
  // a count that would need more memory than there is
  const auto sealed = [](std::uint64_t n) {
    std::string b(reinterpret_cast<const char*>(&n), sizeof n);
    const std::uint64_t sum = clay::wire::digest(b);
    return b + std::string(reinterpret_cast<const char*>(&sum), sizeof sum);
  };
  for (std::uint64_t n : {std::uint64_t{1}, std::uint64_t{1} << 40, ~std::uint64_t{0}})
    expectRefused([&] { take(sealed(n)); }, "a count of boxes");
}

TEST(DamagedMessages, OfVerdicts) {
  const std::string good = clay::wire::encode(clay::wire::Verdict{1, 2, "no"});
  EXPECT_EQ(clay::wire::decodeVerdict(good).line, "no");
  EXPECT_EQ(clay::wire::decodeVerdict(good).cfd, 2u);
  for (std::size_t at = 0; at < good.size(); ++at) {
    auto b = good;
    b[at] = static_cast<char>(b[at] ^ 1);
    expectRefused([&] { clay::wire::decodeVerdict(b); }, "byte of the verdict");
    expectRefused([&] { clay::wire::decodeVerdict(good.substr(0, at)); }, "a cut verdict");
  }
  expectRefused([&] { clay::wire::decodeVerdict(good + "!"); }, "a byte more");
}

// Each entry in turn: taken away, and in place of it what is none
TEST(DamagedMessages, OfTerms) {
  const std::string dem = clay::encode(halves::demTerms()), cfd = clay::encode(halves::cfdTerms());
  const auto take = [&](const std::string& d, const std::string& c) {
    const std::string line = clay::disagreement(clay::decodeDem(d), clay::decodeCfd(c));
    if (!line.empty()) throw Damaged(line);
  };
  EXPECT_NO_THROW(take(dem, cfd));
  struct Entry {
    const char* key;
    std::vector<const char*> values;
  };
  const char* triples = "[0,0]";
  const Entry demEntries[] = {
      {"half", {"\"CFD\"", "1", "null"}},
      {"wire", {"8", "9.5", "-1", "1e300", "\"9\"", "null", "99999999999999999999"}},
      {"step", {"-1", "0", "null", "1e300", "\"x\"", "[]"}},
      {"interval", {"-1", "0", "20.5", "1e300", "null", "\"20\"", "99999999999999999999"}},
      {"startTime", {"null", "1e300", "1", "-1", "{}"}},
      {"endTime", {"null", "-1e300", "1e300", "-1", "[0]"}},
      {"gravity", {"[0,0,null]", "[0,0,1e300]", triples, "[0,0,0,0]", "0"}},
      {"hasGravity", {"1", "null", "\"yes\""}},
      {"box",
       {"{}", "null", "{\"lo\":[1,1,1],\"hi\":[0,0,0]}", "{\"lo\":[0,0,null],\"hi\":[1,1,1]}",
        "{\"lo\":[0,0,0],\"hi\":[1e300,1,1]}", "{\"lo\":[0,0],\"hi\":[1,1]}"}},
      {"periodic", {"[true]", "[1,2,3]", "[true,true,true,true]", "null"}},
      {"particles", {"-1", "1.5", "1e18", "null", "99999999999999999999"}},
      {"maxRadius", {"-1", "null", "1e300", "[]"}},
      {"bodyDiameter", {"-1", "null", "1e300", "[]"}},
      {"offers", {"[\"smell\"]", "[]", "[1]", "null", "[\"force\"]"}},
      {"brings", {"[\"smell\"]", "[\"force\"]", "[\"spin\"]", "0"}},
      {"needs", {"[\"smell\"]", "[\"radius\"]", "[\"fluidSpin\"]", "0"}},
      {"clumpDrag", {"0", "null", "[]"}},
      {"pairs", {"0", "null", "[]"}},
      {"pair", {"1", "-1", "0.5", "1e300", "null", "\"0\""}}};
  const Entry cfdEntries[] = {
      {"half", {"\"DEM\"", "true"}},
      {"wire", {"7", "9.5", "null"}},
      {"startTime", {"null", "1e300", "5"}},
      {"fluidDensity", {"0", "-1", "null", "1e300"}},
      {"fluidViscosity", {"-1", "null", "1e300"}},
      {"box", {"{\"lo\":[1,1,1],\"hi\":[0,0,0]}", "{\"lo\":[0,0,0],\"hi\":[1,1,null]}"}},
      {"buoyancy", {"0", "null"}},
      {"open", {"[]", "[true,true,true]", "[1,1,1,1,1,1]"}},
      {"overlap", {"0", "null"}},
      {"pair", {"1", "-1", "0.5", "1e300", "null", "[0]"}},
      {"needs", {"[\"smell\"]", "[\"force\"]", "[\"gravity\"]"}},
      {"accepts", {"[\"smell\"]", "[\"force\"]"}},
      {"offers", {"[\"smell\"]", "[]", "[\"radius\"]"}}};
  const auto spoil = [](std::string text, const std::string& key, const char* value) {
    auto at = text.find("\"" + key + "\":") + key.size() + 3;
    auto end = at;
    for (int depth = 0; depth > 0 || (text[end] != ',' && text[end] != '}'); ++end)
      depth += (text[end] == '[' || text[end] == '{') - (text[end] == ']' || text[end] == '}');
    if (value) return text.replace(at, end - at, value);
    at -= key.size() + 3;
    if (text[end] == ',')
      ++end;
    else
      --at;  // the comma before the last
    return text.erase(at, end - at);
  };
  for (const auto& e : demEntries) {
    expectRefused([&] { take(spoil(dem, e.key, nullptr), cfd); },
                  std::string("DEM without ") + e.key);
    for (const char* v : e.values)
      expectRefused([&] { take(spoil(dem, e.key, v), cfd); },
                    std::string("DEM ") + e.key + " " + v);
  }
  for (const auto& e : cfdEntries) {
    expectRefused([&] { take(dem, spoil(cfd, e.key, nullptr)); },
                  std::string("CFD without ") + e.key);
    for (const char* v : e.values)
      expectRefused([&] { take(dem, spoil(cfd, e.key, v)); },
                    std::string("CFD ") + e.key + " " + v);
  }
  for (const std::string& text : {std::string(), std::string("null"), std::string("[[[["),
                                  std::string(100000, '['), std::string("\xff\xfe\0x", 4)})
    expectRefused([&] { take(text, cfd); }, "no terms");
  // a name cannot bring a line of its own into a message
  auto odd = halves::demTerms();
  odd.program = "two\nlines\x1b[31m";
  EXPECT_EQ(clay::decodeDem(clay::encode(odd)).program, "two lines [31m");
}

// The last of its suite
TEST(DamagedMessagesInAll, AreManyHundreds) {
  std::printf("%d damaged messages\n", damagedMessages);
  if (testing::UnitTest::GetInstance()->test_to_run_count() > 1) EXPECT_GE(damagedMessages, 1000);
}
