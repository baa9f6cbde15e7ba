// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file allocations.h
/// What this program's containers take of memory; LIGGGHTS's own arrays do not count.
#pragma once

namespace test {

/// Watches operator new from its making on.
class Allocations {
 public:
  Allocations();
  /// Most bytes held at once beyond those held at the start.
  double most() const;

 private:
  long long start_;
};

}  // namespace test
