// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "contacts/contact_limit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace clay {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Matrix6d = Eigen::Matrix<double, 6, 6>;
constexpr double pi = 3.14159265358979323846;

Matrix3d crossMatrix(const Vector3d& r)
{
  Matrix3d m;
  m << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
  return m;
}

// spheres that touch a plane pressed against the clump from direction n
std::vector<std::size_t> touching(const std::vector<Vector3d>& x, const std::vector<double>& r, const Vector3d& n)
{
  double reach = -1e300, size = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    reach = std::max(reach, x[i].dot(n) + r[i]);
    size = std::max(size, r[i]);
  }
  std::vector<std::size_t> list;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (x[i].dot(n) + r[i] > reach - 1e-6 * size) list.push_back(i);
  return list;
}

}  // namespace

double oscillatorStep(double k, double c)
{
  if (k <= 0 && c <= 0) return std::numeric_limits<double>::infinity();
  // 1/dt is the positive root of s2 - c/2 s - k/4 = 0
  return 1 / (0.25 * c + std::sqrt(0.0625 * c * c + 0.25 * k));
}

void ContactMatrices::add(const BodyContact& b)
{
  Eigen::Matrix<double, 3, 6> J;  // velocity of the contact point
  J << Matrix3d::Identity(), -crossMatrix(b.arm);
  const Matrix3d nn = b.normal * b.normal.transpose(), tt = Matrix3d::Identity() - nn;
  const ContactCoefficients& c = b.coefficients;
  const double times = b.fixed ? 1 : 2;
  K += times * J.transpose() * (c.kn * nn + c.kt * tt) * J;
  C += times * J.transpose() * (c.cn * nn + c.ct * tt) * J;
}

double ContactMatrices::step(double mass, const Matrix3d& inertia) const
{
  if (K.isZero(0) && C.isZero(0)) return std::numeric_limits<double>::infinity();
  Matrix6d M = Matrix6d::Zero();
  M.topLeftCorner<3, 3>() = mass * Matrix3d::Identity();
  M.bottomRightCorner<3, 3>() = inertia;
  const auto largest = [&M](const Matrix6d& A) {
    return Eigen::GeneralizedSelfAdjointEigenSolver<Matrix6d>(A, M, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
  };
  // the two matrices' own largest eigenvalues enclose the step within a factor two
  double lo = oscillatorStep(largest(K), largest(C)), hi = 4 * lo;
  for (int i = 0; i < 60 && hi - lo > 1e-12 * hi; ++i) {
    const double dt = 0.5 * (lo + hi);
    (largest(0.25 * dt * dt * K + 0.5 * dt * C) < 1 ? lo : hi) = dt;
  }
  return lo;
}

double stableStep(double mass, const Matrix3d& inertia, const std::vector<BodyContact>& contacts)
{
  ContactMatrices all;
  for (const BodyContact& b : contacts) all.add(b);
  return all.step(mass, inertia);
}

void ContactBound::add(double mass, double leastInertia, double arm2, const ContactCoefficients& of, bool fixed)
{
  const double share = (fixed ? 1 : 2) * (1 / mass + arm2 / leastInertia);
  k += share * std::max(of.kn, of.kt);
  c += share * std::max(of.cn, of.ct);
  ++contacts;
}

double ContactBound::step() const { return oscillatorStep(k, c); }

double effectiveModulus(double youngs1, double poisson1, double youngs2, double poisson2)
{
  return 1 / ((1 - poisson1 * poisson1) / youngs1 + (1 - poisson2 * poisson2) / youngs2);
}

double rayleighTime(double size, double modulus, double poisson)
{
  // of two like spheres modulus = Y/(2 (1 - poisson2)) = G/(1 - poisson)
  const double shear = modulus * (1 - poisson);
  return pi * size / std::sqrt(shear) / (0.1631 * poisson + 0.8766);
}

// k_n such that an elastic impact at the characteristic velocity reaches the
// overlap it has by Hertz's law; damping from the restitution
double attractedOverlap(const std::function<double(double)>& pull, double stiffness, double diameter)
{
  const auto held = [&](double x) { return stiffness * x * diameter >= pull(diameter * (1 - x)); };
  if (held(0)) return 0;
  const int steps = 3000;  // to find the least: a pull that grows may overtake the spring again
  for (int i = 1; i < steps; ++i) {
    double low = double(i - 1) / steps, high = double(i) / steps;
    if (!held(high)) continue;
    for (int k = 0; k < 50; ++k) (held(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
    return high;
  }
  return std::numeric_limits<double>::infinity();
}

ContactCoefficients hookeCoefficients(double radius, double mass, double modulus, double velocity, double restitution)
{
  ContactCoefficients c;
  const double stiff = std::sqrt(radius) * modulus;
  c.kn = 16.0 / 15.0 * stiff * std::pow(15.0 / 16.0 * mass * velocity * velocity / stiff, 0.2);
  c.kt = c.kn;
  const double l = std::log(restitution);
  c.cn = c.ct = 2 * std::sqrt(mass * c.kn) * std::abs(l) / std::sqrt(l * l + pi * pi);
  return c;
}

std::vector<BodyContact> restingContacts(const std::vector<Vector3d>& x, const std::vector<double>& r,
                                         const ContactCoefficients& withWall, const ContactCoefficients& withBody)
{
  // faces: normals of planes through three spheres; of equal radii, that is all
  Vector3d floor = -Vector3d::UnitZ();
  std::size_t most = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t k = 0; k < j; ++k) {
        const Vector3d n = (x[i] - x[k]).cross(x[j] - x[k]);
        if (n.norm() < 1e-9 * r[i] * r[i]) continue;
        for (double side : {-1.0, 1.0}) {
          const Vector3d u = side * n.normalized();
          const std::size_t count = touching(x, r, u).size();
          if (count > most) {
            most = count;
            floor = u;
          }
        }
      }
  // an upright wall: the side, at right angles to the floor, where most touch
  Vector3d wall = floor.unitOrthogonal();
  most = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < x.size(); ++j) {
      const Vector3d n = (x[i] - x[j]).cross(floor);
      if (n.norm() < 1e-9 * r[i]) continue;
      const std::size_t count = touching(x, r, n.normalized()).size();
      if (count > most) {
        most = count;
        wall = n.normalized();
      }
    }

  std::vector<BodyContact> contacts;
  for (const Vector3d& n : {floor, wall})
    for (std::size_t i : touching(x, r, n)) contacts.push_back({x[i] + r[i] * n, n, withWall, true});
  for (std::size_t i : touching(x, r, -floor)) contacts.push_back({x[i] - r[i] * floor, -floor, withBody, false});
  return contacts;
}

}  // namespace clay
