// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
// The styles of this folder: one line each. Read with FIX_CLASS or PAIR_CLASS
// defined it lists the styles, as LIGGGHTS's own style_fix.h and style_pair.h do.
#include "thermal/fix_brownian.h"
#include "contacts/fix_contact_history_lean.h"
#include "coupling/fix_couple_foam.h"
#include "placing/fix_insert_placed.h"
#include "films/fix_lubrication.h"
#include "clumps/fix_multisphere_clump.h"
#include "rest/fix_rest_bed.h"
#include "settling/fix_settling_curve.h"
#include "settling/fix_settling_profile.h"
#include "clumps/fix_template_clay.h"
#include "contacts/fix_wall_gran_lean.h"
#include "coulomb/pair_coul_clump.h"
#include "coulomb/pair_dlvo_clump.h"
#include "contacts/pair_gran_lean.h"
