// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "clumps/clump_geometry.h"
#include "contacts/contact_limit.h"

using namespace clay;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

namespace {

// growth over 2000 steps of a spring and dashpot under LIGGGHTS's step
double growth(double k, double c, double m, double dt)
{
  double x = 1, v = 0, early = 0, late = 0;
  for (int n = 0; n < 2400; ++n) {
    v += dt * (-k * x - c * v) / m;
    x += dt * v;
    if (n < 400) early = std::max(early, std::hypot(x, v * dt));
    if (n >= 2000) late = std::max(late, std::hypot(x, v * dt));
  }
  return late / early;
}

// largest part of the force after so many steps of a body held by linear
// contacts, against the largest at the start
double bodyForceGrowth(double mass, const Matrix3d& inertia, const std::vector<BodyContact>& contacts, double dt,
                       int steps)
{
  Matrix6d K = Matrix6d::Zero(), C = Matrix6d::Zero(), Minv = Matrix6d::Zero();
  Minv.topLeftCorner<3, 3>() = Matrix3d::Identity() / mass;
  Minv.bottomRightCorner<3, 3>() = inertia.inverse();
  for (const auto& b : contacts) {
    // force of each contact from the motion of its point, as the DEM code has it
    for (int d = 0; d < 6; ++d) {
      Vector6d y = Vector6d::Zero();
      y[d] = 1;
      const Vector3d u = y.head<3>() + y.tail<3>().cross(b.arm), un = u.dot(b.normal) * b.normal;
      const Vector3d fk = b.coefficients.kn * un + b.coefficients.kt * (u - un);
      const Vector3d fc = b.coefficients.cn * un + b.coefficients.ct * (u - un);
      const double times = b.fixed ? 1 : 2;
      K.col(d).head<3>() += times * fk;
      K.col(d).tail<3>() += times * b.arm.cross(fk);
      C.col(d).head<3>() += times * fc;
      C.col(d).tail<3>() += times * b.arm.cross(fc);
    }
  }
  Vector6d x, v = Vector6d::Zero();
  x << 1e-6, -2e-6, 1.5e-6, 1e-3, -2e-3, 3e-3;
  double start = 0;
  for (int n = 0; n < steps; ++n) {
    const Vector6d f = -K * x - C * v;
    if (n < 20) start = std::max(start, f.norm());
    v += dt * Minv * f;
    x += dt * v;
  }
  return (K * x + C * v).norm() / start;
}

struct Plate {
  std::vector<Vector3d> centres;
  std::vector<double> radii;
  double mass;
  Matrix3d inertia;
  Plate()
  {
    const Clump c = illitePlate({1e-3, 2e-3, 1e-3, 2});
    for (const auto& s : c) {
      centres.push_back(s.x);
      radii.push_back(s.r);
    }
    const auto g = sumOfSpheres(c);
    mass = 2600 * g.volume;
    inertia = 2600 * g.inertia;
  }
};

ContactCoefficients coefficients(double k, double c) { return {k, k, c, c}; }

}  // namespace

TEST(ContactLimit, springAndDashpot)
{
  for (double k : {10.0, 5e3})
    for (double c : {0.0, 0.01, 3.0}) {
      const double m = 1.5e-4, dt = oscillatorStep(k / m, c / m);
      EXPECT_LE(growth(k, c, m, 0.99 * dt), 1.01);
      EXPECT_GT(growth(k, c, m, 1.01 * dt), 1e3);
    }
  EXPECT_NEAR(oscillatorStep(4, 0), 1, 1e-14);
  EXPECT_NEAR(oscillatorStep(0, 4), 0.5, 1e-14);
  EXPECT_TRUE(std::isinf(oscillatorStep(0, 0)));
}

TEST(ContactLimit, oneContactThroughTheCentre)
{
  const double m = 2e-4;
  const BodyContact b{Vector3d(0, 0, -1e-3), Vector3d(0, 0, -1), {5000, 0, 1.0, 0}, true};
  EXPECT_NEAR(stableStep(m, 1e-10 * Matrix3d::Identity(), {b}), oscillatorStep(5000 / m, 1.0 / m), 1e-16);
  BodyContact other = b;
  other.fixed = false;
  EXPECT_NEAR(stableStep(m, 1e-10 * Matrix3d::Identity(), {other}), oscillatorStep(2 * 5000 / m, 2 * 1.0 / m), 1e-16);
}

TEST(ContactLimit, plateInACorner)
{
  const Plate p;
  for (double c : {0.0, 0.3, 3.0}) {
    const auto contacts = restingContacts(p.centres, p.radii, coefficients(5000, c), {});
    const double dt = stableStep(p.mass, p.inertia, contacts);
    EXPECT_LT(bodyForceGrowth(p.mass, p.inertia, contacts, 0.99 * dt, 1000), 2.0);
    EXPECT_GT(bodyForceGrowth(p.mass, p.inertia, contacts, 1.01 * dt, 1000), 1e3);
  }
}

