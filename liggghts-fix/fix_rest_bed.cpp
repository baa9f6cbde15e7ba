/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "fix_rest_bed.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix_couple_foam.h"
#include "fix_gravity.h"
#include "fix_wall_gran.h"
#include "force.h"
#include "modify.h"
#include "neighbor.h"
#include "pair_coul_clump.h"
#include "update.h"
#include "verlet_clay.h"

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

FixRestBed::FixRestBed(LAMMPS *lmp, int narg, char **arg) :
  Fix(lmp,narg,arg),
  seconds_(0.), fluid_(0.05), able_(false),
  window_(0), next_(0), built_(-1), skipped_(0), left_out_(0), wakings_(0)
{
  vector_flag = 1;
  size_vector = 3;
  global_freq = 1;
  extvector = 0;
  parse(narg,arg);
  watch_.restart(limits_);

  if (modify->n_fixes_style("rest/bed") > 0)
    error->all(FLERR,"Fix rest/bed: there is one already");
  if (strcmp(update->integrate_style,"verlet"))
    error->all(FLERR,(std::string("Fix rest/bed: works with run_style verlet, not with ") +
                      update->integrate_style).c_str());
  if (!dynamic_cast<VerletClay*>(update->integrate)) {
    delete update->integrate;
    update->integrate = new VerletClay(lmp);
  }
}

/* ---------------------------------------------------------------------- */

void FixRestBed::parse(int narg, char **arg)
{
  if (igroup != 0)
    error->all(FLERR,"Fix rest/bed: its group must be 'all', since any particle may wake another");
  for (int i = 3; i < narg; i += 2) {
    const std::string key = arg[i];
    const bool known = key == "window" || key == "move" || key == "error" || key == "longest" || key == "fluid";
    if (!known)
      error->all(FLERR,("Fix rest/bed: unknown keyword '" + key +
                        "'; known are window, move, error, longest, fluid").c_str());
    if (i+1 == narg) error->all(FLERR,("Fix rest/bed: keyword '" + key + "' needs a value").c_str());
    char *end = NULL;
    const double value = strtod(arg[i+1],&end);
    const bool whole = key != "longest" || (value >= 1 && value <= 1e6 && value == std::floor(value));
    if (*end || !(value > 0.) || !whole)
      error->all(FLERR,("Fix rest/bed: " + key + " is '" + arg[i+1] + "'; " +
                        (key == "longest" ? "a whole number from 1 to 1000000" : "a number above 0") +
                        " is wanted").c_str());
    if (key == "window") seconds_ = value;
    else if (key == "move") limits_.move = value;
    else if (key == "error") limits_.error = value;
    else if (key == "longest") limits_.longest = static_cast<int>(value);
    else fluid_ = value;
  }
}

/* ---------------------------------------------------------------------- */

void FixRestBed::init()
{
  if (!dynamic_cast<VerletClay*>(update->integrate))
    error->all(FLERR,"Fix rest/bed: run_style must stand above it in the script");
  const std::string reason = why_not();
  able_ = reason.empty();
  if (!able_ && comm->me == 0) {
    const std::string text = "Fix rest/bed: every step is computed, since " + reason + "\n";
    if (screen) fputs(text.c_str(),screen);
    if (logfile) fputs(text.c_str(),logfile);
  }
}

/* ----------------------------------------------------------------------
   a script with anything in it that acts by itself is left alone
------------------------------------------------------------------------- */

std::string FixRestBed::why_not() const
{
  static const char *still[] = {
    "gravity", "nve/sphere", "multisphere", "couple/foam", "settling/curve", "property/", "contacthistory",
    "particletemplate/", "particledistribution/", "insert/", "rest/bed", "print", "ave/", "addforce", "viscous",
    "store/", "contactproperty" };

  if (modify->n_fixes_style("gravity") == 0) return "there is no gravity to hold a bed";
  Pair *pair = force->pair ? force->pair_match("coul/clump",1) : NULL;
  const PairCoulClump *coul = dynamic_cast<PairCoulClump*>(pair);
  if (coul && coul->kicks())
    return "pair coul/clump gives its force in impulses; every N hold is wanted";
  for (int i = 0; i < modify->nfix; i++) {
    const Fix *fix = modify->fix[i];
    if (!strncmp(fix->style,"wall/gran",9)) {
      const FixWallGran *wall = static_cast<const FixWallGran*>(fix);
      if (wall->is_mesh_wall() || const_cast<FixWallGran*>(wall)->is_moving())
        return std::string("the wall of fix ") + fix->id + " is a mesh or moves";
      continue;
    }
    bool known = false;
    for (const char *style : still) known |= !strncmp(fix->style,style,strlen(style));
    if (!known) return std::string("fix ") + fix->id + " " + fix->style + " may move particles";
  }
  return "";
}

