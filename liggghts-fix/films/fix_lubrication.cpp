/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "films/fix_lubrication.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string>

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fluid/coupled_fluid.h"
#include "fix_multisphere.h"
#include "fix_wall_gran.h"
#include "force.h"
#include "modify.h"
#include "neighbor.h"
#include "script/values.h"
#include "simd/near_pairs.h"
#include "primitive_wall.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace FixConst;

/* ---------------------------------------------------------------------- */

FixLubrication::FixLubrication(LAMMPS *lmp, int narg, char **arg) :
  Fix(lmp, narg, arg), given_(false), pairs_on_(true), walls_on_(true), bodies_(NULL), built_(-1), nall_(-1)
{
  try {
    parse(narg, arg);
  } catch (const std::invalid_argument &e) {
    error->all(FLERR, (std::string("Fix lubrication: ") + e.what()).c_str());
  }
  mine_[0] = mine_[1] = 0.;
  mine_[2] = law_.outer;
  vector_flag = 1;
  size_vector = 3;
  global_freq = 1;
  extvector = 0;
  comm_forward = SIZE;
}

/* ---------------------------------------------------------------------- */

void FixLubrication::parse(int narg, char **arg)
{
  for (int n = 3; n < narg; n += 2) {
    const std::string key = arg[n];
    if (n + 1 == narg) throw std::invalid_argument("keyword '" + key + "' needs a value");
    const char *value = arg[n + 1];
    if (key == "viscosity") {
      law_.viscosity = clay::positiveNumber(key, value);
      given_ = true;
    } else if (key == "outer") law_.outer = clay::positiveNumber(key, value);
    else if (key == "inner") law_.inner = clay::positiveNumber(key, value);
    else if (key == "logarithm") law_.logarithm = clay::yesOrNo(key, value);
    else if (key == "shear") law_.shear = clay::yesOrNo(key, value);
    else if (key == "shifted") law_.shifted = clay::yesOrNo(key, value);
    else if (key == "contact") law_.contact = clay::yesOrNo(key, value);
    else if (key == "pairs") pairs_on_ = clay::yesOrNo(key, value);
    else if (key == "walls") walls_on_ = clay::yesOrNo(key, value);
    else
      throw std::invalid_argument("unknown keyword '" + key +
                                  "'; known are viscosity, outer, inner, "
                                  "logarithm, shear, shifted, contact, pairs, walls");
  }
  if (law_.inner >= law_.outer) {
    char text[160];
    snprintf(text, sizeof text, "the inner gap, %g, is not below the outer one, %g (in mean radii)", law_.inner,
             law_.outer);
    throw std::invalid_argument(text);
  }
  law_.shear = law_.shear && law_.logarithm;
}

/* ---------------------------------------------------------------------- */

int FixLubrication::setmask() { return POST_FORCE; }

/* ----------------------------------------------------------------------
   all other forces, but the drag, must be known when the films resist
------------------------------------------------------------------------- */

void FixLubrication::init()
{
  if (!atom->rmass_flag || !atom->radius_flag || !atom->omega_flag || !atom->torque_flag)
    error->all(FLERR, "Fix lubrication: needs spheres, as atom_style granular has them");
  if (force->newton_pair) error->all(FLERR, "Fix lubrication: requires newton off");
  if (!comm->ghost_velocity)
    error->all(FLERR, "Fix lubrication: requires velocities of ghost atoms: communicate single vel yes");
  if (modify->n_fixes_style("lubrication") > 1)
    error->all(FLERR,
               "Fix lubrication: only one fix lubrication is allowed; it shares each sphere's mass among its films");

  const int mine = modify->find_fix(id);
  for (int i = mine + 1; i < modify->nfix; i++) {
    const char *style = modify->fix[i]->style;
    if (!strncmp(style, "gravity", 7) || !strncmp(style, "addforce", 8) || !strncmp(style, "wall/", 5) ||
        !strncmp(style, "spring", 6) || !strncmp(style, "brownian", 8))
      error->all(FLERR,
                 (std::string("Fix lubrication: must stand below 'fix ") + modify->fix[i]->id + " " + style +
                  "' in the script, since the films need its force")
                     .c_str());
  }
  if (!given_ && !CoupledFluid::find(modify))
    error->all(FLERR,
               "Fix lubrication: 'viscosity' is missing (Pa s); without fix couple/foam there is no fluid to ask");

  bodies_ = static_cast<FixMultisphere *>(modify->find_fix_style("multisphere", 0));
  walls_.clear();
  for (int i = 0; walls_on_ && i < modify->nfix; i++) {
    FixWallGran *wall = dynamic_cast<FixWallGran *>(modify->fix[i]);
    if (wall && !wall->is_mesh_wall() && wall->primitiveWall()) walls_.push_back(wall);
  }

  // LIGGGHTS hands over ghosts within half of its ghost cut-off; here both
  // processors of a pair need the other's sphere
  if (pairs_on_) {
    double radius = 0., all, least;
    for (int i = 0; i < atom->nlocal; i++) radius = std::max(radius, atom->radius[i]);
    MPI_Allreduce(&radius, &all, 1, MPI_DOUBLE, MPI_MAX, world);
    modify->max_min_rad(radius, least);
    all = std::max(all, radius);
    comm->cutghostuser = std::max(comm->cutghostuser, 2. * (2. + law_.outer) * all + neighbor->skin);
  }
  built_ = -1;
}

