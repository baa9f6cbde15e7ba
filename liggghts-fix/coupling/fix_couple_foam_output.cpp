/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   What fix couple/foam shows: the fluid's force and what it is made of, of
   each sphere, of each body, and of all.
------------------------------------------------------------------------- */

#include "coupling/fix_couple_foam.h"

#include <algorithm>

#include "atom.h"
#include "clumps/fix_multisphere_clump.h"
#include "comm.h"
#include "exchange/session.h"
#include "memory.h"
#include "output.h"
#include "update.h"

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

clay::StepState FixCoupleFoam::last_step() const { return {still_, more_, random_.get(), &moving_}; }

/* ----------------------------------------------------------------------
   the last step of a run is shown whoever may ask
------------------------------------------------------------------------- */

bool FixCoupleFoam::output_due(bigint step) const
{
  if (step == update->laststep || step == update->firststep) return true;
  return readers_.any && (readers_.within || step == output->next);
}

/* ---------------------------------------------------------------------- */

std::vector<clay::FluidAction> FixCoupleFoam::body_actions(const std::vector<BodySphere> &spheres)
{
  std::vector<clay::FluidAction> all(bodies_->n_body());
  if (!still_) {
    for (size_t b = 0; b < all.size(); b++) bodies_->fluid_force(b, all[b].force, all[b].drag);
    return all;
  }
  for (const BodySphere &s : spheres) {
    const clay::FluidAction one = clay::still_action(fluid_[s.atom]);
    for (int k = 0; k < 3; k++) {
      all[s.body].force[k] += one.force[k];
      all[s.body].drag[k] += one.drag[k];
    }
  }
  return all;
}

/* ----------------------------------------------------------------------
   all values of this step, if they are read in it
------------------------------------------------------------------------- */

void FixCoupleFoam::show(bigint step)
{
  if (idle_ || !session_ || !output_due(step)) return;
  if (listed_ != atom->nlocal) list_free();
  const int all = atom->nlocal + atom->nghost;
  for (int i = 0; i < all; i++) std::fill_n(array_atom[i], (int)clay::ShownRow::SIZE, 0.);
  clay::show_spheres(free_, fluid_, spheres(), last_step(), array_atom);
  if (bodies_) show_clumps();
}

/* ----------------------------------------------------------------------
   the body's owner shares its force among its spheres
------------------------------------------------------------------------- */

void FixCoupleFoam::show_clumps()
{
  std::vector<BodySphere> list;
  bodies_->spheres(list);
  if (comm->nprocs > 1) comm->forward_comm_fix(this);
  const std::vector<clay::FluidAction> bodies = body_actions(list);

  const int rows = bodies.size();
  if (rows > size_local_rows || !array_local)
    memory->grow(array_local, std::max(rows, 1), (int)clay::ShownBody::SIZE, "couple/foam:array_local");
  size_local_rows = rows;
  clay::show_bodies(list, bodies, fluid_, array_local);
  for (int b = 0; b < rows; b++) array_local[b][clay::ShownBody::TAG] = bodies_->data().tag(b);

  clay::show_body_spheres(list, bodies, fluid_, atom->v, still_, array_atom);
  if (comm->nprocs == 1) return;
  showing_ = true;
  const int usual = comm_reverse;
  comm_reverse = clay::ShownRow::SIZE;
  comm->reverse_comm_fix(this);
  comm_reverse = usual;
  showing_ = false;
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::vertical_forces(std::vector<double> &bodies, std::vector<double> &atoms)
{
  bodies.assign(bodies_ ? bodies_->n_body() : 0, 0.);
  atoms.assign(atom->nlocal, 0.);
  if (idle_ || !session_) return;
  if (listed_ != atom->nlocal) list_free();
  for (int i : free_) atoms[i] = clay::sphere_action(i, fluid_, spheres(), last_step()).force[2];
  if (!bodies_) return;
  std::vector<BodySphere> list;
  if (still_) {
    bodies_->spheres(list);
    if (comm->nprocs > 1) comm->forward_comm_fix(this);  // rows of spheres that others own
  }
  const std::vector<clay::FluidAction> all = body_actions(list);
  for (size_t b = 0; b < all.size(); b++) bodies[b] = all[b].force[2];
}

/* ----------------------------------------------------------------------
   force, drag, and the impulse given so far
------------------------------------------------------------------------- */

double FixCoupleFoam::compute_vector(int n)
{
  const double mine = total(n);
  double all;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

double FixCoupleFoam::total(int n)
{
  if (still_) book_rest();
  const int k = n % 3;
  if (n >= 6) return given_[k] + (bodies_ ? bodies_->given()[k] : 0.);

  if (listed_ != atom->nlocal) list_free();
  double sum = 0.;
  for (int i : free_) {
    const clay::FluidAction a = clay::sphere_action(i, fluid_, spheres(), last_step());
    sum += n < 3 ? a.force[k] : a.drag[k];
  }
  if (!bodies_) return sum;
  std::vector<BodySphere> list;
  if (still_) bodies_->spheres(list);
  for (const clay::FluidAction &a : body_actions(list)) sum += n < 3 ? a.force[k] : a.drag[k];
  return sum;
}
