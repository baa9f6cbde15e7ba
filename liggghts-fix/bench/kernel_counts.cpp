// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
// Runs a kernel once, for callgrind to count its instructions
// (validation/cost/instructions): kernel_counts
// contact|contact_hertz|contact_rolling|coulomb|coulomb_single|screened|screened_single|dlvo|dlvo_far|packing
#include <cmath>
#include <cstdio>
#include <string>

#include "bench/kernel_scenes.h"

int main(int argc, char **argv)
{
  const std::string which = argc == 2 ? argv[1] : "";
  if (which == "contact" || which == "contact_hertz" || which == "contact_rolling") {
    clay::ContactScene scene(12, which == "contact" ? clay::NormalForce::linear : clay::NormalForce::hertz,
                             which == "contact_rolling");
    scene.step();
    std::printf("pairs %d\n", scene.pairs.size());
    return std::isfinite(scene.f[0]) ? 0 : 1;
  }
  const bool single = which == "coulomb_single" || which == "screened_single";
  const bool screened = which == "screened" || which == "screened_single";
  if (which == "coulomb" || screened || single) {
    clay::CoulombScene scene(4);
    scene.groups.single = single;
    if (screened) scene.law.debye = 2e-3;
    scene.step();
    std::printf("spheres %zu\n", scene.groups.x.size());
    return std::isfinite(scene.groups.wrenches[0].f[0]) ? 0 : 1;
  }
  if (which == "dlvo" || which == "dlvo_far") {  // far: as far as the charges
    clay::DlvoScene scene(4, which == "dlvo" ? 4e-3 : 10e-3);
    scene.step();
    std::printf("spheres %zu\n", scene.groups.x.size());
    return scene.groups.wrenches[0].f[0] != 0 ? 0 : 1;
  }
  if (which == "packing") {
    clay::PackingScene scene(2000);
    scene.message.reserve(2000 * 8 + 2);
    scene.step();
    std::printf("doubles %zu\n", scene.message.size());
    return scene.message.size() == 2000 * 8 + 2 ? 0 : 1;
  }
  std::fprintf(stderr,
               "kernel_counts: choose contact, contact_hertz, contact_rolling, coulomb, coulomb_single, "
               "screened, screened_single, dlvo, dlvo_far or packing\n");
  return 1;
}
