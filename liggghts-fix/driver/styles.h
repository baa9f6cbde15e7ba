// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
// The styles of this folder: one line each. Read with FIX_CLASS or PAIR_CLASS
// defined it lists the styles, as LIGGGHTS's own style_fix.h and style_pair.h do.
#include "fix_brownian.h"
#include "fix_contact_history_lean.h"
#include "fix_couple_foam.h"
#include "fix_insert_placed.h"
#include "fix_lubrication.h"
#include "fix_multisphere_clump.h"
#include "fix_rest_bed.h"
#include "fix_settling_curve.h"
#include "fix_template_clay.h"
#include "fix_wall_gran_lean.h"
#include "pair_coul_clump.h"
#include "pair_gran_lean.h"
