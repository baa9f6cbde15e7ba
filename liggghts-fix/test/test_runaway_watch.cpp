// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "atom.h"
#include "host.h"
#include "coupling/runaway_watch.h"
#include "update.h"

using LAMMPS_NS::RunawayWatch;
using test::Host;

namespace {

// throws in place of ending the program
class Throwing : public RunawayWatch {
 public:
  using RunawayWatch::RunawayWatch;

 protected:
  void end(const std::string &text) { throw std::runtime_error(text); }
};

// what the watch says; empty when all is well
template <class Look>
std::string said(Look look)
{
  try {
    look();
  } catch (const std::runtime_error &e) {
    return e.what();
  }
  return "";
}

void expect(const std::string &text, const std::string &part) { EXPECT_NE(text.find(part), std::string::npos) << text; }

// one sphere above a floor, at rest
void place(Host &host)
{
  host(test::opening("f f f", "-0.01 0.01 -0.01 0.01 -0.01 0.01") +
       "fix p1 all property/global kn peratomtypepair 2 5000 5000 5000 5000\n"
       "fix p2 all property/global kt peratomtypepair 2 5000 5000 5000 5000\n"
       "fix p3 all property/global gamman peratomtypepair 2 4000 4000 4000 4000\n"
       "fix p4 all property/global gammat peratomtypepair 2 4000 4000 4000 4000\n"
       "fix p5 all property/global coefficientFriction peratomtypepair 2 0.5 0.5 0.5 0.5\n"
       "pair_style gran model hooke/stiffness tangential history\npair_coeff * *\n"
       "create_atoms 1 single 0 0 0 units box\nset group all diameter 2e-3\nset group all density 2600\n"
       "fix floor all wall/gran model hooke/stiffness tangential history primitive type 1 zplane -0.009\n"
       "fix nve all nve/sphere\ntimestep 1e-5\nrun 0\n");
}

}  // namespace

TEST(RunawayWatch, letsPassWhatIsWell)
{
  Host host(MPI_COMM_SELF);
  place(host);
  Throwing watch(host.lmp.get());
  watch.start();
  host.lmp->atom->v[0][0] = 199;  // m/s: a diameter in a step is 200
  watch.step();
  watch.places();
  host.lmp->atom->x[0][2] = -0.009 + 0.0005;  // a quarter of d deep
  watch.overlaps(0.39, 1, 2);
  EXPECT_NEAR(watch.wall_overlap(), 0.25, 1e-9);
}

TEST(RunawayWatch, namesTheParticleAndSinceWhen)
{
  Host host(MPI_COMM_SELF);
  place(host);
  double *x = host.lmp->atom->x[0], *v = host.lmp->atom->v[0];
  Throwing watch(host.lmp.get());
  watch.start();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto step = [&]() { watch.step(); };
  const auto places = [&]() { watch.places(); };

  host.lmp->update->ntimestep = 20;
  v[0] = 201;
  expect(said(step), "particle 1 moves more than its diameter in a step at step 20");
  expect(said(step), "last check passed at step 0");
  v[0] = nan;
  expect(said(step), "particle 1 is NaN");
  v[0] = 0;
  EXPECT_EQ(said(step), "");
  x[1] = 0.0101;
  expect(said(places), "particle 1 was pushed out of the box");
  expect(said(places), "last check passed at step 20");
  watch.last_words("; the last saved state is that of step 12");
  expect(said(places), "may help; the last saved state is that of step 12");
  expect(said([&] { watch.overlaps(0.5, 1, 2); }), "stiffness; the last saved state is that of step 12");
  // unless it has left the fluid before
  EXPECT_EQ(said([&] { watch.places([](int) { return true; }); }), "");
  x[1] = nan;
  expect(said(places), "particle 1 is NaN");
  x[1] = 0;
  expect(said([&]() { watch.overlaps(0.41, 7, 9); }), "particles 7 and 9 overlap by 0.41 d");
  x[2] = -0.009 + 0.0001;
  expect(said([&]() { watch.overlaps(0, 0, 0); }), "is pressed 0.45 d into the wall of fix floor");
  host.lmp->update->ntimestep = 0;
}

TEST(RunawayWatch, aWallHoldsItsGroupAlone)
{
  Host host(MPI_COMM_SELF);
  place(host);
  host("group none type 2\nfix lid none wall/gran model hooke/stiffness tangential history "
       "primitive type 1 zplane 0.0001\nrun 0\n");
  Throwing watch(host.lmp.get());
  watch.start();
  watch.overlaps(0, 0, 0);
  EXPECT_EQ(watch.wall_overlap(), 0);
}

TEST(RunawayWatch, leavesSpheresAloneThatNothingMoves)
{
  Host host(MPI_COMM_SELF);
  place(host);
  host.lmp->atom->x[0][2] = -0.009;  // half of it in the floor
  Throwing moved(host.lmp.get());
  moved.start();
  expect(said([&]() { moved.overlaps(0, 0, 0); }), "into the wall");
  host("unfix nve\n");
  Throwing held(host.lmp.get());
  held.start();
  EXPECT_EQ(said([&]() { held.overlaps(0, 0, 0); }), "");
}
