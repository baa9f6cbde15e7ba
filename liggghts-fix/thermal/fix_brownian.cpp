/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "thermal/fix_brownian.h"

#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string>

#include "atom.h"
#include "clumps/body_drag.h"
#include "error.h"
#include "fluid/coupled_fluid.h"
#include "fix_multisphere.h"
#include "force.h"
#include "modify.h"
#include "script/values.h"
#include "thermal/thermal_kick.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace FixConst;

/* ---------------------------------------------------------------------- */

FixBrownian::FixBrownian(LAMMPS *lmp, int narg, char **arg) :
  Fix(lmp, narg, arg), temperature_(0.), viscosity_(0.), seed_(-1), fluid_(NULL), bodies_(NULL)
{
  try {
    parse(narg, arg);
  } catch (const std::invalid_argument &e) {
    error->all(FLERR, (std::string("Fix brownian: ") + e.what()).c_str());
  }
}

/* ---------------------------------------------------------------------- */

void FixBrownian::parse(int narg, char **arg)
{
  for (int n = 3; n < narg; n += 2) {
    const std::string key = arg[n];
    if (n + 1 == narg) throw std::invalid_argument("keyword '" + key + "' needs a value");
    if (key == "temperature") temperature_ = clay::positiveNumber(key, arg[n + 1]);
    else if (key == "viscosity") viscosity_ = clay::positiveNumber(key, arg[n + 1]);
    else if (key == "seed") seed_ = clay::wholeNumber(key, arg[n + 1], 0);
    else throw std::invalid_argument("unknown keyword '" + key + "'; known are temperature, seed, viscosity");
  }
  if (temperature_ == 0.) throw std::invalid_argument("'temperature' is missing (K)");
  if (seed_ < 0) throw std::invalid_argument("'seed' is missing, a whole number");
}

/* ---------------------------------------------------------------------- */

int FixBrownian::setmask() { return POST_FORCE; }

/* ---------------------------------------------------------------------- */

void FixBrownian::init()
{
  if (!atom->rmass_flag || !atom->radius_flag || !atom->tag_enable)
    error->all(FLERR, "Fix brownian: needs spheres with IDs, as atom_style granular has them");
  if (modify->n_fixes_style("brownian") > 1) error->all(FLERR, "Fix brownian: only one fix brownian is allowed");
  fluid_ = CoupledFluid::find(modify);
  bodies_ = static_cast<FixMultisphere *>(modify->find_fix_style("multisphere", 0));
  if (fluid_ && viscosity_ > 0.)
    error->all(FLERR, "Fix brownian: 'viscosity' is given, and fix couple/foam has the fluid's own; leave it out");
  if (!fluid_ && viscosity_ == 0.)
    error->all(FLERR, "Fix brownian: 'viscosity' is missing (Pa s); without fix couple/foam there is no drag to go by");

  // where it brings the drag itself, that must see all other forces
  const int mine = modify->find_fix(id);
  for (int i = mine + 1; !fluid_ && i < modify->nfix; i++) {
    const char *style = modify->fix[i]->style;
    if (!strncmp(style, "gravity", 7) || !strncmp(style, "addforce", 8) || !strncmp(style, "wall/", 5) ||
        !strncmp(style, "spring", 6))
      error->all(FLERR,
                 (std::string("Fix brownian: must stand below 'fix ") + modify->fix[i]->id + " " + style +
                  "' in the script, since its drag needs that force")
                     .c_str());
  }
}

/* ---------------------------------------------------------------------- */

void FixBrownian::setup(int vflag) { post_force(vflag); }

/* ---------------------------------------------------------------------- */

void FixBrownian::kick(int i, double K, double *force, int stream) const
{
  double four[4];
  const double deviation = atom->mask[i] & groupbit ? clay::thermal_force(K, temperature_, update->dt) : 0.;
  clay::normals(seed_, atom->tag[i], update->ntimestep, stream, four);
  for (int k = 0; k < 3; k++) force[k] = deviation * four[k];
}

/* ----------------------------------------------------------------------
   with a coupling: free spheres are kicked by fix couple/foam, where the
   drag is; a body's spheres here, and the drag on the body sees the sum
------------------------------------------------------------------------- */

void FixBrownian::post_force(int)
{
  double **f = atom->f;
  const int nlocal = atom->nlocal;
  if (fluid_) {
    if (!bodies_) return;
    for (int i = 0; i < nlocal; i++) {
      if (!(atom->mask[i] & groupbit) || bodies_->belongs_to(i) < 0) continue;
      double force[3];
      kick(i, fluid_->drag_coefficient(i), force);
      for (int k = 0; k < 3; k++) f[i][k] += force[k];
    }
    return;
  }
  for (int i = 0; i < nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    if (!bodies_ || bodies_->belongs_to(i) < 0) relax(i, atom->rmass[i], true);
    else {
      // its own part of the body's mass
      const double r = atom->radius[i];
      relax(i, 4. / 3. * M_PI * r * r * r * atom->density[i] * bodies_->get_volumeweight()->vector_atom[i], false);
    }
  }
}

/* ----------------------------------------------------------------------
   Stokes's drag and the random force, couple and spin of a free sphere
   alike. A sphere of a body relaxes with its part of the mass: bounded, and
   right when the step is short against the relaxation time.
------------------------------------------------------------------------- */

void FixBrownian::relax(int i, double mass, bool turns)
{
  const double r = atom->radius[i], dt = update->dt;
  double K = 6. * M_PI * viscosity_ * r, random[3];
  if (!turns) {
    K *= relaxation_factor(K * dt / mass);
    kick(i, K, random);
    for (int k = 0; k < 3; k++) atom->f[i][k] += random[k] - K * atom->v[i][k];
    return;
  }
  kick(i, K, random);
  for (int k = 0; k < 3; k++) {
    const double other = atom->f[i][k] + random[k];
    atom->f[i][k] = other + sphere_drag(K, 0., atom->v[i][k], other, mass, dt);
  }
  if (!atom->torque_flag) return;
  const double Kr = 8. * M_PI * viscosity_ * r * r * r, inertia = 0.4 * mass * r * r;
  kick(i, Kr, random, 1);
  for (int k = 0; k < 3; k++) {
    const double other = atom->torque[i][k] + random[k];
    atom->torque[i][k] = other + sphere_drag(Kr, 0., atom->omega[i][k], other, inertia, dt);
  }
}
