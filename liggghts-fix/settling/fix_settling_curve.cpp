/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "settling/fix_settling_curve.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "atom.h"
#include "comm.h"
#include "contacts/granular_script.h"
#include "domain.h"
#include "error.h"
#include "fix_wall_gran.h"
#include "force.h"
#include "modify.h"
#include "neigh_list.h"
#include "pair_gran.h"
#include "primitive_wall.h"
#include "script/values.h"
#include "settling/column_script.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace FixConst;

/* ---------------------------------------------------------------------- */

namespace {

const double farthest = 1e100;  // (m); beyond it, a computation went wrong

}

/* ---------------------------------------------------------------------- */

FixSettlingCurve::FixSettlingCurve(LAMMPS *lmp, int narg, char **arg) :
  Fix(lmp, narg, arg), file_(NULL), scale_(9.49e5), quantile_(0.98), bed_fraction_(0.2), area_(0.0), bottom_(0.0),
  area_given_(false), bottom_given_(false), multisphere_(NULL), diameter_(0.0), measured_(-1), written_(-1),
  interface_(0.0), bed_(0.0), mean_(0.0), overlap_(0.0), volume_(0.0)
{
  bool append = false;
  try {
    parse(narg, arg, append);
  } catch (const std::invalid_argument &e) {
    error->fix_error(FLERR, this, e.what());
  }

  int opened = 1;
  if (comm->me == 0) {
    file_ = fopen(name_.c_str(), append ? "a" : "w");
    opened = file_ != NULL;
    if (opened && (!append || ftell(file_) == 0)) {
      fprintf(file_, "time_s,time_days,interface_m,bed_m,mean_height_m\n");
      fflush(file_);
    }
  }
  MPI_Bcast(&opened, 1, MPI_INT, 0, world);
  if (!opened) error->fix_error(FLERR, this, ("cannot write file " + name_).c_str());

  vector_flag = 1;
  size_vector = 5;
  global_freq = 1;
  extvector = 0;
}

FixSettlingCurve::~FixSettlingCurve()
{
  if (file_) fclose(file_);
}

/* ---------------------------------------------------------------------- */

void FixSettlingCurve::parse(int narg, char **arg, bool &append)
{
  if (narg < 4) throw std::invalid_argument("the number of steps between two rows is missing");
  nevery = static_cast<int>(clay::wholeNumber("the number of steps between two rows", arg[3], 1, INT_MAX));
  for (int iarg = 4; iarg < narg; iarg += 2) {
    const std::string key = arg[iarg];
    if (iarg + 1 == narg) throw std::invalid_argument("keyword '" + key + "' needs a value");
    const char *value = arg[iarg + 1];
    if (key == "file" || key == "append") {
      append = key == "append";
      name_ = value;
    } else if (key == "scale") scale_ = clay::positiveNumber(key, value);
    else if (key == "quantile") {
      quantile_ = clay::number(key, value);
      if (!(quantile_ > 0.1 && quantile_ <= 1.0))
        throw std::invalid_argument("quantile is '" + std::string(value) + "'; it must be above 0.1 and at most 1");
    } else if (key == "bed_fraction") bed_fraction_ = clay::fraction(key, value);
    else if (key == "area") {
      area_ = clay::positiveNumber(key, value);
      area_given_ = true;
    } else if (key == "bottom") {
      bottom_ = clay::number(key, value);
      bottom_given_ = true;
    } else
      throw std::invalid_argument("unknown keyword '" + key +
                                  "'; known are file, append, scale, quantile, "
                                  "bed_fraction, area and bottom");
  }
  if (name_.empty()) throw std::invalid_argument("'file' is missing: the name of the curve's file");
}

/* ---------------------------------------------------------------------- */

int FixSettlingCurve::setmask() { return END_OF_STEP; }

/* ---------------------------------------------------------------------- */

void FixSettlingCurve::init()
{
  if (!atom->radius_flag || !atom->rmass_flag)
    error->fix_error(FLERR, this, "needs spheres: atom_style sphere or granular");
  multisphere_ = multisphere_of(lmp, "Fix settling/curve");
  diameter_ = largest_diameter(lmp);

  const ColumnSpace space = column_space(lmp);
  if (!area_given_) area_ = space.area;
  if (!bottom_given_) bottom_ = space.bottom;
  const double thickness = diameter_ > 0.0 ? diameter_ / 8.0 : domain->zprd / 1000.0;
  profile_.reset(new clay::SettlingProfile(bottom_, domain->boxhi[2], thickness));
  measured_ = -1;
}

