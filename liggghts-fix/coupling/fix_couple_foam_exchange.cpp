/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   What fix couple/foam does in an exchange and in each step: particles to
   the CFD half, its answer back, the fluid's force on free spheres.
------------------------------------------------------------------------- */

#include "coupling/fix_couple_foam.h"

#include <algorithm>
#include <cmath>

#include "atom.h"
#include "clumps/body_drag.h"
#include "comm.h"
#include "coupling/coupled_clumps.h"
#include "coupling/coupling_report.h"
#include "domain.h"
#include "error.h"
#include "thermal/fix_brownian.h"
#include "memory.h"
#include "coupling/runaway_watch.h"
#include "exchange/session.h"
#include "update.h"

using namespace LAMMPS_NS;
using clay::Field;

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::send(bool last)
{
  if (still_) book_rest();
  gather();
  check_finite();
  last_time_ = update->get_cur_time();
  session_->send(sent_,last_time_,last,{{given_[0],given_[1],given_[2]}});
  pending_ = true;
  waited_ = 0;
  report_->exchange(*session_,last);
  if (watch_) watch_->overlaps(report_->overlap(),report_->first(),report_->second());
}

/* ----------------------------------------------------------------------
   free spheres first, then the spheres of the bodies owned here
------------------------------------------------------------------------- */

