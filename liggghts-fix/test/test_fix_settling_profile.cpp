// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>

#include "host.h"
#include "settling/shared_clusters.h"
#include "settling/fix_settling_profile.h"
#include "update.h"

using clay::ColumnProfile;
using test::Host;

namespace {

const char *name = "profile_test.csv";

typedef std::map<std::string, std::vector<double>> Table;

Table table(const std::string &file)
{
  Table columns;
  std::vector<std::string> keys;
  std::ifstream in(file);
  std::string line, word;
  std::getline(in, line);
  for (std::istringstream words(line); std::getline(words, word, ',');) keys.push_back(word);
  while (std::getline(in, line)) {
    std::istringstream words(line);
    for (const std::string &key : keys) {
      std::getline(words, word, ',');
      columns[key].push_back(std::stod(word));
    }
  }
  return columns;
}

// styles: of the pair and of walls; bodies: commands that make them
struct Bed {
  std::string pair, wall, bodies;
  double radius = 0.008;  // of the tube [m]
};

// a narrow tube with rough walls, in which bodies fall through a thick fluid until they are at rest
std::string bed(const Bed &b, const std::string &more, int steps)
{
  const std::string model = " model hooke/stiffness tangential history ";
  std::ostringstream s;
  s << test::opening("f f f", "-0.01 0.01 -0.01 0.01 -0.002 0.08") << "region ins cylinder z 0 0 " << b.radius
    << " 0.0 0.05 units box\n"
       "fix m1 all property/global kn peratomtypepair 2 400 400 400 400\n"
       "fix m2 all property/global kt peratomtypepair 2 400 400 400 400\n"
       "fix m3 all property/global gamman peratomtypepair 2 900 900 900 900\n"
       "fix m4 all property/global gammat peratomtypepair 2 900 900 900 900\n"
       "fix m5 all property/global coefficientFriction peratomtypepair 2 0.4 0.4 0.4 0.4\n"
    << "pair_style hybrid/overlay " << b.pair << model << " coul/clump 0.006\npair_coeff * * " << b.pair << "\n"
    << "pair_coeff 1 1 coul/clump 2e-10\npair_coeff 2 2 coul/clump -2e-10\n"
    << "fix g all gravity 9.81 vector 0 0 -1\n"
    << "fix w1 all " << b.wall << model << "primitive type 1 zplane 0.0\n"
    << "fix w2 all " << b.wall << model << "primitive type 1 zcylinder " << b.radius << " 0. 0.\n"
    << b.bodies << "fix drag all viscous 3e-4\ntimestep 1e-5\n"
    << more << "run " << steps << "\n";
  return s.str();
}

const std::string grains =
    "fix t1 all particletemplate/sphere 15485863 atom_type 1 density constant 2600 radius constant 1e-3\n"
    "fix t2 all particletemplate/sphere 15485867 atom_type 2 density constant 2600 radius constant 0.8e-3\n"
    "fix pdd all particledistribution/discrete 32452843 2 t1 0.5 t2 0.5\n"
    "fix ins all insert/pack seed 49979687 distributiontemplate pdd insert_every once overlapcheck yes all_in yes "
    "maxattempt 400 vel constant 0 0 -0.1 region ins particles_in_region 120 ntry_mc 10000\nfix nve all nve/sphere\n";

std::string profile(int every, const std::string &more = "")
{
  return "fix p all settling/profile " + std::to_string(every) + " file " + name + " " + more + "\n";
}

LAMMPS_NS::FixSettlingProfile &fix(Host &host) { return *dynamic_cast<LAMMPS_NS::FixSettlingProfile *>(host.fix("p")); }

}  // namespace

