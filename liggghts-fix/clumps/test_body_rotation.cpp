// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "clumps/body_rotation.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

using namespace LAMMPS_NS;
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace {

void put(RotationBlock &block, int i, const Quaterniond &q, const Vector3d &I, const Vector3d &L)
{
  const double values[4] = {q.w(), q.x(), q.y(), q.z()};
  const Matrix3d axes = q.toRotationMatrix();
  for (int k = 0; k < 4; ++k) block.q[k][i] = values[k];
  for (int k = 0; k < 3; ++k) {
    block.inertia[k][i] = I[k];
    block.L[k][i] = L[k];
    for (int j = 0; j < 3; ++j) block.axes[3 * j + k][i] = axes(k, j);
  }
}

Matrix3d axes_of(const RotationBlock &block, int i)
{
  Matrix3d axes;
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 3; ++j) axes(k, j) = block.axes[3 * j + k][i];
  return axes;
}

Quaterniond orientation(const RotationBlock &block, int i)
{
  return {block.q[0][i], block.q[1][i], block.q[2][i], block.q[3][i]};
}

RotationBlock filled(const Quaterniond &q, const Vector3d &I, const Vector3d &L)
{
  RotationBlock block;
  for (int i = 0; i < RotationBlock::SIZE; ++i) put(block, i, q, (1 + i) * I, (1 + i) * L);
  return block;
}

const Quaterniond tilted(Eigen::AngleAxisd(0.7, Vector3d(1, -2, 0.5).normalized()));

}  // namespace

TEST(BodyRotation, AboutAPrincipalAxisIsUniform)
{
  const Vector3d I(1e-10, 2e-10, 3e-10);
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d e = tilted.toRotationMatrix().col(axis);
    RotationBlock block = filled(tilted, I, I[axis] * 50 * e);
    for (int n = 0; n < 1000; ++n) block.turn(1e-5);
    const Matrix3d expected = Eigen::AngleAxisd(0.5, e) * tilted.toRotationMatrix();
    for (int i = 0; i < RotationBlock::SIZE; ++i) {
      EXPECT_LT((axes_of(block, i) - expected).norm(), 1e-8) << axis;
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(block.w[k][i], 50 * e[k], 1e-7);
    }
  }
}

TEST(BodyRotation, OfASymmetricTopPrecesses)
{
  // about L at |L|/I1, and about its own axis at (1/I3 - 1/I1) L3
  const Vector3d I(2e-10, 2e-10, 3e-10);
  const Matrix3d start = tilted.toRotationMatrix();
  const Vector3d L = start * Vector3d(4e-9, 0, 9e-9);
  RotationBlock block = filled(tilted, I, L);
  for (int n = 0; n < 4000; ++n) block.turn(1e-5);
  const double t = 0.04;
  const Matrix3d expected = Eigen::AngleAxisd(L.norm() / I[0] * t, L.normalized()) * start *
      Eigen::AngleAxisd((1 / I[2] - 1 / I[0]) * 9e-9 * t, Vector3d::UnitZ());
  for (int i = 0; i < RotationBlock::SIZE; ++i) EXPECT_LT((axes_of(block, i) - expected).norm(), 1e-6);
}

TEST(BodyRotation, OfAnAsymmetricBodyKeepsItsEnergyToThirdOrder)
{
  const Vector3d I(1e-10, 2e-10, 3e-10), L = tilted * Vector3d(1e-9, 2e-8, -2e-9);
  auto drift = [&](double dt) {
    RotationBlock block = filled(tilted, I, L);
    auto energy = [&] {
      const Vector3d local = axes_of(block, 2).transpose() * L;
      return (local.array().square() / I.array()).sum();
    };
    const double before = energy();
    for (int n = 0; n * dt < 0.0995; ++n) block.turn(dt);
    EXPECT_NEAR(orientation(block, 2).norm(), 1, 1e-15);
    return std::abs(energy() / before - 1);
  };
  const double coarse = drift(1e-3), fine = drift(2.5e-4);
  EXPECT_LT(fine, 1e-4);
  EXPECT_LT(fine, coarse / 8);
}

