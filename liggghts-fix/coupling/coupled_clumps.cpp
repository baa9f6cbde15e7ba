// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/coupled_clumps.h"

#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "comm.h"
#include "error.h"
#include "clumps/fix_multisphere_clump.h"
#include "fix_template_multisphere.h"
#include "modify.h"

using namespace LAMMPS_NS;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

// the spheres of a template, which only its own family may see
struct Template : FixTemplateMultisphere {
  static clay::Clump spheres(FixTemplateMultisphere *t)
  {
    double **x = t->*&Template::displace_;
    const double *r = t->*&Template::r_sphere;
    clay::Clump clump(t->number_spheres());
    for (std::size_t i = 0; i < clump.size(); i++) clump[i] = {Vector3d(x[i][0], x[i][1], x[i][2]), r[i]};
    return clump;
  }
};

}  // namespace

/* ---------------------------------------------------------------------- */

std::vector<std::string> CoupledClumps::init(FixMultisphereClump *bodies)
{
  bodies_ = bodies;
  std::vector<std::string> odd;
  for (int i = 0; i < modify->nfix; i++)
    if (FixTemplateMultisphere *t = dynamic_cast<FixTemplateMultisphere *>(modify->fix[i])) {
      if (t->type() >= static_cast<int>(drags_.size())) drags_.resize(t->type() + 1);
      if (drags_[t->type()]) continue;
      const std::string said = add(t);
      if (!said.empty()) odd.push_back(said);
    }
  std::vector<const Matrix6d *> resistances;
  for (const auto &d : drags_) resistances.push_back(d ? &d->resistance() : nullptr);
  bodies_->set_resistances(resistances);
  return odd;
}

/* ----------------------------------------------------------------------
   one processor computes, all know; a warning, or nothing
------------------------------------------------------------------------- */

std::string CoupledClumps::add(FixTemplateMultisphere *t)
{
  const clay::Clump clump = Template::spheres(t);
  Matrix6d R;
  std::string said, odd;
  int bad = 0;
  if (comm->me == 0) {
    try {
      std::string from;
      const clay::StokesResistance found = clay::keptResistance(clump, clay::cacheFolder(), from);
      R = found.R;
      said = found.report() + "; " + from;
      odd = found.warning();
    } catch (const std::exception &e) {
      said = e.what();
      bad = 1;
    }
  }
  MPI_Bcast(&bad, 1, MPI_INT, 0, world);
  if (bad)  // the first processor tells why
    error->all(FLERR,
               (std::string("Fix couple/foam: clumpDrag resistance of template ") + t->id + ": " + said).c_str());
  MPI_Bcast(R.data(), 36, MPI_DOUBLE, 0, world);
  drags_[t->type()].reset(new clay::ClumpDrag(clump, R, law_));
  if (comm->me) return "";

  const clay::ClumpDrag &drag = *drags_[t->type()];
  double sum = 0;
  for (const auto &s : clump) sum += 6 * M_PI * s.r;
  const double sphere = 3 * M_PI * drag.diameter();
  FILE *streams[2] = {screen, logfile};
  for (FILE *out : streams)
    if (out)
      fprintf(out,
              "Clump template %s: %s\n"
              "  drag along its principal axes %.5g %.5g %.5g of the sum of its spheres',\n"
              "  %.5g %.5g %.5g of the drag of the sphere of like volume, %.6g m wide\n",
              t->id, said.c_str(), R(0, 0) / sum, R(1, 1) / sum, R(2, 2) / sum, R(0, 0) / sphere, R(1, 1) / sphere,
              R(2, 2) / sphere, drag.diameter());
  return odd.empty() ? odd : std::string("Fix couple/foam: clumpDrag resistance of template ") + t->id + ": " + odd;
}

/* ---------------------------------------------------------------------- */

const clay::ClumpDrag &CoupledClumps::drag(int ibody) const
{
  const int type = bodies_->clump_type(ibody);
  if (type < 0 || type >= static_cast<int>(drags_.size()) || !drags_[type]) {
    char text[160];
    snprintf(text, sizeof text,
             "Fix couple/foam: clumpDrag resistance: there is no template of type %d, "
             "which clump %d has",
             type, bodies_->data().tag(ibody));
    error->one(FLERR, text);
  }
  return *drags_[type];
}

/* ---------------------------------------------------------------------- */

double CoupledClumps::diameter(int ibody) const { return drag(ibody).diameter(); }

/* ---------------------------------------------------------------------- */

void CoupledClumps::prepare()
{
  told_.resize(bodies_->n_body());
  for (size_t b = 0; b < told_.size(); b++) {
    const clay::ClumpDrag &d = drag(b);
    const Vector3d slip = bodies_->axes(b).transpose() * bodies_->slip(b);
    const double Re = bodies_->knows_fluid(b) ? clay::clump_reynolds(d, slip, rho_, mu_) : -1.0;
    told_[b] = clay::told_drag(d, slip, Re, bodies_->body_volume(b));
  }
}

/* ---------------------------------------------------------------------- */

void CoupledClumps::set_flow(int b, const BodyFlow &flow)
{
  const clay::ClumpDrag &d = drag(b);
  const Matrix3d axes = bodies_->axes(b);
  Vector3d u, w;
  flow.motion(axes, u, w);
  const Vector3d slip = axes.transpose() * (u - bodies_->velocity(b));
  const double Re = clay::clump_reynolds(d, slip, rho_, mu_);
  bodies_->set_flow(b, flow, clay::answered_scale(d, told_[b], bodies_->body_volume(b), flow.K, slip, Re));
}
