// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file test_dem_half.cpp
/// A DEM half for the test runs: random particles, whose answers are known.
#include <random>

#include "exchange/test_halves.h"

using clay::Field;

const clay::Half clay::programHalf = clay::Half::dem;

namespace {

// Particles of this rank at exchange k; none on rank 1, all in one corner at k = 2
void fill(clay::Particles& p, int rank, int k) {
  std::mt19937 random(static_cast<unsigned>(100 * k + rank + 1));
  std::uniform_real_distribution<double> any(0, 1);
  const int n = rank == 1 ? 0 : 150 + 40 * k + 10 * rank;
  p.resize(n);
  for (int i = 0; i < n; ++i) {
    for (int c = 0; c < 3; ++c) {
      p[Field::position][3 * i + c] = halves::size[c] * any(random) * (k == 2 ? 0.05 : 1);
      p[Field::velocity][3 * i + c] = any(random);
      p[Field::impulse][3 * i + c] = any(random);
    }
    p[Field::radius][i] = 0.005 + 0.015 * any(random);
    p[Field::volume][i] = any(random);
    p[Field::mass][i] = any(random);
    p[Field::tag][i] = 1000 * rank + i + 1;
    p[Field::body][i] = -1;
  }
}

void check(const clay::Particles& p, const clay::Particles& answer, int k) {
  halves::expect(answer.size() == p.size(), "an answer for every particle");
  for (int i = 0; i < p.size(); ++i) {
    if (p[Field::position][3 * i] > 1.1) {
      for (int c = 0; c < 3; ++c)
        halves::expect(answer[Field::fluidVelocity][3 * i + c] == 0 &&
                           answer[Field::force][3 * i + c] == 0 &&
                           answer[Field::dragCoefficient][i] == 0,
                       "beyond an open side there is no fluid");
      continue;
    }
    const double tag = p[Field::tag][i];
    halves::expect(answer[Field::dragCoefficient][i] == 3 * tag, "answers in order");
    for (int c = 0; c < 3; ++c)
      halves::expect(answer[Field::fluidVelocity][3 * i + c] ==
                         2 * p[Field::position][3 * i + c] + p[Field::velocity][3 * i + c],
                     "the answer's vector in order");
    halves::expect(answer[Field::force][3 * i] == k, "the answer of this exchange");
  }
}

void run(clay::DemSession& session, const std::string& scenario, int first) {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  clay::FieldSet all = halves::demTerms().offers;
  clay::Particles particles(all), answer;
  for (int k = first; k < first + halves::exchanges; ++k) {
    if (k == 3) halves::dieAs(scenario, "dem");
    if (k == 3 && rank == 0) halves::dieAs(scenario, "dem0");
    if (session.asked())
      clay::abandon("asked to end by signal " + std::to_string(session.asked()) + " on rank " +
                    std::to_string(rank));
    fill(particles, rank, k);
    const bool out = (scenario == "lost" || scenario == "leaves") && k == 3 && rank == 0;
    if (out) particles[Field::position][3 * 17] = 1.5;
    session.send(particles, halves::timeOf(k), k == first + halves::exchanges - 1,
                 {double(particles.size()), double(k), double(rank)});
    if (k % 2)
      while (!session.answered()) usleep(50);
    session.receive(answer);
    check(particles, answer, k);
    halves::expect(session.away() == out, "those beyond an open side are counted");
    MPI_Barrier(MPI_COMM_WORLD);  // as a DEM code's ranks wait for each other
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::string scenario = argv[1];
  const int ranks = argc > 2 ? std::atoi(argv[2]) : 1;
  MPI_Init(&argc, &argv);
  halves::expectOwnWorld(ranks);
  if (scenario.rfind("before:", 0) == 0) halves::dieAs(scenario.substr(7), "dem");
  auto terms = halves::demTerms();
  if (scenario == "refused") terms.endTime += 1;
  int status = 0;
  try {
    clay::DemSession session(terms);
    halves::expect(session.sends() == halves::stateFields(),
                   "needed fields and no others are sent");
    halves::expect(session.receives() == halves::cfdTerms().offers, "the force is received");
    run(session, scenario, 0);
    if (scenario == "resume" || scenario == "resumeRefused") {
      terms.startTime = terms.endTime;
      terms.endTime = halves::timeOf(2 * halves::exchanges - 1);
      if (scenario == "resumeRefused") terms.gravity = {0, 0, -1};
      session.resume(terms);
      run(session, scenario, halves::exchanges);
    }
    if (scenario != "noClose") session.close();
    halves::expect(session.timing().exchanges >= halves::exchanges, "exchanges are counted");
    halves::expect(session.timing().exchange > 0 && session.timing().bytesSent > 0,
                   "time and bytes are counted");
    std::printf("DEM half done after %ld exchanges\n", session.timing().exchanges);
  } catch (const clay::Refusal& e) {
    std::fprintf(stderr, "DEM half: %s\n", e.what());
    status = 2;
  }
  MPI_Finalize();
  return status;
}
