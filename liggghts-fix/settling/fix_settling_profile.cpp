/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   Script, file and rows; what is measured is in fix_settling_profile_sums.cpp.
------------------------------------------------------------------------- */

#include "settling/fix_settling_profile.h"

#include <climits>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_multisphere.h"
#include "fix_property_global.h"
#include "modify.h"
#include "script/values.h"
#include "settling/column_script.h"
#include "settling/pair_listener.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace FixConst;

typedef clay::ColumnProfile Profile;

/* ---------------------------------------------------------------------- */

FixSettlingProfile::FixSettlingProfile(LAMMPS *lmp, int narg, char **arg) :
  Fix(lmp, narg, arg), file_(NULL), bins_(0), area_(0.0), bottom_(0.0), fluid_density_(0.0), area_given_(false),
  bottom_given_(false), multisphere_(NULL), friction_(NULL), gravity_(lmp), measured_(-1),
  written_(-1), clusters_{0.0, 0.0}
{
  bool append = false;
  try {
    parse(narg, arg, append);
  } catch (const std::invalid_argument &e) {
    error->fix_error(FLERR, this, e.what());
  }
  if (igroup != 0) error->fix_error(FLERR, this, "a bed carries all of its particles: the group must be all");

  int opened = 1;
  if (comm->me == 0) {
    file_ = fopen(name_.c_str(), append ? "a" : "w");
    opened = file_ != NULL;
    if (opened && (!append || ftell(file_) == 0)) {
      fprintf(file_,
              "time_s,height_m,solid_fraction,velocity_m_s,flux_m_s,contact_Pa,coulomb_Pa,wall_Pa,fluid_Pa,weight_Pa,"
              "bodies,contacts,cluster,cluster_bound,order_xx,order_yy,order_zz,order_xy,order_xz,order_yz,"
              "face_face,edge_face,edge_edge\n");
      fflush(file_);
    }
  }
  MPI_Bcast(&opened, 1, MPI_INT, 0, world);
  if (!opened) error->fix_error(FLERR, this, ("cannot write file " + name_).c_str());

  listener_.reset(PairListener::make(lmp));
  vector_flag = 1;
  size_vector = 3;
  global_freq = 1;
  extvector = 0;
}

FixSettlingProfile::~FixSettlingProfile()
{
  if (file_) fclose(file_);
}

/* ---------------------------------------------------------------------- */

void FixSettlingProfile::parse(int narg, char **arg, bool &append)
{
  if (narg < 4) throw std::invalid_argument("the number of steps between two profiles is missing");
  nevery = static_cast<int>(clay::wholeNumber("the number of steps between two profiles", arg[3], 1, INT_MAX));
  for (int iarg = 4; iarg < narg; iarg += 2) {
    const std::string key = arg[iarg];
    if (iarg + 1 == narg) throw std::invalid_argument("keyword '" + key + "' needs a value");
    const char *value = arg[iarg + 1];
    if (key == "file" || key == "append") {
      append = key == "append";
      name_ = value;
    } else if (key == "bins") bins_ = static_cast<int>(clay::wholeNumber(key, value, 1, 100000));
    else if (key == "fluid_density") {
      fluid_density_ = clay::number(key, value);
      if (fluid_density_ < 0.0)
        throw std::invalid_argument("fluid_density is '" + std::string(value) + "'; it must be a number of 0 or more");
    } else if (key == "area") {
      area_ = clay::positiveNumber(key, value);
      area_given_ = true;
    } else if (key == "bottom") {
      bottom_ = clay::number(key, value);
      bottom_given_ = true;
    } else
      throw std::invalid_argument("unknown keyword '" + key +
                                  "'; known are file, append, bins, fluid_density, area and bottom");
  }
  if (name_.empty()) throw std::invalid_argument("'file' is missing: the name of the profiles' file");
}

/* ---------------------------------------------------------------------- */

int FixSettlingProfile::setmask() { return END_OF_STEP; }

/* ---------------------------------------------------------------------- */