TEST(BodyRotation, PlacesDoNotMixAndNoInertiaMeansNoSpin)
{
  RotationBlock block = filled(tilted, Vector3d(1e-10, 2e-10, 3e-10), Vector3d(1e-9, 2e-9, -3e-9));
  RotationBlock other = block;
  put(other, 1, Quaterniond::Identity(), Vector3d(0, 1e-10, 1e-10), Vector3d(1e-9, 0, 2e-9));
  block.turn(1e-4);
  other.turn(1e-4);
  for (int k = 0; k < 4; ++k)
    for (int i : {0, 2, 3, 7}) EXPECT_EQ(block.q[k][i], other.q[k][i]);
  EXPECT_NEAR(other.w[0][1], 0, 1e-4);
  EXPECT_NEAR(other.w[2][1], 20, 1e-9);
  EXPECT_NEAR(orientation(other, 1).angularDistance(Quaterniond::Identity()), 2e-3, 1e-9);
}

TEST(BodyRotation, SpinIsThatOfTheAngularMomentum)
{
  const Matrix3d Q = tilted.toRotationMatrix();
  const Vector3d I(1e-10, 2e-10, 0), local(30, -20, 10), L = Q * Vector3d(3e-9, -4e-9, 5e-9);
  double w[3];
  spin(L.data(), Q.col(0).data(), Q.col(1).data(), Q.col(2).data(), I.data(), w);
  const Vector3d expected = Q * Vector3d(local[0], local[1], 0);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(w[k], expected[k], 1e-12);
}

TEST(BodyRotation, OfManyBodiesIsThatOfEach)
{
  // more than a block and not a whole number of them
  enum { N = 2 * RotationBlock::SIZE + 3 };
  double q[4 * N], ex[3 * N], ey[3 * N], ez[3 * N], w[3 * N] = {}, L[3 * N], inertia[3 * N];
  for (int b = 0; b < N; ++b) {
    const Quaterniond turned(Eigen::AngleAxisd(0.1 * b, Vector3d(1, b, -2).normalized()));
    const Matrix3d axes = turned.toRotationMatrix();
    const double values[4] = {turned.w(), turned.x(), turned.y(), turned.z()};
    std::copy(values, values + 4, q + 4 * b);
    for (int k = 0; k < 3; ++k) {
      ex[3 * b + k] = axes(k, 0);
      ey[3 * b + k] = axes(k, 1);
      ez[3 * b + k] = axes(k, 2);
      L[3 * b + k] = 1e-9 * (k - 0.3 * b);
      inertia[3 * b + k] = 1e-10 * (1 + k);
    }
  }
  for (int begin : {0, 5}) {
    const int end = begin + (begin ? 2 : N);
    std::vector<RotationBlock> each;
    for (int b = begin; b < end; ++b) {
      RotationBlock block = filled(Quaterniond::Identity(), Vector3d(1, 1, 1), Vector3d(0, 0, 0));
      for (int k = 0; k < 4; ++k) block.q[k][0] = q[4 * b + k];
      for (int k = 0; k < 3; ++k) {
        block.L[k][0] = L[3 * b + k];
        block.inertia[k][0] = inertia[3 * b + k];
        block.axes[k][0] = ex[3 * b + k];
        block.axes[k + 3][0] = ey[3 * b + k];
        block.axes[k + 6][0] = ez[3 * b + k];
      }
      block.turn(1e-3);
      each.push_back(block);
    }
    turn_bodies({q, ex, ey, ez, w, L, inertia}, begin, end, 1e-3);
    for (int b = begin; b < end; ++b) {
      const RotationBlock &block = each[b - begin];
      for (int k = 0; k < 4; ++k) EXPECT_NEAR(q[4 * b + k], block.q[k][0], 1e-15);
      for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(ex[3 * b + k], block.axes[k][0], 1e-15);
        EXPECT_NEAR(ey[3 * b + k], block.axes[k + 3][0], 1e-15);
        EXPECT_NEAR(ez[3 * b + k], block.axes[k + 6][0], 1e-15);
        EXPECT_NEAR(w[3 * b + k], block.w[k][0], 1e-12);
      }
    }
  }
}
