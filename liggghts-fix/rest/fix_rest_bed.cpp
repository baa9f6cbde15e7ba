/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "rest/fix_rest_bed.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <cstdlib>
#include <cstring>

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "coupling/fix_couple_foam.h"
#include "clumps/script_gravity.h"
#include "fix_addforce.h"
#include "fix_wall_gran.h"
#include "force.h"
#include "memory.h"
#include "modify.h"
#include "coulomb/pair_clump.h"
#include "script/values.h"
#include "update.h"
#include "rest/verlet_clay.h"

using namespace LAMMPS_NS;

// fix addforce keeps the names of its variables to itself
template <char *FixAddForce::*x, char *FixAddForce::*y, char *FixAddForce::*z>
struct AddForceNames {
  friend bool has_variable(const FixAddForce &fix) { return fix.*x || fix.*y || fix.*z; }
};
bool has_variable(const FixAddForce &fix);
template struct AddForceNames<&FixAddForce::xstr, &FixAddForce::ystr, &FixAddForce::zstr>;

namespace {

enum { SIZE = sizeof(clay::RestTrack) / sizeof(double) };

}

/* ---------------------------------------------------------------------- */

FixRestBed::FixRestBed(LAMMPS *lmp, int narg, char **arg) :
  Fix(lmp, narg, arg), seconds_(0.), fluid_(0.05), tracks_(NULL), able_(false), window_(0), next_(0), begun_(0),
  looked_(false), skipped_(0), left_out_(0), wakings_(0)
{
  vector_flag = 1;
  size_vector = 3;
  global_freq = 1;
  extvector = 0;
  try {
    parse(narg, arg);
  } catch (const std::invalid_argument &e) {
    error->all(FLERR, (std::string("Fix rest/bed: ") + e.what()).c_str());
  }
  watch_.restart(limits_);

  if (modify->n_fixes_style("rest/bed") > 0) error->all(FLERR, "Fix rest/bed: only one fix rest/bed is allowed");
  if (strcmp(update->integrate_style, "verlet"))
    error->all(FLERR,
               (std::string("Fix rest/bed: works with run_style verlet, not with ") + update->integrate_style).c_str());
  if (!dynamic_cast<VerletClay *>(update->integrate)) {
    delete update->integrate;
    update->integrate = new VerletClay(lmp);
  }
  create_attribute = 1;  // set_arrays for particles that come within a run
  restart_global = restart_peratom = 1;
  grow_arrays(atom->nmax);
  atom->add_callback(0);
  atom->add_callback(1);
  for (int i = 0; i < atom->nlocal; i++) set_arrays(i);
}

/* ---------------------------------------------------------------------- */

FixRestBed::~FixRestBed()
{
  atom->delete_callback(id, 0);
  atom->delete_callback(id, 1);
  memory->sfree(tracks_);
}

/* ---------------------------------------------------------------------- */

void FixRestBed::parse(int narg, char **arg)
{
  if (igroup != 0) throw std::invalid_argument("its group must be 'all', since any particle may wake another");
  for (int i = 3; i < narg; i += 2) {
    const std::string key = arg[i];
    if (i + 1 == narg) throw std::invalid_argument("keyword '" + key + "' needs a value");
    if (key == "window") seconds_ = clay::positiveNumber(key, arg[i + 1]);
    else if (key == "move") limits_.move = clay::positiveNumber(key, arg[i + 1]);
    else if (key == "error") limits_.error = clay::positiveNumber(key, arg[i + 1]);
    else if (key == "longest") limits_.longest = static_cast<int>(clay::wholeNumber(key, arg[i + 1], 1, 1000000));
    else if (key == "fluid") fluid_ = clay::positiveNumber(key, arg[i + 1]);
    else throw std::invalid_argument("unknown keyword '" + key + "'; known are window, move, error, longest, fluid");
  }
}

/* ---------------------------------------------------------------------- */

void FixRestBed::init()
{
  if (!dynamic_cast<VerletClay *>(update->integrate))
    error->all(FLERR, "Fix rest/bed: run_style must stand above it in the script");
  const std::string reason = why_not();
  able_ = reason.empty();
  if (!able_ && comm->me == 0) {
    const std::string text = "Fix rest/bed: every step is computed, since " + reason + "\n";
    if (screen) fputs(text.c_str(), screen);
    if (logfile) fputs(text.c_str(), logfile);
  }
}

/* ----------------------------------------------------------------------
   a script with anything in it that acts by itself is left alone
------------------------------------------------------------------------- */

