// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file insertion_streams.h
/// The random numbers by which grains are inserted: those of regions, for their
/// places, and of fixes insert. Of the first LIGGGHTS's restart files hold nothing,
/// of the others the first processor's alone.
#ifndef LMP_INSERTION_STREAMS_H
#define LMP_INSERTION_STREAMS_H

#include <vector>

namespace LAMMPS_NS {

class LAMMPS;

/// Where all streams are on each processor; whole on the first one. Collective.
std::vector<double> insertion_streams(LAMMPS *lmp);

/// Goes on there, in the regions and fixes of the same names; on a processor that was not there
/// before at the first one's number and its own, as LIGGGHTS does.
void go_on_with_streams(LAMMPS *lmp, const std::vector<double> &saved);

}  // namespace LAMMPS_NS

#endif
