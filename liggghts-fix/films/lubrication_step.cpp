// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "films/lubrication_step.h"

#include <algorithm>
#include <cmath>

namespace clay {

namespace {

void cross(const double *a, const double *b, double *c)
{
  c[0] = a[1] * b[2] - a[2] * b[1];
  c[1] = a[2] * b[0] - a[0] * b[2];
  c[2] = a[0] * b[1] - a[1] * b[0];
}

// phi = (1 - exp(-x))/x and (1 - phi)/x
void relaxation(double x, double &phi, double &rest)
{
  if (x < 1e-3) {
    phi = 1 - x / 2 + x * x / 6;
    rest = 0.5 - x / 6 + x * x / 24;
  } else {
    phi = -std::expm1(-x) / x;
    rest = (1 - phi) / x;
  }
}

}  // namespace

void add_load(const Film &film, double arm, double m, double I, FilmLoad &load)
{
  load.slide += std::max(film.squeeze, film.shear) / m;
  load.spin += (film.shear * arm * arm + film.roll) / I;
}

FilmForce film_force(const Film &film, const double *n, const FilmSide &i, const FilmSide &j, double dt)
{
  FilmForce out = {};
  const double slide = dt * (i.load.slide + j.load.slide), spin = dt * (i.load.spin + j.load.spin);
  const double most = std::max(film.squeeze, film.shear);

  double u[3], a[3], un = 0, an = 0;
  for (int k = 0; k < 3; k++) {
    u[k] = i.v[k] - j.v[k];
    a[k] = i.a[k] - j.a[k];
    un += u[k] * n[k];
    an += a[k] * n[k];
  }
  double phi, rest;
  if (film.squeeze > 0) {
    relaxation(slide * film.squeeze / most, phi, rest);
    const double f = -film.squeeze * (phi * un + dt * an * rest);
    for (int k = 0; k < 3; k++) out.force[k] = f * n[k];
  }
  if (film.shear > 0) {
    // velocity and acceleration across n, where the arms end
    double wi[3], wj[3], bi[3], bj[3], f[3], couple[3];
    cross(i.w, n, wi);
    cross(j.w, n, wj);
    cross(i.b, n, bi);
    cross(j.b, n, bj);
    relaxation(slide * film.shear / most + spin, phi, rest);
    for (int k = 0; k < 3; k++) {
      const double ut = u[k] - un * n[k] - film.armI * wi[k] - film.armJ * wj[k];
      const double at = a[k] - an * n[k] - film.armI * bi[k] - film.armJ * bj[k];
      f[k] = -film.shear * (phi * ut + dt * at * rest);
      out.force[k] += f[k];
    }
    cross(n, f, couple);
    for (int k = 0; k < 3; k++) {
      out.coupleI[k] -= film.armI * couple[k];
      out.coupleJ[k] -= film.armJ * couple[k];
    }
  }
  if (film.roll > 0) {
    relaxation(spin, phi, rest);
    double w[3], b[3], wn = 0, bn = 0;
    for (int k = 0; k < 3; k++) {
      w[k] = i.w[k] - j.w[k];
      b[k] = i.b[k] - j.b[k];
      wn += w[k] * n[k];
      bn += b[k] * n[k];
    }
    for (int k = 0; k < 3; k++) {
      const double T = -film.roll * (phi * (w[k] - wn * n[k]) + dt * rest * (b[k] - bn * n[k]));
      out.coupleI[k] += T;
      out.coupleJ[k] -= T;
    }
  }
  return out;
}

}  // namespace clay
