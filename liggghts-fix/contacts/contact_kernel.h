// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file contact_kernel.h
/// Contact forces of spheres: linear springs, damping, friction with history.
#pragma once

#include <vector>

namespace clay {

/// What a contact of two atom types is made of.
struct ContactLaw {
  double kn = 0, kt = 0;          ///< stiffness, normal and tangential [N/m]
  double gamman = 0, gammat = 0;  ///< damping [kg/s], of this pair
  double friction = 0;            ///< coefficient [1]
};

/// Model hooke: for an effective radius [m] and mass [kg], a modulus Y [Pa] and a speed v [m/s]
/// kn = 16/15 sqrt(R) Y (15 m v^2/(16 sqrt(R) Y))^(1/5), and the damping that gives the
/// coefficient of restitution of that logarithm; kt = kn, gammat = gamman, no friction.
ContactLaw hookeLaw(double radius, double mass, double modulus, double speed, double restitution_log);

/// Spheres, three numbers each.
struct ContactSpheres {
  const double *x, *v, *omega;  ///< positions [m], velocities [m/s], angular velocities [1/s]
  double *f, *torque;           ///< forces [N], torques [N m]
  int owned;                    ///< only the first so many get forces
};

/// Pairs of spheres that touch or may touch soon, one array a quantity.
struct ContactPairs {
  std::vector<int> i, j;
  std::vector<double> ri, rj;                                      ///< radii [m]
  std::vector<double> kn, kt, gamman, gammat, friction, softness;  ///< as in ContactLaw; 1/kt
  std::vector<double> sx, sy, sz;                                  ///< tangential displacement of i over j [m]
  std::vector<double> touched;                                     ///< 1 for a pair that has touched, or else 0

  int size() const { return static_cast<int>(i.size()); }
  void clear();
  void add(int i, int j, double ri, double rj, const ContactLaw &law, const double *shear, bool touched);
  void resize(int n);  ///< keeps the first n
};

/// Adds the contact forces to those of the spheres. Normal force
/// kn delta - gamman vn, not below 0 if `limit`; tangential force
/// -kt s - gammat vt, or friction times the normal one where kt s is larger.
/// With `update` the displacements s grow by vt dt [s], turn with the contact
/// and give way where it slides.
void contactForces(const ContactSpheres &spheres, ContactPairs &pairs, double dt, bool update, bool limit);

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
/// owned. `history` holds three displacements for each sphere in place of sx, sy, sz; they
/// are 0 where it does not touch. Returns the number of spheres that do.
int wallForces(const ContactSpheres &spheres, ContactPairs &pairs, const WallShape &wall, double *history, double dt,
               bool update, bool limit);

/// Whether none of n points x, three numbers each, is as far as `reach` [m] from where it was.
bool stayed(const double *x, const double *was, int n, double reach);

}  // namespace clay
