// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "resistance/blob_sphere.h"

#include <cmath>
#include <map>
#include <mutex>
#include <stdexcept>
#include <string>

namespace clay {
namespace {

constexpr double pi = 3.14159265358979323846;
using Eigen::Matrix3d;
using Eigen::Vector3d;

std::vector<Vector3d> icosahedron()
{
  const double g = 0.5 * (1 + std::sqrt(5.0));
  std::vector<Vector3d> v;
  for (double s : {-1.0, 1.0})
    for (double t : {-g, g}) {
      v.push_back(Vector3d(0, s, t).normalized());
      v.push_back(Vector3d(s, t, 0).normalized());
      v.push_back(Vector3d(t, 0, s).normalized());
    }
  return v;
}

/// Radii of the spheres of like drag and of like torque as a shell of radius one.
struct Apparent {
  double drag, torque;
};

Apparent apparentRadii(const std::vector<Vector3d>& points, double blob)
{
  std::vector<Blob> blobs;
  for (const auto& p : points) blobs.push_back({p, blob});
  const Matrix6d R = blobResistance(blobs, Vector3d::Zero());
  return {R.topLeftCorner<3, 3>().trace() / (18 * pi), std::cbrt(R.bottomRightCorner<3, 3>().trace() / (24 * pi))};
}

// The torque is that of a larger sphere than the drag when the blobs are small,
// and of a smaller one when they are large; the secant method finds where both agree.
BlobSphere calibrate(int frequency)
{
  BlobSphere s;
  s.points = icosphere(frequency);
  const double spacing = std::sqrt(4 * pi / s.points.size());
  double c0 = 0.30, c1 = 0.34;
  Apparent r = apparentRadii(s.points, c0 * spacing);
  double g0 = std::log(r.drag / r.torque);
  for (int k = 0; k < 30; ++k) {
    r = apparentRadii(s.points, c1 * spacing);
    const double g1 = std::log(r.drag / r.torque);
    if (std::abs(g1) < 1e-12) break;
    const double next = c1 - g1 * (c1 - c0) / (g1 - g0);
    c0 = c1;
    g0 = g1;
    c1 = next;
    if (std::abs(c1 - c0) < 1e-14) break;
  }
  s.shell = 1 / r.drag;
  s.blob = c1 * spacing / r.drag;
  return s;
}

}  // namespace

std::vector<Vector3d> icosphere(int f)
{
  const std::vector<Vector3d> v = icosahedron();
  const auto neighbours = [](const Vector3d& a, const Vector3d& b) { return a.dot(b) > 0.4; };
  std::vector<Vector3d> p = v;
  for (std::size_t i = 0; i < v.size(); ++i)
    for (std::size_t j = i + 1; j < v.size(); ++j) {
      if (!neighbours(v[i], v[j])) continue;
      for (int a = 1; a < f; ++a) p.push_back((a * v[i] + (f - a) * v[j]).normalized());
      for (std::size_t k = j + 1; k < v.size(); ++k) {
        if (!neighbours(v[i], v[k]) || !neighbours(v[j], v[k])) continue;
        for (int a = 1; a < f; ++a)
          for (int b = 1; a + b < f; ++b) p.push_back((a * v[i] + b * v[j] + (f - a - b) * v[k]).normalized());
      }
    }
  return p;
}

const BlobSphere& blobSphere(int frequency)
{
  if (frequency < 1 || frequency > 12)
    throw std::invalid_argument("blobSphere: frequency " + std::to_string(frequency) + ", must be 1 to 12");
  static std::map<int, BlobSphere> known;
  static std::mutex guard;
  const std::lock_guard<std::mutex> lock(guard);
  const auto it = known.find(frequency);
  if (it != known.end()) return it->second;
  return known.emplace(frequency, calibrate(frequency)).first->second;
}

Matrix3d rotnePragerYamakawa(const Vector3d& d, double a, double b)
{
  const double r2 = d.squaredNorm(), r = std::sqrt(r2);
  if (r > a + b) {
    const double q = (a * a + b * b) / r2;
    return ((1 + q / 3) * Matrix3d::Identity() + (1 - q) / r2 * d * d.transpose()) / (8 * pi * r);
  }
  if (r <= std::abs(a - b)) return Matrix3d::Identity() / (6 * pi * std::max(a, b));
  const double diff2 = (a - b) * (a - b), r3 = 32 * r2 * r;
  const double even = (diff2 + 3 * r2) * (diff2 + 3 * r2), odd = (diff2 - r2) * (diff2 - r2);
  return ((16 * r2 * r * (a + b) - even) / r3 * Matrix3d::Identity() + 3 * odd / (r3 * r2) * d * d.transpose()) /
      (6 * pi * a * b);
}

Matrix6d blobResistance(const std::vector<Blob>& blobs, const Vector3d& about)
{
  const Eigen::Index n = static_cast<Eigen::Index>(blobs.size());
  Eigen::MatrixXd M(3 * n, 3 * n);  // only its lower half is used
  Eigen::Matrix<double, Eigen::Dynamic, 6> K(3 * n, 6);
  for (Eigen::Index j = 0; j < n; ++j) {
    const Blob& bj = blobs[j];
    M.block<3, 3>(3 * j, 3 * j) = Matrix3d::Identity() / (6 * pi * bj.a);
    for (Eigen::Index i = j + 1; i < n; ++i)
      M.block<3, 3>(3 * i, 3 * j) = rotnePragerYamakawa(blobs[i].x - bj.x, blobs[i].a, bj.a);
    const Vector3d x = bj.x - about;
    K.block<3, 3>(3 * j, 0).setIdentity();
    K.block<3, 3>(3 * j, 3) << 0, x.z(), -x.y(), -x.z(), 0, x.x(), x.y(), -x.x(), 0;
  }
  const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> solver(M);  // in place
  if (solver.info() != Eigen::Success)
    throw std::runtime_error("blobResistance: two blobs coincide, the mobility is singular");
  solver.matrixL().solveInPlace(K);
  return K.transpose() * K;
}

}  // namespace clay
