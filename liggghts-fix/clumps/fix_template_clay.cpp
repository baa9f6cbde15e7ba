/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "clumps/fix_template_clay.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>

#include "atom.h"
#include "atom_vec.h"
#include "clumps/clay_settings.h"
#include "comm.h"
#include "error.h"
#include "fix_multisphere.h"
#include "modify.h"
#include "particleToInsert_multisphere.h"
#include "probability_distribution.h"

using namespace LAMMPS_NS;

namespace {

// A clump to be inserted whose spheres have atom types of their own; the
// mother class gives them all the template's one type.
class ClayToInsert : public ParticleToInsertMultisphere {
 public:
  ClayToInsert(LAMMPS *lmp, const std::vector<int> &types) :
    ParticleToInsertMultisphere(lmp, types.size()), types_(types)
  {
  }

  int insert()
  {
    const int n = ParticleToInsertMultisphere::insert();
    const int first = atom->nlocal - n;
    for (int i = 0; i < n; i++) atom->type[first + i] = types_[i];
    return n;
  }

 private:
  std::vector<int> types_;
};

}

// The command in the words of particletemplate/multisphere; made before, and
// alive during, the mother class's constructor.
class FixTemplateClay::Words {
 public:
  Words(char **arg, const ClaySettings &s)
  {
    add(arg[0]);
    add(arg[1]);
    add(arg[2]);
    add(s.seed);
    add("atom_type");
    add(std::to_string(s.types[0]));
    for (const auto &w : s.passed_on) add(w);
    add("density");
    add("constant");
    add(s.density);
    add("nspheres");
    add(std::to_string(s.clump.size()));
    add("ntry");
    add("1000000");  // not used
    add("spheres");
    for (const auto &sphere : s.clump) {
      for (int d = 0; d < 3; d++) add(sphere.x[d]);
      add(sphere.r);
    }
    add("type");
    add(std::to_string(s.type));
    for (auto &w : words_) pointers_.push_back(&w[0]);
  }
  int count() const { return static_cast<int>(pointers_.size()); }
  char **list() { return pointers_.data(); }

 private:
  void add(const std::string &w) { words_.push_back(w); }
  void add(const char *w) { words_.push_back(w); }
  void add(double v)
  {
    char text[32];
    snprintf(text, sizeof text, "%.17g", v);
    words_.push_back(text);
  }
  std::vector<std::string> words_;
  std::vector<char *> pointers_;
};

/* ---------------------------------------------------------------------- */

FixTemplateClay::FixTemplateClay(LAMMPS *lmp, int narg, char **arg) :
  FixTemplateClay(lmp, read_clay_settings(lmp, narg, arg), arg)
{
}

FixTemplateClay::FixTemplateClay(LAMMPS *lmp, const ClaySettings &s, char **arg) :
  FixTemplateClay(lmp, s, Words(arg, s))
{
}

FixTemplateClay::FixTemplateClay(LAMMPS *lmp, const ClaySettings &s, Words &&words) :
  FixTemplateMultisphere(lmp, words.count(), words.list()), settings_(s)
{
  const std::vector<int> &types = settings_.types;
  atom_type_sphere = new int[nspheres];
  for (int i = 0; i < nspheres; i++) atom_type_sphere[i] = types[i];

  delete pti;
  pti = new ClayToInsert(lmp, types);
}

/* ----------------------------------------------------------------------
   all that the mother class finds by Monte Carlo, exactly
------------------------------------------------------------------------- */

void FixTemplateClay::post_create()
{
  clay::Clump &clump = settings_.clump;
  geometry_ = settings_.overlaps_once ? clay::unionOfSpheres(clump) : clay::sumOfSpheres(clump);
  for (auto &s : clump) s.x -= geometry_.centre;

  for (int i = 0; i < nspheres; i++) {
    for (int d = 0; d < 3; d++) x_sphere[i][d] = clump[i].x[d];
    volumeweight_[i] = geometry_.share[i];
  }
  const clay::ClumpSphere ball = clay::boundingBall(clump);
  r_bound = ball.r;
  for (int d = 0; d < 3; d++) {
    x_min[d] -= geometry_.centre[d];
    x_max[d] -= geometry_.centre[d];
    x_bound[d] = ball.x[d];
  }

  volume_expect = geometry_.volume;
  mass_expect = mass();
  r_equiv = std::cbrt(0.75 * volume_expect / M_PI);

  const clay::PrincipalAxes principal = clay::principalAxes(settings_.density * geometry_.inertia);
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) moi_[i][j] = settings_.density * geometry_.inertia(i, j);
    inertia_[i] = principal.moments[i];
    ex_space_[i] = principal.axes(i, 0);
    ey_space_[i] = principal.axes(i, 1);
    ez_space_[i] = principal.axes(i, 2);
  }

  check_overlap();
  calc_displace_xcm_x_body();
  print_info();
}

