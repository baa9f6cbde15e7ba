// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "clumps/fix_template_clay.h"
#include "host.h"
#include "multisphere.h"
#include "vector_container.h"

using test::Host;

namespace {

std::string column(int n, const std::string &more = "")
{
  return test::opening("f f f", "-0.0165 0.0165 -0.0165 0.0165 -0.001 0.151") +
      "region ins cylinder z 0 0 0.01625 0 0.15 units box\n" + test::material("coul/clump 0.006") +
      "pair_coeff * * coul/clump 0.0\n" + test::clumps(n, more) + "timestep 1e-6\n";
}

}  // namespace

TEST(FixTemplateClay, the135ClumpsOfTheHalfSizeColumn)
{
  Host host;
  host(column(135) + "run 1\n");
  const auto atoms = host.atoms();
  ASSERT_EQ(atoms.size(), 1890u);

  std::map<int, std::vector<test::Atom>> bodies;
  for (const auto &a : atoms) bodies[a.body].push_back(a);
  EXPECT_EQ(bodies.size(), 135u);
  EXPECT_EQ(bodies.count(-1), 0u);

  const double volume = 14 * 4.0 / 3 * M_PI * 1e-9;
  int illite = 0, kaolinite = 0;
  for (const auto &b : bodies) {
    ASSERT_EQ(b.second.size(), 14u);
    double up[3] = {0, 0, 0}, down[3] = {0, 0, 0}, weight = 0;
    int positive = 0;
    for (const auto &a : b.second) {
      positive += a.type == 1;
      for (int d = 0; d < 3; d++) (a.type == 1 ? up : down)[d] += a.x[d];
      weight += a.weight;
      EXPECT_NEAR(a.rmass, 2600 * volume, 1e-12 * a.rmass);
      EXPECT_LE(std::hypot(a.x[0], a.x[1]), 0.01625);
    }
    EXPECT_NEAR(weight, 1, 1e-14);
    double apart = 0;
    for (int d = 0; d < 3; d++) apart += std::pow(up[d] / positive - down[d] / (14 - positive), 2);
    if (positive == 7) {
      ++illite;
      EXPECT_NEAR(std::sqrt(apart), 1e-3, 1e-12);  // centres of the two layers
    } else {
      ++kaolinite;
      EXPECT_EQ(positive, 2);
      EXPECT_NEAR(std::sqrt(apart), 0, 1e-12);
    }
  }
  EXPECT_NEAR(illite, 67.5, 0.6);
  EXPECT_EQ(illite + kaolinite, 135);
}

TEST(FixTemplateClay, bodiesHaveTheExactMassAndInertia)
{
  const double m = 4.0 / 3 * M_PI * 1e-9 * 2600, r = 1e-3;
  // spheres in full: 14 balls and their distances from the axes
  const double axial = 14 * 0.4 * m * r * r + 12 * m * 4 * r * r;
  const double across = 14 * (0.4 * m * r * r + m * r * r / 4) + 6 * m * 4 * r * r;
  Host host;
  host(column(10) + "run 1\n");
  auto &data = host.multisphere()->data();
  ASSERT_EQ(data.n_body_all(), 10);
  for (int b = 0; b < host.multisphere()->n_body(); b++) {
    EXPECT_NEAR(data.mass(b), 14 * m, 1e-12 * m);
    double inertia[3];
    const double *kept = data.prop().getElementProperty<VectorContainer<double, 3>>("inertia")->begin()[b];
    std::copy(kept, kept + 3, inertia);
    std::sort(inertia, inertia + 3);
    EXPECT_NEAR(inertia[0], across, 1e-12 * axial);
    EXPECT_NEAR(inertia[1], across, 1e-12 * axial);
    EXPECT_NEAR(inertia[2], axial, 1e-12 * axial);
  }
}

TEST(FixTemplateClay, unionCountsOverlapsOnce)
{
  Host host;
  host(column(4, "volume union") + "run 1\n");
  auto *f = dynamic_cast<LAMMPS_NS::FixTemplateClay *>(host.fix("ill"));
  ASSERT_NE(f, nullptr);
  // two spheres a radius apart: 4/3 pi r3 27/16
  const double volume = 7 * 4.0 / 3 * M_PI * 1e-9 * 27 / 16;
  EXPECT_NEAR(f->volexpect(), volume, 1e-12 * volume);
  EXPECT_NEAR(f->massexpect(), 2600 * volume, 1e-12 * 2600 * volume);
  ASSERT_EQ(host.atoms().size(), 56u);
  for (const auto &a : host.atoms()) EXPECT_NEAR(a.rmass / a.density, volume, 1e-12 * volume);
}

