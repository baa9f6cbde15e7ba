// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <chrono>
#include <cmath>
#include <fstream>
#include <random>

#include "allocations.h"
#include "placing/fix_insert_placed.h"
#include "host.h"
#include "multisphere.h"

using Eigen::Quaterniond;
using Eigen::Vector3d;
using test::Host;

namespace {

const char *file = "placed.txt";

std::string column(const std::string &bodies = "multisphere")
{
  return test::opening("f f f", "-0.0165 0.0165 -0.0165 0.0165 -0.001 0.151") + test::material("coul/clump 0.006") +
      "pair_coeff * * coul/clump 0.0\n"
      "fix ill all particletemplate/clay illite seed 15485863 type 1 atom_types 1 2 radius 1e-3 density 2600\n"
      "fix kao all particletemplate/clay kaolinite seed 15485867 type 2 atom_types 1 2 radius 1e-3 density 2600\n"
      "fix ms all " +
      bodies + "\ntimestep 1e-6\n";
}

const char *placed = "fix put all insert/placed file placed.txt templates ill kao\n";

struct Wanted {
  bool kaolinite;
  Vector3d x;
  Quaterniond q;
};

// clumps on a lattice, turned at random; written by one processor
std::vector<Wanted> clumps(int n, double up = 0)
{
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::vector<Wanted> list;
  for (int k = 0; k < n; k++) {
    Wanted w;
    w.kaolinite = k % 3 == 0;
    w.x = Vector3d(-0.0105 + 0.007 * (k % 4), -0.0105 + 0.007 * (k / 4 % 4), up + 0.004 + 0.007 * (k / 16));
    w.q = Quaterniond(normal(random), normal(random), normal(random), normal(random)).normalized();
    list.push_back(w);
  }
  int rank;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0) {
    std::ofstream out(file);
    out.precision(17);
    out << "# template x y z q0 q1 q2 q3\n";
    for (const auto &w : list)
      out << (w.kaolinite ? "kao " : "1 ") << w.x.transpose() << ' ' << w.q.w() << ' ' << w.q.vec().transpose() << '\n';
  }
  MPI_Barrier(MPI_COMM_WORLD);
  return list;
}

void spheres(const std::string &lines)
{
  int rank;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0) std::ofstream(file) << lines;
  MPI_Barrier(MPI_COMM_WORLD);
}

// where the k-th sphere of a plate with the template's axes is
Vector3d sphere(int k)
{
  const double z = k < 7 ? -0.5e-3 : 0.5e-3, t = (k % 7 - 1) * M_PI / 3;
  return k % 7 == 0 ? Vector3d(0, 0, z) : Vector3d(2e-3 * std::cos(t), 2e-3 * std::sin(t), z);
}

void everyClumpIsInItsPlace(const std::string &bodies)
{
  const int n = 200;
  const auto wanted = clumps(n);
  Host host;
  host(column(bodies) + placed);
  EXPECT_EQ(host.lmp->atom->natoms, 14 * n);  // before any run
  for (const char *steps : {"run 0\n", "run 1\n"}) {
    host(steps);
    const auto atoms = host.atoms();
    ASSERT_EQ(atoms.size(), 14u * n);
    for (int i = 0; i < 14 * n; i++) {
      const auto &a = atoms[i];
      const Wanted &w = wanted[i / 14];
      EXPECT_EQ(a.tag, i + 1);
      EXPECT_EQ(a.body, i / 14 + 1);
      const int k = i % 14;
      EXPECT_EQ(a.type == 1, w.kaolinite ? k % 7 == 0 : k < 7);
      EXPECT_LT((Vector3d(a.x) - w.x - w.q * sphere(k)).norm(), 1e-12) << i;
      EXPECT_EQ(a.v[2], 0.0);
      EXPECT_DOUBLE_EQ(a.weight, 1.0 / 14);
    }
  }
  EXPECT_EQ(host.multisphere()->data().n_body_all(), n);
  EXPECT_EQ(host.fix("put")->compute_vector(0), n);
  EXPECT_NEAR(host.fix("put")->compute_vector(1), n * 14 * 4.0 / 3 * M_PI * 1e-9 * 2600, 1e-12);
}

}  // namespace

