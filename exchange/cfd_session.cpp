// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file cfd_session.cpp
/// The CFD half's side of a session.
#include <algorithm>
#include <climits>
#include <cstdio>
#include <stdexcept>

#include "exchange/decode.h"
#include "exchange/shutdown.h"
#include "exchange/handshake.h"
#include "exchange/packing.h"
#include "exchange/session.h"
#include "exchange/shared.h"
#include "exchange/waiting.h"
#include "exchange/wire.h"

namespace clay {

namespace {

using wire::Header;
using wire::Kind;

constexpr const char* forState = "the DEM half's next state";
constexpr const char* forTaking = "the DEM half to take in the answer";

double now() { return PMPI_Wtime(); }

}  // namespace

struct CfdSession::Impl {
  // What comes from one DEM rank and goes back to it. The buffers keep their memory.
  struct RemoteRank {
    Header announced;  // what it does next, comes in at any time
    bool heard = false;
    Header header;  // of the last state
    std::vector<double> state, answer;
    int first = 0;               // its first particle here
    std::ptrdiff_t doubles = 0;  // of its state
    int count() const { return static_cast<int>(header.count); }
    std::size_t announcedDoubles(const FieldSet& fields) const {
      return static_cast<std::size_t>(header.count) * static_cast<std::size_t>(fields.width()) +
             static_cast<std::size_t>(header.shares);
    }
  };

  BothTerms terms;
  FieldSet sends, receives;
  std::vector<RemoteRank> remotes;
  std::vector<MPI_Request> states, out;
  SharedParticles shared;
  int particles = 0;
  double time = 0, interval = 0, reported = 0;
  bool late = false, last = false, open = false, closeReceived = false;
  SavedPair pair;
  std::array<double, 3> impulse{};
  std::array<double, wire::stopDoubles> stop{};  // sent once, when it is not all zeros
  Timing timing;

  void settle() {
    receives = stateFields(terms);
    sends = answerFields(terms);
  }

  void awaitHeaders() {
    for (auto& remote : remotes) remote.heard = false;
  }

