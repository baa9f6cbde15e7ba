/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "coupling/fix_couple_foam.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "atom.h"
#include "clumps/fix_multisphere_clump.h"
#include "comm.h"
#include "coupling/coupled_clumps.h"
#include "coupling/coupling_report.h"
#include "coupling/run_checks.h"
#include "coupling/runaway_watch.h"
#include "coupling/state_saver.h"
#include "coupling/stop_signals.h"
#include "coupling/verlet_coupled.h"
#include "domain.h"
#include "error.h"
#include "exchange/session.h"
#include "exchange/world.h"
#include "memory.h"
#include "modify.h"
#include "thermal/fix_brownian.h"
#include "universe.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace FixConst;
using clay::ClumpDragKind;
using clay::Field;

namespace {

// the words of the command behind the style's name, understood
clay::CoupleSettings settings(int narg, char **arg, Error *error)
{
  try {
    return clay::CoupleSettings::parse(std::vector<std::string>(arg + 3, arg + narg));
  } catch (const std::invalid_argument &e) {
    error->all(FLERR, (std::string("Fix couple/foam: ") + e.what()).c_str());
  }
  return {};
}

// random forces of the script
class Thermal : public clay::RandomForce {
 public:
  explicit Thermal(const FixBrownian *fix) : fix_(fix) {}
  void force(int i, double K, double *force) const override { fix_->kick(i, K, force); }
  void couple(int i, double C, double *couple) const override { fix_->kick(i, C, couple, 1); }

 private:
  const FixBrownian *fix_;
};

}  // namespace

/* ---------------------------------------------------------------------- */

FixCoupleFoam::FixCoupleFoam(LAMMPS *lmp, int narg, char **arg) :
  Fix(lmp, narg, arg), settings_(settings(narg, arg, error)), dt_(0.), idle_(false), opened_(-1), pending_(false),
  waited_(0), prompt_(true), warned_(false), exchanges_(0), bodies_(NULL), fluid_(NULL), more_(NULL), kept_(NULL),
  gravity_(lmp), usual_{}, listed_(-1), still_(false), unseen_(false), still_steps_(0), showing_(false), last_time_(0.),
  start_pair_(0.), save_due_(false), saving_(false), holds_(false), stop_(0)
{
  given_[0] = given_[1] = given_[2] = 0.;

  report_.reset(new CouplingReport(lmp, settings_.stats, settings_.progress));
  report_->setting("clump_drag", clay::name(settings_.clumpDrag));
  if (settings_.clumpDrag == ClumpDragKind::resistance) {
    clumps_.reset(new CoupledClumps(lmp, clay::shapeLaw(settings_.shapeLaw)));
    report_->setting("shape_law", settings_.shapeLaw);
  }
  if (settings_.watch) watch_.reset(new RunawayWatch(lmp));

  clay::listen_for_stops(true);
  nevery = 1;
  time_depend = 1;
  create_attribute = 1;  // set_arrays for particles inserted within a run
  restart_global = restart_peratom = 1;

  peratom_flag = local_flag = vector_flag = 1;
  peratom_freq = local_freq = global_freq = 1;
  size_peratom_cols = clay::ShownRow::SIZE;
  size_local_cols = clay::ShownBody::SIZE;
  size_local_rows = 0;
  size_vector = 9;
  extvector = 1;  // sums over particles

  grow_arrays(atom->nmax);
  atom->add_callback(0);
  atom->add_callback(1);
  if (!settings_.checkpoint.empty()) {
    saver_.reset(new StateSaver(lmp, settings_));
    make_kept();
  }
  if (strcmp(update->integrate_style, "verlet") == 0 && !dynamic_cast<VerletCoupled *>(update->integrate)) {
    delete update->integrate;
    update->integrate = new VerletCoupled(lmp);
  }
  for (int i = 0; i < atom->nlocal; i++) set_arrays(i);
}

/* ---------------------------------------------------------------------- */

