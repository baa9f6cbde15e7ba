// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file lubrication_step.h
/// Mean forces of many films over a time step, bounded whatever the step.
#ifndef LMP_LUBRICATION_STEP_H
#define LMP_LUBRICATION_STEP_H

#include "films/lubrication_law.h"

namespace clay {

/// What the films on a sphere sum up to, as rates: of its motion and of its spin [1/s].
struct FilmLoad {
  double slide = 0, spin = 0;
};

/// Motion of a sphere, or of a wall with loads and accelerations zero.
struct FilmSide {
  const double *v, *w;  ///< velocity [m/s] and spin [1/s]
  const double *a, *b;  ///< accelerations of both by all other forces
  FilmLoad load;        ///< of all films on it
};

/// Force on i and couples on i and j, mean over a step.
struct FilmForce {
  double force[3], coupleI[3], coupleJ[3];
};

/// Adds a film to the load of sphere i or j of mass m [kg] and moment of inertia I [kg m2].
void add_load(const Film &film, double arm, double m, double I, FilmLoad &load);

/// Force of a film over dt [s]; n is the unit vector from j to i.
///
/// Each of the three motions of a film, of velocity w and resistance c, relaxes exactly,
/// with the acceleration of the other forces held: f = -c (phi w + dt wdot (1 - phi)/x), phi =
/// (1 - exp(-x))/x. x is c dt over the mass that the film moves, and here a sphere's mass is
/// shared out among its films as they resist: so dt (load_i + load_j) stands for x. A film
/// alone is solved exactly; the shares of a sphere add up to its mass, and so all films
/// together take no more than the energy there is, for any step and number of them:
/// sum c phi dt w2 <= sum of m_ij wij2 over the films, m_ij the reduced mass of two shares,
/// and that is at most sum m v2.
FilmForce film_force(const Film &film, const double *n, const FilmSide &i, const FilmSide &j, double dt);

}  // namespace clay

#endif
