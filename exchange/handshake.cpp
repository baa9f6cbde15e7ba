// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/handshake.h"

#include <stdexcept>
#include <utility>

#include "exchange/decode.h"
#include "exchange/shutdown.h"
#include "exchange/waiting.h"
#include "exchange/wire.h"

namespace clay {

namespace {

constexpr const char* forTerms = "the other half's terms";
constexpr const char* forVerdict = "the other half's verdict on the terms";
constexpr const char* forBoxes = "the boxes of the CFD ranks";

// The first rank's text on every rank of this half
std::string fromFirst(const std::string& text, int tag, const char* forWhat) {
  const auto& world = World::instance();
  if (world.rank() != 0) return receiveText(world.localRanks()[0], tag, forWhat);
  for (int r = 1; r < world.size(); ++r)
    sendText(text, world.localRanks()[static_cast<std::size_t>(r)], tag, forWhat);
  return text;
}

// First ranks: mine for theirs. Both send first: the message must be under way before the wait
std::string swapped(const std::string& mine, int tag, const char* forWhat) {
  const auto& world = World::instance();
  std::vector<MPI_Request> request(1);
  PMPI_Isend(mine.data(), static_cast<int>(mine.size()), MPI_CHAR, world.remoteRanks()[0], tag,
             world.whole(), &request[0]);
  std::string theirs = receiveText(world.remoteRanks()[0], tag, forWhat);
  waitUntil([&] { return allDone(request); }, forWhat);
  return theirs;
}

// Why these terms are refused, or nothing; whether the other half is one that gives a verdict
std::string judged(const std::string& dem, const std::string& cfd, bool& sameWire) {
  sameWire = false;
  try {
    const DemTerms d = decodeDem(dem);
    const CfdTerms c = decodeCfd(cfd);
    sameWire = d.wire == c.wire;
    return disagreement(d, c);
  } catch (const Refusal& refusal) {
    return refusal.what();
  }
}

// First ranks: what both halves make of the terms that they have. Where the other half may
// not have found why this one refuses them, it is told, and both end at once: one that goes to
// MPI_Finalize while the other ends can leave mpirun waiting.
wire::Verdict concluded(Half half, const std::string& dem, const std::string& cfd) {
  bool sameWire = false;
  wire::Verdict mine{wire::digest(dem), wire::digest(cfd), judged(dem, cfd, sameWire)};
  bool told = !sameWire;
  if (sameWire) try {
      const auto theirs =
          wire::decodeVerdict(swapped(wire::encode(mine), wire::tagVerdict, forVerdict));
      told = theirs.dem != mine.dem || theirs.cfd != mine.cfd;
      if (told)
        mine.line = "the terms did not come in as they were sent";
      else if (mine.line.empty() || (half == Half::cfd && !theirs.line.empty()))
        mine.line = theirs.line;
    } catch (const wire::Damaged& damage) {
      told = true;
      mine.line = std::string("the other half's verdict on the terms: ") + damage.what();
    }
  if (told) abandon(mine.line);
  return mine;
}

// The first ranks' verdict on the terms that they have, on every rank
BothTerms settled(Half half, std::string dem, std::string cfd) {
  std::string verdict;
  if (World::instance().rank() == 0) {
    const auto mine = concluded(half, dem, cfd);
    if (!mine.line.empty()) setStage(Stage::closed);
    verdict = wire::encode(mine);
  }
  dem = fromFirst(dem, wire::tagTerms, forTerms);
  cfd = fromFirst(cfd, wire::tagTerms, forTerms);
  try {
    const auto all = wire::decodeVerdict(fromFirst(verdict, wire::tagVerdict, forVerdict));
    if (all.dem != wire::digest(dem) || all.cfd != wire::digest(cfd))
      throw wire::Damaged("the terms did not come in as they were sent");
    if (!all.line.empty()) {
      setStage(Stage::closed);
      throw Refusal(all.line);
    }
  } catch (const wire::Damaged& damage) {
    abandon(std::string("from this half's first rank: ") + damage.what());
  }
  return {decodeDem(dem), decodeCfd(cfd)};
}

std::vector<RankBoxes> decoded(const std::string& bytes, std::size_t ranks, const Box& mesh) {
  try {
    return wire::decodeBoxes(bytes, ranks, mesh);
  } catch (const wire::Damaged& damage) {
    abandon(std::string("the boxes of the CFD ranks: ") + damage.what());
  }
}

}  // namespace

BothTerms shakeHands(Half half, const std::string& myTerms) {
  const auto& world = World::instance();
  if (world.ready() && world.which() != half)
    throw std::logic_error(std::string("a session of the ") + name(half) +
                           " half in a program of the " + name(world.which()) + " half");
  if (!world.ready() || !world.hasOtherHalf())
    throw Refusal(std::string("started alone, ") + (half == Half::dem ? "no CFD" : "no DEM") +
                  " half is in this mpirun: a coupled run is `mpirun -np N liggghts-clay ... : "
                  "-np M clayFoam ...`");
  if (stage() == Stage::closed)
    throw Refusal("the coupled run is over: the other half has ended, none can begin");
  silenceLimit();
  std::string theirs;
  if (world.rank() == 0) theirs = swapped(myTerms, wire::tagTerms, forTerms);
  const bool dem = half == Half::dem;
  BothTerms both = settled(half, dem ? myTerms : theirs, dem ? theirs : myTerms);
  setStage(Stage::coupled);
  return both;
}

void shakeHandsAgain(Half half, const std::string& demTerms, BothTerms& both) {
  const auto& world = World::instance();
  std::string dem = demTerms;
  if (world.rank() == 0) {
    if (half == Half::dem)
      sendText(dem, world.remoteRanks()[0], wire::tagTerms, forTerms);
    else
      dem = receiveText(world.remoteRanks()[0], wire::tagTerms, forTerms);
  }
  both = settled(half, dem, encode(both.cfd));
}

void sendBoxes(const RankBoxes& mine, const Box& mesh) {
  const auto& world = World::instance();
  const int tag = wire::tagBoxes;
  if (world.rank() != 0) {
    sendText(wire::encodeBoxes({mine}), world.localRanks()[0], tag, forBoxes);
    return;
  }
  std::vector<RankBoxes> all{mine};
  for (int r = 1; r < world.size(); ++r) {
    const int rank = world.localRanks()[static_cast<std::size_t>(r)];
    all.push_back(decoded(receiveText(rank, tag, forBoxes), 1, mesh)[0]);
  }
  sendText(wire::encodeBoxes(all), world.remoteRanks()[0], tag, forBoxes);
}

std::vector<RankBoxes> receiveBoxes(const Box& mesh) {
  const auto& world = World::instance();
  std::string bytes;
  if (world.rank() == 0) bytes = receiveText(world.remoteRanks()[0], wire::tagBoxes, forBoxes);
  return decoded(fromFirst(bytes, wire::tagBoxes, forBoxes), world.remoteRanks().size(), mesh);
}

FieldSet stateFields(const BothTerms& both) {
  FieldSet set = both.cfd.needs;
  for (unsigned i = 0; i < fieldCount; ++i)
    if (both.dem.brings.has(static_cast<Field>(i))) set.add(static_cast<Field>(i));
  return set;
}

FieldSet answerFields(const BothTerms& both) {
  // what a CFD half offers only when its models have it
  const FieldSet ifOffered{Field::force, Field::addedMass, Field::turnCoefficient,
                           Field::fluidSpin};
  FieldSet set;
  for (unsigned i = 0; i < fieldCount; ++i) {
    const auto f = static_cast<Field>(i);
    if (both.cfd.offers.has(f) && (both.dem.needs.has(f) || ifOffered.has(f))) set.add(f);
  }
  return set;
}

}  // namespace clay