TEST(FixTemplateClay, shapeKeywords)
{
  Host host;
  host(test::opening("f f f", "0 1 0 1 0 1") +
       "fix a all particletemplate/clay illite seed 15485863 type 1 atom_types 2 1 radius 1e-3 density 2600 "
       "spacing 1.9e-3 height 3.5e-3\n"
       "fix b all particletemplate/clay generic seed 15485863 type 2 atom_types 1 2 density 1000 "
       "spheres 3 0 0 0 1e-3 P 3e-3 0 0 2e-3 N 0 4e-3 0 1e-3 N\n"
       "fix c all particletemplate/clay kaolinite seed 15485863 type 3 atom_types 1 2 radius 1e-3 density 2600 "
       "layers 3 layer_spacing 2e-3\n");
  auto *a = dynamic_cast<LAMMPS_NS::FixTemplateClay *>(host.fix("a"));
  auto *b = dynamic_cast<LAMMPS_NS::FixTemplateClay *>(host.fix("b"));
  auto *c = dynamic_cast<LAMMPS_NS::FixTemplateClay *>(host.fix("c"));
  EXPECT_NEAR(a->clump()[1].x.x(), 1.9e-3, 1e-15);
  EXPECT_NEAR(a->clump()[7].x.z() - a->clump()[0].x.z(), 1.5e-3, 1e-15);
  EXPECT_EQ(a->maxtype(), 2);
  EXPECT_EQ(a->mintype(), 1);

  const double v = 4.0 / 3 * M_PI * 1e-9;
  EXPECT_NEAR(b->volexpect(), 10 * v, 1e-12 * v);
  // centre of mass: (8 * 3 mm, 4 mm) over 10
  EXPECT_NEAR(b->clump()[0].x.x(), -2.4e-3, 1e-15);
  EXPECT_NEAR(b->clump()[0].x.y(), -0.4e-3, 1e-15);
  EXPECT_EQ(b->type(), 2);
  EXPECT_EQ(c->number_spheres(), 21);
  EXPECT_NEAR(c->max_r_bound(), 1e-3 + std::sqrt(8e-6), 1e-9);
}

// a plate with one type in the middle of its faces and another around it, each with its charge
TEST(FixTemplateClay, typesBySphere)
{
  Host host;
  host(test::opening("f f f", "-0.02 0.02 -0.02 0.02 0 0.05") +
       "region ins block -0.02 0.02 -0.02 0.02 0 0.05 units box\n" + test::material("coul/clump 0.006") +
       "pair_coeff 1 1 coul/clump -2e-10\npair_coeff 2 2 coul/clump 1e-10\n"
       "fix p all particletemplate/clay illite seed 15485863 type 1 radius 1e-3 density 2600 "
       "sphere_types 14 1 2 2 2 2 2 2 1 2 2 2 2 2 2\n"
       "fix pdd all particledistribution/discrete/numberbased 32452843 1 p 1.0\nfix ms all multisphere\n"
       "fix ins all insert/pack seed 49979687 distributiontemplate pdd insert_every once overlapcheck yes "
       "orientation random all_in yes vel constant 0 0 0 region ins particles_in_region 5 ntry_mc 10000\n"
       "timestep 1e-6\nrun 1\n");
  auto *f = dynamic_cast<LAMMPS_NS::FixTemplateClay *>(host.fix("p"));
  EXPECT_EQ(f->types(), (std::vector<int>{1, 2, 2, 2, 2, 2, 2, 1, 2, 2, 2, 2, 2, 2}));
  EXPECT_EQ(f->maxtype(), 2);
  std::map<int, std::vector<test::Atom>> bodies;
  for (const auto &a : host.atoms()) bodies[a.body].push_back(a);
  ASSERT_EQ(bodies.size(), 5u);
  for (const auto &b : bodies) {
    int faces = 0;
    double centre[3] = {0, 0, 0};
    for (const auto &a : b.second)
      for (int d = 0; d < 3; d++) centre[d] += a.x[d] / 14;
    for (const auto &a : b.second) {
      const double away = std::hypot(a.x[0] - centre[0], a.x[1] - centre[1], a.x[2] - centre[2]);
      // middle of a face half a radius off the middle, the others two radii from the axis
      EXPECT_NEAR(away, a.type == 1 ? 5e-4 : std::hypot(5e-4, 2e-3), 1e-6);
      faces += a.type == 1;
    }
    EXPECT_EQ(faces, 2);
  }
}

TEST(FixTemplateClay, besideAStockTemplate)
{
  Host host;
  host(test::opening("f f f", "-0.02 0.02 -0.02 0.02 0 0.05") +
       "region ins block -0.02 0.02 -0.02 0.02 0 0.05 units box\n" + test::material("coul/clump 0.006") +
       "pair_coeff * * coul/clump 0.0\n"
       "fix s all particletemplate/multisphere 15485863 atom_type 1 density constant 2000 nspheres 2 ntry 100000 "
       "spheres 0 0 0 1e-3 1.5e-3 0 0 1e-3 type 1\n"
       "fix c all particletemplate/clay illite seed 15485867 type 2 atom_types 1 2 radius 1e-3 density 2600\n"
       "fix pdd all particledistribution/discrete/numberbased 32452843 2 s 0.5 c 0.5\nfix ms all multisphere\n"
       "fix ins all insert/pack seed 49979687 distributiontemplate pdd insert_every once overlapcheck yes "
       "orientation random all_in yes vel constant 0 0 0 region ins particles_in_region 20 ntry_mc 10000\n"
       "timestep 1e-6\nrun 2\n");
  std::map<int, int> sizes, bodies;
  for (const auto &a : host.atoms()) bodies[a.body]++;
  for (const auto &b : bodies) sizes[b.second]++;
  EXPECT_EQ(sizes[2], 10);
  EXPECT_EQ(sizes[14], 10);
}
