// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "contacts/lean_coefficients.h"

#include <cmath>

#include "property_registry.h"

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

void LeanCoefficients::connect(PropertyRegistry &registry, const clay::LeanModel &model, const char *who)
{
  if (model.kind.tangential != clay::TangentialForce::none) registry.connect("coeffFrict", friction_, who);
  if (model.kind.rolling != clay::RollingTorque::none) registry.connect("coeffRollFrict", rolling_, who);
  if (model.kind.cohesion) registry.connect("cohEnergyDens", cohesion_, who);
  if (model.modulus()) {
    registry.connect("Yeff", modulus_, who);
    if (model.kind.normal == clay::NormalForce::hertz) {
      registry.connect("Geff", shear_modulus_, who);
      registry.connect("betaeff", beta_, who);
      return;
    }
    registry.connect("charVel", speed_, who);
    registry.connect("coeffRestLog", restitution_log_, who);
    return;
  }
  const bool hertz = model.kind.normal == clay::NormalForce::hertzStiffness;
  registry.connect("k_n", kn_, who);
  registry.connect("k_t", kt_, who);
  registry.connect(model.absoluteDamping ? "gamman_abs" : hertz ? "gamma_n" : "gamman", gamman_, who);
  registry.connect(model.absoluteDamping ? "gammat_abs" : hertz ? "gamma_t" : "gammat", gammat_, who);
}

/* ---------------------------------------------------------------------- */

clay::ContactLaw LeanCoefficients::law(const clay::LeanModel &model, int a, int b, double radius, double mass,
                                       double nktv2p) const
{
  clay::ContactLaw law;
  if (model.kind.normal == clay::NormalForce::hertz) {
    law = clay::hertzLaw(radius, mass, modulus_[a][b], shear_modulus_[a][b], beta_[a][b]);
    law.kn /= nktv2p;
    law.kt /= nktv2p;
  } else if (model.modulus()) {
    law = clay::hookeLaw(radius, mass, modulus_[a][b], speed_, restitution_log_[a][b]);
    law.kn /= nktv2p;
    law.kt = model.softer ? 0.285714286 * law.kn : law.kn;
  } else {
    const double root = model.kind.normal == clay::NormalForce::hertzStiffness ? sqrt(radius) : 1.0;
    const double moving = model.absoluteDamping ? 1.0 : mass;
    law.kn = root * kn_[a][b] / nktv2p;
    law.kt = root * kt_[a][b] / nktv2p;
    law.gamman = root * moving * gamman_[a][b];
    law.gammat = root * moving * gammat_[a][b];
  }
  if (!model.tangentialDamping) law.gammat = 0.0;
  if (friction_) law.friction = friction_[a][b];
  if (rolling_) law.rolling = rolling_[a][b];
  if (cohesion_) law.cohesion = cohesion_[a][b];
  law.radius = radius;
  return law;
}
