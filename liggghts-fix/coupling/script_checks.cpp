// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/script_checks.h"

#include <cstdarg>
#include <cstdio>
#include <stdexcept>

namespace clay {

namespace {

bool begins(const std::string &style, const char *with) { return style.rfind(with, 0) == 0; }

__attribute__((format(printf, 1, 2))) std::string text(const char *format, ...)
{
  char line[384];
  std::va_list values;
  va_start(values, format);
  std::vsnprintf(line, sizeof line, format, values);
  va_end(values);
  return line;
}

}  // namespace

/* ---------------------------------------------------------------------- */

void check_order(const std::vector<FixEntry> &fixes, int mine)
{
  for (std::size_t i = mine + 1; i < fixes.size(); i++) {
    const FixEntry &other = fixes[i];
    if (!other.forces || other.style.find("property/") != std::string::npos) continue;
    for (const char *style : {"gravity", "addforce", "wall/", "spring", "lubrication", "brownian"})
      if (begins(other.style, style))
        throw std::invalid_argument("must stand below 'fix " + other.id + " " + other.style +
                                    "' in the script, since the drag needs its force");
  }
}

/* ---------------------------------------------------------------------- */

void check_others(const std::vector<FixEntry> &fixes)
{
  for (const FixEntry &other : fixes) {
    if (begins(other.style, "couple/cfd"))
      throw std::invalid_argument("'fix " + other.id + " " + other.style +
                                  "' belongs to another coupling and takes no part in this one; take it out");
    if (other.style == "buoyancy")
      throw std::invalid_argument("'fix " + other.id +
                                  " buoyancy' would count twice, since the CFD half's force model buoyancy brings it; "
                                  "take it out");
  }
}

/* ---------------------------------------------------------------------- */

void check_holders(const std::vector<FixEntry> &fixes)
{
  for (const FixEntry &fix : fixes)
    if (!fix.odd.empty()) throw std::invalid_argument("'fix " + fix.id + " " + fix.style + "' " + fix.odd);
}

/* ---------------------------------------------------------------------- */

void check_last(const std::vector<FixEntry> &fixes, int mine)
{
  for (std::size_t i = mine + 1; i < fixes.size(); i++) {
    const FixEntry &other = fixes[i];
    if (other.forces && !begins(other.style, "property/") && !begins(other.style, "multisphere"))
      throw std::invalid_argument("the CFD half has added mass, which takes part of all other forces: 'fix " +
                                  other.id + " " + other.style + "' must stand above it in the script");
  }
}

/* ---------------------------------------------------------------------- */

void check_interval(long steps, int interval)
{
  if (steps % interval == 0) return;
  const long below = steps / interval * interval;
  const std::string choice = below ? std::to_string(below) + " or " : "";
  throw std::invalid_argument(text("run of %ld steps is no multiple of the coupling interval 'every %d'; use %s%ld",
                                   steps, interval, choice.c_str(), below + interval));
}

/* ---------------------------------------------------------------------- */

void check_contact_limit(double dt, double limit, const std::string &which)
{
  if (dt <= limit) return;
  throw std::invalid_argument(text("timestep %g s is above %.3g s, the contact limit of %s at rest; "
                                   "take a smaller one, or a softer contact, or contact_limit no",
                                   dt, limit, which.c_str()));
}

/* ---------------------------------------------------------------------- */

std::string check_rayleigh(double dt, double rayleigh, const std::string &which)
{
  const double most = 0.3 * rayleigh;
  if (dt <= most) return "";
  return text(
      "timestep %g s is %.2g of the Rayleigh time of %s, %.3g s: contacts under load may not be stable; take at "
      "most 0.3 of it, %.3g s, or a smaller modulus",
      dt, dt / rayleigh, which.c_str(), rayleigh, most);
}

/* ---------------------------------------------------------------------- */

std::string check_charges(const LAMMPS_NS::ChargedContact &c)
{
  if (c.impact <= 0.1) return "";
  const std::string need = text("a stiffness of %.3g N/m in place of %.3g makes it 0.1 d", c.wanted, c.stiffness);
  if (c.overlap > 1.)
    throw std::invalid_argument(text("%s of types %d and %d pull their spheres into each other: the contact does "
                                     "not hold them at any overlap; %s, or take smaller charges, or contact_limit no",
                                     c.by.c_str(), c.first, c.second, need.c_str()));
  return text("%s of types %d and %d make spheres that come from afar overlap by up to %.2g d, "
              "at rest by %.2g d; %s",
              c.by.c_str(), c.first, c.second, c.impact, c.overlap, need.c_str());
}

/* ---------------------------------------------------------------------- */

std::string contact_limit_warning(double dt, double limit, int contacts, long step)
{
  return text("timestep %g s is above %.3g s, the contact limit of a body with %d contacts at step %ld", dt, limit,
              contacts, step);
}

/* ---------------------------------------------------------------------- */

void check_step(double agreed, double dt)
{
  if (dt == agreed) return;
  throw std::invalid_argument(
      text("the timestep changed from %g to %g s within a run; change it between two runs", agreed, dt));
}

}  // namespace clay
