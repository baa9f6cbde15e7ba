// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file body_spheres.h
/// The spheres of rigid bodies, body by body and close together in memory.
#ifndef LMP_BODY_SPHERES_H
#define LMP_BODY_SPHERES_H

#include <vector>

namespace LAMMPS_NS {

/// A sphere of a body that this processor owns.
struct BodySphere {
  int atom;         ///< local or ghost index
  int body;         ///< local index of the body
  const double *r;  ///< from the body's centre of mass, body axes [m]
  double fraction;  ///< share of the body's volume it stands for
};

/// Spheres sorted by body. Those of body b are begin(b) up to end(b); of each real
/// sphere the first one counts, up to counted(b), and the others are its images.
class BodySpheres {
 public:
  /// Forgets all; spheres of nbody bodies are then added in any order.
  void clear(int nbody);

  /// Adds a sphere of body b that the program knows as `atom`, d [m] from the
  /// centre of mass in body axes, shifted by whole periods or not.
  void add(int b, int atom, const double *d, bool counts, bool shifted);

  /// Sorts what was added, keeping the order within a body.
  void sort();

  int bodies() const { return static_cast<int>(first_.size()) - 1; }
  int begin(int b) const { return first_[b]; }
  int counted(int b) const { return counted_[b]; }
  int end(int b) const { return first_[b + 1]; }

  int atom(int n) const { return atom_[n]; }
  const double *body_place(int n) const { return &d_[3 * n]; }   ///< [m], body axes
  const double *space_place(int n) const { return &r_[4 * n]; }  ///< [m], space axes
  bool shifted(int b) const { return shifted_[b]; }              ///< any sphere of the body

  /// Turns the places of a body into space axes, where its axes are ex, ey, ez.
  void turn(int b, const double *ex, const double *ey, const double *ez);

  /// Adds force and torque on a body's spheres up to those of the body; f and
  /// torque, like x, v and omega below, hold three numbers for each atom.
  void gather(int b, const double *f, const double *torque, double *force, double *couple) const;

  /// Gives a body's spheres their velocity and spin.
  void set_velocity(int b, const double *v_, const double *w_, double *v, double *omega) const;

  /// Turns a body's spheres and gives them place, velocity and spin, in one pass.
  void place(int b, const double *ex, const double *ey, const double *ez, const double *centre, const double *v_,
             const double *w_, double *x, double *v, double *omega);

 private:
  struct Added {
    int body, atom;
    double d[3];
    bool counts, shifted;
  };

  std::vector<Added> added_;
  std::vector<int> first_, counted_, atom_;
  std::vector<double> d_, r_;  // in body axes and, with a fourth number each, in space
  std::vector<char> shifted_;
};

}  // namespace LAMMPS_NS

#endif