TEST(FixInsertPlaced, clumpsForMultisphere) { everyClumpIsInItsPlace("multisphere"); }

TEST(FixInsertPlaced, clumpsForMultisphereClump) { everyClumpIsInItsPlace("multisphere/clump"); }

TEST(FixInsertPlaced, bodiesMoveAsOthersDo)
{
  clumps(60);
  Host host;
  host(column() + placed + "fix g all gravity 9.81 vector 0 0 -1\nrun 0\n");
  const auto before = host.atoms();
  host("run 1000\n");
  const auto after = host.atoms();
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < after.size(); i++) {
    EXPECT_NEAR(after[i].x[2] - before[i].x[2], -0.5 * 9.81 * 1e-6, 1e-12);
    EXPECT_NEAR(after[i].v[2], -9.81e-3, 1e-9);
  }
}

TEST(FixInsertPlaced, aSecondListGoesOnWithTheNumbers)
{
  clumps(16);
  Host host;
  host(column() + placed + "run 0\n");
  clumps(32, 0.05);
  host("fix more all insert/placed file placed.txt templates ill kao verbose no\n");
  const auto atoms = host.atoms();
  ASSERT_EQ(atoms.size(), 14u * 48);
  for (std::size_t i = 0; i < atoms.size(); i++) {
    EXPECT_EQ(atoms[i].tag, int(i) + 1);
    EXPECT_EQ(atoms[i].body, int(i) / 14 + 1);
  }
}

