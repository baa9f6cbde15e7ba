// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file body_spheres.h
/// The spheres of rigid bodies, body by body and close together in memory.
#ifndef LMP_BODY_SPHERES_H
#define LMP_BODY_SPHERES_H

#include <vector>

namespace LAMMPS_NS {

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
  const double *body_place(int n) const { return &d_[3 * n]; }  ///< [m], body axes
  const double *space_place(int n) const { return &r_[3 * n]; } ///< [m], space axes
  bool shifted(int b) const { return shifted_[b]; }             ///< any sphere of the body

  /// Turns the places of a body into space axes, where its axes are ex, ey, ez.
  void turn(int b, const double *ex, const double *ey, const double *ez)
  {
    for (int n = first_[b]; n < first_[b + 1]; n++) {
      const double *d = &d_[3 * n];
      double *r = &r_[3 * n];
      for (int k = 0; k < 3; k++) r[k] = ex[k] * d[0] + ey[k] * d[1] + ez[k] * d[2];
    }
  }

  /// Adds force and torque on a body's spheres up to those of the body; f and
  /// torque, like x, v and omega below, hold three numbers for each atom.
  void gather(int b, const double *f, const double *torque, double *force, double *couple) const
  {
    double F[3] = {force[0], force[1], force[2]}, T[3] = {couple[0], couple[1], couple[2]};
    for (int n = first_[b]; n < counted_[b]; n++) {
      const double *r = &r_[3 * n], *p = f + 3 * atom_[n], *t = torque + 3 * atom_[n];
      for (int k = 0; k < 3; k++) F[k] += p[k];
      T[0] += r[1] * p[2] - r[2] * p[1] + t[0];
      T[1] += r[2] * p[0] - r[0] * p[2] + t[1];
      T[2] += r[0] * p[1] - r[1] * p[0] + t[2];
    }
    for (int k = 0; k < 3; k++) force[k] = F[k], couple[k] = T[k];
  }

  /// Gives a body's spheres their velocity and spin.
  void set_velocity(int b, const double *v_, const double *w_, double *v, double *omega) const
  {
    const double V[3] = {v_[0], v_[1], v_[2]}, w[3] = {w_[0], w_[1], w_[2]};
    for (int n = first_[b]; n < first_[b + 1]; n++) {
      const double *r = &r_[3 * n];
      double *vi = v + 3 * atom_[n], *wi = omega + 3 * atom_[n];
      vi[0] = w[1] * r[2] - w[2] * r[1] + V[0];
      vi[1] = w[2] * r[0] - w[0] * r[2] + V[1];
      vi[2] = w[0] * r[1] - w[1] * r[0] + V[2];
      for (int k = 0; k < 3; k++) wi[k] = w[k];
    }
  }

  /// Turns a body's spheres and gives them place, velocity and spin, in one pass.
  void place(int b, const double *ex, const double *ey, const double *ez, const double *centre,
             const double *v_, const double *w_, double *x, double *v, double *omega)
  {
    const double c[3] = {centre[0], centre[1], centre[2]}, V[3] = {v_[0], v_[1], v_[2]};
    const double w[3] = {w_[0], w_[1], w_[2]};
    const double Q[3][3] = {
        {ex[0], ey[0], ez[0]}, {ex[1], ey[1], ez[1]}, {ex[2], ey[2], ez[2]}};
    for (int n = first_[b]; n < first_[b + 1]; n++) {
      const double *d = &d_[3 * n];
      const int i = 3 * atom_[n];
      double *xi = x + i, *vi = v + i, *wi = omega + i, r[3];
      for (int k = 0; k < 3; k++) r[k] = Q[k][0] * d[0] + Q[k][1] * d[1] + Q[k][2] * d[2];
      for (int k = 0; k < 3; k++) r_[3 * n + k] = r[k];
      for (int k = 0; k < 3; k++) xi[k] = r[k] + c[k];
      vi[0] = w[1] * r[2] - w[2] * r[1] + V[0];
      vi[1] = w[2] * r[0] - w[0] * r[2] + V[1];
      vi[2] = w[0] * r[1] - w[1] * r[0] + V[2];
      for (int k = 0; k < 3; k++) wi[k] = w[k];
    }
  }

 private:
  struct Added {
    int body, atom;
    double d[3];
    bool counts, shifted;
  };

  std::vector<Added> added_;
  std::vector<int> first_, counted_, atom_;
  std::vector<double> d_, r_;
  std::vector<char> shifted_;
};

}  // namespace LAMMPS_NS

#endif
