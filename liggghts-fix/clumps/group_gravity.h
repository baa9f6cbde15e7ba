// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file group_gravity.h
/// Gravity on particles of several groups.
#pragma once

#include <array>
#include <vector>

namespace clay {

/// Gravity by group: the sum of what holds for a sphere's groups.
class GroupGravity {
 public:
  void clear() { parts_.clear(); }
  /// Adds g [m/s2] on a group.
  void add(int group, const std::array<double, 3> &g) { parts_.push_back({group, g}); }
  /// Adds another one of the same groups, times the weight.
  void gather(const GroupGravity &other, double weight)
  {
    if (parts_.size() != other.parts_.size()) {
      parts_ = other.parts_;
      for (Part &p : parts_) p.g = {};
    }
    for (std::size_t i = 0; i < parts_.size(); i++)
      for (int k = 0; k < 3; k++) parts_[i].g[k] += weight * other.parts_[i].g[k];
  }
  GroupGravity by(double factor) const
  {
    GroupGravity all;
    all.gather(*this, factor);
    return all;
  }
  /// On a sphere of these groups [m/s2].
  std::array<double, 3> on(int groups) const
  {
    std::array<double, 3> sum{};
    for (const Part &p : parts_)
      if (p.group & groups)
        for (int k = 0; k < 3; k++) sum[k] += p.g[k];
    return sum;
  }

  /// All of it as numbers, four a group, for a restart file; and back.
  std::vector<double> numbers() const
  {
    std::vector<double> all;
    for (const Part &p : parts_) all.insert(all.end(), {static_cast<double>(p.group), p.g[0], p.g[1], p.g[2]});
    return all;
  }
  void take(const std::vector<double> &numbers)
  {
    clear();
    for (std::size_t i = 0; i + 4 <= numbers.size(); i += 4)
      add(static_cast<int>(numbers[i]), {numbers[i + 1], numbers[i + 2], numbers[i + 3]});
  }

 private:
  struct Part {
    int group;
    std::array<double, 3> g;
  };
  std::vector<Part> parts_;
};

}  // namespace clay
