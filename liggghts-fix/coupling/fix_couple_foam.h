/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   fix ID group couple/foam every N ...: couples this run to a CFD half in
   the same mpirun. Described in doc/fix_couple_foam.md.
------------------------------------------------------------------------- */

#ifdef FIX_CLASS

FixStyle(couple/foam,FixCoupleFoam)

#else

#ifndef LMP_FIX_COUPLE_FOAM_H
#define LMP_FIX_COUPLE_FOAM_H

#include <functional>
#include <memory>
#include <vector>

#include "coupling/couple_settings.h"
#include "coupling/fluid_output.h"
#include "coupling/particle_packer.h"
#include "coupling/script_checks.h"
#include "coupling/sphere_forces.h"
#include "coupling/value_readers.h"
#include "exchange/fields.h"
#include "exchange/session.h"
#include "fix.h"
#include "clumps/script_gravity.h"
#include "fluid/coupled_fluid.h"

namespace LAMMPS_NS {

class CoupledClumps;
class CouplingReport;
class FixMultisphereClump;
class RunawayWatch;
class StateSaver;

class FixCoupleFoam : public Fix, public CoupledFluid {
 public:
  FixCoupleFoam(class LAMMPS *, int, char **);
  ~FixCoupleFoam();
  int setmask();
  void post_create();
  void init();
  void setup_pre_force(int);
  void setup(int);
  void pre_exchange();
  void post_force(int);
  void end_of_step();
  void post_run();
  void post_integrate();
  void write_restart(FILE *);
  void restart(char *);
  int size_restart(int);
  int maxsize_restart();
  int pack_restart(int, double *);
  void unpack_restart(int, int);

  double fluid_viscosity() const override;
  double drag_coefficient(int i) const override { return fluid_[i][clay::FluidRow::DRAG]; }
  void vertical_forces(std::vector<double> &bodies, std::vector<double> &atoms) override;
  /// DEM steps between two exchanges.
  int interval() const { return settings_.interval; }
  /// Particles keep still from now on, or move again (fix rest/bed).
  void rest(bool still);
  /// Before each step in which they keep still. False when the fluid's force on a
  /// particle has changed by more than this part of its weight.
  bool rest_step(double tolerance);
  /// Gives the particles the impulse of the steps they kept still, before one that is computed.
  void book_rest();

  double compute_vector(int);

  /// States of this half are saved within a run.
  bool saves() const { return saver_ != nullptr; }
  /// Step of the next exchange.
  bigint next_exchange() const;
  /// The state is to be saved now, ahead of this step's exchange.
  bool save_due() const { return save_due_; }
  /// Holds the forces there are from here on, until take_held_forces().
  void begins_saving();
  /// Saves it at the end of a run.
  void save_last();
  void ends_saving();
  /// Puts them, or those of a saved state, in place of the forces of a set-up.
  void take_held_forces();
  /// Goes on with the random numbers of insertion where a saved state was; after a run's first set-up, in which
  /// LIGGGHTS's fixes begin theirs anew.
  void go_on_inserting();

  double memory_usage();
  void grow_arrays(int);
  void copy_arrays(int, int, int);
  void set_arrays(int);
  int pack_exchange(int, double *);
  int unpack_exchange(int, double *);
  int pack_comm(int, int *, double *, int, int *);
  void unpack_comm(int, int, double *);
  int pack_reverse_comm(int, int, double *);
  void unpack_reverse_comm(int, int *, double *);

 private:
  typedef clay::FluidRow Row;
  typedef clay::InertiaRow More;
  enum { KEPT = 9 };  // of kept_: force, torque, the fluid's force in the row

  void refuse(const std::function<void()> &check);
  void check_contacts();
  void watch_contact_limit();
  clay::DemTerms terms();
  void open();
  void send(bool last, const clay::SavedPair &pair = clay::SavedPair());
  int agreed_stop() const;
  void stop(int signal);
  void pack_clumps(int first);
  void hold_forces();
  void make_more();
  void make_kept();
  void save();
  void tell_saved();
  bool is_sound() const;
  void tell_motions();
  void check_finite();
  void take_answer();
  void look_for_answer();
  void take_body_answers();
  void apply(bool first);
  void list_free();
  bool output_due(bigint step) const;
  void show(bigint step);
  void show_clumps();
  clay::StepState last_step() const;
  std::vector<clay::FluidAction> body_actions(const std::vector<BodySphere> &spheres);
  double total(int component);
  void find_gravity();
  void follow_gravity(bool first);
  clay::Hydrostatics hydrostatics() const;
  clay::SphereArrays spheres() const;
  std::vector<clay::StillSphere> still_spheres() const;

  const clay::CoupleSettings settings_;
  double dt_;      // DEM step at the start of the run [s]
  bool idle_;      // a run of no steps
  bigint opened_;  // last step of the run that was set up
  bool pending_;   // an answer is still to come
  int waited_;     // steps that went on without it
  bool prompt_;    // the last answer came late: wait for the next one
  bool warned_;    // of the contacts there are
  long exchanges_;
  FixMultisphereClump *bodies_;                // null without clumps
  std::unique_ptr<clay::RandomForce> random_;  // null without random forces
  std::unique_ptr<CoupledClumps> clumps_;      // null when the drag is the sum over spheres
  double **fluid_;                             // per-atom store, rows of FluidRow
  double **more_;                              // another one, of InertiaRow; null when it is not needed
  double **kept_;                              // another one: forces ahead of a set-up; null when not needed
  clay::MovingGroups moving_;                  // which spheres follow the forces on them
  clay::AxisGroups mute_;                      // groups that a fix above took the forces from
  ScriptGravity gravity_;
  clay::GroupGravity pull_;                  // gravity at the last exchange
  clay::GroupGravity mean_pull_;             // its sum over the interval, where it changes [m/s]
  clay::GroupGravity last_pull_;             // in the last step
  std::array<double, 3> usual_;              // of that on all particles [m/s2]
  std::vector<int> free_, yielding_, held_;  // spheres in no body: all, those that move, the others
  int listed_;                               // local spheres when they were listed; -1 when out of date
  bool still_;                               // particles keep still
  bool unseen_;                              // an answer has come that rest_step() has not compared
  int still_steps_;                          // for so many steps since the last exchange
  clay::StillForces still_forces_;           // of the fluid when they came to rest
  double given_[3];                          // impulse given on this rank, to particles that are gone, too [N s]
  ValueReaders readers_;                     // of what array_atom and array_local show
  bool showing_;                             // rows of array_atom are on their way between processors

  std::unique_ptr<clay::DemSession> session_;
  clay::Particles sent_, answer_;
  std::vector<BodySphere> spheres_;    // of the bodies owned here
  double last_time_;                   // of the last exchange [s]
  std::vector<double> streams_;        // of a saved state, to be gone on with
  double start_pair_;                  // number of the saved pair that this half starts from, 0 for none
  bool save_due_, saving_;             // at this exchange; the set-up is that of a state being saved
  bool holds_;                         // kept_ is to be taken
  int stop_;                           // after which the run ends when the state is saved, as agreed_stop() has it
  std::unique_ptr<StateSaver> saver_;  // null when no states are saved
  std::unique_ptr<CouplingReport> report_;
  std::unique_ptr<RunawayWatch> watch_;  // null when it is switched off
};

}

#endif
#endif