/* ----------------------------------------------------------------------
   clump types must be 1, 2, ... over all templates, of whatever style
------------------------------------------------------------------------- */

void FixTemplateClay::init()
{
  std::vector<FixTemplateMultisphere *> all;
  for (int i = 0; i < modify->nfix; i++)
    if (FixTemplateMultisphere *t = dynamic_cast<FixTemplateMultisphere *>(modify->fix[i])) all.push_back(t);

  const int n = static_cast<int>(all.size());
  char text[256];
  if (type_ > n) {
    snprintf(text, sizeof text, "type %d with %d clump template(s): types must be 1 to %d, each used once", type_, n,
             n);
    error->fix_error(FLERR, this, text);
  }
  for (FixTemplateMultisphere *t : all)
    if (t != this && t->type() == type_) {
      snprintf(text, sizeof text, "type %d is also that of fix %s: each clump template needs its own", type_, t->id);
      error->fix_error(FLERR, this, text);
    }

  Fix *multisphere = modify->find_fix_style("multisphere", 0);
  if (multisphere && (multisphere->groupbit & groupbit) == 0)
    error->fix_error(FLERR, this, "must be in the same group as fix multisphere");

  for (int t : settings_.types)
    if (t > atom->ntypes) {
      std::string words = "sphere_types has " + std::to_string(t);
      if (settings_.positive)
        words = "atom_types " + std::to_string(settings_.positive) + " " + std::to_string(settings_.negative);
      snprintf(text, sizeof text, "%s: the box has %d atom type(s); create_box sets their number", words.c_str(),
               atom->ntypes);
      error->fix_error(FLERR, this, text);
    }
}

/* ---------------------------------------------------------------------- */

void FixTemplateClay::randomize_single()
{
  FixTemplateMultisphere::randomize_single();
  pti->atom_type = settings_.types[0];
}

/* ---------------------------------------------------------------------- */

void FixTemplateClay::init_ptilist(int n, const bool, FixPropertyAtom *const)
{
  const std::vector<int> &types = settings_.types;
  n_pti_max = n;
  // an array of pointers is meant: NOLINTNEXTLINE(bugprone-sizeof-expression)
  pti_list = static_cast<ParticleToInsert **>(memory->smalloc(n * sizeof(ParticleToInsert *), "pti_list"));
  for (int i = 0; i < n; i++) pti_list[i] = new ClayToInsert(lmp, types);
}

/* ---------------------------------------------------------------------- */

void FixTemplateClay::print_info()
{
  if (comm->me != 0) return;
  std::map<int, int> counts;
  for (int t : settings_.types) counts[t]++;
  std::string kinds;
  for (const auto &c : counts)
    kinds += (kinds.empty() ? "" : ", ") + std::to_string(c.second) + " of atom type " + std::to_string(c.first);

  FILE *streams[2] = {screen, logfile};
  for (FILE *out : streams) {
    if (!out) continue;
    fprintf(out,
            "Clay template %s (%s): %d spheres, %s\n"
            "  volume %.12g m3 (%s), mass %.12g kg\n"
            "  principal moments of inertia %.12g %.12g %.12g kg m2\n"
            "  bounding radius %.12g m, radius of equal volume %.12g m\n",
            id, settings_.shape.c_str(), nspheres, kinds.c_str(), volume_expect,
            settings_.overlaps_once ? "union of the spheres" : "sum of the spheres", mass_expect, inertia_[0],
            inertia_[1], inertia_[2], r_bound, r_equiv);
    if (!settings_.verbose) continue;
    fprintf(out, "  sphere: centre (m) from the centre of mass, radius (m), atom type, share of the volume\n");
    for (int i = 0; i < nspheres; i++)
      fprintf(out, "  %2d: %14.7e %14.7e %14.7e  %.7e  %d  %.9f\n", i + 1, x_sphere[i][0], x_sphere[i][1],
              x_sphere[i][2], r_sphere[i], atom_type_sphere[i], volumeweight_[i]);
  }
}
