/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   What fix couple/foam does in an exchange and in each step: particles to
   the CFD half, its answer back, the fluid's force on free spheres, or what
   they receive while fix rest/bed keeps them still.
------------------------------------------------------------------------- */

#include "coupling/fix_couple_foam.h"

#include <algorithm>
#include <cmath>

#include "atom.h"
#include "clumps/fix_multisphere_clump.h"
#include "comm.h"
#include "coupling/coupled_clumps.h"
#include "coupling/coupling_report.h"
#include "coupling/motion_record.h"
#include "coupling/runaway_watch.h"
#include "domain.h"
#include "error.h"
#include "exchange/session.h"
#include "update.h"

using namespace LAMMPS_NS;
using clay::Field;

/* ---------------------------------------------------------------------- */

clay::SphereArrays FixCoupleFoam::spheres() const
{
  clay::SphereArrays s;
  s.x = atom->x;
  s.v = atom->v;
  s.omega = atom->omega;
  s.f = atom->f;
  s.torque = atom->torque;
  s.radius = atom->radius;
  s.mass = atom->rmass;
  s.tag = atom->tag;
  s.groups = atom->mask;
  s.gravity = &pull_;
  return s;
}

/* ----------------------------------------------------------------------
   as it is now; the usual one is that of most particles: on all, or on the
   group of this fix
------------------------------------------------------------------------- */

void FixCoupleFoam::find_gravity()
{
  pull_ = gravity_.now();
  usual_ = pull_.on(1 | groupbit);
}

