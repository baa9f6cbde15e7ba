// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file charge_tiles.h
/// Coulomb forces between groups of charges, a register full of spheres at a time.
#pragma once

#include <vector>

namespace clay {

/// Charged spheres of one body, or loose ones that are near each other.
struct ChargeGroup {
  double x, y, z, r;  ///< ball around the centres [m]
  int begin, end;     ///< where they are in the lists of spheres
  long body;          ///< groups of the same body do not act on each other; -1 for loose spheres
  bool acted;         ///< their force is wanted

  bool loose() const { return body < 0; }
};

/// Who acts on whom: group a and each of second[first[a]] up to second[first[a+1]].
/// Of a body and loose spheres the body comes first; of two groups of loose
/// spheres either comes first once, and each comes with itself.
struct PairsInReach {
  std::vector<int> first, second;
};

/// Force [N] and torque [N m] about the ball's centre.
struct Wrench {
  double f[3], t[3];
};

/// An exponent of the screening that no pair goes beyond, however deep its spheres are in each other.
constexpr double screeningMost = 60;

/// F = q q (exp(decay (near - r)) (1/r2 + decay/r) - shift) for r < 1, in units of the cut-off, the
/// largest charge, and `force` [N]; without decay that is q q (1/r2 - shift).
struct TileLaw {
  double cutoff;  ///< [m]
  double shift, force;
  double decay;     ///< cut-off over Debye length
  double near = 0;  ///< in cut-offs
};

/// F = R (repulsion q q exp(-decay h) - attraction/(h2 (1 + retardation h))) for gaps h < gap, with
/// R = r r/(r + r), and as at `contact` below it; lengths in cut-offs.
struct DlvoTileLaw : TileLaw {
  double repulsion = 0, attraction = 0, retardation = 0, contact = 0, gap = 0;
};

/// Lists of x, y, z of all spheres.
struct Places {
  const double *x, *y, *z;
};
struct Forces {
  double *x, *y, *z;
};

/// The charges as the loops want them.
template <class Real>
struct ChargeTiles {
  static constexpr int LANES = 64 / sizeof(Real);

  /// Spheres of a group; lanes that are left over have no charge.
  struct alignas(64) Tile {
    Real x[LANES], y[LANES], z[LANES];  ///< from the ball's centre, in cut-offs
    Real q[LANES];
    Real fx[LANES], fy[LANES], fz[LANES];  ///< force of the groups that come first in a pair
    int used;
  };

  std::vector<Tile> tiles;
  std::vector<int> begin;  ///< tiles of each group, and the end

  struct alignas(64) Radii {
    Real r[LANES];
  };
  std::vector<Radii> radii;  ///< of the tiles' spheres [m], 0 in lanes that are left over

  /// Takes in the charges of the groups' spheres over the largest one.
  void build(const std::vector<ChargeGroup>& groups, const std::vector<double>& q, double largest);
  /// Takes in the spheres' radii.
  void takeRadii(const std::vector<ChargeGroup>& groups, const std::vector<double>& radius);
};

/// Adds up the forces of the pairs: on bodies to `wrenches`, on loose spheres to `f`.
void act(const PairsInReach& pairs, const TileLaw& law, const std::vector<ChargeGroup>& groups, Places x,
         ChargeTiles<float>& c, std::vector<Wrench>& wrenches, Forces f);
void act(const PairsInReach& pairs, const TileLaw& law, const std::vector<ChargeGroup>& groups, Places x,
         ChargeTiles<double>& c, std::vector<Wrench>& wrenches, Forces f);
void act(const PairsInReach& pairs, const DlvoTileLaw& law, const std::vector<ChargeGroup>& groups, Places x,
         ChargeTiles<double>& c, std::vector<Wrench>& wrenches, Forces f);

}  // namespace clay
