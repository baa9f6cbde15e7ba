// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#ifndef LMP_REGISTER_STYLES_H
#define LMP_REGISTER_STYLES_H

namespace LAMMPS_NS {

class LAMMPS;

/// Makes the styles of styles.h known to a LIGGGHTS that was built without
/// them. To be called after each `new LAMMPS` and before its script is read.
void register_clay_styles(LAMMPS *lmp);

/// Makes pair_style gran and fix wall/gran take the lean loops where these can do what a
/// script says. After register_clay_styles.
void offer_lean_contacts(LAMMPS *lmp);

}

#endif
