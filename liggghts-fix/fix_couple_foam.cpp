/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "fix_couple_foam.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>

#include "atom.h"
#include "body_drag.h"
#include "comm.h"
#include "contact_check.h"
#include "coupling_report.h"
#include "domain.h"
#include "error.h"
#include "fix_gravity.h"
#include "force.h"
#include "memory.h"
#include "modify.h"
#include "session.h"
#include "universe.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace FixConst;
using clay::Field;

/* ---------------------------------------------------------------------- */

FixCoupleFoam::FixCoupleFoam(LAMMPS *lmp, int narg, char **arg) :
  Fix(lmp, narg, arg),
  interval_(0), dt_(0.), idle_(false), opened_(-1), pending_(false), check_limit_(true),
  warned_(false), exchanges_(0),
  bodies_(NULL), fluid_(NULL), last_time_(0.)
{
  parse(narg,arg);
  given_[0] = given_[1] = given_[2] = 0.;

  nevery = 1;
  time_depend = 1;
  create_attribute = 1;   // set_arrays for particles inserted within a run
  restart_global = 1;     // the clock, which LIGGGHTS does not restart
  comm_forward = comm_reverse = FORCE - DRAG;
  grow_arrays(atom->nmax);
  atom->add_callback(0);
  for (int i = 0; i < atom->nlocal; i++) set_arrays(i);
}

/* ---------------------------------------------------------------------- */

FixCoupleFoam::~FixCoupleFoam()
{
  if (session_) session_->close();
  Fix *ms = modify ? modify->find_fix_style("multisphere",0) : NULL;
  if (FixMultisphereClump *bodies = dynamic_cast<FixMultisphereClump*>(ms)) bodies->uncouple();
  atom->delete_callback(id,0);
  memory->destroy(fluid_);
}

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
  double seconds = 1.0;

  int iarg = 3;
  while (iarg < narg) {
    if (iarg+2 > narg)
      error->all(FLERR,(std::string("Fix couple/foam: keyword '") + arg[iarg] +
                        "' needs a value").c_str());
    const std::string key = arg[iarg], value = arg[iarg+1];
    if (key == "every") interval_ = whole_number(arg[iarg+1]);
    else if (key == "stats") stats = value;
    else if (key == "progress") seconds = force->numeric(FLERR,arg[iarg+1]);
    else if (key == "contact_limit") {
      if (value != "yes" && value != "no")
        error->all(FLERR,("Fix couple/foam: contact_limit is '" + value +
                          "'; yes or no is wanted").c_str());
      check_limit_ = value == "yes";
    } else
      error->all(FLERR,("Fix couple/foam: unknown keyword '" + key + "'; known are "
                        "every, stats, progress, contact_limit").c_str());
    iarg += 2;
  }
  if (interval_ < 1)
    error->all(FLERR,"Fix couple/foam: 'every N' is missing; "
                     "N is the number of DEM steps between two exchanges");
  report_.reset(new CouplingReport(lmp,stats,seconds));
}

/* ---------------------------------------------------------------------- */

int FixCoupleFoam::setmask()
{
  // PRE_FORCE stands for setup_pre_force()
  return POST_INTEGRATE | PRE_EXCHANGE | PRE_FORCE | POST_FORCE | END_OF_STEP;
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::post_create()
{
  if (modify->n_fixes_style("couple/foam") > 1)
    error->all(FLERR,"Fix couple/foam: there is one already; one fix couples all particles");
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::init()
{
  if (!atom->rmass_flag || !atom->radius_flag)
    error->all(FLERR,"Fix couple/foam: needs radius and mass per particle, "
                     "as atom_style granular has them");

  Fix *ms = modify->find_fix_style("multisphere",0);
  bodies_ = dynamic_cast<FixMultisphereClump*>(ms);
  if (ms && !bodies_)
    error->all(FLERR,(std::string("Fix couple/foam: clumps need 'fix multisphere/clump'; the script has 'fix ") +
                      ms->style + "'").c_str());
  if (bodies_ && igroup != 0)
    error->all(FLERR,"Fix couple/foam: with clumps its group must be 'all'");
  if (strstr(update->integrate_style,"respa"))
    error->all(FLERR,"Fix couple/foam: works with run_style verlet, not with respa");
  if (bodies_) bodies_->couple();

  check_order();
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
         !strncmp(other->style,"wall/",5) || !strncmp(other->style,"spring",6)))
      error->all(FLERR,(std::string("Fix couple/foam: must stand below 'fix ") + other->id + " " +
                        other->style + "' in the script, since the drag needs its force").c_str());
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
           "Fix couple/foam: timestep %g s is above %.3g s, the contact limit of a clump '%s' at rest; "
           "take a smaller one, or a softer contact, or contact_limit no",
           update->dt,limit,which.c_str());
  error->all(FLERR,text);
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

/* ---------------------------------------------------------------------- */

