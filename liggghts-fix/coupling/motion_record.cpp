// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/motion_record.h"

#include <algorithm>
#include <cmath>

namespace clay {

using Row = FluidRow;

namespace {

// a force that differs from the weight by less than this part of the forces there
// are differs by rounding
constexpr double rounding = 1e-6;

// sums of what is compared, over the spheres of a body
struct Odd {
  double force[3] = {0., 0., 0.}, size = 0.;

  void add(const double *other, double mass, const double *gravity, double all)
  {
    for (int k = 0; k < 3; k++) force[k] += other[k] - mass * gravity[k];
    size += all;
  }
  bool touched() const
  {
    return std::max({std::fabs(force[0]), std::fabs(force[1]), std::fabs(force[2])}) > rounding * size;
  }
};

struct Slot {
  double *mean, *other, *touched;
  const double *velocity, *impulse, *gravity;
  double mass;

  Slot(Particles &message, const Interval &interval, int slot) :
    mean(message[Field::meanVelocity] + 3 * slot), other(message[Field::otherForce] + 3 * slot),
    touched(message[Field::touched] + slot), velocity(message[Field::velocity] + 3 * slot),
    impulse(message[Field::impulse] + 3 * slot),
    gravity(message.fields().has(Field::gravity) ? message[Field::gravity] + 3 * slot : interval.gravity.data()),
    mass(message[Field::mass][slot])
  {
  }

  void unknown()
  {
    for (int k = 0; k < 3; k++) {
      mean[k] = velocity[k];
      other[k] = mass * gravity[k];
    }
    *touched = 0.;
  }

  // gravity as it was in the interval: what the spheres' motion is compared with
  void recall(const Interval &interval, int groups, std::array<double, 3> &store)
  {
    if (!interval.mean) return;
    store = interval.mean->on(groups);
    gravity = store.data();
  }

  // from its displacement [m] and the change of its velocity [m/s]; the impulse lacks
  // what the hydrostatic pressure gives to its mass [m/s2]
  void known(const Interval &interval, const double *displacement, const double *change, const double *lift, Odd &odd)
  {
    double size = 0.;
    for (int k = 0; k < 3; k++) {
      mean[k] = displacement[k] / interval.time;
      other[k] = (mass * change[k] - impulse[k]) / interval.time - mass * lift[k];
      // the terms of the difference
      const double all = mass * (std::fabs(gravity[k]) + std::fabs(lift[k])) +
          (mass * (std::fabs(velocity[k]) + std::fabs(velocity[k] - change[k])) + std::fabs(impulse[k])) /
              interval.time;
      size = std::max(size, all);
    }
    odd.add(other, mass, gravity, size);
  }
};

bool wanted(const Particles &message) { return message.fields().has(Field::touched); }

}  // namespace

/* ---------------------------------------------------------------------- */

void tell_motion(const std::vector<int> &list, const SphereArrays &spheres, double *const *fluid,
                 const Interval &interval, Particles &message)
{
  if (!wanted(message)) return;
  for (int i : list) {
    double *row = fluid[i];
    const double *x = spheres.x[i];
    Slot slot(message, interval, static_cast<int>(row[Row::SLOT]));
    if (row[Row::SEEN] > 0. && interval.time > 0.) {
      double displacement[3], change[3], lift[3];
      for (int k = 0; k < 3; k++) {
        lift[k] = row[Row::HYDRO + k] / slot.mass;
        displacement[k] = x[k] - row[Row::PLACE + k];
        change[k] = slot.velocity[k] - row[Row::SPEED + k];
      }
      if (interval.nearest) interval.nearest(displacement);
      Odd odd;
      std::array<double, 3> mean;
      slot.recall(interval, interval.mean ? spheres.groups[i] : 0, mean);
      slot.known(interval, displacement, change, lift, odd);
      *slot.touched = odd.touched();
    } else slot.unknown();
    std::copy(x, x + 3, row + Row::PLACE);
    std::copy(slot.velocity, slot.velocity + 3, row + Row::SPEED);
    row[Row::SEEN] = 1.;
  }
}

/* ---------------------------------------------------------------------- */

void tell_body_motion(const std::vector<BodySphere> &list, const std::vector<BodyMotion> &bodies,
                      const Interval &interval, int first, Particles &message)
{
  if (!wanted(message)) return;
  std::vector<Odd> odd(bodies.size());
  for (std::size_t n = 0; n < list.size(); n++) {
    const BodyMotion &b = bodies[list[n].body];
    Slot slot(message, interval, first + static_cast<int>(n));
    if (b.known && interval.time > 0.) {
      double displacement[3];
      std::copy(b.displacement.begin(), b.displacement.end(), displacement);
      if (interval.nearest) interval.nearest(displacement);
      std::array<double, 3> mean;
      slot.recall(interval, b.groups, mean);
      // the turning is that of now
      for (int k = 0; k < 3; k++) displacement[k] += interval.time * (slot.velocity[k] - b.velocity[k]);
      slot.known(interval, displacement, b.change.data(), b.lift.data(), odd[list[n].body]);
    } else slot.unknown();
  }
  for (std::size_t n = 0; n < list.size(); n++) {
    const BodyMotion &b = bodies[list[n].body];
    if (b.known && interval.time > 0.)
      message[Field::touched][first + n] = b.spheres > 1 || odd[list[n].body].touched();
  }
}

}  // namespace clay
