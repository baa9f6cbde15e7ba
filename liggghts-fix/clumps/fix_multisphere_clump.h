/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   fix ID group multisphere/clump: LIGGGHTS's multisphere bodies, moved by
   leaner loops, with the fluid's drag on each body applied implicitly in
   velocity and spin.
------------------------------------------------------------------------- */

#ifdef FIX_CLASS

FixStyle(multisphere/clump,FixMultisphereClump)

#else

#ifndef LMP_FIX_MULTISPHERE_CLUMP_H
#define LMP_FIX_MULTISPHERE_CLUMP_H

#include <algorithm>
#include <functional>
#include <vector>

#include "clumps/body_drag.h"
#include "clumps/body_resistance.h"
#include "clumps/body_spheres.h"
#include "clumps/script_gravity.h"
#include "fix_multisphere.h"

namespace LAMMPS_NS {

class FixMultisphereClump : public FixMultisphere {
 public:
  FixMultisphereClump(class LAMMPS *, int, char **);

  void init();
  void initial_integrate(int vflag);
  void final_integrate();
  void calc_force(bool setupflag);
  void pre_exchange();
  void pre_neighbor();

  /// All spheres of this processor's bodies, ghosts among them; valid until the
  /// next neighbour list is built.
  void spheres(std::vector<BodySphere> &list);

  /// Takes the fluid's action on a body, until it is given anew.
  void set_drag(int ibody, const BodyDrag &drag);

  /// Forces on it that do not depend on its motion [N], their part that the hydrostatic
  /// pressure has, which is left out of the impulse, and its added mass [kg].
  void set_loads(int ibody, const double *load, const double *hydro, double added);
  const double *hydrostatic(int ibody) { return stored(ibody).hydro; }

  /// All that the fluid does to a body in this step, and its drag alone [N]. With added
  /// mass what the turning of its spheres' places takes of that counts as drag.
  void fluid_force(int ibody, double *force, double *drag);

  /// From now on set_flow() is called in place of set_drag(): the resistance for
  /// unit viscosity of each clump type, about the centre of mass in body axes.
  void set_resistances(const std::vector<const Matrix6d *> &by_type) { resistances_ = by_type; }

  /// Takes what a body's spheres see of the fluid; scale [Pa s] is that of its resistance.
  void set_flow(int ibody, const BodyFlow &flow, double scale);

  /// Whether set_flow() was called for a body, and its slip u - v then or, if not, -v [m/s].
  bool knows_fluid(int ibody) { return stored(ibody).whole.scale > 0.0; }
  Eigen::Vector3d slip(int ibody);

  /// Kind of clump, axes as columns, velocity [m/s] of the centre of mass.
  int clump_type(int ibody) { return clumptype_(ibody); }
  Eigen::Matrix3d axes(int ibody);
  Eigen::Vector3d velocity(int ibody) { return Eigen::Vector3d(vcm_(ibody)); }

  /// Impulse [N s] the fluid gave to a body since the last call, without buoyancy.
  void take_impulse(int ibody, double *impulse);

  /// Adds what it gave to all of this processor's bodies since the last call, also to
  /// those that are gone since.
  void take_given(double *impulse);
  /// What the next call will add [N s].
  const double *given() const { return given_; }

  /// Adds to it what the fluid gave while the bodies kept still [N s].
  void add_impulse(int ibody, const double *impulse);

  /// Displacement [m] of a body's centre of mass and change of its velocity [m/s]
  /// since the last call; false, with zeros, when there was none for this body.
  bool take_motion(int ibody, double *displacement, double *change);

  /// Keeps the forces on bodies that there are, through a set-up or a restart file, and puts
  /// them in place of those of the set-up.
  void hold_forces();
  void take_held_forces();

  /// Switches the fluid on; without it this is plain multisphere. before() is called
  /// before spheres may change places in memory: bodies that left the box are taken out;
  /// after() when a step's forces on the bodies are known.
  void couple(
      const std::function<void()> &before = [] {}, const std::function<void()> &after = [] {});

  /// Switches it off and forgets it.
  void uncouple();

  /// Solid volume [m3] and mass [kg] of a body.
  double body_volume(int ibody) { return multisphere_.volume(ibody); }
  double body_mass(int ibody) { return multisphere_.mass(ibody); }

  /// Diameter of a sphere of a body's volume, mean of the bodies by volume; that of the
  /// templates before there are any, 0 without these [m]. Collective.
  double mean_diameter();

 private:
  // what is kept of the fluid, per body: it moves with the body
  struct Fluid {
    union {
      DragStep drag;
      ResistanceStep whole;  // with resistances_
    };
    double load[3];             // force that does not depend on the motion [N]
    double hydro[3];            // its part that the hydrostatic pressure has [N]
    double added;               // added mass [kg]
    double force[3];            // of the last step, without the hydrostatic part [N]
    double impulse[3];          // since the last exchange [N s]
    double place[3], speed[3];  // of the centre of mass at the last exchange [m, m/s]
    double seen;                // above 0 when it was there
    double held[9];             // force and torque on the body, `force`, ahead of a set-up
    double owner;               // whose it is
  };
  enum { SIZE = sizeof(Fluid) / sizeof(double) };
  // LIGGGHTS makes room for a new body without a word on what is in it
  class Store : public VectorContainer<double, SIZE> {
   public:
    using VectorContainer<double, SIZE>::VectorContainer;
    void addUninitialized(int n)
    {
      VectorContainer<double, SIZE>::addUninitialized(n);
      for (int b = this->size() - n; b < this->size(); b++) std::fill_n((*this)(b), int(SIZE), 0.);
    }
  };
  typedef VectorContainer<double, 3> Vectors;

  bool stock_features();
  bool images() const;
  void sort_spheres();
  void place(int ibody);
  void sum_forces(int ibody, const clay::GroupGravity &gravity, bool setupflag);
  Matrix6d mobility(int ibody);
  void apply_drag(int ibody, bool setupflag);
  void half_kick(int begin, int end);
  void turn(int begin, int end);
  Fluid &stored(int ibody);
  Vectors &vectors(const char *name);

  // of the bodies, kept by LIGGGHTS
  Vectors &xcm_, &vcm_, &fcm_, &torque_, &dragforce_, &hdtorque_;
  Vectors &angmom_, &omega_, &inertia_, &ex_, &ey_, &ez_;
  VectorContainer<double, 4> &quat_;
  VectorContainer<bool, 3> &fflag_, &tflag_;
  ScalarContainer<int> &clumptype_;

  Store *store_;
  std::vector<const Matrix6d *> resistances_;  // by clump type; none for the sum over spheres
  bool coupled_;
  double given_[3];  // since take_given() [N s]
  ScriptGravity gravity_;
  std::function<void()> before_, after_;
  BodySpheres spheres_;
  bool unsorted_;  // spheres have changed places in memory
  bool unturned_;  // bodies have turned without spheres_
  int natoms_;     // local and ghost ones when sorted
};

}

#endif
#endif
