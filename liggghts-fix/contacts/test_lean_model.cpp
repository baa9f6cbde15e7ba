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
  EXPECT_THROW(m.complete(), std::invalid_argument);
  EXPECT_TRUE(m.take("tangential", "history"));
  EXPECT_NO_THROW(m.complete());
  EXPECT_FALSE(m.modulus());
  EXPECT_TRUE(m.take("surface", "default"));
  EXPECT_TRUE(m.take("rolling_friction", "off"));
  EXPECT_TRUE(m.take("cohesion", "off"));
  EXPECT_TRUE(m.tangentialDamping);
  EXPECT_FALSE(m.absoluteDamping || m.limitForce || m.softer);
  EXPECT_TRUE(m.take("tangential_damping", "off"));
  EXPECT_TRUE(m.take("absolute_damping", "on"));
  EXPECT_TRUE(m.take("limitForce", "on"));
  EXPECT_TRUE(m.take("ktToKnUser", "on"));
  EXPECT_FALSE(m.tangentialDamping);
  EXPECT_TRUE(m.absoluteDamping && m.limitForce && m.softer);
  EXPECT_TRUE(m.take("limitForce", "off"));
  EXPECT_FALSE(m.limitForce);
}

TEST(LeanModel, modulusWithHooke)
{
  LeanModel m;
  m.take("model", "hooke");
  EXPECT_TRUE(m.modulus());
  m.take("tangential", "history");
  EXPECT_NO_THROW(m.complete());
}

TEST(LeanModel, refusesWhatItCannotDo)
{
  const char* bad[][2] = {{"model", "hertz"},        {"tangential", "no_history"}, {"rolling_friction", "epsd"},
                          {"cohesion", "sjkr"},      {"surface", "superquadric"},  {"limitForce", "maybe"},
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
