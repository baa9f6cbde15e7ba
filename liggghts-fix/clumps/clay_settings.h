// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file clay_settings.h
/// The words of fix particletemplate/clay.
#ifndef LMP_CLAY_SETTINGS_H
#define LMP_CLAY_SETTINGS_H

#include <string>
#include <vector>

#include "clumps/clump_geometry.h"

namespace LAMMPS_NS {

class LAMMPS;

/// What a fix particletemplate/clay command says, checked.
struct ClaySettings {
  std::string shape;               ///< illite, kaolinite or generic
  std::string seed;                ///< of LIGGGHTS's random numbers
  clay::Clump clump;               ///< spheres as given [m]
  double density = 0;              ///< of the solid [kg/m3]
  int type = 0;                    ///< clump type
  int positive = 0, negative = 0;  ///< atom types of the two charges; 0 where spheres have theirs
  std::vector<int> types;          ///< atom type of each sphere
  bool overlaps_once = false;      ///< volume union
  bool verbose = false;
  std::vector<std::string> passed_on;  ///< keywords of the mother class, as they are
};

/// Reads the command; ends the run, naming the word, when it is wrong.
ClaySettings read_clay_settings(LAMMPS *lmp, int narg, char **arg);

}

#endif
