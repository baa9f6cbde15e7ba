// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "films/lubrication_law.h"

#include <algorithm>
#include <cmath>

namespace clay {

bool LubricationLaw::terms(double xi, double &inverse, double &log) const
{
  if (xi >= outer || (xi < 0 && !contact)) return false;
  xi = std::max(xi, inner);
  inverse = 1 / xi - (shifted ? 1 / outer : 0);
  log = !logarithm ? 0 : shifted ? std::log(outer / xi) : std::max(0.0, -std::log(xi));
  return true;
}

Film LubricationLaw::spheres(double a, double b, double h) const
{
  Film film;
  double inverse, log;
  if (!terms(2 * h / (a + b), inverse, log)) return film;
  // q: ratio of radii; with it the coefficients of Jeffrey and Onishi's X and Y
  const double q = b / a, s = 1 + q, s3 = s * s * s, p = 2 + q + 2 * q * q;
  const double stokes = 6 * M_PI * viscosity * a;
  film.squeeze = stokes * (2 * q * q / s3 * inverse + q * (1 + 7 * q + q * q) / (5 * s3) * log);
  if (!shear) return film;
  // the arms follow from Y^A and Y^B and add up to the distance of the centres,
  // what they leave of Y^C is the roll
  film.shear = stokes * 4 * q * p / (15 * s3) * log;
  film.armI = a * (4 + q) * s / (2 * p);
  film.armJ = a * q * (1 + 4 * q) * s / (2 * p);
  film.roll = stokes * a * a * q * q * q / (s * p) * log;
  return film;
}

Film LubricationLaw::wall(double a, double h, double R) const
{
  Film film;
  double inverse, log;
  if (!terms(h / a, inverse, log)) return film;
  // film h + x2/2r + y2/2a: Reynolds's equation has the pressure 6 mu V r a/(r+a)/H2
  double narrow = 1;
  if (R != 0) {
    const double r = 1 / (1 / a - 1 / R);
    narrow = 2 * std::pow(r * a, 1.5) / ((r + a) * a * a);
  }
  const double stokes = 6 * M_PI * viscosity * a;
  film.squeeze = stokes * (narrow * inverse + log / 5);
  if (!shear) return film;
  film.shear = stokes * 8.0 / 15 * log;
  film.armI = a / 4;
  film.roll = stokes * a * a / 2 * log;
  return film;
}

}  // namespace clay
