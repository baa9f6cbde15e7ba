// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file test_adopt_half.cpp
/// Either half as a host code that splits the world by itself, so that it needs
/// no wrappers. Arguments: dem or cfd, the colour of its ranks, and
/// perhaps another half that it says it is.
#include "exchange/test_halves.h"

using clay::Field;

namespace {

// One particle a rank, in the middle of the mesh: shared by CFD ranks at cuts
void demHalf() {
  clay::DemSession session(halves::demTerms());
  clay::Particles particles(halves::demTerms().offers), answer;
  particles.resize(1);
  particles[Field::radius][0] = 0.01;
  for (int c = 0; c < 3; ++c) particles[Field::position][c] = 0.5 * halves::size[c];
  particles[Field::tag][0] = clay::World::instance().rank() + 1;
  for (int k = 0; k < 2; ++k) {
    session.send(particles, halves::timeOf(k), k == 1, {0, 0, 0});
    session.receive(answer);
    halves::expect(answer[Field::dragCoefficient][0] == particles[Field::tag][0], "the answer");
  }
  session.close();
}

void cfdHalf() {
  const auto& world = clay::World::instance();
  clay::CfdSession session(halves::cfdTerms(), {halves::slab(world.rank(), world.size())});
  clay::Particles particles;
  while (session.next(particles) == clay::CfdSession::Event::state) {
    const std::size_t n = static_cast<std::size_t>(particles.size());
    clay::Particles answers(session.sends());
    answers.resize(particles.size());
    std::copy(particles[Field::tag], particles[Field::tag] + n, answers[Field::dragCoefficient]);
    session.answer(answers, session.own(std::vector<double>(n, 0.)));
  }
  session.close();
}

}  // namespace

int main(int argc, char** argv) {
  const bool dem = std::string(argv[1]) == "dem";
  MPI_Init(&argc, &argv);
  MPI_Comm half;
  int rank = 0, one = 1, done = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_split(MPI_COMM_WORLD, std::atoi(argv[2]), rank, &half);
  const std::string says = argv[argc > 3 ? 3 : 1];
  clay::World::instance().adopt(half, says == "dem" ? clay::Half::dem : clay::Half::cfd);
  dem ? demHalf() : cfdHalf();
  MPI_Reduce(&one, &done, 1, MPI_INT, MPI_SUM, 0, MPI_COMM_WORLD);
  if (rank == 0) std::printf("%d ranks are done\n", done);
  MPI_Comm_free(&half);
  MPI_Finalize();
  return 0;
}