  bool headersIn();
  void checkHeaders();
  void receiveStates();
  void takeState(Particles& particles);
  void unpack(Particles& particles);
  void pack(const Particles& answers, const std::vector<char>& owned, RemoteRank& remote);
};

// Nothing is posted for them: of a message that is too long for what is posted, MPI may say nothing
bool CfdSession::Impl::headersIn() {
  const auto& world = World::instance();
  bool all = true;
  for (std::size_t p = 0; p < remotes.size(); ++p) {
    if (remotes[p].heard) continue;
    MPI_Message message;
    MPI_Status status;
    int there = 0, bytes = 0;
    PMPI_Improbe(world.remoteRanks()[p], wire::tagHeader, world.whole(), &there, &message, &status);
    if (!there) {
      all = false;
      continue;
    }
    PMPI_Get_count(&status, MPI_BYTE, &bytes);
    if (bytes != static_cast<int>(sizeof(double)) * Header::doubles)
      abandon("the announcement of DEM rank " + std::to_string(p) + ": it holds " +
              std::to_string(bytes) + " bytes of " +
              std::to_string(sizeof(double) * Header::doubles));
    PMPI_Mrecv(&remotes[p].announced, Header::doubles, MPI_DOUBLE, &message, MPI_STATUS_IGNORE);
    remotes[p].heard = true;
  }
  return all;
}

void CfdSession::Impl::checkHeaders() {
  const auto& dem = terms.dem;
  const wire::Known known{timing.exchanges, time, dem.endTime, dem.step, last, receives.width()};
  std::ptrdiff_t all = 0;
  for (std::size_t p = 0; p < remotes.size(); ++p) try {
      wire::checkHeader(remotes[p].announced, known);
      wire::checkAlike(remotes[0].announced, remotes[p].announced);
      all += static_cast<std::ptrdiff_t>(remotes[p].announced.count);
      if (all > INT_MAX) throw wire::Damaged("all ranks' particles are too many for one rank");
    } catch (const wire::Damaged& damage) {
      abandon("the announcement of DEM rank " + std::to_string(p) + ": " + damage.what());
    }
}

// The messages' lengths are looked at before there is room for them
void CfdSession::Impl::receiveStates() {
  const auto& world = World::instance();
  const auto receive = [&](std::size_t p) {
    auto& remote = remotes[p];
    MPI_Message message;
    MPI_Status status;
    int there = 0, doubles = 0;
    PMPI_Improbe(world.remoteRanks()[p], wire::tagState, world.whole(), &there, &message, &status);
    if (!there) return false;
    PMPI_Get_count(&status, MPI_DOUBLE, &doubles);
    remote.doubles = doubles;
    remote.state.resize(static_cast<std::size_t>(std::max(doubles, 0)));
    int bytes = 0;
    PMPI_Get_count(&status, MPI_BYTE, &bytes);
    if (doubles < 0 || static_cast<std::size_t>(doubles) != remote.announcedDoubles(receives))
      abandon("the state of DEM rank " + std::to_string(p) + " has " + std::to_string(bytes) +
              " bytes; " + std::to_string(8 * remote.announcedDoubles(receives)) +
              " were announced");
    states.emplace_back();
    PMPI_Imrecv(remote.state.data(), doubles, MPI_DOUBLE, &message, &states.back());
    return true;
  };
  std::vector<std::size_t> waiting;
  for (std::size_t p = 0; p < remotes.size(); ++p)
    if (remotes[p].count() > 0) waiting.push_back(p);
  states.clear();
  waitUntil(
      [&] {
        waiting.erase(std::remove_if(waiting.begin(), waiting.end(), receive), waiting.end());
        return waiting.empty() && allDone(states);
      },
      forState, &timing.waiting);
}

void CfdSession::Impl::takeState(Particles& list) {
  time = remotes[0].announced.time;
  interval = remotes[0].announced.interval;
  last = remotes[0].announced.last != 0;
  pair = {remotes[0].announced.pair, remotes[0].announced.step};
  impulse = {};
  particles = 0;
  for (auto& remote : remotes) {
    const Header& h = remote.header = remote.announced;
    // in the order of the ranks: the sum is the same on every CFD rank
    for (int c = 0; c < 3; ++c) impulse[c] += h.impulse[c];
    remote.first = particles;
    particles += remote.count();
  }
  receiveStates();
  unpack(list);
}

void CfdSession::Impl::unpack(Particles& list) {
  const auto& world = World::instance();
  if (!(list.fields() == receives)) list = Particles(receives);
  list.resize(particles);
  shared.clear();
  for (std::size_t p = 0; p < remotes.size(); ++p) {
    const auto& remote = remotes[p];
    const int n = remote.count();
    if (n == 0) continue;
    try {
      wire::checkState(remote.state.data(), remote.doubles, remote.header, receives.width(),
                       world.rank(), world.size());
    } catch (const wire::Damaged& damage) {
      abandon("the state of DEM rank " + std::to_string(p) + ": " + damage.what());
    }
    const double* from = unpackFields(remote.state.data(), receives, n, list, remote.first);
    shared.add(from, static_cast<std::size_t>(remote.header.shares), remote.first);
  }
  const Astray astray = firstAstray(list);
  if (astray.particle < 0) return;
  char when[40];
  std::snprintf(when, sizeof when, "%.9g s", time);
  abandon("from the DEM half came " + describe(astray, list, list) + ", at time " + when +
          "; a smaller timestep, a stiffer contact or a shorter coupling interval may help");
}

void CfdSession::Impl::pack(const Particles& answers, const std::vector<char>& owned,
                            RemoteRank& remote) {
  packAnswers(answers, owned, sends, remote.first, remote.count(), wire::answerEnd, remote.answer);
  wire::endAnswer(remote.answer, reported, late, timing.exchanges - 1);
}

CfdSession::CfdSession(const CfdTerms& mine, const RankBoxes& boxes) : impl_(new Impl) {
  auto& s = *impl_;
  s.terms = shakeHands(Half::cfd, encode(mine));
  s.settle();
  sendBoxes(boxes, mine.box);
  s.remotes.resize(World::instance().remoteRanks().size());
  s.time = s.terms.dem.startTime;
  s.open = true;
  s.awaitHeaders();
}

CfdSession::~CfdSession() {
  // messages under way keep their buffers: the program ends without close()
  if (impl_ && impl_->open) static_cast<void>(impl_.release());
}

const DemTerms& CfdSession::remoteTerms() const { return impl_->terms.dem; }
const FieldSet& CfdSession::receives() const { return impl_->receives; }
const FieldSet& CfdSession::sends() const { return impl_->sends; }
const Timing& CfdSession::timing() const { return impl_->timing; }
double CfdSession::time() const { return impl_->time; }
double CfdSession::interval() const { return impl_->interval; }
bool CfdSession::last() const { return impl_->last; }
const SavedPair& CfdSession::pair() const { return impl_->pair; }
std::array<double, 3> CfdSession::impulse() const { return impl_->impulse; }

CfdSession::Event CfdSession::next(Particles& particles) {
  auto& s = *impl_;
  if (s.closeReceived) return Event::closed;
  const double start = now(), idle = s.timing.waiting;
  waitUntil([&] { return s.headersIn() && allDone(s.out); }, forState, &s.timing.waiting);
  s.checkHeaders();
  const Header h = s.remotes[0].announced;
  Event event = Event::state;
  switch (static_cast<Kind>(static_cast<int>(h.kind))) {
    case Kind::state:
      s.takeState(particles);
      ++s.timing.exchanges;
      s.awaitHeaders();
      break;
    case Kind::resume:
      // this half goes on where the last run ended
      s.terms.cfd.startTime = s.time;
      s.last = false;
      shakeHandsAgain(Half::cfd, "", s.terms);
      s.settle();
      s.awaitHeaders();
      event = Event::resumed;
      break;
    case Kind::close:
      s.closeReceived = true;
      s.open = false;
      setStage(Stage::closed);
      event = Event::closed;
      break;
  }
  s.timing.exchange += now() - start - (s.timing.waiting - idle);
  return event;
}

void CfdSession::sumShared(std::vector<double>& values, int stride) {
  const double start = now();
  impl_->shared.sum(values, stride);
  impl_->timing.exchange += now() - start;
}

std::vector<char> CfdSession::own(const std::vector<double>& claims) {
  const double start = now();
  auto owned = impl_->shared.own(claims);
  impl_->timing.exchange += now() - start;
  return owned;
}

void CfdSession::answer(const Particles& answers, const std::vector<char>& owned) {
  auto& s = *impl_;
  const auto& world = World::instance();
  if (answers.size() != s.particles || owned.size() != static_cast<std::size_t>(s.particles))
    throw std::logic_error("CfdSession::answer: not one answer a particle");
  if (!s.sends.without(answers.fields()).empty())
    throw std::logic_error("CfdSession::answer: a field that the DEM half needs is missing");
  const double start = now(), idle = s.timing.waiting;
  s.out.clear();
  double bytes = 0;
  for (std::size_t p = 0; p < s.remotes.size(); ++p) {
    auto& remote = s.remotes[p];
    if (remote.count() == 0) continue;
    s.pack(answers, owned, remote);
    s.out.emplace_back();
    PMPI_Isend(remote.answer.data(), static_cast<int>(remote.answer.size()), MPI_DOUBLE,
               world.remoteRanks()[p], wire::tagAnswer, world.whole(), &s.out.back());
    bytes += 8. * static_cast<double>(remote.answer.size());
  }
  s.timing.bytesSent += bytes;
  // A long message needs this rank's help on its way, which it would not get
  // while this half solves: a DEM half that waits for it gets it now, one that
  // does not is not waited for long.
  const double longest = 1e-3 + bytes / 200e6;
  waitUntil([&] { return allDone(s.out) || now() - start > longest; }, forTaking,
            &s.timing.waiting);
  s.timing.exchange += now() - start - (s.timing.waiting - idle);
}

void CfdSession::report(double momentumResidual, bool late) {
  impl_->reported = momentumResidual;
  impl_->late = late;
}

void CfdSession::askStop(int signal) {
  auto& s = *impl_;
  const auto& world = World::instance();
  if (s.stop[0] > 0 || world.rank() > 0) return;
  s.stop = wire::stopMessage(signal, s.timing.exchanges);
  MPI_Request request;
  PMPI_Isend(s.stop.data(), wire::stopDoubles, MPI_DOUBLE, world.remoteRanks()[0], wire::tagStop,
             world.whole(), &request);
  // so short that it is on its way at once; nobody waits for it to be taken
  PMPI_Request_free(&request);
}

void CfdSession::close() {
  auto& s = *impl_;
  if (!s.closeReceived) abandon("the CFD half closed its session before the coupled run had ended");
  s.open = false;
}

}  // namespace clay