// at every height contacts, charges and walls carry the weight above; the walls take part of it
TEST(FixSettlingProfile, aBedAtRestCarriesTheWeightAbove)
{
  if (test::processors() > 1) GTEST_SKIP() << "beds take long to come to rest; two see what one does, below";
  const Bed beds[] = {{"gran", "wall/gran", grains, 0.0036},
                      {"gran/lean", "wall/gran/lean", grains, 0.0036},
                      {"gran", "wall/gran", test::clumps(14)},
                      {"gran/lean", "wall/gran/lean", test::clumps(14)}};
  for (const Bed &b : beds) {
    {
      Host host;
      host(bed(b, profile(5000, "bins 40"), 50000));
      EXPECT_LT(host.fix("p")->compute_vector(0), 0.01) << b.pair << b.bodies.substr(0, 12);
      EXPECT_GT(host.fix("p")->compute_vector(1), 5);
    }
    MPI_Barrier(MPI_COMM_WORLD);
    const Table t = table(name);
    const std::size_t last = t.at("time_s").size() - 40;
    const double thickness = 0.08 / 40;
    double whole = 0, walls = 0, charges = 0, solids = 0, levers = 0, held = 0;
    for (int k = 0; k < 40; k++) {
      whole = std::max(whole, t.at("weight_Pa")[last + k]);
      walls = std::max(walls, t.at("wall_Pa")[last + k]);
      charges = std::max(charges, std::abs(t.at("coulomb_Pa")[last + k]));
      solids += t.at("solid_fraction")[last + k] * thickness;
      levers += t.at("solid_fraction")[last + k] * thickness * t.at("height_m")[last + k];
      held += t.at("weight_Pa")[last + k] * thickness;
      const double carried = t.at("contact_Pa")[last + k] + t.at("coulomb_Pa")[last + k] + t.at("wall_Pa")[last + k];
      EXPECT_NEAR(carried, t.at("weight_Pa")[last + k], 0.01 * t.at("weight_Pa")[last]) << k;
    }
    // summed over the height, the weight above is that of all times its mean height
    EXPECT_NEAR(held, levers * 2600 * 9.81, 0.01 * held);
    EXPECT_LT(whole, 1.001 * solids * 2600 * 9.81);
    if (b.bodies == grains) EXPECT_GT(walls, 0.03 * whole);
    EXPECT_GT(charges, 1e-3 * whole);
    MPI_Barrier(MPI_COMM_WORLD);
  }
  std::remove(name);
}

// what is measured changes nothing
TEST(FixSettlingProfile, leavesTheRunAsItWas)
{
  for (const char *lean : {"", "/lean"}) {
    const Bed b = {std::string("gran") + lean, std::string("wall/gran") + lean, test::clumps(12)};
    Host with, without;
    with(bed(b, profile(7), 3000));
    without(bed(b, "", 3000));
    const auto x = with.atoms(), y = without.atoms();
    ASSERT_EQ(x.size(), y.size());
    for (std::size_t i = 0; i < x.size(); i++)
      for (int d = 0; d < 3; d++) {
        EXPECT_EQ(x[i].x[d], y[i].x[d]) << lean << i;
        EXPECT_EQ(x[i].f[d], y[i].f[d]) << lean << i;
      }
  }
  std::remove(name);
}

// three spheres in a stack that carry each other, by hand: overlaps of 10, 20 and 30 um
TEST(FixSettlingProfile, aStackByHand)
{
  for (const char *lean : {"", "/lean"}) {
    Host host;
    const double z1 = 1e-3 - 3e-5, z2 = z1 + 2e-3 - 2e-5, z3 = z2 + 2e-3 - 1e-5;
    std::ostringstream s;
    s.precision(15);
    for (double z : {z1, z2, z3}) s << "create_atoms 1 single 0 0 " << z << " units box\n";
    host(bed({std::string("gran") + lean, std::string("wall/gran") + lean,
              s.str() + "set group all diameter 2e-3 density 2600\nfix nve all nve/sphere\n"},
             "pair_coeff 1 1 coul/clump 0\npair_coeff 2 2 coul/clump 0\n" + profile(1, "bins 80 fluid_density 1000"),
             0));
    if (test::processors() == 1) {
      const ColumnProfile &p = fix(host).profile();
      // slices of 1 mm: the lowest has planes below and above the first centre
      const double m = 1600 * 4.0 / 3 * M_PI * 1e-9 * 9.81, part = z1 / 1e-3;
      EXPECT_NEAR(p.get(ColumnProfile::CONTACT, 0), 400 * (3e-5 * part + 2e-5 * (1 - part)), 1e-9) << lean;
      EXPECT_NEAR(p.get(ColumnProfile::CONTACT, 1), 400 * 2e-5, 1e-9) << lean;
      EXPECT_NEAR(p.get(ColumnProfile::CONTACT, 3), 400 * 1e-5, 1e-9) << lean;
      EXPECT_NEAR(p.get(ColumnProfile::WEIGHT, 1), 2 * m, 1e-9 * m);
      EXPECT_NEAR(p.get(ColumnProfile::WEIGHT, 3), m, 1e-9 * m);
      EXPECT_EQ(p.get(ColumnProfile::CONTACTS, 0), 1);
      EXPECT_EQ(p.get(ColumnProfile::CONTACTS, 2), 2);
      EXPECT_EQ(p.get(ColumnProfile::TOUCHING, 2), 3);
      EXPECT_EQ(p.get(ColumnProfile::AXES, 2), 0);
    }
    EXPECT_EQ(host.fix("p")->compute_vector(1), 3);
  }
  std::remove(name);
}

