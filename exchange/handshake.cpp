// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/handshake.h"

#include <cstring>
#include <stdexcept>

#include "exchange/shutdown.h"
#include "exchange/waiting.h"
#include "exchange/wire.h"

namespace clay {

namespace {

constexpr const char* forTerms = "the other half's terms";
constexpr const char* forBoxes = "the boxes of the CFD ranks";

// The first rank's text on every rank of this half
std::string fromFirst(const std::string& text, int tag, const char* forWhat) {
  const auto& world = World::instance();
  if (world.rank() != 0) return receiveText(world.localRanks()[0], tag, forWhat);
  for (int r = 1; r < world.size(); ++r)
    sendText(text, world.localRanks()[static_cast<std::size_t>(r)], tag, forWhat);
  return text;
}

// Their number and they
std::string pack(const RankBoxes& boxes) {
  const std::size_t n = boxes.size();
  return std::string(reinterpret_cast<const char*>(&n), sizeof n) +
         std::string(reinterpret_cast<const char*>(boxes.data()), n * sizeof(Box));
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
  const int tag = wire::tagTerms;
  std::string theirs;
  if (world.rank() == 0) {
    // both halves send first: the message must be under way before the wait
    std::vector<MPI_Request> request(1);
    PMPI_Isend(myTerms.data(), static_cast<int>(myTerms.size()), MPI_CHAR, world.remoteRanks()[0],
               tag, world.whole(), &request[0]);
    theirs = receiveText(world.remoteRanks()[0], tag, forTerms);
    waitUntil([&] { return allDone(request); }, forTerms);
  }
  const std::string mine = fromFirst(myTerms, tag, forTerms);
  theirs = fromFirst(theirs, tag, forTerms);
  BothTerms both;
  try {
    both.dem = decodeDem(half == Half::dem ? mine : theirs);
    both.cfd = decodeCfd(half == Half::cfd ? mine : theirs);
  } catch (const Refusal&) {
    setStage(Stage::closed);
    throw;
  }
  agree(both.dem, both.cfd);
  setStage(Stage::coupled);
  return both;
}

void agree(const DemTerms& dem, const CfdTerms& cfd) {
  const std::string line = disagreement(dem, cfd);
  if (line.empty()) return;
  setStage(Stage::closed);
  throw Refusal(line);
}

void sendBoxes(const RankBoxes& mine) {
  const auto& world = World::instance();
  const int tag = wire::tagBoxes;
  if (world.rank() != 0) {
    sendText(pack(mine), world.localRanks()[0], tag, forBoxes);
    return;
  }
  std::string all = pack(mine);
  for (int r = 1; r < world.size(); ++r)
    all += receiveText(world.localRanks()[static_cast<std::size_t>(r)], tag, forBoxes);
  sendText(all, world.remoteRanks()[0], tag, forBoxes);
}

std::string shareText(const std::string& text) { return fromFirst(text, wire::tagTerms, forTerms); }

std::string receiveFromOtherHalf(int tag, const char* forWhat) {
  const auto& world = World::instance();
  std::string text;
  if (world.rank() == 0) text = receiveText(world.remoteRanks()[0], tag, forWhat);
  return fromFirst(text, tag, forWhat);
}

std::vector<RankBoxes> receiveBoxes() {
  const std::string text = receiveFromOtherHalf(wire::tagBoxes, forBoxes);
  std::vector<RankBoxes> all;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t n = 0;
    std::memcpy(&n, text.data() + at, sizeof n);
    at += sizeof n;
    all.emplace_back(n);
    std::memcpy(all.back().data(), text.data() + at, n * sizeof(Box));
    at += n * sizeof(Box);
  }
  return all;
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
