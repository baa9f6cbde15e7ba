// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file contact_limit.h
/// The largest time step with which a body in several contacts stays stable.
///
/// LIGGGHTS's step is x' = x + dt v', v' = v + dt f/m with the damping taken at
/// the old half-step velocity. For one spring k and dashpot c it is stable while
/// k dt2/(4 m) + c dt/(2 m) < 1; for a body in many contacts while the largest
/// eigenvalue of M^-1 (dt2 K/4 + dt C/2) is below 1, K and C being the 6 x 6
/// stiffness and damping of all its contacts.
#pragma once

#include <Eigen/Dense>
#include <functional>
#include <vector>

namespace clay {

/// Spring and dashpot of one contact.
struct ContactCoefficients {
  double kn = 0, kt = 0;  ///< normal and tangential stiffness [N/m]
  double cn = 0, ct = 0;  ///< normal and tangential damping [kg/s]
};

/// A contact of a body.
struct BodyContact {
  Eigen::Vector3d arm;     ///< from the centre of mass to the contact [m]
  Eigen::Vector3d normal;  ///< unit vector
  ContactCoefficients coefficients;
  bool fixed = true;  ///< with a wall; else with another body that moves as well
};

/// Step [s] at which the body, with all these contacts closed and sticking,
/// becomes unstable. inertia [kg m2] is about the centre of mass. A contact
/// with another body counts twice, as both can move against each other.
double stableStep(double mass, const Eigen::Matrix3d& inertia, const std::vector<BodyContact>& contacts);

/// The 6 x 6 stiffness and damping of a body's contacts, about its centre of
/// mass: they add up contact by contact, on whichever processor that is known.
struct ContactMatrices {
  Eigen::Matrix<double, 6, 6> K = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 6> C = Eigen::Matrix<double, 6, 6>::Zero();
  void add(const BodyContact& contact);
  /// Step [s] at which the body becomes unstable.
  double step(double mass, const Eigen::Matrix3d& inertia) const;
};

/// A bound of the same, never above it, from sums that cost next to nothing:
/// every contact as if at its worst direction.
struct ContactBound {
  double k = 0, c = 0;  // sums per mass [1/s2], [1/s]
  int contacts = 0;
  /// leastInertia [kg m2] is the body's smallest principal moment, arm2 the square
  /// of the distance from its centre of mass to the contact [m2].
  void add(double mass, double leastInertia, double arm2, const ContactCoefficients& of, bool fixed);
  /// Step [s]; infinite without contacts.
  double step() const;
};

/// k dt2/4 + c dt/2 = 1 solved for dt; k [1/s2] and c [1/s] are per mass.
double oscillatorStep(double k, double c);

/// Overlap over the diameter [m] of two spheres in contact that attract each other with
/// pull(r) [N] at a distance of r [m] against a spring [N/m]: the least; infinite when the
/// spring does not hold them.
double attractedOverlap(const std::function<double(double)>& pull, double stiffness, double diameter);

/// Coefficients of LIGGGHTS's model hooke for an effective radius [m] and mass
/// [kg], effective modulus [Pa], characteristic velocity [m/s], restitution.
ContactCoefficients hookeCoefficients(double radius, double mass, double modulus, double velocity, double restitution);

/// Time [s] that a Rayleigh wave takes over a sphere in contact with a like one: in use as a
/// scale of the step for Hertz's contacts, whose stiffness grows with the overlap. `size` is
/// radius times the root of the density [m (kg/m3)^1/2], modulus the pair's effective one [Pa].
double rayleighTime(double size, double modulus, double poisson);

/// Effective modulus [Pa] of two materials from Young's moduli and Poisson's ratios.
double effectiveModulus(double youngs1, double poisson1, double youngs2, double poisson2);

/// Contacts of a clump (spheres about its centre of mass) that lies on a floor
/// with a wall at its side and as many contacts from above as from below: what
/// a plate at the foot of a column meets. The directions are those in which
/// most spheres touch.
std::vector<BodyContact> restingContacts(const std::vector<Eigen::Vector3d>& centres, const std::vector<double>& radii,
                                         const ContactCoefficients& withWall, const ContactCoefficients& withBody);

}  // namespace clay
