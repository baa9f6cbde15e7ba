// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file contact_kernel.h
/// Contact forces of spheres: springs, linear or of Hertz, damping, friction with and
/// without history, rolling friction, cohesion.
#pragma once

#include <vector>

namespace clay {

/// How stiffness and damping go with the overlap: not at all; with its root, and damping with
/// its fourth root; both with its root.
enum class NormalForce { linear, hertz, hertzStiffness };

/// None; damping alone; a spring with history and damping.
enum class TangentialForce { none, damped, sprung };

/// None; constant directional torque (LIGGGHTS's cdt); a spring with history (epsd2).
enum class RollingTorque { none, constant, sprung };

/// The kind of law that all contacts follow.
struct ContactKind {
  NormalForce normal = NormalForce::linear;
  TangentialForce tangential = TangentialForce::sprung;
  RollingTorque rolling = RollingTorque::none;
  bool cohesion = false;  ///< in proportion to the area of contact
  bool limit = false;     ///< the normal force never pulls
  bool reduce = false;    ///< cohesion counts in friction
  bool torsion = false;   ///< rolling friction acts on spin about the normal, too

  int shears() const { return tangential == TangentialForce::sprung ? 3 : 0; }
  /// Numbers of history that a contact has: displacement, then rolling torque.
  int history() const { return shears() + (rolling == RollingTorque::sprung ? 3 : 0); }
};

/// What a contact of two atom types is made of. Of Hertz's kinds, stiffness and damping are
/// those at an overlap of 1 m.
struct ContactLaw {
  double kn = 0, kt = 0;          ///< stiffness, normal and tangential [N/m]
  double gamman = 0, gammat = 0;  ///< damping [kg/s], of this pair
  double friction = 0;            ///< coefficient [1]
  double rolling = 0;             ///< coefficient of rolling friction [1]
  double radius = 0;              ///< effective radius, of rolling friction [m]
  double cohesion = 0;            ///< energy density [J/m3]

  bool operator==(const ContactLaw &) const;
};

/// Model hooke: for an effective radius [m] and mass [kg], a modulus Y [Pa] and a speed v [m/s]
/// kn = 16/15 sqrt(R) Y (15 m v^2/(16 sqrt(R) Y))^(1/5), and the damping that gives the
/// coefficient of restitution of that logarithm; kt = kn, gammat = gamman, no friction.
ContactLaw hookeLaw(double radius, double mass, double modulus, double speed, double restitution_log);

/// Model hertz: for an effective radius R [m] and mass m [kg], moduli Y and G [Pa] and LIGGGHTS's
/// betaeff b < 0, at the overlap d: kn = 4/3 Y sqrt(R d), kt = 8 G sqrt(R d),
/// damping -2 sqrt(5/6) b sqrt(k m) with k = 2 Y sqrt(R d), tangential with k = kt.
ContactLaw hertzLaw(double radius, double mass, double modulus, double shear_modulus, double beta);

/// So many pairs are computed together.
constexpr int CONTACT_BLOCK = 64;

/// Spheres, three numbers each.
struct ContactSpheres {
  const double *x, *v, *omega;  ///< positions [m], velocities [m/s], angular velocities [1/s]
  double *f, *torque;           ///< forces [N], torques [N m]
  int owned;                    ///< only the first so many get forces
};

/// Pairs of spheres that touch or may touch soon, one array a quantity. While all have the
/// same radii and law, the arrays of these hold one block's numbers, for any pairs.
struct ContactPairs {
  std::vector<int> i, j;
  std::vector<double> ri, rj;                                      ///< radii [m]
  std::vector<double> kn, kt, gamman, gammat, friction, softness;  ///< as in ContactLaw; 1/kt
  std::vector<double> reach, rolling, cohesion;                    ///< ContactLaw's radius, rolling, cohesion
  std::vector<double> sx, sy, sz;                                  ///< tangential displacement of i over j [m]
  std::vector<double> qx, qy, qz;                                  ///< rolling torque of the spring [N m]
  std::vector<double> touched;                                     ///< 1 for a pair that has touched, or else 0

  ContactKind kind;  ///< of all; to be set while there are no pairs

  int size() const { return static_cast<int>(i.size()); }
  bool alike() const { return alike_; }
  void clear();
  /// history: kind.history() numbers
  void add(int i, int j, double ri, double rj, const ContactLaw &law, const double *history, bool touched);
  /// The history of pair k, kind.history() numbers.
  void tell(int k, double *history) const;

 private:
  void putLaw(double ri, double rj, const ContactLaw &law, int times);

  bool alike_ = true;
  double first_[2] = {0, 0};  // radii and law of the first pair
  ContactLaw law_;
};

/// Adds the contact forces to those of the spheres. Normal force
/// kn delta - gamman vn, not below 0 with kind.limit; tangential force
/// -kt s - gammat vt, or friction times the normal one where kt s is larger; without history
/// -gammat vt, or friction times the normal one where that is less.
/// With `update` the displacements s grow by vt dt [s], turn with the contact
/// and give way where it slides.
void contactForces(const ContactSpheres &spheres, ContactPairs &pairs, double dt, bool update);

/// A plane across an axis (0 to 2), or a cylinder about it.
struct WallShape {
  int axis = 0;
  bool cylinder = false;
  double at = 0;              ///< the plane's place, the cylinder's radius [m]
  double centre[2] = {0, 0};  ///< of the cylinder, on the two axes that follow [m]

  /// Distance of a point from the wall [m].
  double gap(const double *x) const;
};

/// The same for spheres i of the pairs at a wall at rest, which stands for j; all of them are
/// owned. `history` holds kind.history() numbers for each sphere in place of the pairs' own; they
/// are 0 where it does not touch. Returns the number of spheres that do.
int wallForces(const ContactSpheres &spheres, ContactPairs &pairs, const WallShape &wall, double *history, double dt,
               bool update);

/// Whether none of n points x, three numbers each, is as far as `reach` [m] from where it was.
bool stayed(const double *x, const double *was, int n, double reach);

}  // namespace clay
