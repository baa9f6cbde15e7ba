// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file coul_kernel.h
/// Coulomb forces between groups of charged spheres, cut off at a distance.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "coulomb/charge_tiles.h"
#include "coulomb/dlvo_law.h"

namespace clay {

/// F = k q_i q_j / r2 for r < cutoff; shifted: F = k q_i q_j (1/r2 - 1/cutoff2).
/// Screened with Debye length L: F = k q_i q_j exp((near - r)/L) (1/r2 + 1/(L r)), and shifted
/// by its own value at the cut-off. Each follows from a potential that is zero there.
/// `near` keeps numbers in range: weight() has it, too. The charges of these laws are
/// true ones times their weights.
struct CoulombLaw {
  double k = 8.9875517873681764e9;  ///< 1/(4 pi eps0 eps_r) [N m2/C2]
  double cutoff = 0;                ///< [m]
  bool shifted = false;
  double debye = 0;      ///< Debye length [m]; 0: not screened
  bool spheres = false;  ///< screened by ions that stay outside of the spheres, or else as points
  double near = 0;       ///< distance from which the screening is counted [m]

  /// What a charge counts on a sphere of radius a [m]: exp((a - near/2)/L)/(1 + a/L) if `spheres`.
  double weight(double a) const;
  /// Force over distance for two charges a distance r apart [N/m].
  double forceOverDistance(double qq, double r) const;
  /// Their energy [J].
  double energy(double qq, double r) const;

 private:
  double screening(double r) const { return debye > 0 ? std::exp(std::min(screeningMost, (near - r) / debye)) : 1; }
  /// Force of two unit charges over k, uncut [1/m2].
  double slope(double r) const { return screening(r) * (1 / (r * r) + (debye > 0 ? 1 / (debye * r) : 0)); }
};

/// Charged spheres in order of their groups, and the forces on them.
class ChargeGroups {
 public:
  std::vector<double> x, y, z, q;  ///< centres [m], charges [C] or potentials [V]
  std::vector<double> radius;      ///< [m], for DlvoLaw
  std::vector<ChargeGroup> groups;
  std::vector<Wrench> wrenches;    ///< on the groups of bodies
  std::vector<double> fx, fy, fz;  ///< on loose spheres [N]

  void clear();
  void add(double px, double py, double pz, double charge);
  /// Makes a group of the spheres added since the last one.
  void close(long body, bool acted);
  /// To be called when x, y, z were changed.
  void moved();

  /// Single precision in place of double leaves an error of the order of 1e-7 of the largest force.
  bool single = false;

  /// Sets the forces.
  void act(const CoulombLaw& law);
  /// In double precision.
  void act(const DlvoLaw& law);

 private:
  bool listHolds(double skin) const;
  void list(double range);
  void refresh(double cutoff);

  PairsInReach pairs_;       // with a skin, for many calls
  std::vector<double> was_;  // balls when it was made
  double largest_ = 0;       // charge
  ChargeTiles<float> floats_;
  ChargeTiles<double> doubles_;
};

/// Pairs of groups whose balls are closer than `range` [m] and of which one is acted on;
/// a group of loose spheres is also a pair with itself.
std::vector<std::pair<int, int>> pairsInReach(const ChargeGroups& c, double range);

/// Calls visit(i, j, r) for every pair of spheres that acts, r apart.
template <class Visit>
void eachPair(const ChargeGroups& c, double cutoff, Visit visit)
{
  for (const auto& p : pairsInReach(c, cutoff)) {
    const auto &A = c.groups[p.first], &B = c.groups[p.second];
    for (int i = A.begin; i < A.end; ++i)
      for (int j = B.begin; j < (p.first == p.second ? i : B.end); ++j) {
        const double r = std::hypot(c.x[i] - c.x[j], c.y[i] - c.y[j], c.z[i] - c.z[j]);
        if (r < cutoff) visit(i, j, r);
      }
  }
}

}  // namespace clay
