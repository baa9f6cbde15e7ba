// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file dem_session.cpp
/// The DEM half's side of a session.
#include <algorithm>
#include <climits>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "exchange/decode.h"
#include "exchange/shutdown.h"
#include "exchange/handshake.h"
#include "exchange/routing.h"
#include "exchange/session.h"
#include "exchange/waiting.h"
#include "exchange/wire.h"

namespace clay {

namespace {

using wire::Header;
using wire::Kind;

constexpr const char* forAnswer = "the CFD half's answer";
constexpr const char* forTaking = "the CFD half to take in the state";

double now() { return PMPI_Wtime(); }

std::string text(const double* x) {
  char s[96];
  std::snprintf(s, sizeof s, "(%.9g %.9g %.9g)", x[0], x[1], x[2]);
  return s;
}

std::string seconds(double time) {
  char s[40];
  std::snprintf(s, sizeof s, "%.9g s", time);
  return s;
}

}  // namespace

struct DemSession::Impl {
  // What goes to one CFD rank and comes back from it. The buffers keep their memory.
  struct RemoteRank {
    Header header;
    std::vector<double> state, answer;
    std::size_t answerSlot = 0;
  };

  BothTerms terms;
  FieldSet sends, receives;
  Routing routing;
  std::vector<RemoteRank> remotes;
  std::vector<MPI_Request> out, in;
  std::vector<MPI_Status> inStatus;
  std::vector<long> answeredIn;  // exchange in which a particle was answered
  const Particles* sent = nullptr;
  double lastTime = 0, sentAt = 0, reported = 0;
  int away = 0, asked = 0;
  bool late = false;
  bool open = false, awaiting = false, arrived = false, runOver = false;
  Timing timing;

  // Fields of the state and of the answer change when a further run asks for others
  void settle() {
    sends = stateFields(terms);
    receives = answerFields(terms);
  }

  void announce(Kind kind) {
    const auto& world = World::instance();
    waitUntil([&] { return allDone(out); }, forTaking, &timing.waiting);
    out.clear();
    for (std::size_t p = 0; p < remotes.size(); ++p) {
      auto& header = remotes[p].header;
      header = Header{};
      header.kind = static_cast<int>(kind);
      header.exchange = static_cast<double>(timing.exchanges);
      header.time = lastTime;
      wire::sealHeader(header);
      post(&header, Header::doubles, world.remoteRanks()[p], wire::tagHeader);
    }
  }

  void post(const void* data, std::size_t doubles, int rank, int tag) {
    out.emplace_back();
    PMPI_Isend(data, static_cast<int>(doubles), MPI_DOUBLE, rank, tag, World::instance().whole(),
               &out.back());
    timing.bytesSent += 8. * static_cast<double>(doubles);
  }