// what slides is held by friction alone: as in the step itself, not with the damping of a contact that holds
TEST(FixSettlingProfile, slidingContacts)
{
  for (const char *lean : {"", "/lean"}) {
    const auto slid = [lean](double x, double more) {
      Host host;
      std::ostringstream s;
      s.precision(15);
      s << "create_atoms 1 single " << x << " 0 0.02 units box\n";
      if (more > 0) s << "create_atoms 2 single " << x - more << " 0 0.0202 units box\n";
      s << "set group all diameter 2e-3 density 2600\nfix nve all nve/sphere\ngroup one type 1\n"
           "velocity one set "
        << (more > 0 ? 0.05 : -0.05) << " 0 -0.5 units box\nfix push one addforce " << (more > 0 ? -0.05 : 0.05)
        << " 0 0\n";  // the normal force grows, and the spring that was held by friction seems to hold
      host(bed({std::string("gran") + lean, std::string("wall/gran") + lean, s.str()},
               "pair_coeff 1 1 coul/clump 0\npair_coeff 2 2 coul/clump 0\n" + profile(1, "bins 800"), 6));
      const test::Atom a = host.atoms()[0];
      const double m = 2600 * 4.0 / 3 * M_PI * 1e-9, other = a.f[2] + m * 9.81 + 3e-4 * a.v[2];
      if (test::processors() > 1) return;
      // slices of 0.1 mm: a plane below the first, a plane between the two
      const int k = static_cast<int>(a.x[2] / 1e-4) + (more > 0 ? 1 : -1);
      const double found = more > 0 ? -fix(host).profile().get(ColumnProfile::CONTACT, k)
                                    : fix(host).profile().get(ColumnProfile::WALL, k);
      EXPECT_GT(other, 1e-4) << lean;
      EXPECT_NEAR(found, other, 0.02 * other) << lean << x;
    };
    slid(0.007 + 2e-5, 0);
    slid(0.001, 2e-3 - 4e-5);
  }
  std::remove(name);
}

// unlike charges at rest hold each other over a gap, moving ones do not
TEST(FixSettlingProfile, chargesThatBind)
{
  for (double speed : {0.0, 5.0}) {
    Host host;
    std::ostringstream s;
    s.precision(15);
    s << "create_atoms 1 single 0 0 0.02 units box\ncreate_atoms 2 single 0 0 0.0235 units box\n"
      << "set group all diameter 2e-3 density 2600\nfix nve all nve/sphere\ngroup one type 1\nvelocity one set "
      << speed << " 0 0 units box\n";
    host(bed({"gran", "wall/gran", s.str()}, profile(1, "bins 80"), 0));
    EXPECT_EQ(host.fix("p")->compute_vector(1), 1);
    EXPECT_EQ(host.fix("p")->compute_vector(2), speed > 0 ? 1 : 2);
    if (test::processors() > 1) continue;
    const ColumnProfile &p = fix(host).profile();
    const double pull = 8.9875517873681764e9 * 4e-20 / (0.0035 * 0.0035);
    EXPECT_NEAR(p.get(ColumnProfile::COULOMB, 22), -pull, 1e-9 * pull);
    EXPECT_NEAR(p.get(ColumnProfile::COULOMB, 25), 0, 1e-9 * pull);
  }
  std::remove(name);
}

// plates of clay lie flat on each other
TEST(FixSettlingProfile, orderOfClumps)
{
  Host host;
  {
    std::ofstream f("profile_flat.places");
    f << "ill 0 0 0.0035 1 0 0 0\nill 0 0 0.00645 1 0 0 0\n";
  }
  MPI_Barrier(MPI_COMM_WORLD);
  host(bed({"gran/lean", "wall/gran/lean",
            "fix ill all particletemplate/clay illite seed 15485863 type 1 atom_types 1 2 radius 1e-3 density 2600\n"
            "fix ms all multisphere\nfix put all insert/placed file profile_flat.places templates ill verbose no\n"},
           profile(1, "bins 20"), 1));
  if (test::processors() == 1) {
    const ColumnProfile &p = fix(host).profile();
    double bodies = 0, flat = 0, faces = 0, others = 0;
    for (int k = 0; k < 20; k++) {
      bodies += p.get(ColumnProfile::BODIES, k);
      flat += p.get(ColumnProfile::ZZ, k);
      faces += p.get(ColumnProfile::FACE_FACE, k);
      others += p.get(ColumnProfile::EDGE_FACE, k) + p.get(ColumnProfile::EDGE_EDGE, k);
    }
    EXPECT_EQ(bodies, 2);
    EXPECT_NEAR(flat, 2, 1e-3);
    EXPECT_EQ(faces, 1);
    EXPECT_EQ(others, 0);
  }
  std::remove(name);
}