void FixCoupleFoam::gather()
{
  const int nlocal = atom->nlocal;
  const double third = 4./3.*M_PI, at_rest[3] = {0.,0.,0.};

  spheres_.clear();
  if (bodies_) bodies_->spheres(spheres_);

  int nfree = 0;
  for (int i = 0; i < nlocal; i++)
    fluid_[i][SLOT] = free_sphere(i) ? nfree++ : -1;

  sent_.resize(nfree + spheres_.size());
  const clay::FieldSet fields = sent_.fields();

  auto put = [&](int slot, int i, double volume, double mass, double body, const double *impulse) {
    if (fields.has(Field::position)) {
      double *x = sent_[Field::position] + 3*slot;
      std::copy(atom->x[i],atom->x[i] + 3,x);
      if (domain->xperiodic || domain->yperiodic || domain->zperiodic) domain->remap(x);
    }
    if (fields.has(Field::velocity)) {
      const double *v = still_ ? at_rest : atom->v[i];
      std::copy(v,v + 3,sent_[Field::velocity] + 3*slot);
    }
    if (fields.has(Field::radius)) sent_[Field::radius][slot] = atom->radius[i];
    if (fields.has(Field::volume)) sent_[Field::volume][slot] = volume;
    if (fields.has(Field::mass)) sent_[Field::mass][slot] = mass;
    if (fields.has(Field::tag)) sent_[Field::tag][slot] = atom->tag[i];
    if (fields.has(Field::body)) sent_[Field::body][slot] = body;
    if (fields.has(Field::spin))
      std::copy(atom->omega[i],atom->omega[i] + 3,sent_[Field::spin] + 3*slot);
    if (fields.has(Field::impulse))
      std::copy(impulse,impulse + 3,sent_[Field::impulse] + 3*slot);
  };

  for (int i = 0; i < nlocal; i++) {
    const int slot = fluid_[i][SLOT];
    if (slot < 0) continue;
    const double r = atom->radius[i];
    double *impulse = fluid_[i] + IMPULSE;
    put(slot,i,third*r*r*r,atom->rmass[i],-1.,impulse);
    for (int k = 0; k < 3; k++) {
      given_[k] += impulse[k];
      impulse[k] = 0.;
    }
  }

  if (clumps_)
    for (Field f : {Field::dragDiameter, Field::dragFactor})
      std::fill(sent_[f],sent_[f] + nfree,0.);

  if (spheres_.empty() && comm->nprocs == 1) return;
  share_impulses();
  if (clumps_) tell_clumps(nfree);
  int slot = nfree;
  for (size_t n = 0; n < spheres_.size(); n++) {
    const auto &s = spheres_[n];
    put(slot++,s.atom,s.fraction*bodies_->body_volume(s.body),
        s.fraction*bodies_->body_mass(s.body),bodies_->data().tag(s.body),&shares_[3*n]);
  }
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::tell_clumps(int slot)
{
  clumps_->prepare();
  for (const auto &s : spheres_) {
    sent_[Field::dragDiameter][slot] = clumps_->diameter(s.body);
    sent_[Field::dragFactor][slot++] = clumps_->factor(s.body);
  }
}

/* ----------------------------------------------------------------------
   a body's impulse comes from its spheres: each has what its own drag and
   load gave it since the last exchange; what the body's motion within the
   interval makes of the sum is shared out by the drag coefficients
------------------------------------------------------------------------- */

void FixCoupleFoam::share_impulses()
{
  if (!bodies_) return;
  const double time = update->get_cur_time() - last_time_;
  if (comm->nprocs > 1) comm->forward_comm_fix(this);

  const int nbody = bodies_->n_body();
  std::vector<double> rest(3*nbody), weight(nbody,0.);
  for (int b = 0; b < nbody; b++) {
    bodies_->take_impulse(b,&rest[3*b]);
    for (int k = 0; k < 3; k++) given_[k] += rest[3*b+k];
  }

  shares_.resize(3*spheres_.size());
  for (size_t n = 0; n < spheres_.size(); n++) {
    const auto &s = spheres_[n];
    const double *fluid = fluid_[s.atom];
    weight[s.body] += fluid[DRAG];
    for (int k = 0; k < 3; k++) {
      shares_[3*n+k] = time*(fluid[LOAD+k] + fluid[DRAG]*(fluid[VELOCITY+k] - (still_ ? 0. : atom->v[s.atom][k])));
      rest[3*s.body+k] -= shares_[3*n+k];
    }
  }
  for (size_t n = 0; n < spheres_.size(); n++) {
    const auto &s = spheres_[n];
    const double part = weight[s.body] > 0. ? fluid_[s.atom][DRAG]/weight[s.body] : s.fraction;
    for (int k = 0; k < 3; k++) shares_[3*n+k] += part*rest[3*s.body+k];
  }
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::check_finite()
{
  if (!sent_.fields().has(Field::position) || !sent_.fields().has(Field::velocity)) return;
  const double *x = sent_[Field::position], *v = sent_[Field::velocity];
  for (int i = 0; i < 3*sent_.size(); i++)
    if (!std::isfinite(x[i]) || !std::isfinite(v[i])) {
      const int slot = i/3;
      char text[256];
      snprintf(text,sizeof text,"Fix couple/foam: particle %d has position (%g %g %g), velocity (%g %g %g) "
               "at step " BIGINT_FORMAT "; it went wrong in the last %d steps",
               sent_.fields().has(Field::tag) ? (int) sent_[Field::tag][slot] : slot,
               x[3*slot],x[3*slot+1],x[3*slot+2],v[3*slot],v[3*slot+1],v[3*slot+2],
               update->ntimestep,interval_);
      error->one(FLERR,text);
    }
}

/* ----------------------------------------------------------------------
   the first steps of an interval go on with the answer before, while the
   CFD half maps; not when it solves the fluid before it answers
------------------------------------------------------------------------- */

void FixCoupleFoam::look_for_answer()
{
  if (prompt_ || waited_++ >= lag_) take_answer();
  else session_->answered();   // helps the messages on their way
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::take_answer()
{
  report_->wait_begins();
  session_->receive(answer_);
  report_->wait_ends();
  pending_ = false;
  unseen_ = true;
  if (lag_ > 0) {
    const int mine = session_->late();
    int any = mine;
    if (comm->nprocs > 1) MPI_Allreduce(&mine,&any,1,MPI_INT,MPI_MAX,world);
    prompt_ = any;
  }

  const bool loaded = answer_.fields().has(Field::force);
  const double *K = answer_[Field::dragCoefficient];
  const double *u = answer_[Field::fluidVelocity];
  const double *f = loaded ? answer_[Field::force] : NULL;
  const double none[3] = {0.,0.,0.};
  const bool weighted = answer_.fields().has(Field::addedMass);
  const bool turned = answer_.fields().has(Field::turnCoefficient);

  auto keep = [&](int i, int slot) {
    fluid_[i][DRAG] = K[slot];
    for (int k = 0; k < 3; k++) {
      fluid_[i][VELOCITY+k] = u[3*slot+k];
      fluid_[i][LOAD+k] = loaded ? f[3*slot+k] : 0.;
    }
  };

  for (int i = 0; i < atom->nlocal; i++) {
    const int slot = fluid_[i][SLOT];
    if (slot < 0) continue;
    keep(i,slot);
    fluid_[i][RELAX] = relaxation_factor(K[slot]*update->dt/atom->rmass[i]);
    // what no fix moves does not accelerate
    if (weighted) more_[i][ADDED] = moves(i) ? answer_[Field::addedMass][slot] : 0.;
    if (turned) {
      more_[i][TURN] = moves(i) ? answer_[Field::turnCoefficient][slot] : 0.;
      const double *spin = answer_[Field::fluidSpin] + 3*slot;
      std::copy(spin,spin + 3,more_[i] + SPIN);
    }
  }
  if (!bodies_) return;

  // the body's owner knows its spheres' answers; each sphere takes its own along
  if (comm->nprocs > 1)
    for (int i = 0; i < atom->nlocal + atom->nghost; i++)
      if (i >= atom->nlocal || bodies_->belongs_to(i) >= 0)
        std::fill(fluid_[i] + DRAG,fluid_[i] + FORCE,0.);

  auto sum = [&](auto &bodies) {
    int slot = sent_.size() - spheres_.size();
    for (const auto &s : spheres_) {
      keep(s.atom,slot);
      bodies[s.body].add_sphere(s.r,K[slot],u + 3*slot,loaded ? f + 3*slot : none);
      if (weighted) bodies[s.body].add_mass(s.r,answer_[Field::addedMass][slot]);
      slot++;
    }
  };
  if (clumps_) {
    std::vector<BodyFlow> flow(bodies_->n_body());
    sum(flow);
    for (size_t b = 0; b < flow.size(); b++) clumps_->set_flow(b,flow[b]);
  } else {
    std::vector<BodyDrag> drag(bodies_->n_body());
    sum(drag);
    for (size_t b = 0; b < drag.size(); b++) bodies_->set_drag(b,drag[b]);
  }

  if (comm->nprocs > 1) comm->reverse_comm_fix(this);
}

/* ----------------------------------------------------------------------
   what the fluid does to a sphere, between its owner and its ghosts
------------------------------------------------------------------------- */

int FixCoupleFoam::pack_comm(int n, int *list, double *buf, int, int *)
{
  for (int m = 0; m < n; m++)
    buf = std::copy(fluid_[list[m]] + DRAG,fluid_[list[m]] + FORCE,buf);
  return comm_forward;
}

void FixCoupleFoam::unpack_comm(int n, int first, double *buf)
{
  for (int i = first; i < first + n; i++, buf += comm_forward)
    std::copy(buf,buf + comm_forward,fluid_[i] + DRAG);
}

int FixCoupleFoam::pack_reverse_comm(int n, int first, double *buf)
{
  for (int i = first; i < first + n; i++)
    buf = std::copy(fluid_[i] + DRAG,fluid_[i] + FORCE,buf);
  return comm_reverse;
}

void FixCoupleFoam::unpack_reverse_comm(int n, int *list, double *buf)
{
  for (int m = 0; m < n; m++)
    for (int k = DRAG; k < FORCE; k++) fluid_[list[m]][k] += *buf++;
}