  void pack(const Particles& particles, const Routing::Route& route, RemoteRank& remote);
  bool test();
  void take(std::size_t p, Particles& answer);
  void unpack(Particles& answer);
  bool left(int i) const;
  [[noreturn]] void lost(int i) const;
};

// Field by field, then the list of sharers
void DemSession::Impl::pack(const Particles& particles, const Routing::Route& route,
                            RemoteRank& remote) {
  const std::size_t n = route.particles.size();
  const std::size_t most = INT_MAX;
  if (n > most / static_cast<std::size_t>(sends.width()) || route.shares.size() > most / 2)
    abandon(std::to_string(n) +
            " particles of a rank are too many for one message; take more ranks");
  remote.state.resize(n * static_cast<std::size_t>(sends.width()) + route.shares.size());
  double* to = remote.state.data();
  for (unsigned k = 0; k < fieldCount; ++k) {
    const auto f = static_cast<Field>(k);
    if (!sends.has(f)) continue;
    const int width = components(f);
    const double* from = particles[f];
    for (int i : route.particles)
      for (int c = 0; c < width; ++c) *to++ = from[width * i + c];
  }
  std::copy(route.shares.begin(), route.shares.end(), to);
}

bool DemSession::Impl::test() {
  if (arrived) return true;
  int done = 0;
  PMPI_Testall(static_cast<int>(in.size()), in.data(), &done, inStatus.data());
  arrived = done;
  return arrived;
}

// Through an open side of the mesh's box
bool DemSession::Impl::left(int i) const {
  const double* x = (*sent)[Field::position] + 3 * i;
  const auto& cfd = terms.cfd;
  for (std::size_t k = 0; k < 3; ++k)
    if ((x[k] < cfd.box.lo[k] && cfd.open[2 * k]) || (x[k] > cfd.box.hi[k] && cfd.open[2 * k + 1]))
      return true;
  return false;
}

void DemSession::Impl::lost(int i) const {
  const auto& world = terms.cfd.box;
  const double* tag = sent->fields().has(Field::tag) ? (*sent)[Field::tag] : nullptr;
  abandon("particle " + (tag ? std::to_string(std::llround(tag[i])) : std::string("?")) + " at " +
          text((*sent)[Field::position] + 3 * i) + " m lies outside the mesh, " +
          text(world.lo.data()) + " to " + text(world.hi.data()) + " m, at " + seconds(lastTime));
}

// One CFD rank's answers to their places
void DemSession::Impl::take(std::size_t p, Particles& answer) {
  const auto& remote = remotes[p];
  const auto& particles = routing[p].particles;
  if (particles.empty()) return;
  const long exchange = timing.exchanges - 1;
  wire::AnswerParts parts;
  try {
    int doubles = 0;
    PMPI_Get_count(&inStatus[remote.answerSlot], MPI_DOUBLE, &doubles);
    parts = wire::readAnswer(remote.answer.data(), doubles, particles.size(), receives.width(),
                             exchange);
  } catch (const wire::Damaged& damage) {
    abandon("the answer of CFD rank " + std::to_string(p) + ": " + damage.what());
  }
  reported = parts.reported;
  late = late || parts.late;
  const auto place = [&](std::size_t a) {
    return particles[static_cast<std::size_t>(parts.place[a])];
  };
  for (std::size_t a = 0; a < parts.count; ++a) {
    auto& answered = answeredIn[static_cast<std::size_t>(place(a))];
    if (answered >= 0) abandon("two CFD ranks answered for the same particle");
    answered = exchange;
  }
  const double* from = parts.fields;
  for (unsigned k = 0; k < fieldCount; ++k) {
    const auto f = static_cast<Field>(k);
    if (!receives.has(f)) continue;
    const int c = components(f);
    double* to = answer[f];
    for (std::size_t a = 0; a < parts.count; ++a, from += c)
      std::copy(from, from + c, to + static_cast<std::ptrdiff_t>(c) * place(a));
  }
}

void DemSession::Impl::unpack(Particles& answer) {
  const int n = sent->size();
  if (!(answer.fields() == receives)) answer = Particles(receives);
  answer.resize(n);
  answeredIn.resize(static_cast<std::size_t>(n), -1);
  std::fill(answeredIn.begin(), answeredIn.end(), -1);
  late = false;
  for (std::size_t p = 0; p < remotes.size(); ++p) take(p, answer);
  away = 0;
  for (int i = 0; i < n; ++i) {
    if (answeredIn[static_cast<std::size_t>(i)] >= 0) continue;
    if (!left(i)) lost(i);
    ++away;
    for (unsigned k = 0; k < fieldCount; ++k) {
      const auto f = static_cast<Field>(k);
      if (receives.has(f)) std::fill_n(answer[f] + components(f) * i, components(f), 0.);
    }
  }
  const Astray astray = firstAstray(answer);
  if (astray.particle >= 0)
    abandon("the CFD half's answer to " + describe(astray, answer, *sent) + ", at " +
            seconds(lastTime) +
            "; the flow or its forces went wrong: a smaller maxCo or deltaT, or a shorter coupling "
            "interval, may help");
}

DemSession::DemSession(const DemTerms& mine) : impl_(new Impl) {
  auto& s = *impl_;
  s.terms = shakeHands(Half::dem, encode(mine));
  s.settle();
  s.routing = Routing(receiveBoxes(s.terms.cfd.box));
  s.remotes.resize(s.routing.size());
  s.lastTime = s.terms.dem.startTime;
  s.open = true;
}

DemSession::~DemSession() {
  // messages under way keep their buffers: the program ends without close()
  if (impl_ && impl_->open) static_cast<void>(impl_.release());
}

double DemSession::reported() const { return impl_->reported; }
int DemSession::asked() {
  auto& s = *impl_;
  const auto& world = World::instance();
  if (s.asked || world.rank() > 0) return s.asked;
  MPI_Message message;
  MPI_Status status;
  int there = 0, bytes = 0, doubles = 0;
  PMPI_Improbe(world.remoteRanks()[0], wire::tagStop, world.whole(), &there, &message, &status);
  if (!there) return 0;
  PMPI_Get_count(&status, MPI_BYTE, &bytes);
  PMPI_Get_count(&status, MPI_DOUBLE, &doubles);
  std::vector<double> words(static_cast<std::size_t>(bytes) / sizeof(double) + 1);
  PMPI_Mrecv(words.data(), bytes, MPI_BYTE, &message, MPI_STATUS_IGNORE);
  try {
    s.asked = wire::readStop(words.data(), doubles, s.timing.exchanges);
  } catch (const wire::Damaged& damage) {
    abandon(std::string("the CFD half asks for the end: ") + damage.what());
  }
  return s.asked;
}

int DemSession::away() const { return impl_->away; }
bool DemSession::late() const { return impl_->late; }
const CfdTerms& DemSession::remoteTerms() const { return impl_->terms.cfd; }
const FieldSet& DemSession::sends() const { return impl_->sends; }
const FieldSet& DemSession::receives() const { return impl_->receives; }
const Timing& DemSession::timing() const { return impl_->timing; }

void DemSession::send(const Particles& particles, double time, bool last,
                      const std::array<double, 3>& impulse, const SavedPair& pair) {
  auto& s = *impl_;
  const auto& world = World::instance();
  FieldSet needed = s.sends;
  needed.add(Field::position);
  needed.add(Field::radius);
  if (!needed.without(particles.fields()).empty())
    throw std::logic_error("DemSession::send: a field that the CFD half needs is missing");
  if (s.awaiting) throw std::logic_error("DemSession::send: the last answer was not received");
  if (s.runOver) throw std::logic_error("DemSession::send: the run is over, resume() comes first");

  const double start = now(), idle = s.timing.waiting;
  waitUntil([&] { return allDone(s.out); }, forTaking, &s.timing.waiting);
  s.out.clear();
  s.routing.route(particles[Field::position], particles[Field::radius], particles.size());
  const std::size_t width = static_cast<std::size_t>(s.receives.width());
  s.in.clear();
  for (std::size_t p = 0; p < s.remotes.size(); ++p) {
    auto& remote = s.remotes[p];
    const auto& route = s.routing[p];
    const std::size_t n = route.particles.size();
    auto& h = remote.header;
    h.kind = static_cast<int>(Kind::state);
    h.exchange = static_cast<double>(s.timing.exchanges);
    h.time = time;
    h.interval = time - s.lastTime;
    h.last = last;
    h.count = static_cast<double>(n);
    h.shares = static_cast<double>(route.shares.size());
    std::copy(impulse.begin(), impulse.end(), h.impulse);
    h.pair = pair.number;
    h.step = pair.number > 0 ? pair.step : 0;
    if (n > 0) s.pack(particles, route, remote);
    h.stateSeal = n > 0 ? wire::seal(remote.state.data(), remote.state.size()) : 0;
    wire::sealHeader(h);
    s.post(&h, Header::doubles, world.remoteRanks()[p], wire::tagHeader);
    if (n == 0) continue;
    s.post(remote.state.data(), remote.state.size(), world.remoteRanks()[p], wire::tagState);
    remote.answer.resize(n * (1 + width) + wire::answerEnd);
    remote.answerSlot = s.in.size();
    s.in.emplace_back();
    PMPI_Irecv(remote.answer.data(), static_cast<int>(remote.answer.size()), MPI_DOUBLE,
               world.remoteRanks()[p], wire::tagAnswer, world.whole(), &s.in.back());
  }
  s.inStatus.resize(s.in.size());
  s.sent = &particles;
  s.lastTime = time;
  s.sentAt = now();
  s.runOver = last;
  s.awaiting = true;
  s.arrived = false;
  ++s.timing.exchanges;
  s.timing.exchange += now() - start - (s.timing.waiting - idle);
}

bool DemSession::answered() {
  if (impl_->awaiting && impl_->test()) return true;
  checkShutdown();
  if (impl_->awaiting) endOnSilence(now() - impl_->sentAt, forAnswer);
  return !impl_->awaiting;
}

void DemSession::receive(Particles& answer) {
  auto& s = *impl_;
  if (!s.awaiting) throw std::logic_error("DemSession::receive: nothing was sent");
  const double start = now(), idle = s.timing.waiting;
  waitUntil([&] { return s.test(); }, forAnswer, &s.timing.waiting);
  s.unpack(answer);
  s.awaiting = false;
  s.timing.exchange += now() - start - (s.timing.waiting - idle);
}

void DemSession::resume(const DemTerms& terms) {
  auto& s = *impl_;
  if (s.awaiting) throw std::logic_error("DemSession::resume: the last answer was not received");
  s.announce(Kind::resume);
  // the CFD half goes on where the last run ended
  s.runOver = false;
  s.terms.cfd.startTime = s.lastTime;
  shakeHandsAgain(Half::dem, encode(terms), s.terms);
  s.settle();
}

void DemSession::close() {
  auto& s = *impl_;
  if (!s.open) return;
  if (s.awaiting) waitUntil([&] { return s.test(); }, forAnswer, &s.timing.waiting);
  s.awaiting = false;
  s.announce(Kind::close);
  waitUntil([&] { return allDone(s.out); }, forTaking, &s.timing.waiting);
  s.open = false;
  setStage(Stage::closed);
}

}  // namespace clay