/* ---------------------------------------------------------------------- */

void FixLubrication::setup(int vflag)
{
  if (!given_) { law_.viscosity = CoupledFluid::find(modify)->fluid_viscosity(); }
  post_force(vflag);
}

/* ----------------------------------------------------------------------
   a sphere of a body stands for its own part of the body's mass: parts of
   all of them make up its mass and moments of inertia
------------------------------------------------------------------------- */

void FixLubrication::mass_and_inertia(int i, double &m, double &I) const
{
  const double r = atom->radius[i];
  m = atom->rmass[i];
  if (bodies_ && bodies_->belongs_to(i) >= 0)
    m = 4. / 3. * M_PI * r * r * r * atom->density[i] * bodies_->get_volumeweight()->vector_atom[i];
  I = 0.4 * m * r * r;
}

/* ---------------------------------------------------------------------- */

void FixLubrication::seek_pairs()
{
  pairs_.clear();
  if (!pairs_on_) return;
  std::vector<double> reach(nall_);
  for (int i = 0; i < nall_; i++) reach[i] = (1. + 0.5 * law_.outer) * atom->radius[i] + 0.5 * neighbor->skin;
  clay::near_pairs(atom->x, reach.data(), atom->nlocal, nall_, pairs_);

  size_t kept = 0;
  for (size_t p = 0; p < pairs_.size(); p++) {
    const int i = pairs_[p].first, j = pairs_[p].second;
    if (!(atom->mask[i] & groupbit) || !(atom->mask[j] & groupbit)) continue;
    const int body = bodies_ ? bodies_->belongs_to(i) : -1;
    if (body >= 0 && body == bodies_->belongs_to(j)) continue;
    pairs_[kept++] = pairs_[p];
  }
  pairs_.resize(kept);
}

/* ---------------------------------------------------------------------- */

void FixLubrication::seek_walls()
{
  beside_.clear();
  for (size_t w = 0; w < walls_.size(); w++) {
    PrimitiveWall *wall = walls_[w]->primitiveWall();
    for (int i = 0; i < atom->nlocal; i++) {
      double to[3];
      const double r = atom->radius[i];
      if ((atom->mask[i] & groupbit) && (atom->mask[i] & walls_[w]->groupbit) &&
          wall->resolveContact(atom->x[i], r, to) < law_.outer * r + 0.5 * neighbor->skin)
        beside_.push_back(std::make_pair(static_cast<int>(w), i));
    }
  }
}

/* ---------------------------------------------------------------------- */

void FixLubrication::add(const Thin &thin)
{
  const int nlocal = atom->nlocal;
  double m, I;
  if (thin.i < nlocal) {
    mass_and_inertia(thin.i, m, I);
    clay::add_load(thin.film, thin.film.armI, m, I, state_[thin.i].load);
  }
  if (thin.j >= 0 && thin.j < nlocal) {
    mass_and_inertia(thin.j, m, I);
    clay::add_load(thin.film, thin.film.armJ, m, I, state_[thin.j].load);
  }
  films_.push_back(thin);
}

/* ---------------------------------------------------------------------- */

void FixLubrication::find_films()
{
  double **x = atom->x;
  const double *radius = atom->radius;
  for (size_t p = 0; p < pairs_.size(); p++) {
    const int i = pairs_[p].first, j = pairs_[p].second;
    const double dx = x[i][0] - x[j][0], dy = x[i][1] - x[j][1], dz = x[i][2] - x[j][2];
    const double sum = radius[i] + radius[j], reach = sum * (1. + 0.5 * law_.outer);
    const double r2 = dx * dx + dy * dy + dz * dz;
    if (r2 >= reach * reach || r2 == 0.) continue;
    const double r = sqrt(r2);
    const Thin thin = {law_.spheres(radius[i], radius[j], r - sum), i, j, {dx / r, dy / r, dz / r}};
    if (!thin.film.acts()) continue;
    mine_[2] = std::min(mine_[2], 2. * (r - sum) / sum);
    add(thin);
  }
  mine_[0] = films_.size();
}

/* ---------------------------------------------------------------------- */

