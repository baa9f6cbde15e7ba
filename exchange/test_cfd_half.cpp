// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file test_cfd_half.cpp
/// A CFD half for the test runs: checks what comes in, answers what is known.
#include "exchange/test_halves.h"

using clay::Field;

const clay::Half clay::programHalf = clay::Half::cfd;

namespace {

struct Holders {
  int count = 0;
  double sum = 0;  // of 0.1 (rank + 1), in the order of the ranks
  int centre = -1;
  int lowest = -1;
};

Holders holders(const double* x, double r, int ranks) {
  Holders h;
  for (int rank = 0; rank < ranks; ++rank) {
    const clay::Box box = halves::slab(rank, ranks);
    if (!box.reaches(x, r)) continue;
    ++h.count;
    h.sum += 0.1 * (rank + 1);
    if (h.lowest < 0) h.lowest = rank;
    if (x[0] >= box.lo[0] && (x[0] < box.hi[0] || rank == ranks - 1)) h.centre = rank;
  }
  return h;
}

void step(clay::CfdSession& session, const clay::Particles& p, int k, bool lost) {
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const int n = p.size();
  halves::expect(std::fabs(session.time() - halves::timeOf(k)) < 1e-12, "the state's time");
  const double interval = k == 0 ? 0 : halves::timeOf(1);
  halves::expect(std::fabs(session.interval() - interval) < 1e-12, "the state's interval");
  halves::expect(session.last() == (k % halves::exchanges == halves::exchanges - 1),
                 "the last state");

  std::vector<double> sums(2 * static_cast<std::size_t>(n)), claims, same;
  for (int i = 0; i < n; ++i) {
    sums[2 * i] = 1;
    sums[2 * i + 1] = 0.1 * (rank + 1);
    same.push_back(7);
  }
  session.sumShared(sums, 2);
  std::vector<Holders> known;
  for (int i = 0; i < n; ++i) {
    known.push_back(holders(p[Field::position] + 3 * i, p[Field::radius][i], ranks));
    const bool outside = p[Field::position][3 * i] > 1.1;
    halves::expect(outside == (known[i].count == 0), "a particle comes where it touches");
    halves::expect(!outside || lost, "particles lie inside the mesh");
    claims.push_back(known[i].centre == rank ? 0 : 1e300);
    if (outside) continue;
    halves::expect(sums[2 * i] == known[i].count, "number of holders");
    halves::expect(sums[2 * i + 1] == known[i].sum, "sum over the holders, bit by bit");
  }
  const auto lowest = session.own(same);
  const auto owned = session.own(claims);
  long mine = 0, all = 0;
  for (int i = 0; i < n; ++i) {
    if (known[i].count > 0)
      halves::expect(lowest[i] == (known[i].lowest == rank), "ties: the lowest");
    halves::expect(owned[i] == (known[i].centre == rank), "the owner has the smallest claim");
    mine += owned[i];
  }
  MPI_Allreduce(&mine, &all, 1, MPI_LONG, MPI_SUM, MPI_COMM_WORLD);
  if (!lost)
    halves::expect(all == std::lround(session.impulse()[0]), "each particle is owned once");

  clay::Particles answers(session.sends());
  answers.resize(n);
  for (int i = 0; i < n; ++i) {
    answers[Field::dragCoefficient][i] = 3 * p[Field::tag][i];
    for (int c = 0; c < 3; ++c)
      answers[Field::fluidVelocity][3 * i + c] =
          2 * p[Field::position][3 * i + c] + p[Field::velocity][3 * i + c];
    answers[Field::force][3 * i] = k;
  }
  session.answer(answers, owned);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string scenario = argv[1];
  const int ranks = argc > 2 ? std::atoi(argv[2]) : 1;
  clay::World::init(argc, argv);
  halves::expectOwnWorld(ranks);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (scenario.rfind("before:", 0) == 0) halves::dieAs(scenario.substr(7), "cfd");
  clay::onShutdown([rank](const std::string& reason) {
    const char* slowness = std::getenv("TEST_SAVE_SECONDS");
    if (slowness) sleep(static_cast<unsigned>(std::atoi(slowness)));
    std::printf("CFD rank %d saved its state: %s\n", rank, reason.c_str());
  });
  auto terms = halves::cfdTerms();
  terms.gravity = {{0, 0, -9.81}};
  terms.open[1] = scenario == "leaves";
  if (scenario == "refused") terms.endTime = halves::demTerms().endTime;
  int status = 0, k = 0;
  try {
    clay::CfdSession session(terms, {halves::slab(rank, ranks)});
    clay::Particles particles;
    for (bool open = true; open;) {
      switch (session.next(particles)) {
        case clay::CfdSession::Event::state:
          if (k == 3) halves::dieAs(scenario, "cfd");
          if (k == 3 && rank == 0) halves::dieAs(scenario, "cfd0");
          if (k == 2 && scenario == "asked") session.askStop(SIGTERM);
          if (k == 3 && scenario == "asked") session.askStop(SIGINT);
          step(session, particles, k++, scenario == "lost" || scenario == "leaves");
          break;
        case clay::CfdSession::Event::resumed:
          halves::expect(k == halves::exchanges, "a further run after the last state");
          halves::expect(session.remoteTerms().endTime == halves::timeOf(2 * halves::exchanges - 1),
                         "the further run's end");
          break;
        case clay::CfdSession::Event::closed:
          open = false;
      }
    }
    session.close();
    halves::expect(session.timing().exchanges == k, "exchanges are counted");
    std::printf("CFD half done after %d exchanges\n", k);
  } catch (const clay::Refusal& e) {
    std::fprintf(stderr, "CFD half: %s\n", e.what());
    status = 2;
  }
  if (scenario == "noFinalize") return status;
  MPI_Finalize();
  return status;
}