TEST(ContactLimit, floorIsALayerAndWallAnEdge)
{
  const Plate p;
  const auto contacts = restingContacts(p.centres, p.radii, coefficients(1, 0), coefficients(2, 0));
  int floor = 0, wall = 0, above = 0;
  for (const auto& b : contacts) {
    if (!b.fixed) ++above;
    else if (std::abs(b.normal.z()) > 0.99) ++floor;
    else ++wall;
  }
  EXPECT_EQ(floor, 7);
  EXPECT_EQ(wall, 4);  // two spheres of each layer
  EXPECT_EQ(above, 7);
}

TEST(ContactLimit, knownBlowUp)
{
  // k = 5000 N/m, gamma = 2e4 1/s times the body's mass, dt = 1e-5 s: seen to blow
  // up in a corner, forces doubling every two steps
  const Plate p;
  const double dt = 1e-5;
  const auto each = coefficients(5000, 2e4 * p.mass);
  const auto corner = restingContacts(p.centres, p.radii, each, {});
  const std::vector<BodyContact> one(corner.begin(), corner.begin() + 1), three(corner.begin(), corner.begin() + 3),
      five(corner.begin(), corner.begin() + 5);

  EXPECT_GT(stableStep(p.mass, p.inertia, one), 4 * dt);
  EXPECT_LT(bodyForceGrowth(p.mass, p.inertia, one, dt, 1000), 1);
  EXPECT_GT(stableStep(p.mass, p.inertia, three), dt);
  EXPECT_LT(bodyForceGrowth(p.mass, p.inertia, three, dt, 1000), 1);
  EXPECT_LT(stableStep(p.mass, p.inertia, five), dt);
  EXPECT_GT(bodyForceGrowth(p.mass, p.inertia, five, dt, 100), std::pow(2.0, 50));
  EXPECT_LT(stableStep(p.mass, p.inertia, corner), 0.5 * dt);
}

TEST(ContactLimit, cheapBoundIsBelow)
{
  const Plate p;
  const double least = principalAxes(p.inertia).moments[0];
  for (double c : {0.0, 0.5}) {
    const auto contacts = restingContacts(p.centres, p.radii, coefficients(5000, c), coefficients(5000, c / 2));
    ContactBound bound;
    for (const auto& b : contacts) bound.add(p.mass, least, b.arm.squaredNorm(), b.coefficients, b.fixed);
    const double exact = stableStep(p.mass, p.inertia, contacts);
    EXPECT_EQ(bound.contacts, int(contacts.size()));
    EXPECT_LE(bound.step(), exact);
    EXPECT_GT(bound.step(), 0.3 * exact);
  }
  EXPECT_TRUE(std::isinf(ContactBound().step()));
}

TEST(ContactLimit, hookeModelAgainstTable)
{
  std::ifstream file(CLAYFOAM_TEST_DATA "/hooke_lsd_restitution.csv");
  ASSERT_TRUE(file.good());
  std::string line;
  int rows = 0;
  while (std::getline(file, line)) {
    if (line.empty() || line[0] == '#' || line[0] == 'e') continue;
    std::istringstream in(line);
    double v[9];
    char comma;
    for (int i = 0; i < 9; ++i) in >> v[i] >> (i < 8 ? comma : comma);
    const auto c = hookeCoefficients(v[1], v[2], v[3], 0.01, v[0]);
    EXPECT_NEAR(c.kn, v[4], 1e-5 * v[4]);
    EXPECT_NEAR(c.cn, v[5], 1e-5 * v[5] + 1e-20);
    ++rows;
  }
  EXPECT_EQ(rows, 6);
  // 5 MPa and 0.45 against itself
  EXPECT_NEAR(effectiveModulus(5e6, 0.45, 5e6, 0.45), 3.134796e6, 1.0);
}

TEST(ContactLimit, attractedSpheresRestWhereTheSpringHoldsThem)
{
  const double d = 2e-3, k = 750;
  const auto overlap = [=](double pull) {
    return clay::attractedOverlap([=](double r) { return pull / (r * r); }, k, d);
  };
  for (double share : {1e-4, 0.02, 0.14}) {
    const double pull = share * k * d * d * d, x = overlap(pull);
    EXPECT_NEAR(k * x * d, pull / (d * d * (1 - x) * (1 - x)), 1e-9 * k * d);
    EXPECT_LT(x, 1.0 / 3.0);
  }
  // x (1 - x)^2 is 4/27 at most
  EXPECT_NEAR(overlap(0.999999 * 4.0 / 27.0 * k * d * d * d), 1.0 / 3.0, 1e-3);
  EXPECT_TRUE(std::isinf(overlap(0.149 * k * d * d * d)));
  EXPECT_EQ(overlap(0), 0);
  // a force that does not change is held deeper
  EXPECT_NEAR(clay::attractedOverlap([=](double) { return 0.2 * k * d; }, k, d), 0.2, 1e-12);
}

// t = pi r sqrt(density/G)/(0.1631 nu + 0.8766), G = Y/(2 (1 + nu)); glass of 1 mm
TEST(ContactLimit, rayleighTimeOfLikeSpheres)
{
  const double Y = 7e10, nu = 0.22, r = 5e-4, density = 2500;
  const double modulus = clay::effectiveModulus(Y, nu, Y, nu);
  EXPECT_NEAR(clay::rayleighTime(r * std::sqrt(density), modulus, nu), 5.0817e-7, 1e-10);
}