// two spheres in sheared contact on both sides of the middle, which may be a
// border of processors: what a later list adds far away is nothing to them
TEST(FixInsertPlaced, contactsOutliveALaterList)
{
  int rank;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  double spin[2];
  for (bool more : {false, true}) {
    Host host;
    host(test::opening("f f f", "-0.0165 0.0165 -0.0165 0.0165 -0.001 0.151") + test::material("coul/clump 0.006") +
         "pair_coeff * * coul/clump 0.0\n"
         "create_atoms 1 single 0 0 0.07401 units box\ncreate_atoms 1 single 0 0 0.07599 units box\n"
         "set group all diameter 2e-3 density 2600\ngroup upper id 2\nvelocity upper set 0.01 0 0 units box\n"
         "fix nve all nve/sphere\ntimestep 1e-6\nrun 20\n");
    if (more) {
      if (rank == 0)
        std::ofstream(file) << "s 0.01 0.01 0.01\ns 0.01 -0.01 0.01\ns -0.01 -0.01 0.01\ns -0.01 0.01 0.14\n";
      MPI_Barrier(MPI_COMM_WORLD);
      host("fix s all particletemplate/sphere 15485863 atom_type 1 density constant 2600 radius constant 1e-3\n"
           "fix put all insert/placed file placed.txt templates s\n");
    }
    host("run 100\n");
    const LAMMPS_NS::Atom *atom = host.lmp->atom;
    double mine = 0;
    for (int i = 0; i < atom->nlocal; i++)
      if (atom->tag[i] <= 2) mine += std::abs(atom->omega[i][1]);
    MPI_Allreduce(&mine, &spin[more], 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  }
  EXPECT_GT(spin[0], 0);
  EXPECT_NEAR(spin[1], spin[0], 1e-9 * spin[0]);
}

TEST(FixInsertPlaced, spheresAlsoWithRadiiOfTheirOwn)
{
  spheres("grain 0.001 0.002 0.003\n1 0.01 0.09 0.01 2e-3\n1 0.05 0.05 0.05\n");
  Host host;
  host(test::opening("f f f", "0 0.1 0 0.1 0 0.1") + test::material("coul/clump 0.006") +
       "pair_coeff * * coul/clump 0.0\n"
       "fix grain all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 1e-3\n"
       "fix put all insert/placed file placed.txt templates grain\nfix n all nve/sphere\ntimestep 1e-6\nrun 1\n");
  const auto atoms = host.atoms();
  ASSERT_EQ(atoms.size(), 3u);
  EXPECT_DOUBLE_EQ(atoms[0].x[2], 0.003);
  EXPECT_DOUBLE_EQ(atoms[0].radius, 1e-3);
  EXPECT_EQ(atoms[1].type, 1);
  EXPECT_EQ(atoms[1].tag, 2);
  EXPECT_DOUBLE_EQ(atoms[1].radius, 2e-3);
  EXPECT_NEAR(atoms[1].rmass, 2500 * 4.0 / 3 * M_PI * 8e-9, 1e-18);
  EXPECT_DOUBLE_EQ(atoms[2].x[0], 0.05);
}

TEST(FixInsertPlaced, aRestartedRunHasItsParticlesAlready)
{
  spheres("grain 0.01 0.02 0.03\ngrain 0.07 0.08 0.09\n");
  const std::string put =
      "fix grain all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 1e-3\n"
      "fix put all insert/placed file placed.txt templates grain\nfix n all nve/sphere\ntimestep 1e-6\n";
  const std::string box = test::opening("f f f", "0 0.1 0 0.1 0 0.1");
  {
    Host host;
    host(box + test::material("coul/clump 0.006") + "pair_coeff * * coul/clump 0.0\n" + put +
         "run 1\nwrite_restart placed.restart\n");
  }
  Host host;
  const std::size_t at = box.find("region"), end = box.find("neighbor");
  host(box.substr(0, at) + "read_restart placed.restart\n" + box.substr(end) + test::material("coul/clump 0.006") +
       "pair_coeff * * coul/clump 0.0\n" + put + "run 1\n");
  ASSERT_EQ(host.atoms().size(), 2u);
  EXPECT_EQ(host.fix("put")->compute_vector(0), 2);
  EXPECT_NEAR(host.fix("put")->compute_vector(1), 2 * 2500 * 4.0 / 3 * M_PI * 1e-9, 1e-15);
}

// many in one half of the box, one in the other, which may be another processor's: what the
// styles keep there, and pass through, has nothing to do with the length of the list
TEST(FixInsertPlacedParallel, noProcessorHoldsTheList)
{
  ASSERT_EQ(test::processors(), 2);
  int rank;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  double most[2];
  const int n[2] = {16000, 64000};
  for (int k = 0; k < 2; k++) {
    std::ostringstream list;
    for (int i = 0; i < n[k]; i++)
      list << "grain " << 0.001 + 0.002 * (i % 40) << ' ' << 0.001 + 0.002 * (i / 40 % 40) << ' '
           << 0.001 + 0.001 * (i / 1600) << '\n';
    list << "grain 0.05 0.05 0.09\n";
    spheres(list.str());
    std::string start = test::opening("f f f", "0 0.1 0 0.1 0 0.1");
    start.replace(start.find("* * *"), 5, "1 1 2");
    Host host;
    host(start + test::material("coul/clump 0.006") +
         "pair_coeff * * coul/clump 0.0\n"
         "fix grain all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 1e-3\n");
    const test::Allocations allocations;
    host("fix put all insert/placed file placed.txt templates grain\n");
    most[k] = allocations.most();
    EXPECT_EQ(host.fix("put")->compute_vector(0), n[k] + 1);
    EXPECT_EQ(host.lmp->atom->nlocal, rank ? 1 : n[k]);
  }
  EXPECT_GT(most[0], 6e4);  // a part of the list
  EXPECT_LT(most[1], 1.02 * most[0]);
}

TEST(FixInsertPlaced, aThousandClumpsTakeMoments)
{
  // a lattice four times over: that they overlap is no matter here
  clumps(320);
  Host host;
  host(column());
  const auto start = std::chrono::steady_clock::now();
  for (const char *id : {"a", "b", "c", "d"})
    host("fix " + std::string(id) + " all insert/placed file placed.txt templates ill kao\n");
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  EXPECT_EQ(host.lmp->atom->natoms, 4 * 320 * 14);
  EXPECT_LT(took.count(), 20.0);  // hundredths by themselves; one at a time it was a minute
}