void FixSettlingProfile::init()
{
  if (!atom->radius_flag || !atom->rmass_flag || !atom->torque_flag)
    error->fix_error(FLERR, this, "needs spheres: atom_style sphere or granular");
  if (domain->zperiodic) error->fix_error(FLERR, this, "a column has a floor: z must not be periodic");
  multisphere_ = multisphere_of(lmp, "Fix settling/profile");
  gravity_.find();
  friction_ = dynamic_cast<FixPropertyGlobal *>(modify->find_fix_property(
      "coefficientFriction", "property/global", "peratomtypepair", atom->ntypes, atom->ntypes, style, false));

  const ColumnSpace space = column_space(lmp);
  if (!area_given_) area_ = space.area;
  if (!bottom_given_) bottom_ = space.bottom;
  const double height = domain->boxhi[2] - bottom_, diameter = largest_diameter(lmp);
  if (!(height > 0.0)) error->fix_error(FLERR, this, "bottom is above the simulation box");
  const int slices = bins_ > 0 ? bins_ : diameter > 0.0 ? static_cast<int>(std::ceil(height / (2.0 * diameter))) : 50;
  profile_.reset(new Profile(bottom_, domain->boxhi[2], slices));
  measured_ = -1;
}

/* ---------------------------------------------------------------------- */

void FixSettlingProfile::setup(int)
{
  if (update->ntimestep % nevery == 0) end_of_step();
}

void FixSettlingProfile::end_of_step()
{
  measure();
  write_rows();
}

/* ----------------------------------------------------------------------
   a row for each slice; means over nothing are nan
------------------------------------------------------------------------- */

void FixSettlingProfile::write_rows()
{
  if (written_ == update->ntimestep) return;
  written_ = update->ntimestep;
  if (comm->me != 0) return;
  const double time = update->get_cur_time(), space = area_ * profile_->thickness();
  for (int k = 0; k < profile_->slices(); k++) {
    const auto get = [&](Profile::Sum s) { return profile_->get(s, k); };
    const auto per = [&](Profile::Sum s, Profile::Sum t) { return get(t) > 0.0 ? get(s) / get(t) : NAN; };
    std::vector<double> row = {time, profile_->height(k), get(Profile::VOLUME) / space,
                               per(Profile::FLUX, Profile::VOLUME), get(Profile::FLUX) / space};
    for (Profile::Sum s : {Profile::CONTACT, Profile::COULOMB, Profile::WALL, Profile::FLUID, Profile::WEIGHT})
      row.push_back(get(s) / area_);
    row.push_back(get(Profile::BODIES));
    for (Profile::Sum s : {Profile::CONTACTS, Profile::TOUCHING, Profile::BOUND})
      row.push_back(per(s, Profile::BODIES));
    for (Profile::Sum s : {Profile::XX, Profile::YY, Profile::ZZ, Profile::XY, Profile::XZ, Profile::YZ})
      row.push_back(per(s, Profile::AXES));
    for (Profile::Sum s : {Profile::FACE_FACE, Profile::EDGE_FACE, Profile::EDGE_EDGE}) row.push_back(get(s));
    for (std::size_t c = 0; c < row.size(); c++) {
      if (std::isnan(row[c])) fputs(c ? ",nan" : "nan", file_);
      else fprintf(file_, c ? ",%.7g" : "%.9g", row[c]);
    }
    fputc('\n', file_);
  }
  fflush(file_);
  if (ferror(file_)) error->one(FLERR, ("Fix settling/profile: cannot write to " + name_).c_str());
}

/* ----------------------------------------------------------------------
   1 what contacts, charges, walls and fluid lack of the weight above at any
   height, over the whole weight; bodies of the largest cluster 2 in touch,
   3 in touch or bound
------------------------------------------------------------------------- */

double FixSettlingProfile::compute_vector(int n)
{
  if (measured_ != update->ntimestep) measure();
  double value = n == 0 ? profile_->imbalance() : clusters_[n - 1];
  MPI_Bcast(&value, 1, MPI_DOUBLE, 0, world);
  return value;
}