/* ---------------------------------------------------------------------- */

void FixSettlingCurve::setup(int)
{
  if (update->ntimestep % nevery == 0) end_of_step();
}

void FixSettlingCurve::end_of_step()
{
  measure();
  write_row();
}

/* ----------------------------------------------------------------------
   a sphere whose height is no number: the curve would hide it
------------------------------------------------------------------------- */

void FixSettlingCurve::stop(int i)
{
  const double *x = atom->x[i], *v = atom->v[i];
  char text[512];
  snprintf(text, sizeof text,
           "Fix settling/curve: particle %d is NaN or far away at step " BIGINT_FORMAT
           " (%g s): position (%g %g %g) m, velocity (%g %g %g) m/s; a smaller timestep, a stiffer contact or a "
           "shorter coupling interval may help",
           atom->tag[i], update->ntimestep, update->get_cur_time(), x[0], x[1], x[2], v[0], v[1], v[2]);
  error->one(FLERR, text);
}

void FixSettlingCurve::measure()
{
  measured_ = update->ntimestep;
  profile_->clear();
  for (int i = 0; i < atom->nlocal; i++)
    if (!(std::fabs(atom->x[i][2]) < farthest)) stop(i);
    else if (atom->mask[i] & groupbit)
      profile_->add(atom->x[i][2], atom->radius[i], sphere_volume(lmp, multisphere_, i));
  std::vector<double> &sums = profile_->sums();
  MPI_Allreduce(MPI_IN_PLACE, sums.data(), sums.size(), MPI_DOUBLE, MPI_SUM, world);

  volume_ = profile_->volume();
  const bool solids = volume_ > 0.0;
  interface_ = solids ? profile_->interface(quantile_, 0.5 * diameter_) - bottom_ : 0.0;
  bed_ = solids ? profile_->bed(area_, bed_fraction_, 2.0 * diameter_) - bottom_ : 0.0;
  mean_ = solids ? profile_->mean() - bottom_ : 0.0;
}

void FixSettlingCurve::write_row()
{
  if (volume_ == 0.0 || written_ == update->ntimestep) return;
  written_ = update->ntimestep;
  if (comm->me != 0) return;
  const double time = update->get_cur_time();
  fprintf(file_, "%.9g,%.9g,%.9g,%.9g,%.9g\n", time, time * scale_ / 86400.0, interface_, bed_, mean_);
  fflush(file_);
  if (ferror(file_)) error->one(FLERR, ("Fix settling/curve: cannot write to " + name_).c_str());
}

/* ----------------------------------------------------------------------
   1 interface, 2 bed, 3 mean height (m), 4 largest overlap of two spheres as
   part of the largest diameter, 5 volume of the solids (m3)
------------------------------------------------------------------------- */

double FixSettlingCurve::compute_vector(int n)
{
  if (measured_ != update->ntimestep) measure();
  switch (n) {
  case 0:
    return interface_;
  case 1:
    return bed_;
  case 2:
    return mean_;
  case 3:
    return largest_overlap();
  default:
    return volume_;
  }
}

double FixSettlingCurve::largest_overlap() const
{
  double mine = 0.0, all = 0.0;
  double **x = atom->x;
  const PairGran *gran = granular_pair(lmp);
  if (gran && gran->list) {
    const NeighList *list = gran->list;
    for (int a = 0; a < list->inum; a++) {
      const int i = list->ilist[a];
      for (int b = 0; b < list->numneigh[i]; b++) {
        const int j = list->firstneigh[i][b] & NEIGHMASK;
        const double d[3] = {x[i][0] - x[j][0], x[i][1] - x[j][1], x[i][2] - x[j][2]};
        mine = std::max(mine, atom->radius[i] + atom->radius[j] - std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]));
      }
    }
  }
  double to_wall[3];
  for (FixWallGran *wall : primitive_walls(lmp))
    for (int i = 0; i < atom->nlocal; i++)
      if (atom->mask[i] & wall->groupbit)
        mine = std::max(mine, -wall->primitiveWall()->resolveContact(x[i], atom->radius[i], to_wall));
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_MAX, world);
  return diameter_ > 0.0 ? all / diameter_ : 0.0;
}