clay::DemTerms FixCoupleFoam::terms()
{
  clay::DemTerms t;
  t.program = universe->version;
  t.step = update->dt;
  t.interval = interval_;
  t.startTime = update->get_cur_time();
  t.endTime = t.startTime + (update->laststep - update->firststep)*update->dt;

  FixGravity *gravity = static_cast<FixGravity*>(modify->find_fix_style("gravity",0));
  t.hasGravity = gravity != NULL;
  if (gravity) gravity->get_gravity(t.gravity.data());

  for (int k = 0; k < 3; k++) {
    t.box.lo[k] = domain->boxlo[k];
    t.box.hi[k] = domain->boxhi[k];
  }

  double radius = 0., all;
  bigint n = 0, nall;
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & groupbit) {
      radius = std::max(radius,atom->radius[i]);
      n++;
    }
  MPI_Allreduce(&radius,&all,1,MPI_DOUBLE,MPI_MAX,world);
  MPI_Allreduce(&n,&nall,1,MPI_LMP_BIGINT,MPI_SUM,world);
  t.maxRadius = all;
  t.particles = nall;

  t.offers = {Field::position, Field::radius, Field::volume, Field::velocity, Field::tag,
              Field::body, Field::impulse, Field::mass};
  t.needs = {Field::dragCoefficient, Field::fluidVelocity};
  return t;
}

/* ----------------------------------------------------------------------
   handshake, at the first run; a further run goes on from there
------------------------------------------------------------------------- */