std::string FixRestBed::why_not() const
{
  static const char *still[] = {"gravity",        "nve/sphere",        "multisphere",
                                "couple/foam",    "settling/",         "property/",
                                "contacthistory", "particletemplate/", "particledistribution/",
                                "insert/",        "rest/bed",          "print",
                                "ave/",           "addforce",          "viscous",
                                "store/",         "contactproperty"};

  ScriptGravity gravity(lmp);
  gravity.find();
  if (!gravity.any()) return "there is no gravity to hold a bed";
  if (gravity.changes()) return "gravity changes by a variable";
  if (gravity.differs(0)) return "gravity acts on a part of the particles";
  for (const std::string name : {"coul/clump", "dlvo/clump"}) {
    Pair *pair = force->pair ? force->pair_match(name.c_str(), 1) : NULL;
    const PairClump *kicking = dynamic_cast<PairClump *>(pair);
    if (kicking && kicking->kicks()) return "pair " + name + " gives its force in impulses; it must be every N hold";
  }
  for (int i = 0; i < modify->nfix; i++) {
    const Fix *fix = modify->fix[i];
    if (!strncmp(fix->style, "wall/gran", 9)) {
      const FixWallGran *wall = static_cast<const FixWallGran *>(fix);
      if (wall->is_mesh_wall() || const_cast<FixWallGran *>(wall)->is_moving())
        return std::string("the wall of fix ") + fix->id + " is a mesh or moves";
      continue;
    }
    const FixAddForce *push = dynamic_cast<const FixAddForce *>(fix);
    if (push && has_variable(*push)) return std::string("the force of fix ") + fix->id + " addforce is a variable";
    bool known = false;
    for (const char *style : still) known |= !strncmp(fix->style, style, strlen(style));
    if (!known) return std::string("fix ") + fix->id + " " + fix->style + " may move particles";
  }
  return "";
}

/* ---------------------------------------------------------------------- */

void FixRestBed::count_left_out()
{
  const double windows = uncounted();
  left_out_ = skipped_;
  watch_.only(windows);
  if (windows == 0.) return;
  for (int i = 0; i < atom->nlocal; i++)
    if (tracks_[i].known != 0.) tracks_[i].charge(watch_.weights(), windows);
}

/* ----------------------------------------------------------------------
   windows left out since the look before
------------------------------------------------------------------------- */

double FixRestBed::uncounted() const { return skipped_ > left_out_ ? double(skipped_ - left_out_) / window_ : 0.; }

/* ---------------------------------------------------------------------- */

void FixRestBed::begin_anew()
{
  count_left_out();
  watch_.restart(limits_);
  looked_ = false;
  begun_ = update->ntimestep;
  next_ = next_window();
}

/* ---------------------------------------------------------------------- */

bool FixRestBed::begin(int n)
{
  FixCoupleFoam *fluid = dynamic_cast<FixCoupleFoam *>(modify->find_fix_style("couple/foam", 0));
  const bigint every = fluid ? fluid->interval() : 1;
  const double seconds = seconds_ > 0. ? seconds_ : 500 * update->dt;
  const bigint steps = std::max<bigint>(1, static_cast<bigint>(std::llround(seconds / update->dt)));
  window_ = (steps + every - 1) / every * every;
  begin_anew();

  find_gravity();
  const double size = std::sqrt(gravity_[0] * gravity_[0] + gravity_[1] * gravity_[1] + gravity_[2] * gravity_[2]);
  for (int k = 0; k < 3; k++) up_[k] = size > 0. ? -gravity_[k] / size : 0.;
  return able_ && size > 0. && window_ < n;
}

/* ----------------------------------------------------------------------
   true when it is another one than before
------------------------------------------------------------------------- */

bool FixRestBed::find_gravity()
{
  double before[3];
  std::copy(gravity_, gravity_ + 3, before);
  ScriptGravity script(lmp);
  script.find();
  const std::array<double, 3> now = script.now().on(1);
  std::copy(now.begin(), now.end(), gravity_);
  return !std::equal(before, before + 3, gravity_);
}

/* ---------------------------------------------------------------------- */

