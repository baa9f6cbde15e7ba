// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
// Google Benchmarks of the DEM half's kernels.
#include <benchmark/benchmark.h>

#include "bench/kernel_scenes.h"

namespace {

void contact(benchmark::State &state)
{
  clay::ContactScene scene(static_cast<int>(state.range(0)), static_cast<clay::NormalForce>(state.range(1)),
                           state.range(2) != 0);
  for (auto _ : state) scene.step();
  state.SetItemsProcessed(state.iterations() * scene.pairs.size());
}

void coulomb(benchmark::State &state)
{
  clay::CoulombScene scene(static_cast<int>(state.range(0)));
  scene.groups.single = state.range(1) != 0;
  for (auto _ : state) scene.step();
  state.SetItemsProcessed(state.iterations() * scene.groups.x.size());
}

void packing(benchmark::State &state)
{
  clay::PackingScene scene(static_cast<int>(state.range(0)));
  for (auto _ : state) scene.step();
  state.SetItemsProcessed(state.iterations() * scene.count);
}

}  // namespace

BENCHMARK(contact)->ArgNames({"side", "hertz", "rolling"})->ArgsProduct({{12, 40}, {0, 1}, {0, 1}});
BENCHMARK(coulomb)->ArgNames({"side", "single"})->Args({4, 0})->Args({4, 1})->Args({8, 0})->Args({8, 1});
BENCHMARK(packing)->Arg(2000)->Arg(50000);
BENCHMARK_MAIN();