void FixCoupleFoam::open()
{
  dt_ = update->dt;
  check_interval();
  if (check_limit_) check_contact_limit();
  try {
    const clay::DemTerms mine = terms();
    if (session_) session_->resume(mine);
    else {
      session_.reset(new clay::DemSession(mine));
      for (const std::string &odd : clay::warnings(mine,session_->peer())) report_->warn(odd);
    }
  } catch (clay::Refusal &refusal) {
    error->all(FLERR,refusal.what());
  }
  sent_ = clay::Particles(session_->sends());
  answer_ = clay::Particles(session_->receives());
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::setup_pre_force(int)
{
  idle_ = update->laststep == update->firststep;
  opened_ = update->laststep;
  if (idle_) return;
  report_->start();
  open();
  send(false);
  take_answer();
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::setup(int)
{
  if (!idle_) apply(true);
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::post_integrate()
{
  if (update->laststep != opened_)
    error->all(FLERR,"Fix couple/foam: 'run ... pre no' starts without its set-up, which the coupling needs; leave out 'pre no'");
  if (!pending_) return;
  // a fix that stands above may insert or delete particles in pre_exchange
  for (int i = 0; i < modify->nfix; i++)
    if (modify->fix[i]->force_reneighbor && modify->fix[i]->next_reneighbor == update->ntimestep) {
      take_answer();
      return;
    }
}

/* ----------------------------------------------------------------------
   LIGGGHTS keeps the step in its restart files, but not the time
------------------------------------------------------------------------- */

void FixCoupleFoam::write_restart(FILE *fp)
{
  if (comm->me) return;
  const int size = sizeof(double);
  const double time = update->get_cur_time();
  fwrite(&size,sizeof(int),1,fp);
  fwrite(&time,sizeof(double),1,fp);
}

void FixCoupleFoam::restart(char *buf)
{
  std::memcpy(&update->atime,buf,sizeof(double));
  update->atimestep = update->ntimestep;
}

/* ----------------------------------------------------------------------
   particles are about to change places: the answer must be in before
------------------------------------------------------------------------- */

void FixCoupleFoam::pre_exchange()
{
  if (pending_) take_answer();
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::post_force(int)
{
  if (idle_) return;
  if (pending_) take_answer();
  apply(false);
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::end_of_step()
{
  if (idle_ || (update->ntimestep - update->firststep) % interval_) return;
  if (update->dt != dt_) {
    char text[192];
    snprintf(text,sizeof text,"Fix couple/foam: the timestep changed from %g to %g s within a run; "
             "change it between two runs",dt_,update->dt);
    error->all(FLERR,text);
  }
  if (check_limit_ && ++exchanges_ % 50 == 0) watch_contact_limit();
  send(update->ntimestep == update->laststep);
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::post_run()
{
  if (idle_) return;
  if (pending_) take_answer();
  report_->finish(*session_,interval_);
}

/* ---------------------------------------------------------------------- */

bool FixCoupleFoam::free_sphere(int i) const
{
  return (atom->mask[i] & groupbit) && !(bodies_ && bodies_->belongs_to(i) >= 0);
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::send(bool last)
{
  gather();
  check_finite();
  last_time_ = update->get_cur_time();
  session_->send(sent_,last_time_,last,{{given_[0],given_[1],given_[2]}});
  pending_ = true;
  report_->exchange(*session_,last);
}

/* ----------------------------------------------------------------------
   free spheres first, then the spheres of the bodies owned here
------------------------------------------------------------------------- */

void FixCoupleFoam::gather()
{
  const int nlocal = atom->nlocal;
  const double third = 4./3.*M_PI;

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
    if (fields.has(Field::velocity))
      std::copy(atom->v[i],atom->v[i] + 3,sent_[Field::velocity] + 3*slot);
    if (fields.has(Field::radius)) sent_[Field::radius][slot] = atom->radius[i];
    if (fields.has(Field::volume)) sent_[Field::volume][slot] = volume;
    if (fields.has(Field::mass)) sent_[Field::mass][slot] = mass;
    if (fields.has(Field::tag)) sent_[Field::tag][slot] = atom->tag[i];
    if (fields.has(Field::body)) sent_[Field::body][slot] = body;
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

  if (spheres_.empty() && comm->nprocs == 1) return;
  share_impulses();
  int slot = nfree;
  for (size_t n = 0; n < spheres_.size(); n++) {
    const auto &s = spheres_[n];
    put(slot++,s.atom,s.fraction*bodies_->body_volume(s.body),
        s.fraction*bodies_->body_mass(s.body),bodies_->data().tag(s.body),&shares_[3*n]);
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
      shares_[3*n+k] = time*(fluid[LOAD+k] + fluid[DRAG]*(fluid[VELOCITY+k] - atom->v[s.atom][k]));
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

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::take_answer()
{
  session_->receive(answer_);
  pending_ = false;

  const bool loaded = answer_.fields().has(Field::force);
  const double *K = answer_[Field::dragCoefficient];
  const double *u = answer_[Field::fluidVelocity];
  const double *f = loaded ? answer_[Field::force] : NULL;
  const double none[3] = {0.,0.,0.};

  auto keep = [&](int i, int slot) {
    fluid_[i][DRAG] = K[slot];
    for (int k = 0; k < 3; k++) {
      fluid_[i][VELOCITY+k] = u[3*slot+k];
      fluid_[i][LOAD+k] = loaded ? f[3*slot+k] : 0.;
    }
  };

  for (int i = 0; i < atom->nlocal; i++) {
    const int slot = fluid_[i][SLOT];
    if (slot >= 0) keep(i,slot);
  }
  if (!bodies_) return;

  // the body's owner knows its spheres' answers; each sphere takes its own along
  if (comm->nprocs > 1)
    for (int i = 0; i < atom->nlocal + atom->nghost; i++)
      if (i >= atom->nlocal || bodies_->belongs_to(i) >= 0)
        std::fill(fluid_[i] + DRAG,fluid_[i] + FORCE,0.);

  std::vector<BodyDrag> drag(bodies_->n_body());
  int slot = sent_.size() - spheres_.size();
  for (const auto &s : spheres_) {
    keep(s.atom,slot);
    drag[s.body].add_sphere(s.r,K[slot],u + 3*slot,loaded ? f + 3*slot : none);
    slot++;
  }
  for (size_t b = 0; b < drag.size(); b++) bodies_->set_drag(b,drag[b]);

  if (comm->nprocs > 1) comm->reverse_comm_fix(this);
}

/* ----------------------------------------------------------------------
   free spheres; bodies get theirs in fix multisphere/clump.
   A force of step n acts over [n-1/2, n+1/2], and v is that of n-1/2.
------------------------------------------------------------------------- */

void FixCoupleFoam::apply(bool setupflag)
{
  const double dt = update->dt;
  double **v = atom->v;
  double **f = atom->f;

  for (int i = 0; i < atom->nlocal; i++) {
    if (!free_sphere(i)) continue;
    double *s = fluid_[i];
    const double a = s[DRAG]*dt/atom->rmass[i];
    const double phi = relaxation_factor(a);
    for (int k = 0; k < 3; k++) {
      const double load = s[LOAD+k];
      const double drag = phi*s[DRAG]*(s[VELOCITY+k] - v[i][k]) + (phi - 1.)*(f[i][k] + load);
      const double force = load + drag;
      if (!setupflag) s[IMPULSE+k] += 0.5*dt*(s[FORCE+k] + force);
      s[FORCE+k] = force;
      f[i][k] += force;
    }
  }
}

/* ---------------------------------------------------------------------- */

double FixCoupleFoam::memory_usage()
{
  return atom->nmax*SIZE*sizeof(double);
}

void FixCoupleFoam::grow_arrays(int nmax)
{
  memory->grow(fluid_,nmax,(int) SIZE,"couple/foam:fluid");
}

void FixCoupleFoam::copy_arrays(int i, int j, int)
{
  std::copy(fluid_[i],fluid_[i] + SIZE,fluid_[j]);
}

void FixCoupleFoam::set_arrays(int i)
{
  std::fill(fluid_[i],fluid_[i] + SIZE,0.);
  fluid_[i][SLOT] = -1;
}

int FixCoupleFoam::pack_exchange(int i, double *buf)
{
  std::copy(fluid_[i],fluid_[i] + SIZE,buf);
  return SIZE;
}

int FixCoupleFoam::unpack_exchange(int nlocal, double *buf)
{
  std::copy(buf,buf + SIZE,fluid_[nlocal]);
  return SIZE;
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
