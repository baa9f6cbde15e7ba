// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/motion_record.h"

#include <gtest/gtest.h>

#include <cmath>

#include "clumps/body_drag.h"
#include "coupling/particle_packer.h"
#include "sphere_store.h"

using namespace clay;
using Row = FluidRow;

namespace {

const FieldSet told = {Field::velocity,     Field::impulse,    Field::mass,
                       Field::meanVelocity, Field::otherForce, Field::touched};
const FieldSet packed = {Field::position, Field::radius,       Field::volume,     Field::velocity,
                         Field::tag,      Field::body,         Field::impulse,    Field::mass,
                         Field::spin,     Field::meanVelocity, Field::otherForce, Field::touched};
const double g = 9.81, T = 2e-3, K = 2e-7, u = 0.3, mass = 1e-9, load = 2e-9;

Interval interval()
{
  Interval i;
  i.time = T;
  i.gravity = {0., 0., -g};
  return i;
}

// one sphere, told of where it is, with what it has got from the fluid [N s]
struct Told {
  SphereStore s{1};
  Particles message{told};

  Told()
  {
    s.mass[0] = mass;
    s.fluid[0][Row::SLOT] = 0;
    message.resize(1);
  }
  void tell(const Interval &interval, double impulse = 0.)
  {
    for (int k = 0; k < 3; k++) {
      message[Field::velocity][k] = s.v[0][k];
      message[Field::impulse][k] = k == 2 ? impulse : 0.;
    }
    message[Field::mass][0] = mass;
    tell_motion({0}, s.arrays(), s.fluid.rows(), interval, message);
  }
  double mean(int k) { return message[Field::meanVelocity][k]; }
  double other(int k) { return message[Field::otherForce][k]; }
  double touched() { return message[Field::touched][0]; }
};

}  // namespace

// as the DEM half steps it: fluid's force and weight, by leaps of half a step
TEST(TellMotion, underGravityAndDragAloneItIsFree)
{
  for (int steps : {1, 7, 1000})
    for (double stiff : {1e-4, 1., 1e4}) {
      SphereStore s(1);
      Particles message(packed);
      message.resize(1);
      const double dt = T / steps, k = stiff * mass / T;
      double given[3] = {0., 0., 0.};
      s.mass[0] = mass;
      s.fluid[0][Row::DRAG] = k;
      s.fluid[0][Row::VELOCITY] = u;
      s.fluid[0][Row::VELOCITY + 2] = -u;
      s.fluid[0][Row::LOAD + 2] = load;
      s.fluid[0][Row::HYDRO + 2] = 0.75 * load;
      s.fluid[0][Row::RELAX] = LAMMPS_NS::relaxation_factor(k * dt / mass);
      s.v[0][1] = 0.7;
      s.v[0][2] = -0.1;
      const auto force = [&](bool first) {
        s.f[0][0] = s.f[0][1] = 0.;
        s.f[0][2] = -g * mass;
        push_spheres({0}, s.fluid.rows(), s.arrays(), nullptr, dt, first, given);
      };
      const auto tell = [&] {
        pack_free({0}, s.arrays(), s.fluid.rows(), false, message);
        tell_motion({0}, s.arrays(), s.fluid.rows(), interval(), message);
      };
      force(true);
      tell();
      EXPECT_EQ(message[Field::touched][0], 0.);  // nothing is known yet
      for (int n = 0; n < steps; n++) {
        for (int d = 0; d < 3; d++) {
          s.v[0][d] += 0.5 * dt / mass * s.f[0][d];
          s.x[0][d] += dt * s.v[0][d];
        }
        force(false);
        for (int d = 0; d < 3; d++) s.v[0][d] += 0.5 * dt / mass * s.f[0][d];
      }
      const double x[3] = {s.x[0][0], s.x[0][1], s.x[0][2]};
      tell();
      EXPECT_EQ(message[Field::touched][0], 0.) << steps << " steps, K T/m " << stiff;
      const double scale = mass * (g + 2. / T);
      for (int d = 0; d < 3; d++) {
        EXPECT_NEAR(message[Field::otherForce][d], d == 2 ? -g * mass : 0., 1e-12 * scale);
        EXPECT_DOUBLE_EQ(message[Field::meanVelocity][d], x[d] / T);
      }
    }
}