bigint FixRestBed::look()
{
  count_left_out();
  const int n = atom->nlocal;
  // largest way, lowest particle, is any new or pulled elsewhere
  double most[3] = {0., -1e300, find_gravity() || !looked_ ? 1. : 0.}, mosts[3], sum[2] = {0., double(n)}, sums[2];
  looked_ = true;
  for (int i = 0; i < n; i++) {
    const double *x = atom->x[i], r = atom->radius[i], h = x[0] * up_[0] + x[1] * up_[1] + x[2] * up_[2];
    sum[0] += h;
    most[1] = std::max(most[1], -h);
    if (tracks_[i].known == 0.) most[2] = 1.;
    else most[0] = std::max(most[0], tracks_[i].moved2(x) / (r * r));
  }
  MPI_Allreduce(most, mosts, 3, MPI_DOUBLE, MPI_MAX, world);
  MPI_Allreduce(sum, sums, 2, MPI_DOUBLE, MPI_SUM, world);

  clay::RestSight sight;
  sight.farthest = std::sqrt(mosts[0]);
  sight.mean = sums[1] > 0. ? sums[0] / sums[1] : 0.;
  sight.height = sight.mean + mosts[1];
  const bool whole = mosts[2] == 0. && sums[1] > 0.;

  if (whole && sight.farthest <= limits_.move) {
    const clay::RestWeights weights = watch_.weights_with_next();
    double allowed = 1e300;
    for (int i = 0; i < n; i++) {
      clay::RestTrack &t = tracks_[i];
      if (!watch_.resting()) t.begin();
      t.see(atom->x[i]);
      allowed = std::min(allowed, t.allowed(weights, limits_.behind * atom->radius[i]));
    }
    MPI_Allreduce(&allowed, &sight.allowed, 1, MPI_DOUBLE, MPI_MIN, world);
  }
  const bigint windows = watch_.windows(sight, whole);

  for (int i = 0; i < n; i++) {
    std::copy(atom->x[i], atom->x[i] + 3, tracks_[i].last);
    tracks_[i].known = 1.;
  }
  next_ = update->ntimestep + (windows + 1) * window_;
  return windows * window_;
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

bigint FixRestBed::next_window() const { return begun_ + ((update->ntimestep - begun_) / window_ + 1) * window_; }

/* ----------------------------------------------------------------------
   steps left out, estimate of what the mean height missed, wakings
------------------------------------------------------------------------- */

double FixRestBed::compute_vector(int n)
{
  return n == 0 ? double(skipped_) : n == 1 ? watch_.missed() : double(wakings_);
}

double FixRestBed::memory_usage() { return double(atom->nmax) * sizeof(clay::RestTrack); }

void FixRestBed::grow_arrays(int nmax)
{
  tracks_ =
      static_cast<clay::RestTrack *>(memory->srealloc(tracks_, nmax * sizeof(clay::RestTrack), "rest/bed:tracks"));
}

void FixRestBed::copy_arrays(int i, int j, int) { tracks_[j] = tracks_[i]; }

void FixRestBed::set_arrays(int i) { tracks_[i].create(); }

int FixRestBed::pack_exchange(int i, double *buf)
{
  memcpy(buf, tracks_ + i, sizeof(clay::RestTrack));
  return SIZE;
}

int FixRestBed::unpack_exchange(int nlocal, double *buf)
{
  memcpy(tracks_ + nlocal, buf, sizeof(clay::RestTrack));
  return SIZE;
}

/* ----------------------------------------------------------------------
   what was missed so far counts in the run that goes on from the file
------------------------------------------------------------------------- */

void FixRestBed::write_restart(FILE *fp)
{
  if (comm->me) return;
  clay::RestWatch now = watch_;
  now.only(uncounted());
  const double state[3] = {double(skipped_), double(wakings_), now.missed_way()};
  const int size = sizeof state;
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(state, sizeof(double), 3, fp);
}

void FixRestBed::restart(char *buf)
{
  double state[3];
  memcpy(state, buf, sizeof state);
  skipped_ = left_out_ = static_cast<bigint>(state[0]);
  wakings_ = static_cast<bigint>(state[1]);
  watch_.resume(state[2]);
}

int FixRestBed::size_restart(int) { return 4; }

int FixRestBed::maxsize_restart() { return 4; }

int FixRestBed::pack_restart(int i, double *buf)
{
  buf[0] = 4.;
  clay::RestTrack now = tracks_[i];
  if (now.known != 0.) now.charge(watch_.weights(), uncounted());
  std::copy(now.missed, now.missed + 3, buf + 1);
  return 4;
}

void FixRestBed::unpack_restart(int nlocal, int nth)
{
  const double *from = atom->extra[nlocal];
  for (int n = 0; n < nth; n++) from += static_cast<int>(*from);
  tracks_[nlocal].create();
  std::copy(from + 1, from + 4, tracks_[nlocal].missed);
}
