// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "body_spheres.h"

#include <algorithm>

namespace LAMMPS_NS {

void BodySpheres::clear(int nbody)
{
  added_.clear();
  first_.assign(nbody + 1, 0);
  counted_.assign(nbody, 0);
  shifted_.assign(nbody, 0);
}

void BodySpheres::add(int b, int atom, const double *d, bool counts, bool shifted)
{
  added_.push_back({b, atom, {d[0], d[1], d[2]}, counts, shifted});
  first_[b + 1]++;
  if (counts) counted_[b]++;
  if (shifted) shifted_[b] = 1;
}

void BodySpheres::sort()
{
  const int nbody = bodies();
  for (int b = 0; b < nbody; b++) first_[b + 1] += first_[b];
  std::vector<int> next(first_.begin(), first_.end() - 1), image(nbody);
  for (int b = 0; b < nbody; b++) image[b] = counted_[b] += first_[b];

  atom_.resize(added_.size());
  d_.resize(3 * added_.size());
  r_.resize(3 * added_.size());
  for (const Added &a : added_) {
    const int n = a.counts ? next[a.body]++ : image[a.body]++;
    atom_[n] = a.atom;
    std::copy(a.d, a.d + 3, &d_[3 * n]);
  }
}

}  // namespace LAMMPS_NS
