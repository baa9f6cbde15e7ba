// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "allocations.h"

#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<long long> held{0}, most_held{0};

}

void *operator new(std::size_t size)
{
  void *p = std::malloc(size ? size : 1);
  if (!p) throw std::bad_alloc();
  const long long now = held += malloc_usable_size(p);
  if (now > most_held) most_held = now;
  return p;
}

void operator delete(void *p) noexcept
{
  if (!p) return;
  held -= malloc_usable_size(p);
  std::free(p);
}

void operator delete(void *p, std::size_t) noexcept { operator delete(p); }

namespace test {

Allocations::Allocations() : start_(held) { most_held = start_; }

double Allocations::most() const { return static_cast<double>(most_held - start_); }

}  // namespace test
