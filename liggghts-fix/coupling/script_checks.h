// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file script_checks.h
/// Whether the script around fix couple/foam goes with it. What is wrong is
/// thrown as std::invalid_argument, one line.
#pragma once

#include <string>
#include <vector>

#include "coupling/moving_groups.h"
#include "coupling/run_checks.h"

namespace clay {

/// The drag of free spheres is implicit: the usual forces must stand above, `mine`
/// being the place of fix couple/foam among the script's.
void check_order(const std::vector<FixEntry> &fixes, int mine);

/// Fixes of another coupling take no part in this one, and another buoyancy would count twice.
void check_others(const std::vector<FixEntry> &fixes);

/// What a fix holds must be known by group and axis.
void check_holders(const std::vector<FixEntry> &fixes);

/// Added mass takes part of all other forces: each must stand above.
void check_last(const std::vector<FixEntry> &fixes, int mine);

/// A run ends with an exchange.
void check_interval(long steps, int interval);

/// A body in many contacts needs a smaller step than one contact does: dt against
/// the limit [s] of `which` at rest.
void check_contact_limit(double dt, double limit, const std::string &which);

/// Hertz's contacts grow stiff with the overlap, so that no limit is known beforehand: a
/// warning when dt is above 0.3 of the Rayleigh time [s] of `which`, else empty.
std::string check_rayleigh(double dt, double rayleigh, const std::string &which);

/// Charges can press spheres together harder than their contact holds. Returns a
/// warning, empty when there is none.
std::string check_charges(const LAMMPS_NS::ChargedContact &contact);

/// Of a run under way, whose step dt [s] is above the limit of a body's contacts.
std::string contact_limit_warning(double dt, double limit, int contacts, long step);

/// Within a run the DEM step must stay what the handshake said [s].
void check_step(double agreed, double dt);

}  // namespace clay
