// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file coul_kernel.h
/// Coulomb forces between groups of charged spheres, cut off at a distance.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

namespace clay {

/// F = k q_i q_j / r2 for r < cutoff; shifted: F = k q_i q_j (1/r2 - 1/cutoff2).
/// Either follows from a potential that is zero at the cut-off.
struct CoulombLaw {
  double k = 8.9875517873681764e9;  ///< 1/(4 pi eps0 eps_r) [N m2/C2]
  double cutoff = 0;                ///< [m]
  bool shifted = false;

  /// Force over distance for two charges a distance r apart [N/m].
  double forceOverDistance(double qq, double r) const;
  /// Their energy [J].
  double energy(double qq, double r) const;
};

/// Charged spheres in order of their groups, one array a component.
/// A group holds the spheres of one body, or loose ones that are near each other.
struct ChargeGroups {
  struct Group {
    int begin, end;       ///< spheres of the group
    long body;            ///< groups of the same body do not act on each other; -1 for none
    bool acted;           ///< has spheres whose force is wanted
    double x, y, z, r;    ///< ball around the centres
  };
  std::vector<double> x, y, z, q;     ///< centres [m], charges [C]
  std::vector<double> fx, fy, fz;     ///< forces [N]
  std::vector<Group> groups;

  /// What coulombForces works with: the spheres again, each group filled up to
  /// whole vector registers with spheres without charge.
  struct Lanes {
    static constexpr int WIDTH = 8;  ///< doubles in the widest register
    std::vector<int> begin;          ///< of each group
    std::vector<int> reaching;       ///< spheres of a group within another's reach
    std::vector<double> x, y, z, q;
    std::vector<double> fx, fy, fz;  ///< force on a sphere of a pair's second group
    std::vector<double> sx, sy, sz;  ///< force on one of its first, in WIDTH parts
  } lanes;

  /// Forgets the spheres and groups; the forces stay until they are set anew.
  void clear();
  void add(double px, double py, double pz, double charge);
  /// Makes a group of the spheres added since the last one.
  void close(long body, bool acted);
};

/// Pairs of groups within each other's reach, of which at least one is acted
/// on; a group of loose spheres is also a pair with itself.
std::vector<std::pair<int, int>> pairsInReach(const ChargeGroups& c, const CoulombLaw& law);

/// Sets the forces between the groups.
void coulombForces(ChargeGroups& c, const CoulombLaw& law);

/// Calls visit(i, j, r) for every pair of spheres that acts, r apart.
template <class Visit>
void eachPair(const ChargeGroups& c, const CoulombLaw& law, Visit visit)
{
  for (const auto& p : pairsInReach(c, law)) {
    const auto &A = c.groups[p.first], &B = c.groups[p.second];
    for (int i = A.begin; i < A.end; ++i)
      for (int j = B.begin; j < (p.first == p.second ? i : B.end); ++j) {
        const double r = std::hypot(c.x[i] - c.x[j], c.y[i] - c.y[j], c.z[i] - c.z[j]);
        if (r < law.cutoff) visit(i, j, r);
      }
  }
}

}  // namespace clay