// a push of something else is seen whatever its size, down to rounding, in any direction
TEST(TellMotion, aContactsImpulseOfAnySizeIsSeen)
{
  for (double part : {1e-5, 1e-3, 1., 1e3, 1e6})
    for (int k = 0; k < 3; k++)
      for (double sign : {-1., 1.}) {
        Told t;
        t.tell(interval());
        const double push = sign * part * g * T;  // [m/s]
        t.s.v[0][2] -= g * T;
        t.s.v[0][k] += push;
        t.tell(interval());
        EXPECT_EQ(t.touched(), 1.) << part << ' ' << k;
        EXPECT_NEAR(t.other(k), mass * (push / T - (k == 2 ? g : 0.)), 1e-9 * mass * (std::fabs(push) / T + g));
      }
}

// held by a contact: nothing moves, and the fluid's pull and the weight are carried
TEST(TellMotion, whatHoldsItIsSeen)
{
  Told t;
  t.tell(interval());
  t.tell(interval(), 3e-9 * T);
  EXPECT_EQ(t.touched(), 1.);
  EXPECT_DOUBLE_EQ(t.other(2), -3e-9);
  EXPECT_EQ(t.mean(2), 0.);
}

TEST(TellMotion, eachIntervalStandsForItself)
{
  Told t;
  t.s.x[0][2] = 1.;
  t.s.v[0][2] = -0.1;
  t.tell(interval());
  t.s.x[0][2] = 1.5;  // pushed
  t.s.v[0][2] = 0.4;
  t.tell(interval());
  EXPECT_EQ(t.touched(), 1.);
  EXPECT_DOUBLE_EQ(t.mean(2), 0.5 / T);
  t.s.x[0][2] = 1.75;  // free again
  t.s.v[0][2] -= g * T;
  t.tell(interval());
  EXPECT_EQ(t.touched(), 0.);
  EXPECT_DOUBLE_EQ(t.mean(2), 0.25 / T);
  EXPECT_NEAR(t.other(2), -g * mass, 1e-12 * mass / T);
}

TEST(TellMotion, wholePeriodsAreTakenOff)
{
  Interval i = interval();
  i.nearest = [](double *d) { d[0] -= std::round(d[0] / 4.) * 4.; };
  Told t;
  t.s.x[0][0] = 3.75;
  t.s.v[0][0] = 0.5 / T;
  t.tell(interval());
  t.s.x[0][0] = 0.25;  // through the end of a box of 4 m
  t.s.v[0][2] -= g * T;
  t.tell(i);
  EXPECT_DOUBLE_EQ(t.mean(0), 0.5 / T);
  EXPECT_EQ(t.touched(), 0.);
}

// a sphere inserted amid a run has had its weight alone, at its velocity
TEST(TellMotion, aNewSphereIsFree)
{
  Told t;
  t.s.x[0][2] = 5.;
  t.s.v[0][2] = -0.25;
  t.tell(interval());
  EXPECT_EQ(t.touched(), 0.);
  EXPECT_EQ(t.mean(2), -0.25);
  EXPECT_DOUBLE_EQ(t.other(2), -g * mass);
  EXPECT_EQ(t.other(0), 0.);
  // and is known from then on
  t.s.x[0][2] = 4.5;
  t.s.v[0][2] -= g * T;
  t.tell(interval());
  EXPECT_DOUBLE_EQ(t.mean(2), -0.5 / T);
  EXPECT_EQ(t.touched(), 0.);
}