clay::Hydrostatics FixCoupleFoam::hydrostatics() const
{
  const clay::CfdTerms &fluid = session_->remoteTerms();
  return {fluid.buoyancy ? fluid.fluidDensity : 0., usual_};
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::list_free()
{
  free_.clear();
  yielding_.clear();
  held_.clear();
  listed_ = atom->nlocal;
  for (int i = 0; i < listed_; i++)
    if ((atom->mask[i] & groupbit) && !(bodies_ && bodies_->belongs_to(i) >= 0)) {
      free_.push_back(i);
      (moving_.held(atom->mask[i]) ? held_ : yielding_).push_back(i);
    }
}

/* ----------------------------------------------------------------------
   on free spheres; bodies get theirs in fix multisphere/clump
------------------------------------------------------------------------- */

void FixCoupleFoam::apply(bool first)
{
  if (listed_ != atom->nlocal) list_free();
  if (more_) clay::push_inertial_spheres(yielding_, fluid_, more_, spheres(), random_.get(), update->dt, first, given_);
  else clay::push_spheres(yielding_, fluid_, spheres(), random_.get(), update->dt, first, given_);
  clay::push_held_spheres(held_, fluid_, more_, spheres(), moving_, mute_, random_.get(), update->dt, first, given_);
  if (gravity_.changes()) follow_gravity(first);
}

/* ----------------------------------------------------------------------
   a step's force acts by halves before and after it: so does gravity
------------------------------------------------------------------------- */

void FixCoupleFoam::follow_gravity(bool first)
{
  const clay::GroupGravity now = gravity_.now();
  if (!first) {
    mean_pull_.gather(last_pull_, 0.5 * update->dt);
    mean_pull_.gather(now, 0.5 * update->dt);
  }
  last_pull_ = now;
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::send(bool last, const clay::SavedPair &pair)
{
  if (still_) book_rest();
  find_gravity();

  spheres_.clear();
  if (bodies_) bodies_->spheres(spheres_);
  list_free();
  sent_.resize(free_.size() + spheres_.size());
  for (int i = 0; i < atom->nlocal; i++) fluid_[i][Row::SLOT] = -1;
  clay::pack_free(free_, spheres(), fluid_, still_, sent_);
  if (bodies_) pack_clumps(free_.size());
  tell_motions();
  if (sent_.fields().has(Field::position) && (domain->xperiodic || domain->yperiodic || domain->zperiodic))
    for (int n = 0; n < sent_.size(); n++) domain->remap(sent_[Field::position] + 3 * n);
  check_finite();

  last_time_ = update->get_cur_time();
  session_->send(sent_, last_time_, last, {{given_[0], given_[1], given_[2]}}, pair);
  pending_ = true;
  waited_ = 0;
  report_->exchange(*session_, last);
  if (watch_) watch_->overlaps(report_->overlap(), report_->first(), report_->second());
}

/* ----------------------------------------------------------------------
   the spheres of the bodies owned here, from that place of the message on
------------------------------------------------------------------------- */

void FixCoupleFoam::pack_clumps(int first)
{
  if (comm->nprocs > 1) comm->forward_comm_fix(this);
  bodies_->take_given(given_);

  std::vector<clay::BodyState> states(bodies_->n_body());
  for (size_t b = 0; b < states.size(); b++) {
    clay::BodyState &s = states[b];
    s.volume = bodies_->body_volume(b);
    s.mass = bodies_->body_mass(b);
    s.tag = bodies_->data().tag(b);
    bodies_->take_impulse(b, s.impulse.data());
  }
  const std::vector<double> shares =
      clay::share_impulses(spheres_, states, fluid_, atom->v, still_, update->get_cur_time() - last_time_);
  clay::pack_bodies(spheres_, states, shares, spheres(), still_, first, sent_);

  if (!clumps_) return;
  clumps_->prepare();
  int slot = first;
  for (const BodySphere &s : spheres_) {
    sent_[Field::dragDiameter][slot] = clumps_->diameter(s.body);
    sent_[Field::dragFactor][slot++] = clumps_->factor(s.body);
  }
}

/* ----------------------------------------------------------------------
   what all of them did since the last exchange
------------------------------------------------------------------------- */

void FixCoupleFoam::tell_motions()
{
  clay::Interval interval;
  interval.time = update->get_cur_time() - last_time_;
  interval.gravity = usual_;
  const clay::GroupGravity mean = interval.time > 0. ? mean_pull_.by(1. / interval.time) : clay::GroupGravity();
  if (gravity_.changes()) interval.mean = &mean;
  mean_pull_.clear();
  if (domain->xperiodic || domain->yperiodic || domain->zperiodic)
    interval.nearest = [this](double *d) { domain->minimum_image(d); };

  clay::tell_motion(free_, spheres(), fluid_, interval, sent_);
  if (!bodies_) return;
  std::vector<clay::BodyMotion> motions(bodies_->n_body());
  for (size_t b = 0; b < motions.size(); b++) {
    motions[b].known = bodies_->take_motion(b, motions[b].displacement.data(), motions[b].change.data());
    motions[b].spheres = bodies_->data().nrigid(b);
    for (int k = 0; k < 3; k++) motions[b].velocity[k] = bodies_->velocity(b)[k];
    for (int k = 0; k < 3; k++) motions[b].lift[k] = bodies_->hydrostatic(b)[k] / bodies_->body_mass(b);
  }
  // LIGGGHTS goes by the groups of one of a body's spheres
  for (const BodySphere &s : spheres_) motions[s.body].groups = atom->mask[s.atom];
  clay::tell_body_motion(spheres_, motions, interval, free_.size(), sent_);
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::check_finite()
{
  const int slot = clay::first_astray(sent_);
  if (slot < 0) return;
  const double *x = sent_[Field::position] + 3 * slot, *v = sent_[Field::velocity] + 3 * slot;
  char text[256];
  snprintf(text, sizeof text,
           "Fix couple/foam: particle %d has position (%g %g %g), velocity (%g %g %g) "
           "at step " BIGINT_FORMAT "; it went wrong in the last %d steps",
           sent_.fields().has(Field::tag) ? (int)sent_[Field::tag][slot] : slot, x[0], x[1], x[2], v[0], v[1], v[2],
           update->ntimestep, settings_.interval);
  error->one(FLERR, text);
}

/* ----------------------------------------------------------------------
   the first steps of an interval go on with the answer before, while the
   CFD half maps; not when it solves the fluid before it answers
------------------------------------------------------------------------- */

void FixCoupleFoam::look_for_answer()
{
  if (prompt_ || waited_++ >= settings_.lag) take_answer();
  else session_->answered();  // helps the messages on their way
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::take_answer()
{
  report_->wait_begins();
  session_->receive(answer_);
  report_->wait_ends();
  pending_ = false;
  unseen_ = true;
  if (settings_.lag > 0) {
    const int mine = session_->late();
    int any = mine;
    if (comm->nprocs > 1) MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, world);
    prompt_ = any;
  }

  clay::unpack_free(answer_, sent_, hydrostatics(), atom->nlocal, atom->rmass, atom->mask, moving_, update->dt, fluid_,
                    more_);
  if (bodies_) take_body_answers();
}

/* ----------------------------------------------------------------------
   the body's owner knows its spheres' answers; each sphere takes its own along
------------------------------------------------------------------------- */

void FixCoupleFoam::take_body_answers()
{
  if (comm->nprocs > 1)
    for (int i = 0; i < atom->nlocal + atom->nghost; i++)
      if (i >= atom->nlocal || bodies_->belongs_to(i) >= 0)
        std::fill(fluid_[i] + Row::DRAG, fluid_[i] + Row::FORCE, 0.);

  const int first = sent_.size() - spheres_.size(), nbody = bodies_->n_body();
  if (clumps_) {
    const auto flow = clay::unpack_bodies<BodyFlow>(answer_, sent_, hydrostatics(), first, spheres_, nbody, fluid_);
    for (int b = 0; b < nbody; b++) clumps_->set_flow(b, flow[b]);
  } else {
    const auto drag = clay::unpack_bodies<BodyDrag>(answer_, sent_, hydrostatics(), first, spheres_, nbody, fluid_);
    for (int b = 0; b < nbody; b++) bodies_->set_drag(b, drag[b]);
  }

  const bool added = answer_.fields().has(Field::addedMass);
  std::vector<std::array<double, 7>> sums(nbody);
  int slot = first;
  for (const BodySphere &s : spheres_) {
    std::array<double, 7> &sum = sums[s.body];
    for (int k = 0; k < 3; k++) {
      sum[k] += fluid_[s.atom][Row::LOAD + k];
      sum[3 + k] += fluid_[s.atom][Row::HYDRO + k];
    }
    if (added) sum[6] += answer_[Field::addedMass][slot++];
  }
  for (int b = 0; b < nbody; b++) bodies_->set_loads(b, sums[b].data(), sums[b].data() + 3, sums[b][6]);

  if (comm->nprocs > 1) comm->reverse_comm_fix(this);
}

/* ---------------------------------------------------------------------- */

std::vector<clay::StillSphere> FixCoupleFoam::still_spheres() const
{
  std::vector<clay::StillSphere> all;
  for (int i : free_) all.push_back({fluid_[i], atom->rmass[i]});
  for (const BodySphere &s : spheres_) all.push_back({fluid_[s.atom], s.fraction * bodies_->body_mass(s.body)});
  return all;
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::rest(bool still)
{
  if (still == still_) return;
  if (still) {
    if (pending_) take_answer();
    if (listed_ != atom->nlocal) list_free();
    still_forces_.mark(still_spheres());
    unseen_ = false;
  } else book_rest();
  still_ = still;
}

/* ----------------------------------------------------------------------
   the contacts take up what the fluid gives to a particle at rest
------------------------------------------------------------------------- */

void FixCoupleFoam::book_rest()
{
  if (still_steps_ == 0) return;
  const double time = still_steps_ * update->dt;
  double force[3];
  for (int i : free_) {
    clay::still_force(fluid_[i], force);
    for (int k = 0; k < 3; k++) {
      fluid_[i][Row::IMPULSE + k] += time * force[k];
      given_[k] += time * force[k];
    }
  }
  for (const BodySphere &s : spheres_) {
    clay::still_force(fluid_[s.atom], force);
    for (int k = 0; k < 3; k++) given_[k] += force[k] *= time;
    bodies_->add_impulse(s.body, force);
  }
  still_steps_ = 0;
}

/* ---------------------------------------------------------------------- */

bool FixCoupleFoam::rest_step(double tolerance)
{
  if (pending_) take_answer();
  if (unseen_) {
    unseen_ = false;
    const std::array<double, 3> g = gravity_.now().on(1 | groupbit);
    const double limit = tolerance * std::sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
    int changed = still_forces_.changed(still_spheres(), limit), any;
    MPI_Allreduce(&changed, &any, 1, MPI_INT, MPI_MAX, world);
    if (any) return false;
  }
  still_steps_++;
  show(update->ntimestep + 1);
  return true;
}
