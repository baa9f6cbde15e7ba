// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <stdexcept>

#include "contacts/lean_model.h"

using clay::LeanModel;

TEST(LeanModel, takesModelsAndSwitches)
{
  LeanModel m;
  EXPECT_FALSE(m.modulus());
  EXPECT_TRUE(m.take("model", "hooke/stiffness"));
  EXPECT_NO_THROW(m.complete());
  EXPECT_EQ(m.tangential(), "off");
  EXPECT_EQ(m.kind.tangential, clay::TangentialForce::none);
  EXPECT_TRUE(m.take("tangential", "history"));
  EXPECT_NO_THROW(m.complete());
  EXPECT_FALSE(m.modulus());
  EXPECT_TRUE(m.take("surface", "default"));
  EXPECT_TRUE(m.take("rolling_friction", "off"));
  EXPECT_TRUE(m.take("cohesion", "off"));
  EXPECT_TRUE(m.tangentialDamping);
  EXPECT_FALSE(m.absoluteDamping || m.kind.limit || m.softer);
  EXPECT_TRUE(m.take("tangential_damping", "off"));
  EXPECT_TRUE(m.take("absolute_damping", "on"));
  EXPECT_TRUE(m.take("limitForce", "on"));
  EXPECT_TRUE(m.take("ktToKnUser", "on"));
  EXPECT_FALSE(m.tangentialDamping);
  EXPECT_TRUE(m.absoluteDamping && m.kind.limit && m.softer);
  EXPECT_TRUE(m.take("limitForce", "off"));
  EXPECT_FALSE(m.kind.limit);
}

TEST(LeanModel, modulusWithHooke)
{
  LeanModel m;
  m.take("model", "hooke");
  EXPECT_TRUE(m.modulus());
  m.take("tangential", "history");
  EXPECT_NO_THROW(m.complete());
}

TEST(LeanModel, kindsOfLaw)
{
  const struct {
    const char *model, *tangential;
    clay::NormalForce normal;
    clay::TangentialForce friction;
    int history;
  } expected[] = {
      {"hooke", "off", clay::NormalForce::linear, clay::TangentialForce::none, 0},
      {"hertz", "no_history", clay::NormalForce::hertz, clay::TangentialForce::damped, 0},
      {"hertz/stiffness", "history", clay::NormalForce::hertzStiffness, clay::TangentialForce::sprung, 3},
  };
  for (const auto& e : expected) {
    LeanModel m;
    m.take("model", e.model);
    m.take("tangential", e.tangential);
    EXPECT_EQ(m.name(), e.model);
    EXPECT_EQ(m.tangential(), e.tangential);
    EXPECT_EQ(m.kind.normal, e.normal);
    EXPECT_EQ(m.kind.tangential, e.friction);
    EXPECT_EQ(m.kind.history(), e.history);
    EXPECT_EQ(m.modulus(), e.model != std::string("hertz/stiffness"));
  }
}

TEST(LeanModel, rollingFrictionAndCohesion)
{
  LeanModel m;
  m.take("model", "hertz");
  EXPECT_EQ(m.text(), "model hertz tangential off");
  m.take("tangential", "history");
  m.take("rolling_friction", "epsd2");
  m.take("cohesion", "sjkr");
  EXPECT_TRUE(m.kind.cohesion);
  EXPECT_EQ(m.kind.rolling, clay::RollingTorque::sprung);
  EXPECT_EQ(m.kind.history(), 6);
  EXPECT_EQ(m.text(), "model hertz tangential history cohesion sjkr rolling_friction epsd2");
  EXPECT_FALSE(m.kind.torsion || m.kind.reduce);
  m.take("torsionTorque", "on");
  m.take("tangential_reduce", "on");
  EXPECT_TRUE(m.kind.torsion && m.kind.reduce);
  m.take("rolling_friction", "cdt");
  EXPECT_EQ(m.kind.rolling, clay::RollingTorque::constant);
  EXPECT_EQ(m.kind.history(), 3);
}

TEST(LeanModel, aWordSaysWhetherItIsWanted)
{
  const auto use = [](std::vector<std::string> text, std::vector<std::string> left) {
    std::vector<char*> words;
    for (std::string& t : text) words.push_back(&t[0]);
    const clay::LeanUse u = clay::takeLeanUse(words);
    EXPECT_EQ(std::vector<std::string>(words.begin(), words.end()), left);
    return u;
  };
  EXPECT_EQ(use({"model", "hertz"}, {"model", "hertz"}), clay::LeanUse::may);
  EXPECT_EQ(use({"model", "hertz", "lean", "yes"}, {"model", "hertz"}), clay::LeanUse::must);
  EXPECT_EQ(use({"lean", "no", "model", "hertz"}, {"model", "hertz"}), clay::LeanUse::never);
  EXPECT_EQ(use({"lean", "auto"}, {}), clay::LeanUse::may);
  EXPECT_THROW(use({"lean", "on"}, {}), std::invalid_argument);
  EXPECT_THROW(use({"lean"}, {}), std::invalid_argument);
}

TEST(LeanModel, refusesWhatItCannotDo)
{
  const char* bad[][2] = {{"model", "jkr"},          {"tangential", "luding"},    {"rolling_friction", "epsd"},
                          {"cohesion", "sjkr2"},     {"surface", "superquadric"}, {"limitForce", "maybe"},
                          {"tangential_damping", ""}};
  for (const auto& b : bad) {
    LeanModel m;
    EXPECT_THROW(m.take(b[0], b[1]), std::invalid_argument) << b[0];
  }
  LeanModel m;
  EXPECT_FALSE(m.take("primitive", "type"));
  EXPECT_FALSE(m.take("computeElasticPotential", "on"));
  EXPECT_THROW(m.complete(), std::invalid_argument);
}
