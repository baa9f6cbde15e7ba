// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "resistance/stokes_resistance.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <mutex>
#include <stdexcept>

namespace clay {
namespace {

constexpr double pi = 3.14159265358979323846;
using Eigen::Matrix3d;
using Eigen::Vector3d;

// Spheres that lie within another one leave no trace on the surface.
Clump withoutHidden(const Clump& c)
{
  Clump kept;
  for (std::size_t i = 0; i < c.size(); ++i) {
    bool hidden = false;
    for (std::size_t j = 0; j < c.size() && !hidden; ++j) {
      if (j == i) continue;
      const double room = c[j].r - c[i].r - (c[j].x - c[i].x).norm();
      const double tiny = 1e-9 * c[j].r;
      hidden = room > tiny || (room > -tiny && (c[j].r > c[i].r + tiny || j < i));
    }
    if (!hidden) kept.push_back(c[i]);
  }
  return kept;
}

// Axes that turn with the clump, from its spheres' centres.
Matrix3d ownAxes(const Clump& c)
{
  Vector3d middle = Vector3d::Zero();
  for (const auto& s : c) middle += s.x / double(c.size());
  const auto farthest = [&](const Matrix3d& keep) {
    double reach = 0;
    Vector3d best = Vector3d::Zero();
    for (const auto& s : c) {
      const Vector3d d = keep * (s.x - middle);
      if (d.norm() > reach * (1 + 1e-6)) {
        reach = d.norm();
        best = d;
      }
    }
    return best;
  };
  const Vector3d first = farthest(Matrix3d::Identity());
  if (first.norm() < 1e-9) return Matrix3d::Identity();
  const Vector3d u = first.normalized();
  const Vector3d second = farthest(Matrix3d::Identity() - u * u.transpose());
  const Vector3d v = second.norm() < 1e-6 ? u.unitOrthogonal() : second.normalized();
  Matrix3d axes;
  axes << u, v, u.cross(v);
  return axes;
}

bool mapsOntoItself(const Clump& c, const Matrix3d& Q)
{
  return std::all_of(c.begin(), c.end(), [&](const ClumpSphere& s) {
    return std::any_of(c.begin(), c.end(), [&](const ClumpSphere& t) {
      return std::abs(s.r - t.r) < 1e-7 && (Q * s.x - t.x).norm() < 1e-7;
    });
  });
}

// Turns and mirrorings about the origin that leave the clump as it is. Of a
// clump in one line, as many as make a tensor symmetric about the line.
std::vector<Matrix3d> symmetries(const Clump& c)
{
  std::vector<Matrix3d> found;
  const auto consider = [&](const Matrix3d& Q) {
    if (!mapsOntoItself(c, Q)) return;
    for (const auto& P : found)
      if ((P - Q).norm() < 1e-5) return;
    found.push_back(Q);
  };
  const auto frame = [](const Vector3d& a, const Vector3d& b) {
    Matrix3d f;
    const Vector3d u = a.normalized(), v = (b - u.dot(b) * u).normalized();
    f << u, v, u.cross(v);
    return f;
  };
  const Matrix3d mirror = Vector3d(1, 1, -1).asDiagonal();

  std::size_t first = 0, second = 0;
  double reach = 0, width = 0;
  for (std::size_t i = 0; i < c.size(); ++i)
    if (c[i].x.norm() > reach * (1 + 1e-6)) {
      reach = c[i].x.norm();
      first = i;
    }
  for (std::size_t i = 0; i < c.size() && reach > 1e-7; ++i) {
    const double w = c[first].x.normalized().cross(c[i].x).norm();
    if (w > width * (1 + 1e-6)) {
      width = w;
      second = i;
    }
  }
  if (width < 1e-6) {  // a point or a line: quarter turns and flips of its axes
    const Vector3d u = reach > 1e-7 ? c[first].x.normalized() : Vector3d::UnitX();
    const Matrix3d own = frame(u, u.unitOrthogonal());
    for (int p = 0; p < 6; ++p)
      for (int s = 0; s < 8; ++s) {
        static const int order[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
        Matrix3d Q = Matrix3d::Zero();
        for (int k = 0; k < 3; ++k) Q(k, order[p][k]) = (s >> k) & 1 ? -1 : 1;
        consider(own * Q * own.transpose());
      }
    return found;
  }
  const Matrix3d own = frame(c[first].x, c[second].x);
  const auto alike = [&](std::size_t i, std::size_t j) {
    return std::abs(c[i].r - c[j].r) < 1e-7 && std::abs(c[i].x.norm() - c[j].x.norm()) < 1e-7;
  };
  for (std::size_t i = 0; i < c.size(); ++i)
    for (std::size_t j = 0; j < c.size(); ++j) {
      if (!alike(i, first) || !alike(j, second)) continue;
      if (std::abs(c[i].x.dot(c[j].x) - c[first].x.dot(c[second].x)) > 1e-6) continue;
      const Matrix3d other = frame(c[i].x, c[j].x);
      consider(other * own.transpose());
      consider(other * mirror * own.transpose());
    }
  return found;
}

// A turn or mirroring of the tensor; the parts that join force and spin are
// pseudotensors.
Matrix6d transformed(const Matrix6d& R, const Matrix3d& Q)
{
  const double hand = Q.determinant() < 0 ? -1 : 1;
  Matrix6d T = Matrix6d::Zero();
  T.topLeftCorner<3, 3>() = Q;
  T.bottomRightCorner<3, 3>() = hand * Q;
  return T * R * T.transpose();
}

Matrix6d shifted(const Matrix6d& R, const Vector3d& d)
{
  // a motion (v, w) of the new point is (v - w x d, w) of the old one
  Matrix6d S = Matrix6d::Identity();
  S.topRightCorner<3, 3>() << 0, -d.z(), d.y(), d.z(), 0, -d.x(), -d.y(), d.x(), 0;
  return S.transpose() * R * S;
}

// The clump, of size one and in its own axes, covered with blobs.
std::vector<Blob> cover(const Clump& c, int frequency)
{
  std::vector<Blob> blobs;
  for (const auto& s : c) {
    const BlobSphere& ball = blobSphere(std::max(1, int(std::lround(frequency * s.r))));
    for (const auto& p : ball.points) {
      const Vector3d at = s.x + s.r * p;
      const bool inside =
          std::any_of(c.begin(), c.end(), [&](const ClumpSphere& o) { return (at - o.x).norm() < o.r * (1 - 1e-9); });
      if (!inside) blobs.push_back({s.x + ball.shell * s.r * p, ball.blob * s.r});
    }
  }
  return blobs;
}

// Largest relative change of the dissipation y.R y over all motions y.
double largestChange(const Matrix6d& before, const Matrix6d& now)
{
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(before, now, Eigen::EigenvaluesOnly);
  return (solver.eigenvalues().array() - 1).abs().maxCoeff();
}

Matrix6d scaled(Matrix6d R, double length)
{
  R.topLeftCorner<3, 3>() *= length;
  R.topRightCorner<3, 3>() *= length * length;
  R.bottomLeftCorner<3, 3>() *= length * length;
  R.bottomRightCorner<3, 3>() *= length * length * length;
  return R;
}

void check(const Clump& clump)
{
  if (clump.empty()) throw std::invalid_argument("stokesResistance: the clump has no spheres");
  for (std::size_t i = 0; i < clump.size(); ++i)
    if (!(clump[i].r > 0) || !clump[i].x.allFinite() || !std::isfinite(clump[i].r))
      throw std::invalid_argument("stokesResistance: sphere " + std::to_string(i + 1) + " has radius " +
                                  std::to_string(clump[i].r) + ", must be positive and finite");
}

// About the mean of the spheres' centres, in the clump's own axes and size.
StokesResistance refine(const Clump& c, const StokesOptions& o)
{
  StokesResistance result;
  const std::vector<Matrix3d> group = symmetries(c);
  Matrix6d before = Matrix6d::Zero();
  for (int f = 1; f <= o.maxFrequency; ++f) {
    const std::vector<Blob> blobs = cover(c, f);
    const long unknowns = 3 * long(blobs.size());
    if (unknowns > o.maxUnknowns) {
      if (f == 1)
        throw std::invalid_argument("stokesResistance: maxUnknowns " + std::to_string(o.maxUnknowns) +
                                    ", the coarsest cover of this clump needs " + std::to_string(unknowns));
      break;
    }
    const Matrix6d raw = blobResistance(blobs, Vector3d::Zero());
    Matrix6d now = Matrix6d::Zero();
    for (const auto& Q : group) now += transformed(raw, Q) / double(group.size());

    StokesLevel level{f, int(blobs.size()), 1.0};
    if (f > 1) level.change = largestChange(before, now);
    result.levels.push_back(level);
    result.R = now;
    if (f > 1 && o.extrapolate) {
      const double fine = f * f, coarse = (f - 1) * (f - 1);
      const Matrix6d limit = now + coarse / (fine - coarse) * (now - before);
      if (limit.llt().info() == Eigen::Success) result.R = limit;
    }
    before = now;
    if (f > 1 && level.change <= o.tolerance) {
      result.converged = true;
      break;
    }
  }
  return result;
}

}  // namespace

StokesResistance stokesResistance(const Clump& clump, const Vector3d& about, const StokesOptions& o)
{
  check(clump);
  Vector3d middle = Vector3d::Zero();
  double unit = 0;
  const Clump outer = withoutHidden(clump);
  for (const auto& s : outer) {
    middle += s.x / double(outer.size());
    unit = std::max(unit, s.r);
  }
  const Matrix3d axes = ownAxes(outer);
  Clump own = outer;
  std::vector<double> key{o.tolerance, double(o.maxUnknowns), double(o.maxFrequency), double(o.extrapolate)};
  for (auto& s : own) {
    s.x = axes.transpose() * (s.x - middle) / unit;
    s.r /= unit;
    // to nine digits: the same clump, turned or elsewhere, is known again
    for (double v : {s.x.x(), s.x.y(), s.x.z(), s.r}) key.push_back(std::round(v * 1e9));
  }

  static std::map<std::vector<double>, StokesResistance> known;
  static std::mutex guard;
  const std::lock_guard<std::mutex> lock(guard);
  auto it = known.find(key);
  if (it == known.end()) it = known.emplace(key, refine(own, o)).first;

  StokesResistance result = it->second;
  result.R = shifted(transformed(scaled(result.R, unit), axes), about - middle);
  result.R = 0.5 * (result.R + result.R.transpose()).eval();
  return result;
}

std::string StokesResistance::report() const
{
  std::string s = "Stokes resistance:";
  char text[80];
  for (const auto& l : levels) {
    if (&l == &levels.front()) std::snprintf(text, sizeof text, " %d blobs", l.blobs);
    else std::snprintf(text, sizeof text, ", %d blobs (change %.3g %%)", l.blobs, 100 * l.change);
    s += text;
  }
  return s + (converged ? "" : ": not converged");
}

std::string StokesResistance::warning() const
{
  if (converged || levels.empty()) return "";
  char text[220];
  if (levels.size() == 1)
    std::snprintf(text, sizeof text,
                  "its Stokes resistance has not converged: only %d blobs fit into the solve, and how far "
                  "off they are is not known; use fewer spheres, or clumpDrag sphereSum",
                  levels.back().blobs);
  else
    std::snprintf(text, sizeof text,
                  "its Stokes resistance has not converged: with the last level, %d blobs, it still changed by "
                  "%.2g %% (tolerance %.2g %%); the drag is uncertain by about that, fewer spheres need fewer blobs",
                  levels.back().blobs, 100 * levels.back().change, 100 * StokesOptions().tolerance);
  return text;
}

Matrix6d rotated(const Matrix6d& R, const Matrix3d& Q) { return transformed(R, Q); }

Matrix6d movedTo(const Matrix6d& R, const Vector3d& shift) { return shifted(R, shift); }

double volumeDragRatio(const Matrix6d& R, double volume, const Vector3d& n)
{
  const Vector3d u = n.normalized();
  return u.dot(R.topLeftCorner<3, 3>() * u) / (6 * pi * std::cbrt(0.75 * volume / pi));
}

double meanResistance(const Matrix6d& R) { return 3 / R.inverse().topLeftCorner<3, 3>().trace(); }

}  // namespace clay