TEST(TellMotion, onlyTheListedAndOnlyWhenAsked)
{
  SphereStore s(2);
  s.fluid[1][Row::SLOT] = 0;
  Particles message(told);
  message.resize(1);
  tell_motion({1}, s.arrays(), s.fluid.rows(), interval(), message);
  EXPECT_EQ(s.fluid[0][Row::SEEN], 0.);
  EXPECT_GT(s.fluid[1][Row::SEEN], 0.);

  Particles plain({Field::velocity, Field::impulse, Field::mass});
  plain.resize(1);
  tell_motion({0}, s.arrays(), s.fluid.rows(), interval(), plain);
  EXPECT_EQ(s.fluid[0][Row::SEEN], 0.);
}

namespace {

const double arm[3] = {0., 0., 0.};
const std::vector<BodySphere> two_bodies = {{2, 0, arm, 0.75}, {0, 0, arm, 0.25}, {1, 1, arm, 1.}};

// two bodies of two spheres and one behind one free sphere: their masses, velocities
// and impulses along z. They turn: the spheres' own velocities are not the centre's
Particles of_bodies()
{
  Particles message(told);
  message.resize(4);
  const double m[4] = {9., 3., 1., 2.}, v[4] = {9., 4., -8., -0.5}, impulse[4] = {9., 0.6, 0.2, 0.};
  for (int i = 0; i < 4; i++) {
    message[Field::mass][i] = m[i];
    message[Field::velocity][3 * i + 2] = v[i];
    message[Field::impulse][3 * i + 2] = impulse[i];
    message[Field::touched][i] = 7.;
  }
  return message;
}

}  // namespace

TEST(TellBodyMotion, spheresMoveWithTheCentreOfMassAndTurn)
{
  Particles message = of_bodies();
  // both as under gravity and the fluid's impulse, 0.8 N s on 4 kg
  std::vector<BodyMotion> bodies(2);
  bodies[0] = {true, {0., 0., 3e-3}, {0., 0., 0.2 - g * T}, {0., 0., 1.}};
  bodies[1] = {true, {1e-3, 0., 0.}, {0., 0., -g * T}, {0., 0., -0.5}};
  tell_body_motion(two_bodies, bodies, interval(), 1, message);
  EXPECT_EQ(message[Field::touched][0], 7.);  // the free sphere's is left alone
  for (int i = 1; i < 4; i++) EXPECT_EQ(message[Field::touched][i], 0.) << i;
  // 1.5 m/s, and what the spheres' turning makes of it
  EXPECT_DOUBLE_EQ(message[Field::meanVelocity][3 * 1 + 2], 1.5 + 3.);
  EXPECT_DOUBLE_EQ(message[Field::meanVelocity][3 * 2 + 2], 1.5 - 9.);
  EXPECT_DOUBLE_EQ(message[Field::meanVelocity][3 * 3], 0.5);
  EXPECT_NEAR(message[Field::otherForce][3 * 1 + 2], -3. * g, 1e-9);
  EXPECT_NEAR(message[Field::otherForce][3 * 3 + 2], -2. * g, 1e-9);
}

// the fluid does not share its impulse by mass: the body is free all the same
TEST(TellBodyMotion, theSumOverABodyDecides)
{
  Particles message = of_bodies();
  message[Field::impulse][3 * 1 + 2] = 0.;
  message[Field::impulse][3 * 2 + 2] = 0.8;
  std::vector<BodyMotion> bodies(2);
  bodies[0] = {true, {}, {0., 0., 0.2 - g * T}};
  bodies[1] = {true, {}, {0., 0., -g * T}};
  tell_body_motion(two_bodies, bodies, interval(), 1, message);
  EXPECT_EQ(message[Field::touched][1], 0.);
  EXPECT_EQ(message[Field::touched][2], 0.);
}

TEST(TellBodyMotion, whatTouchesABodyTouchesEachOfItsSpheres)
{
  for (double push : {1e-4, 1., 1e4})
    for (int touched = 0; touched < 2; touched++) {
      Particles message = of_bodies();
      std::vector<BodyMotion> bodies(2);
      bodies[0] = {true, {}, {0., 0., 0.2 - g * T}};
      bodies[1] = {true, {}, {0., 0., -g * T}};
      bodies[touched].change[1] += push;
      tell_body_motion(two_bodies, bodies, interval(), 1, message);
      for (int i = 1; i < 4; i++) EXPECT_EQ(message[Field::touched][i], touched == (i == 3)) << i << ' ' << push;
    }
}

