// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "fix.h"
#include "fix_property_atom.h"
#include "host.h"

using test::Host;

namespace {

const char *const STIFFNESS = "hooke/stiffness", *const HOOKE = "hooke", *const HERTZ = "hertz";

/// Spheres thrown into a tube with a floor; a wall of each shape, by the given style and model.
std::string thrown(const std::string &wall, const std::string &law, const std::string &more = "",
                   const std::string &friction = "history")
{
  std::ostringstream s;
  s.precision(17);
  s << test::opening("f f f", "-0.01 0.01 -0.01 0.01 0 0.04")
    << "fix m1 all property/global kn peratomtypepair 2 3000. 2500. 2500. 2000.\n"
       "fix m2 all property/global kt peratomtypepair 2 2000. 1500. 1500. 1200.\n"
       "fix m3 all property/global gamman peratomtypepair 2 2000. 1500. 1500. 1000.\n"
       "fix m4 all property/global gammat peratomtypepair 2 1000. 1200. 1200. 800.\n"
       "fix m5 all property/global coefficientFriction peratomtypepair 2 0.5 0.3 0.3 0.1\n"
       "fix m6 all property/global youngsModulus peratomtype 1.e7 8.e6\n"
       "fix m7 all property/global poissonsRatio peratomtype 0.45 0.3\n"
       "fix m8 all property/global coefficientRestitution peratomtypepair 2 0.7 0.6 0.6 0.5\n"
       "fix m9 all property/global characteristicVelocity scalar 0.1\n"
       "fix m10 all property/global coefficientRollingFriction peratomtypepair 2 0.2 0.1 0.1 0.05\n"
       "fix m11 all property/global cohesionEnergyDensity peratomtypepair 2 3e3 1e4 1e4 3e4\n"
       "pair_style gran model hooke/stiffness tangential history\npair_coeff * *\n";
  std::mt19937 random(5);
  std::uniform_real_distribution<double> side(-5e-3, 5e-3), up(1e-3, 8e-3), speed(-0.4, 0.4), size(1.2e-3, 2e-3);
  for (int i = 1; i <= 40; i++)
    s << "create_atoms " << 1 + i % 2 << " single " << side(random) << ' ' << side(random) << ' ' << up(random)
      << " units box\n"
      << "set atom " << i << " diameter " << size(random) << "\nset atom " << i << " density 2600\n"
      << "group one id " << i << "\nvelocity one set " << speed(random) << ' ' << speed(random) << ' ' << speed(random)
      << " units box\ngroup one delete\n";
  const std::string model = " all " + wall + " model " + law + " tangential " + friction + " primitive type ";
  s << "fix nve all nve/sphere\nfix grav all gravity 9.81 vector 0 0 -1\n"
    << "fix floor" << model << "1 zplane 0. " << more << "\nfix side" << model << "2 zcylinder 0.007 0. 0. " << more
    << "\nfix xl" << model << "1 xplane -0.006 " << more << "\ntimestep 2e-6\n";
  return s.str();
}

// unlike rounding grows from contact to contact: few steps show the law, more of them its use
void same(const std::string &law, const std::string &more, const std::string &friction, int steps, double x_gate,
          double v_gate, double f_gate)
{
  Host stock, lean;
  const std::string run = "run " + std::to_string(steps) + "\n";
  stock(thrown("wall/gran", law, more, friction) + run);
  lean(thrown("wall/gran/lean", law, more, friction) + run);
  const auto a = stock.atoms(), b = lean.atoms();
  ASSERT_EQ(a.size(), b.size());
  double x = 0, v = 0, f = 0, most = 0, turn = 0, most_turn = 1e-30;
  for (std::size_t i = 0; i < a.size(); i++)
    for (int d = 0; d < 3; d++) {
      x = std::max(x, std::abs(a[i].x[d] - b[i].x[d]));
      v = std::max(v, std::abs(a[i].v[d] - b[i].v[d]));
      f = std::max(f, std::abs(a[i].f[d] - b[i].f[d]));
      most = std::max(most, std::abs(a[i].f[d]));
      turn = std::max(turn, std::abs(a[i].torque[d] - b[i].torque[d]));
      most_turn = std::max(most_turn, std::abs(a[i].torque[d]));
    }
  EXPECT_LT(x, x_gate);
  EXPECT_LT(v, v_gate);
  EXPECT_LT(f, f_gate * most);
  EXPECT_LT(turn, f_gate * most_turn);
  double contacts = lean.fix("floor")->compute_vector(1) + lean.fix("side")->compute_vector(1), all;
  MPI_Allreduce(&contacts, &all, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  EXPECT_GT(all, 100);
}

void same(const std::string &law, const std::string &more, const std::string &friction = "history")
{
  same(law, more, friction, 200, 1e-16, 1e-12, 1e-13);
  same(law, more, friction, 1000, 1e-13, 1e-9, 1e-6);
}

}  // namespace

TEST(FixWallGranLean, pushesAsStockDoes) { same(STIFFNESS, ""); }

TEST(FixWallGranLean, takesTheModelsSwitches) { same(STIFFNESS, "tangential_damping off limitForce on"); }

TEST(FixWallGranLean, takesModulusAndRestitution)
{
  same(HOOKE, "");
  same(HOOKE, "tangential_damping off ktToKnUser on");
}

TEST(FixWallGranLean, takesHertz)
{
  same(HERTZ, "");
  same(HERTZ, "tangential_damping off limitForce on");
  same("hertz/stiffness", "");
}

TEST(FixWallGranLean, takesFrictionWithoutHistory)
{
  for (const char *law : {STIFFNESS, HERTZ})
    for (const char *friction : {"no_history", "off"}) same(law, "", friction);
}

TEST(FixWallGranLean, takesRollingFrictionAndCohesion)
{
  const auto few = [](const std::string &law, const std::string &more, const std::string &friction) {
    SCOPED_TRACE(law + " " + friction + " " + more);
    same(law, more, friction, 100, 1e-16, 1e-12, 1e-13);
    same(law, more, friction, 1000, 1e-13, 1e-9, 1e-6);
  };
  for (const char *law : {HOOKE, HERTZ}) {
    few(law, "", "history rolling_friction cdt");
    few(law, "", "no_history rolling_friction epsd2");
    few(law, "", "history cohesion sjkr");
    few(law, "torsionTorque on tangential_reduce on", "history cohesion sjkr rolling_friction epsd2");
    few(law, "torsionTorque on", "history rolling_friction cdt");
  }
}

TEST(FixWallGranLean, keepsDisplacementsWhereStockDoes)
{
  // so that a restart may go on with either
  double size[2] = {0, 0};
  const char *styles[2] = {"wall/gran", "wall/gran/lean"};
  for (int h = 0; h < 2; h++) {
    Host host;
    host(thrown(styles[h], STIFFNESS));
    double sum = 0;
    for (int part = 0; part < 10; part++) {
      host("run 200\n");
      for (const char *wall : {"history_floor", "history_side", "history_xl"}) {
        auto *kept = dynamic_cast<LAMMPS_NS::FixPropertyAtom *>(host.fix(wall));
        ASSERT_TRUE(kept);
        for (int i = 0; i < host.lmp->atom->nlocal; i++)
          for (int d = 0; d < 3; d++) sum += std::abs(kept->array_atom[i][d]);
      }
    }
    MPI_Allreduce(&sum, &size[h], 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  }
  EXPECT_GT(size[0], 1e-7);
  EXPECT_NEAR(size[1], size[0], 1e-8 * size[0]);
}
