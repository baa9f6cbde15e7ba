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

#include <memory>
#include <string>
#include <vector>

#include "exchange/fields.h"
#include "fix.h"
#include "clumps/fix_multisphere_clump.h"
#include "fluid/coupled_fluid.h"

namespace clay { class DemSession; struct DemTerms; }

namespace LAMMPS_NS {

class CoupledClumps;
class CouplingReport;
class RunawayWatch;

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

  double fluid_viscosity() const override;
  double drag_coefficient(int i) const override { return fluid_[i][DRAG]; }
  /// DEM steps between two exchanges.
  int interval() const { return interval_; }
  /// Particles keep still from now on, or move again (fix rest/bed).
  void rest(bool still);
  /// Before each step in which they keep still. False when the fluid's force on a
  /// particle has changed by more than this part of its weight.
  bool rest_step(double tolerance);
  /// Gives the particles the impulse of the steps they kept still, before one that is computed.
  void book_rest();

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
  // what is kept of the fluid, per sphere; FORCE, IMPULSE and RELAX of free ones only
  enum { DRAG = 0, VELOCITY = 1, LOAD = 4, FORCE = 7, IMPULSE = 10, SLOT = 13, RELAX = 14, SIZE = 15 };
  // and of free ones, if the CFD half has added mass or torque
  enum { ADDED = 0, TURN = 1, SPIN = 2, MORE = 5 };

  int whole_number(const char *);
  void parse(int, char **);
  void parse_lag(const std::string &);
  void parse_clump_drag(const std::string &, const std::string &);
  void check_interval();
  void check_order();
  void check_contact_limit();
  void check_charges();
  void watch_contact_limit();
  clay::DemTerms terms();
  void open();
  void send(bool last);
  void take_answer();
  void look_for_answer();
  void gather();
  void tell_clumps(int slot);
  void share_impulses();
  void check_finite();
  void apply(bool setupflag);
  void apply_inertia(bool setupflag);
  void apply_turn(int i);
  void check_last();
  bool moves(int i) const;
  bool free_sphere(int i) const;
  void list_free();
  void still_forces(std::vector<double> &forces) const;

  int interval_;                 // DEM steps between two exchanges
  double dt_;                    // DEM step at the start of the run [s]
  bool idle_;                    // a run of no steps
  bigint opened_;                // last step of the run that was set up
  bool pending_;                 // an answer is still to come
  int lag_, waited_;             // steps that may go on without it, and that did so
  bool prompt_;                  // the last answer came late: wait for the next one
  bool check_limit_;             // refuse a step above the contact limit
  bool warned_;                  // of the contacts there are
  long exchanges_;
  FixMultisphereClump *bodies_;  // null without clumps
  class FixBrownian *thermal_;   // null without random forces
  std::unique_ptr<CoupledClumps> clumps_;  // null when the drag is the sum over spheres
  double **fluid_;               // per-atom store
  double **more_;                // another one; null when it is not needed
  int movers_;                   // groups that some fix nve integrates
  std::vector<int> free_;        // spheres in no body
  int listed_;                   // local spheres when they were listed; -1 when out of date
  bool still_;                   // particles keep still
  bool unseen_;                  // an answer has come that rest_step() has not compared
  int still_steps_;              // for so many steps since the last exchange
  std::vector<double> still_force_;  // of the fluid when they came to rest [N]
  double given_[3];              // impulse given to this rank's particles [N s]

  std::unique_ptr<clay::DemSession> session_;
  clay::Particles sent_, answer_;
  std::vector<FixMultisphereClump::Sphere> spheres_;  // of the bodies owned here
  std::vector<double> shares_;   // impulse of each of them [N s]
  double last_time_;             // of the last exchange [s]
  std::unique_ptr<CouplingReport> report_;
  std::unique_ptr<RunawayWatch> watch_;  // null when it is switched off
};

}

#endif
#endif