FixCoupleFoam::~FixCoupleFoam()
{
  clay::listen_for_stops(false);
  if (session_) session_->close();
  Fix *ms = modify ? modify->find_fix_style("multisphere", 0) : NULL;
  if (FixMultisphereClump *bodies = dynamic_cast<FixMultisphereClump *>(ms)) bodies->uncouple();
  atom->delete_callback(id, 0);
  atom->delete_callback(id, 1);
  memory->destroy(fluid_);
  memory->destroy(more_);
  memory->destroy(array_atom);
  memory->destroy(array_local);
  memory->destroy(kept_);
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
    error->all(FLERR, "Fix couple/foam: only one fix couple/foam is allowed; it couples all particles");
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::init()
{
  if (!atom->rmass_flag || !atom->radius_flag)
    error->all(FLERR,
               "Fix couple/foam: needs radius and mass per particle, "
               "as atom_style granular has them");

  Fix *ms = modify->find_fix_style("multisphere", 0);
  bodies_ = dynamic_cast<FixMultisphereClump *>(ms);
  if (ms && !bodies_)
    error->all(
        FLERR,
        (std::string("Fix couple/foam: clumps need 'fix multisphere/clump'; the script has 'fix ") + ms->style + "'")
            .c_str());
  if (bodies_ && igroup != 0) error->all(FLERR, "Fix couple/foam: with clumps its group must be 'all'");
  if (strstr(update->integrate_style, "respa"))
    error->all(FLERR, "Fix couple/foam: works with run_style verlet, not with respa");
  if ((saver_ || holds_) && !dynamic_cast<VerletCoupled *>(update->integrate))
    error->all(FLERR, "Fix couple/foam: run_style must stand above it in the script where states are saved");
  if (bodies_)
    bodies_->couple(
        [this] {
          if (pending_) take_answer();
        },
        [this] { show(update->ntimestep); });
  if (clumps_ && !bodies_)
    error->all(FLERR, "Fix couple/foam: clumpDrag resistance: there are no clumps; 'fix multisphere/clump' makes them");
  if (clumps_)
    for (const std::string &odd : clumps_->init(bodies_)) report_->warn(odd);
  const FixBrownian *thermal = dynamic_cast<FixBrownian *>(modify->find_fix_style("brownian", 0));
  random_.reset(thermal ? new Thermal(thermal) : NULL);

  moving_ = moving_groups(lmp);
  mute_ = clay::frozen_above(script_fixes(lmp), modify->find_fix(id));
  gravity_.find();
  readers_ = ValueReaders::of(lmp, id);
  comm_forward = comm_reverse = (readers_.any ? Row::FORCE : Row::FRACTION) - Row::DRAG;

  refuse([&] { clay::check_holders(script_fixes(lmp)); });
  refuse([&] { clay::check_order(script_fixes(lmp), modify->find_fix(id)); });
  refuse([&] { clay::check_others(script_fixes(lmp)); });
}

/* ----------------------------------------------------------------------
   what a check throws ends the run
------------------------------------------------------------------------- */

void FixCoupleFoam::refuse(const std::function<void()> &check)
{
  try {
    check();
  } catch (const std::invalid_argument &e) {
    error->all(FLERR, (std::string("Fix couple/foam: ") + e.what()).c_str());
  }
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::check_contacts()
{
  std::string which;
  const double limit = resting_step_limit(lmp, &which);
  refuse([&] { clay::check_contact_limit(update->dt, limit, which); });
  const double rayleigh = rayleigh_step(lmp, &which);
  const std::string near = clay::check_rayleigh(update->dt, rayleigh, which);
  if (!near.empty()) report_->warn(near);
  const ChargedContact worst = charged_contact(lmp);
  std::string odd;
  refuse([&] { odd = clay::check_charges(worst); });
  if (!odd.empty()) report_->warn(odd);
}

void FixCoupleFoam::watch_contact_limit()
{
  if (warned_) return;
  int contacts = 0;
  const double limit = present_step_limit(lmp, &contacts);
  if (update->dt <= limit) return;
  warned_ = true;
  report_->warn(clay::contact_limit_warning(update->dt, limit, contacts, update->ntimestep));
}

/* ---------------------------------------------------------------------- */

clay::DemTerms FixCoupleFoam::terms()
{
  clay::DemTerms t;
  t.program = universe->version;
  t.step = update->dt;
  t.interval = settings_.interval;
  t.startTime = update->get_cur_time();
  t.endTime = t.startTime + (update->laststep - update->firststep) * update->dt;

  gravity_.evaluate();
  find_gravity();
  t.hasGravity = gravity_.any();
  t.gravity = usual_;

  for (int k = 0; k < 3; k++) {
    t.box.lo[k] = domain->boxlo[k];
    t.box.hi[k] = domain->boxhi[k];
    t.periodic[k] = domain->periodicity[k];
  }

  double radius = 0., all;
  bigint n = 0, nall;
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & groupbit) {
      radius = std::max(radius, atom->radius[i]);
      n++;
    }
  MPI_Allreduce(&radius, &all, 1, MPI_DOUBLE, MPI_MAX, world);
  MPI_Allreduce(&n, &nall, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  t.maxRadius = all;
  t.particles = nall;

  t.offers = {Field::position, Field::radius, Field::volume, Field::velocity,     Field::tag,        Field::body,
              Field::impulse,  Field::mass,   Field::spin,   Field::meanVelocity, Field::otherForce, Field::touched};
  if (clumps_) t.brings = {Field::dragDiameter, Field::dragFactor};
  if (gravity_.differs(igroup)) t.brings.add(Field::gravity);
  if (bodies_) {
    t.clumpDrag = clay::name(settings_.clumpDrag);
    t.bodyDiameter = bodies_->mean_diameter();
  }
  t.needs = {Field::dragCoefficient, Field::fluidVelocity};
  if (readers_.any) t.needs.add(Field::voidFraction);
  if (saver_) t.pairs = saver_->folder();
  t.pair = start_pair_;
  return t;
}

/* ---------------------------------------------------------------------- */

double FixCoupleFoam::fluid_viscosity() const { return session_ ? session_->remoteTerms().fluidViscosity : 0.; }

/* ----------------------------------------------------------------------
   handshake, at the first run; a further run goes on from there
------------------------------------------------------------------------- */

void FixCoupleFoam::open()
{
  dt_ = update->dt;
  refuse([&] { clay::check_interval(update->laststep - update->firststep, settings_.interval); });
  if (settings_.contactLimit) check_contacts();
  try {
    const clay::DemTerms mine = terms();
    if (session_) session_->resume(mine);
    else {
      session_.reset(new clay::DemSession(mine));
      for (const std::string &odd : clay::warnings(mine, session_->remoteTerms())) report_->warn(odd);
    }
  } catch (clay::Refusal &refusal) {
    error->all(FLERR, refusal.what());
  }
  sent_ = clay::Particles(session_->sends());
  answer_ = clay::Particles(session_->receives());
  if (clumps_) clumps_->fluid(session_->remoteTerms().fluidViscosity, session_->remoteTerms().fluidDensity);

  const clay::FieldSet &gets = session_->receives();
  if (gets.has(Field::addedMass)) refuse([&] { clay::check_last(script_fixes(lmp), modify->find_fix(id)); });
  if (gets.has(Field::addedMass) || gets.has(Field::turnCoefficient)) make_more();
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::setup_pre_force(int)
{
  idle_ = update->laststep == update->firststep;
  opened_ = update->laststep;
  if (idle_) return;
  if (saving_) {
    save();
    return;
  }
  report_->start();
  just_created = 0;  // else Modify::setup() calls set_arrays() and the first answer is lost
  if (watch_) watch_->start();
  open();
  start_pair_ = 0.;
  if (saver_) saver_->start();
  send(false);
  take_answer();
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::setup(int)
{
  listed_ = -1;
  if (idle_) return;
  apply(true);
  show(update->ntimestep);
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::post_integrate()
{
  if (update->laststep != opened_)
    error->all(
        FLERR,
        "Fix couple/foam: 'run ... pre no' starts without its set-up, which the coupling needs; leave out 'pre no'");
  if (!pending_) return;
  // a fix that stands above may insert or delete particles in pre_exchange
  for (int i = 0; i < modify->nfix; i++)
    if (modify->fix[i]->force_reneighbor && modify->fix[i]->next_reneighbor == update->ntimestep) {
      take_answer();
      return;
    }
}

/* ----------------------------------------------------------------------
   particles are about to change places: the answer must be in before
------------------------------------------------------------------------- */

void FixCoupleFoam::pre_exchange()
{
  listed_ = -1;
  if (watch_) watch_->places([this](int i) { return fluid_[i][Row::DRAG] <= 0.; });
  report_->places();
  if (pending_) take_answer();
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::post_force(int)
{
  if (idle_) return;
  if (pending_) look_for_answer();
  apply(false);
  if (!bodies_) show(update->ntimestep);
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::end_of_step()
{
  if (idle_) return;
  if (watch_) watch_->step();
  if ((update->ntimestep - update->firststep) % settings_.interval) return;
  refuse([&] { clay::check_step(dt_, update->dt); });
  stop_ = update->ntimestep < update->laststep ? agreed_stop() : 0;
  if (stop_ && !saver_) stop(stop_);
  if (settings_.contactLimit && ++exchanges_ % 50 == 0) watch_contact_limit();
  save_due_ = saver_ && (saver_->due() || stop_);
  if (!save_due_) send(update->ntimestep == update->laststep);
}

/* ----------------------------------------------------------------------
   the signal that one of the ranks was sent, the same on all; below 0 one
   that the CFD half was sent; 0: none
------------------------------------------------------------------------- */

int FixCoupleFoam::agreed_stop() const
{
  int mine[2] = {clay::noted_stop(), session_->asked()}, any[2] = {mine[0], mine[1]};
  if (comm->nprocs > 1) MPI_Allreduce(mine, any, 2, MPI_INT, MPI_MAX, world);
  return any[0] ? any[0] : -any[1];
}

/* ----------------------------------------------------------------------
   a run that ends too early ends both halves, with an error: what it has so
   far is told, but it is not finished. signal 0: LIGGGHTS left its loop
------------------------------------------------------------------------- */

void FixCoupleFoam::stop(int signal)
{
  if (pending_) take_answer();
  if (saver_) tell_saved();  // where no particles were answered it may have come late
  report_->finish(*session_, settings_.interval, watch_ ? watch_->wall_overlap() : 0.);
  const double left = (update->laststep - update->ntimestep) * update->dt, now = update->get_cur_time();
  clay::abandon(clay::stop_reason(signal, now, now + left));
}

/* ---------------------------------------------------------------------- */

void FixCoupleFoam::post_run()
{
  if (idle_) return;
  if (update->ntimestep < update->laststep) stop(agreed_stop());
  if (pending_) take_answer();
  report_->finish(*session_, settings_.interval, watch_ ? watch_->wall_overlap() : 0.);
}
