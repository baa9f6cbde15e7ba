/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   What the command of fix couple/foam says, and whether the script around
   it goes with that.
------------------------------------------------------------------------- */

#include "coupling/fix_couple_foam.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "resistance/clump_drag.h"
#include "coupling/run_checks.h"
#include "coupling/coupled_clumps.h"
#include "coupling/coupling_report.h"
#include "error.h"
#include "force.h"
#include "modify.h"
#include "coupling/runaway_watch.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace FixConst;

/* ---------------------------------------------------------------------- */

int FixCoupleFoam::whole_number(const char *text)
{
  char *end = NULL;
  const long value = strtol(text,&end,10);
  if (*end || value < 1 || value > 100000000)
    error->all(FLERR,(std::string("Fix couple/foam: every is '") + text + "'; a whole number of "
                      "DEM steps from 1 to 100000000 is wanted").c_str());
  return value;
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::parse(int narg, char **arg)
{
  std::string stats;
  std::string law, drag = "sphereSum", lag = "0";
  double seconds = 1.0;
  bool watch = true;

  int iarg = 3;
  while (iarg < narg) {
    if (iarg+2 > narg)
      error->all(FLERR,(std::string("Fix couple/foam: keyword '") + arg[iarg] +
                        "' needs a value").c_str());
    const std::string key = arg[iarg], value = arg[iarg+1];
    if (key == "every") interval_ = whole_number(arg[iarg+1]);
    else if (key == "stats") stats = value;
    else if (key == "lag") lag = value;
    else if (key == "progress") seconds = force->numeric(FLERR,arg[iarg+1]);
    else if (key == "contact_limit") {
      if (value != "yes" && value != "no")
        error->all(FLERR,("Fix couple/foam: contact_limit is '" + value +
                          "'; yes or no is wanted").c_str());
      check_limit_ = value == "yes";
    } else if (key == "watch") {
      if (value != "yes" && value != "no")
        error->all(FLERR,("Fix couple/foam: watch is '" + value + "'; yes or no is wanted").c_str());
      watch = value == "yes";
    } else if (key == "clumpDrag") drag = value;
    else if (key == "shapeLaw") law = value;
    else
      error->all(FLERR,("Fix couple/foam: unknown keyword '" + key + "'; known are "
                        "every, lag, stats, progress, contact_limit, watch, clumpDrag, shapeLaw").c_str());
    iarg += 2;
  }
  if (interval_ < 1)
    error->all(FLERR,"Fix couple/foam: 'every N' is missing; "
                     "N is the number of DEM steps between two exchanges");
  parse_lag(lag);
  report_.reset(new CouplingReport(lmp,stats,seconds));
  if (watch) watch_.reset(new RunawayWatch(lmp));
  parse_clump_drag(drag,law);
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::parse_lag(const std::string &text)
{
  if (text == "auto") {
    lag_ = interval_/4;
    return;
  }
  char *end = NULL;
  const long value = strtol(text.c_str(),&end,10);
  if (text.empty() || *end || value < 0 || value >= interval_)
    error->all(FLERR,("Fix couple/foam: lag is '" + text + "'; auto or a whole number of DEM steps "
                      "from 0 to " + std::to_string(interval_-1) + ", below every, is wanted").c_str());
  lag_ = value;
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::parse_clump_drag(const std::string &drag, const std::string &law)
{
  std::string what = "clumpDrag is ";
  try {
    if (clay::clumpDragKind(drag) == clay::ClumpDragKind::resistance) {
      what = "shapeLaw: ";
      clumps_.reset(new CoupledClumps(lmp,clay::shapeLaw(law.empty() ? "tranCong" : law)));
    }
  } catch (const std::invalid_argument &e) {
    error->all(FLERR,("Fix couple/foam: " + what + e.what()).c_str());
  }
  if (!clumps_ && !law.empty())
    error->all(FLERR,"Fix couple/foam: shapeLaw belongs to clumpDrag resistance, which is not set");
  report_->setting("clump_drag",drag);
  if (clumps_) report_->setting("shape_law",law.empty() ? "tranCong" : law);
}

/* ----------------------------------------------------------------------
   the drag of free spheres is implicit: all other forces must be known
------------------------------------------------------------------------- */

void FixCoupleFoam::check_order()
{
  int mine = modify->find_fix(id);
  for (int i = mine + 1; i < modify->nfix; i++) {
    Fix *other = modify->fix[i];
    if ((other->setmask() & POST_FORCE) && !strstr(other->style,"property/") &&
        (!strncmp(other->style,"gravity",7) || !strncmp(other->style,"addforce",8) ||
         !strncmp(other->style,"wall/",5) || !strncmp(other->style,"spring",6) ||
         !strncmp(other->style,"lubrication",11) || !strncmp(other->style,"brownian",8)))
      error->all(FLERR,(std::string("Fix couple/foam: must stand below 'fix ") + other->id + " " +
                        other->style + "' in the script, since the drag needs its force").c_str());
  }
}

/* ----------------------------------------------------------------------
   added mass scales the sum of all forces on a free sphere
------------------------------------------------------------------------- */

void FixCoupleFoam::check_last()
{
  for (int i = modify->find_fix(id) + 1; i < modify->nfix; i++) {
    Fix *other = modify->fix[i];
    if ((other->setmask() & POST_FORCE) && strncmp(other->style,"property/",9) &&
        strncmp(other->style,"multisphere",11))
      error->all(FLERR,(std::string("Fix couple/foam: the CFD half has added mass, which takes part of all other "
                        "forces: 'fix ") + other->id + " " + other->style +
                        "' must stand above it in the script").c_str());
  }
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::check_interval()
{
  const bigint steps = update->laststep - update->firststep;
  if (steps % interval_) {
    const bigint below = steps/interval_*interval_;
    char text[256], choice[64] = "";
    if (below) snprintf(choice,sizeof choice,BIGINT_FORMAT " or ",below);
    snprintf(text,sizeof text,
             "Fix couple/foam: run of " BIGINT_FORMAT " steps is no multiple of the coupling interval "
             "'every %d'; %s" BIGINT_FORMAT " steps would be",steps,interval_,choice,below + interval_);
    error->all(FLERR,text);
  }
}

/* ----------------------------------------------------------------------
   a body in many contacts needs a smaller step than one contact does
------------------------------------------------------------------------- */

void FixCoupleFoam::check_contact_limit()
{
  std::string which;
  const double limit = resting_step_limit(lmp,&which);
  if (update->dt <= limit) return;
  char text[256];
  snprintf(text,sizeof text,
           "Fix couple/foam: timestep %g s is above %.3g s, the contact limit of %s at rest; "
           "take a smaller one, or a softer contact, or contact_limit no",
           update->dt,limit,which.c_str());
  error->all(FLERR,text);
}

/* ----------------------------------------------------------------------
   charges can press spheres together harder than their contact holds
------------------------------------------------------------------------- */

void FixCoupleFoam::check_charges()
{
  const ChargedContact c = charged_contact(lmp);
  if (c.impact <= 0.1) return;
  char text[320], need[96];
  snprintf(need,sizeof need,"with a stiffness of %.3g N/m in place of %.3g it would be 0.1 d",c.wanted,c.stiffness);
  if (c.overlap > 1.) {
    snprintf(text,sizeof text,"Fix couple/foam: the charges of types %d and %d pull their spheres into each other: the contact does not "
             "hold them at any overlap; %s, or take smaller charges, or contact_limit no",c.first,c.second,need);
    error->all(FLERR,text);
  }
  snprintf(text,sizeof text,"the charges of types %d and %d make spheres that come from afar overlap by up to %.2g d, at rest by %.2g d; %s",
           c.first,c.second,c.impact,c.overlap,need);
  report_->warn(text);
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::watch_contact_limit()
{
  if (warned_) return;
  int contacts = 0;
  const double limit = present_step_limit(lmp,&contacts);
  if (update->dt <= limit) return;
  warned_ = true;
  char text[256];
  snprintf(text,sizeof text,
           "timestep %g s is above %.3g s, the contact limit of a body with %d contacts at step " BIGINT_FORMAT,
           update->dt,limit,contacts,update->ntimestep);
  report_->warn(text);
}