void FixLubrication::find_wall_films()
{
  for (size_t n = 0; n < beside_.size(); n++) {
    PrimitiveWall *wall = walls_[beside_[n].first]->primitiveWall();
    const int i = beside_[n].second;
    const double r = atom->radius[i];
    double to[3] = {0., 0., 0.};
    const double gap = wall->resolveContact(atom->x[i], r, to);
    if (gap >= law_.outer * r) continue;
    const double away = sqrt(to[0] * to[0] + to[1] * to[1] + to[2] * to[2]);
    if (away == 0.) continue;
    double curved = 0.;
    if (wall->axis() >= 0) {
      double out[3];
      const double centre = wall->calcRadialDistance(atom->x[i], out);
      const bool inside = to[0] * out[0] + to[1] * out[1] + to[2] * out[2] > 0.;
      curved = inside ? centre + gap + r : -(centre - gap - r);
    }
    const Thin thin = {law_.wall(r, gap, curved), i, -1, {-to[0] / away, -to[1] / away, -to[2] / away}};
    if (!thin.film.acts()) continue;
    mine_[2] = std::min(mine_[2], gap / r);
    add(thin);
  }
  mine_[1] = films_.size() - mine_[0];
}

/* ---------------------------------------------------------------------- */

void FixLubrication::post_force(int)
{
  const int nlocal = atom->nlocal;
  if (neighbor->lastcall != built_ || nlocal + atom->nghost != nall_) {
    built_ = neighbor->lastcall;
    nall_ = nlocal + atom->nghost;
    seek_pairs();
    seek_walls();
  }

  films_.clear();
  mine_[2] = law_.outer;
  const State none = {};
  state_.assign(nall_, none);
  find_films();
  find_wall_films();

  // with processors, one whose spheres have no film may still own a neighbour's
  if (comm->nprocs == 1 && films_.empty()) return;
  for (int i = 0; i < nlocal; i++) {
    // what a body's other spheres feel is not known here
    if (bodies_ && bodies_->belongs_to(i) >= 0) continue;
    double m, I;
    mass_and_inertia(i, m, I);
    for (int k = 0; k < 3; k++) {
      state_[i].a[k] = atom->f[i][k] / m;
      state_[i].b[k] = atom->torque[i][k] / I;
    }
  }
  if (pairs_on_ && atom->nghost + comm->nprocs > 1) comm->forward_comm_fix(this);

  const double still[3] = {0., 0., 0.};
  const clay::FilmSide wall = {still, still, still, still, clay::FilmLoad()};
  for (size_t p = 0; p < films_.size(); p++) {
    const Thin &thin = films_[p];
    const int i = thin.i, j = thin.j;
    const State &s = state_[i];
    const clay::FilmSide one = {atom->v[i], atom->omega[i], s.a, s.b, s.load};
    clay::FilmSide other = wall;
    if (j >= 0) {
      const State &t = state_[j];
      other = {atom->v[j], atom->omega[j], t.a, t.b, t.load};
    }
    const clay::FilmForce force = clay::film_force(thin.film, thin.n, one, other, update->dt);
    if (i < nlocal)
      for (int k = 0; k < 3; k++) {
        atom->f[i][k] += force.force[k];
        atom->torque[i][k] += force.coupleI[k];
      }
    if (j >= 0 && j < nlocal)
      for (int k = 0; k < 3; k++) {
        atom->f[j][k] -= force.force[k];
        atom->torque[j][k] += force.coupleJ[k];
      }
  }
}

/* ----------------------------------------------------------------------
   1, 2: films between spheres and at walls; 3: smallest gap over mean radius.
   A film between two processors is counted by both.
------------------------------------------------------------------------- */

double FixLubrication::compute_vector(int n)
{
  double all;
  MPI_Allreduce(&mine_[n], &all, 1, MPI_DOUBLE, n == 2 ? MPI_MIN : MPI_SUM, world);
  return all;
}

/* ---------------------------------------------------------------------- */

int FixLubrication::pack_comm(int n, int *list, double *buf, int, int *)
{
  for (int m = 0; m < n; m++) {
    const double *from = reinterpret_cast<const double *>(&state_[list[m]]);
    buf = std::copy(from, from + SIZE, buf);
  }
  return SIZE;
}

void FixLubrication::unpack_comm(int n, int first, double *buf)
{
  for (int i = first; i < first + n; i++, buf += SIZE)
    std::copy(buf, buf + SIZE, reinterpret_cast<double *>(&state_[i]));
}

/* ---------------------------------------------------------------------- */

double FixLubrication::memory_usage()
{
  return (pairs_.capacity() + beside_.capacity()) * sizeof(pairs_[0]) + state_.capacity() * sizeof(State) +
      films_.capacity() * sizeof(Thin);
}
