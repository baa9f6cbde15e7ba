// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file routing.h
/// Which CFD ranks a DEM rank's particles go to; internal to exchange/.
#pragma once

#include <vector>

#include "exchange/fields.h"

namespace clay {

/// Routes particles to the CFD ranks whose box they touch.
class Routing {
 public:
  /// What goes to one CFD rank.
  struct Route {
    std::vector<int> particles;  ///< index here of each particle there
    std::vector<double> shares;  ///< index there, number of sharers, their ranks; ...
  };

  /// \param boxes  of each CFD rank [m]: first that of its cells, empty when it
  ///               has none, then those where a sphere reaches it by an image
  explicit Routing(std::vector<RankBoxes> boxes = {});

  /// Routes n spheres with centres x [m] and radii r [m]. A sphere that touches
  /// no box goes to the nearest one, whose rank will find no cell for it.
  void route(const double* x, const double* r, int n);

  std::size_t size() const { return routes_.size(); }
  const Route& operator[](std::size_t rank) const { return routes_[rank]; }

 private:
  void chooseCandidates(const double* x, const double* r, int n);
  int nearest(const double* x) const;

  struct Candidate {
    int rank;
    Box box;
  };
  std::vector<RankBoxes> boxes_;
  std::vector<Route> routes_;
  std::vector<Candidate> candidates_;  // in the order of the ranks
  std::vector<int> touched_;
};

}  // namespace clay