// a sphere of a body that has others is no free one, whatever touches the body
TEST(TellBodyMotion, spheresOfOneBodyHoldEachOther)
{
  Particles message = of_bodies();
  std::vector<BodyMotion> bodies(2);
  bodies[0] = {true, {}, {0., 0., 0.2 - g * T}, {}, {}, 1, 2};
  bodies[1] = {true, {}, {0., 0., -g * T}};
  tell_body_motion(two_bodies, bodies, interval(), 1, message);
  EXPECT_EQ(message[Field::touched][1], 1.);
  EXPECT_EQ(message[Field::touched][2], 1.);
  EXPECT_EQ(message[Field::touched][3], 0.);
}

TEST(TellBodyMotion, wholePeriodsAndNewBodies)
{
  Particles message = of_bodies();
  Interval i = interval();
  i.nearest = [](double *d) { d[0] -= std::round(d[0] / 4.) * 4.; };
  std::vector<BodyMotion> bodies(2);
  bodies[0] = {true, {-3.5, 0., 0.}, {0., 0., 0.2 - g * T}};
  tell_body_motion(two_bodies, bodies, i, 1, message);
  EXPECT_DOUBLE_EQ(message[Field::meanVelocity][3 * 1], 0.5 / T);
  EXPECT_DOUBLE_EQ(message[Field::meanVelocity][3 * 2], 0.5 / T);
  // the second is new: its sphere's velocity, and its weight
  EXPECT_EQ(message[Field::touched][3], 0.);
  EXPECT_EQ(message[Field::meanVelocity][3 * 3 + 2], -0.5);
  EXPECT_DOUBLE_EQ(message[Field::otherForce][3 * 3 + 2], -2. * g);
}

// what changed within the interval is no other force, for a sphere and for a body
TEST(TellMotion, gravityThatChangesWithinTheIntervalTouchesNothing)
{
  for (bool known : {true, false}) {
    GroupGravity mean;
    mean.add(1, {{0.2, 0., -0.5 * g}});
    mean.add(4, {{0., 0.7, 0.}});
    Interval now = interval();
    if (known) now.mean = &mean;

    Told t;
    t.s.mask[0] = 1 | 4;
    t.tell(now);
    t.s.v[0][0] = 0.2 * T;
    t.s.v[0][1] = 0.7 * T;
    t.s.v[0][2] = -0.5 * g * T;
    t.tell(now);
    EXPECT_EQ(t.touched(), known ? 0. : 1.);
    EXPECT_NEAR(t.other(2), -0.5 * g * mass, 1e-12 * mass);

    BodyMotion b;
    b.known = true;
    b.groups = 1 | 4;
    b.change = {{0.2 * T, 0.7 * T, -0.5 * g * T}};
    const double arm[3] = {0., 0., 0.};
    t.tell(now);
    tell_body_motion({{0, 0, arm, 1.}}, {b}, now, 0, t.message);
    EXPECT_EQ(t.touched(), known ? 0. : 1.);
  }
}

TEST(GroupGravity, meanOverSteps)
{
  GroupGravity sum, step;
  step.add(1, {{1., 2., 3.}});
  step.add(4, {{0., 0., -1.}});
  for (int n = 0; n < 4; n++) sum.gather(step, 0.5);
  EXPECT_DOUBLE_EQ(sum.by(0.5).on(1)[1], 2.);
  EXPECT_DOUBLE_EQ(sum.by(0.5).on(1 | 4)[2], 2.);
  GroupGravity back;
  back.add(8, {{9., 9., 9.}});
  back.take(sum.numbers());
  EXPECT_EQ(back.numbers(), sum.numbers());
  EXPECT_EQ(back.on(1), sum.on(1));
  EXPECT_EQ(back.on(4), sum.on(4));
  EXPECT_EQ(back.on(8)[0], 0.);
  sum.clear();
  EXPECT_EQ(sum.by(1.).on(1)[0], 0.);
}