/* ---------------------------------------------------------------------- */

void FixRestBed::count_left_out()
{
  const bigint passed = skipped_ - left_out_;   // since the look before
  left_out_ = skipped_;
  watch_.only(passed ? double(passed)/window_ : 0.);
}

/* ---------------------------------------------------------------------- */

bool FixRestBed::begin(int n)
{
  count_left_out();
  watch_.restart(limits_);
  built_ = -1;
  FixCoupleFoam *fluid = dynamic_cast<FixCoupleFoam*>(modify->find_fix_style("couple/foam",0));
  const bigint every = fluid ? fluid->interval() : 1;
  const double seconds = seconds_ > 0. ? seconds_ : 500*update->dt;
  const bigint steps = std::max<bigint>(1,static_cast<bigint>(std::llround(seconds/update->dt)));
  window_ = (steps + every - 1)/every*every;
  next_ = next_window();

  FixGravity *gravity = static_cast<FixGravity*>(modify->find_fix_style("gravity",0));
  double g[3] = {0.,0.,0.};
  if (gravity) gravity->get_gravity(g);
  const double size = std::sqrt(g[0]*g[0] + g[1]*g[1] + g[2]*g[2]);
  for (int k = 0; k < 3; k++) up_[k] = size > 0. ? -g[k]/size : 0.;
  return able_ && size > 0. && window_ < n;
}

/* ---------------------------------------------------------------------- */

bigint FixRestBed::look()
{
  count_left_out();
  const int n = atom->nlocal;
  const double *x = n ? atom->x[0] : NULL;
  double most[4] = {0.,-1e300,0.,0.}, sum[2] = {0.,double(n)};
  const bool same = built_ == neighbor->lastcall && places_.size() == n;
  most[0] = same ? 0. : 1.;                     // particles may have changed places in memory
  if (!watch_.resting()) begun_ = places_;
  if (same && n) {
    most[2] = places_.farthest(x,atom->radius);
    most[3] = begun_.farthest(x,atom->radius);
  }
  for (int i = 0; i < n; i++) {
    const double h = x[3*i]*up_[0] + x[3*i+1]*up_[1] + x[3*i+2]*up_[2];
    sum[0] += h;
    most[1] = std::max(most[1],-h);
  }
  double mosts[4], sums[2];
  MPI_Allreduce(most,mosts,4,MPI_DOUBLE,MPI_MAX,world);
  MPI_Allreduce(sum,sums,2,MPI_DOUBLE,MPI_SUM,world);

  clay::RestSight sight;
  sight.farthest = mosts[2];
  sight.gone = mosts[3];
  sight.mean = sums[1] > 0. ? sums[0]/sums[1] : 0.;
  sight.height = sight.mean + mosts[1];
  const bigint windows = watch_.windows(sight,mosts[0] == 0. && sums[1] > 0.);

  places_.keep(x,n);
  built_ = neighbor->lastcall;
  next_ = update->ntimestep + (windows + 1)*window_;
  return windows*window_;
}

/* ---------------------------------------------------------------------- */

void FixRestBed::woken()
{
  wakings_++;
  recomputed();
}


void FixRestBed::recomputed()
{
  count_left_out();
  watch_.wake();
  next_ = next_window();
}

/* ----------------------------------------------------------------------
   windows end where exchanges are
------------------------------------------------------------------------- */

bigint FixRestBed::next_window() const
{
  return update->firststep + ((update->ntimestep - update->firststep)/window_ + 1)*window_;
}

/* ----------------------------------------------------------------------
   steps left out, estimate of what the mean height missed, wakings
------------------------------------------------------------------------- */

double FixRestBed::compute_vector(int n)
{
  return n == 0 ? double(skipped_) : n == 1 ? watch_.missed() : double(wakings_);
}

double FixRestBed::memory_usage()
{
  return 3.0*(places_.size() + begun_.size())*sizeof(double);
}