// one processor and two see the same of the same bed
TEST(FixSettlingProfileParallel, twoProcessorsSeeWhatOneDoes)
{
  ASSERT_EQ(test::processors(), 2);
  int rank;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  const Bed b = {"gran/lean", "wall/gran/lean", test::clumps(22)};
  const std::string go_on = "neighbor 0.0005 bin\nneigh_modify delay 0\n" +
      std::string("fix m1 all property/global kn peratomtypepair 2 400 400 400 400\n"
                  "fix m2 all property/global kt peratomtypepair 2 400 400 400 400\n"
                  "fix m3 all property/global gamman peratomtypepair 2 900 900 900 900\n"
                  "fix m4 all property/global gammat peratomtypepair 2 900 900 900 900\n"
                  "fix m5 all property/global coefficientFriction peratomtypepair 2 0.4 0.4 0.4 0.4\n"
                  "pair_style hybrid/overlay gran/lean model hooke/stiffness tangential history coul/clump 0.006\n"
                  "pair_coeff * * gran/lean\npair_coeff 1 1 coul/clump 2e-10\npair_coeff 2 2 coul/clump -2e-10\n"
                  "fix g all gravity 9.81 vector 0 0 -1\n"
                  "fix w1 all wall/gran/lean model hooke/stiffness tangential history primitive type 1 zplane 0.0\n"
                  "fix w2 all wall/gran/lean model hooke/stiffness tangential history primitive type 1 zcylinder "
                  "0.008 0. 0.\n"
                  "fix ill all particletemplate/clay illite seed 15485863 type 1 atom_types 1 2 radius 1e-3 density "
                  "2600\nfix kao all particletemplate/clay kaolinite seed 15485867 type 2 atom_types 1 2 radius 1e-3 "
                  "density 2600\nfix ms all multisphere\ntimestep 1e-5\n");
  if (rank == 0) {
    Host first(MPI_COMM_SELF);
    first(bed(b, "", 20000) + "write_restart profile.restart\n");
  }
  MPI_Barrier(MPI_COMM_WORLD);
  const std::string begin = "atom_style granular\natom_modify map array\nnewton off\ncommunicate single vel yes\n"
                            "processors * * 2\nread_restart profile.restart\n";
  const std::string one_begin = "atom_style granular\natom_modify map array\nnewton off\ncommunicate single vel yes\n"
                                "read_restart profile.restart\n";
  const auto file = [](const std::string &f) { return "fix p all settling/profile 1 file " + f + " bins 30\nrun 0\n"; };
  {
    Host alone(MPI_COMM_SELF);
    alone(one_begin + go_on + file("profile_alone" + std::to_string(rank) + ".csv"));
  }
  {
    Host together(MPI_COMM_WORLD);
    together(begin + go_on + file("profile_both.csv"));
  }
  MPI_Barrier(MPI_COMM_WORLD);
  if (rank != 0) return;
  const Table one = table("profile_alone0.csv"), two = table("profile_both.csv");
  ASSERT_EQ(one.at("time_s").size(), 30u);
  for (const auto &column : one) {
    double largest = 0;
    for (double v : column.second)
      if (!std::isnan(v)) largest = std::max(largest, std::abs(v));
    for (std::size_t k = 0; k < 30; k++) {
      const double x = column.second[k], y = two.at(column.first)[k];
      if (std::isnan(x)) EXPECT_TRUE(std::isnan(y)) << column.first << k;
      else EXPECT_NEAR(x, y, 2e-6 * largest + 1e-300) << column.first << ' ' << k;
    }
  }
}

// chains along which each processor knows every n-th link, and of which many know one link: they are one cluster
TEST(SharedClusters, reachOverProcessors)
{
  int me, ranks;
  MPI_Comm_rank(MPI_COMM_WORLD, &me);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  std::vector<std::pair<long, long>> links;
  const auto chain = [&](long from, long to, long step) {
    int n = 0;
    for (long k = from; k < to; k += step)
      if (n++ % ranks == me) links.push_back({k, k + step});
  };
  chain(0, 40, 1);               // 41 clumps
  chain(-30, -10, 4);            // 6 spheres: -30 ... -10
  chain(100, 107, 7);            // a pair
  links.push_back({200, -200});  // known by all
  const std::unordered_map<long, int> mine = clay::clusterSizes(links, MPI_COMM_WORLD);

  int found = 0;
  for (const auto &one : mine) {
    ASSERT_EQ(clay::rankNamedBy(one.first, ranks), me);
    const long key = one.first;
    const int size = key >= 0 && key <= 40 ? 41 : key < 0 && key >= -30 ? 6 : 2;
    EXPECT_EQ(one.second, size) << key;
    found++;
  }
  MPI_Allreduce(MPI_IN_PLACE, &found, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
  EXPECT_EQ(found, 41 + 6 + 2 + 2);
}
