/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "placing/fix_insert_placed.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_multisphere.h"
#include "fix_template_multisphere.h"
#include "fix_template_sphere.h"
#include "modify.h"
#include "particleToInsert_multisphere.h"
#include "script/values.h"
#include "update.h"

using namespace LAMMPS_NS;

namespace {

const std::size_t PART = 1 << 16;  // bytes of the list, and a line, that are read at a time

}

/* ---------------------------------------------------------------------- */

FixInsertPlaced::FixInsertPlaced(LAMMPS *lmp, int narg, char **arg) :
  Fix(lmp, narg, arg), verbose_(true), placed_(0.0), mass_(0.0)
{
  for (int iarg = 3; iarg < narg;) {
    const std::string key = arg[iarg++];
    if (key == "file") {
      if (iarg == narg) fail("the file's name is missing");
      file_ = arg[iarg++];
    } else if (key == "templates") {
      for (; iarg < narg && modify->find_fix(arg[iarg]) >= 0; iarg++) {
        FixTemplateSphere *t = dynamic_cast<FixTemplateSphere *>(modify->fix[modify->find_fix(arg[iarg])]);
        const bool clump = dynamic_cast<FixTemplateMultisphere *>(t) != NULL;
        if (!t || (!clump && strcmp(t->style, "particletemplate/sphere") != 0))
          fail("fix '" + std::string(arg[iarg]) + "' is no template of spheres or of multisphere clumps");
        templates_.push_back(t);
        kinds_.push_back({arg[iarg], clump});
      }
      if (templates_.empty())
        fail(iarg == narg ? "the templates' fix IDs are missing"
                          : "there is no fix '" + std::string(arg[iarg]) + "' to be a template");
    } else if (key == "verbose") {
      try {
        verbose_ = clay::yesOrNo(key, iarg < narg ? arg[iarg++] : "");
      } catch (const std::invalid_argument &e) {
        fail(e.what());
      }
    } else if (!templates_.empty() && std::string(arg[iarg - 2]) == kinds_.back().name) {
      fail("there is no fix '" + key + "' to be a template");
    } else fail("unknown keyword '" + key + "': file, templates and verbose are known");
  }
  if (file_.empty()) fail("'file' is missing: the name of the list");
  if (templates_.empty()) fail("'templates' is missing: fix IDs of particle templates");
  if (!atom->radius_flag || !atom->rmass_flag) fail("needs spheres: atom_style sphere or granular");
  if (!atom->tag_enable) fail("needs atoms with tags");
  if (domain->triclinic) fail("does not work with a triclinic box");

  restart_global = 1;
  vector_flag = 1;
  size_vector = 2;
  global_freq = 1;
  extvector = 0;
}

/* ---------------------------------------------------------------------- */

void FixInsertPlaced::fail(const std::string &why) { error->fix_error(FLERR, this, why.c_str()); }

/* ----------------------------------------------------------------------
   the particles are there as soon as the command has been read; those of a
   restarted run have come with the restart file
------------------------------------------------------------------------- */

void FixInsertPlaced::post_create()
{
  if (!modify->have_restart_data(this)) place();
}

/* ----------------------------------------------------------------------
   processor 0 reads whole lines, a part of the file at a time, that all get:
   none holds more of the list. Empty at its end.
------------------------------------------------------------------------- */

std::string FixInsertPlaced::next_lines(std::ifstream &in)
{
  std::string text;
  int size = -1;
  if (comm->me == 0) {
    for (std::string line; text.size() < PART && std::getline(in, line);) text += line + '\n';
    // a folder can be opened, but not be read
    if (in.is_open() && !in.bad()) size = static_cast<int>(text.size());
  }
  MPI_Bcast(&size, 1, MPI_INT, 0, world);
  if (size < 0) fail("cannot read file " + file_);
  text.resize(size);
  MPI_Bcast(&text[0], size, MPI_CHAR, 0, world);
  return text;
}

/* ---------------------------------------------------------------------- */

std::vector<clay::Place> FixInsertPlaced::parse(const std::string &text, int first)
{
  try {
    return clay::readPlaces(text, file_, kinds_, first);
  } catch (const std::runtime_error &e) {
    fail(e.what());
  }
  return {};
}

/* ----------------------------------------------------------------------
   a sphere outside would be lost; whoever looks first ends the run
------------------------------------------------------------------------- */

void FixInsertPlaced::check_box(const clay::Place &p, ParticleToInsert *particle)
{
  for (int s = 0; s < particle->nparticles; s++)
    for (int d = 0; d < 3; d++) {
      const double x = particle->x_ins[s][d];
      if (domain->periodicity[d] || (x >= domain->boxlo[d] && x < domain->boxhi[d])) continue;
      char text[512];
      snprintf(text, sizeof text, "file %s, line %d: a sphere at %c = %.9g is outside the box, %.9g to %.9g",
               file_.c_str(), p.line, "xyz"[d], x, domain -> boxlo[d], domain -> boxhi[d]);
      fail(text);
    }
}

/* ----------------------------------------------------------------------
   A fix that is new gives its values to all atoms at the start of a run. Here
   it does so before, as the bodies' values would be overwritten.
------------------------------------------------------------------------- */

void FixInsertPlaced::set_arrays_of_new_fixes()
{
  for (int i = 0; i < modify->nfix; i++) {
    Fix *f = modify->fix[i];
    if (!f->create_attribute) continue;
    f->pre_set_arrays();
    if (!f->just_created || f->recent_restart) continue;
    f->just_created = 0;
    for (int j = 0; j < atom->nlocal; j++)
      if (atom->mask[j] & f->groupbit) f->set_arrays(j);
  }
}

/* ----------------------------------------------------------------------
   every processor walks through the whole list, part by part, so that all agree on tags,
   and creates the particles whose centre lies in its part of the box
------------------------------------------------------------------------- */

void FixInsertPlaced::place()
{
  FixMultisphere *bodies = static_cast<FixMultisphere *>(modify->find_fix_style("multisphere", 0));
  for (const auto &k : kinds_)
    if (k.clump && modify->n_fixes_style("multisphere") != 1)
      fail("a clump needs one fix multisphere or multisphere/clump before it");

  // the contacts of an earlier run are known by the numbers of the ghosts, whose
  // places the new particles will take
  if (update->first_update)
    if (Fix *history = modify->find_fix_style("contacthistory", 0)) history->setup_pre_exchange();
  atom->nghost = 0;

  set_arrays_of_new_fixes();
  int tag = atom->tag_max() + 1;
  const int first = tag;
  int body = 0;
  ScalarContainer<int> *body_tags = NULL;
  if (bodies) {
    body_tags = bodies->data().prop().getElementProperty<ScalarContainer<int>>("id_multisphere");
    int mine = bodies->tag_max_body();
    MPI_Allreduce(&mine, &body, 1, MPI_INT, MPI_MAX, world);
  }

  double none[3] = {0.0, 0.0, 0.0};
  bigint listed = 0, mine = 0, all = 0;
  int line = 1;
  std::ifstream in;
  if (comm->me == 0) in.open(file_);
  for (std::string text = next_lines(in); !text.empty(); text = next_lines(in)) {
    const std::vector<clay::Place> places = parse(text, line);
    listed += places.size();
    line += static_cast<int>(std::count(text.begin(), text.end(), '\n'));
    for (const clay::Place &p : places) {
      FixTemplateSphere *t = templates_[p.kind];
      const bool clump = kinds_[p.kind].clump;
      t->randomize_single();
      ParticleToInsert *particle = t->pti;
      particle->groupbit |= groupbit;
      if (p.radius > 0.0) {
        particle->radius_ins[0] = particle->r_bound_ins = p.radius;
        particle->volume_ins = 4.0 / 3.0 * M_PI * p.radius * p.radius * p.radius;
        particle->mass_ins = particle->density_ins * particle->volume_ins;
      }
      double x[3] = {p.x[0], p.x[1], p.x[2]}, q[4] = {p.q[0], p.q[1], p.q[2], p.q[3]};
      domain->remap(x);
      particle->set_x_v_omega(x, none, none, q);
      check_box(p, particle);
      mass_ += particle->mass_ins;
      if (clump) body++;

      bool here = true;
      for (int d = 0; d < 3; d++) here = here && x[d] >= domain->sublo[d] && x[d] < domain->subhi[d];
      if (here) {
        mine++;
        const int n = particle->insert(), from = atom->nlocal - n;
        for (int s = 0; s < n; s++) atom->tag[from + s] = tag + s;
        if (clump) {
          const ParticleToInsertMultisphere *c = static_cast<ParticleToInsertMultisphere *>(particle);
          for (int s = 0; s < n; s++) bodies->set_body_displace(from + s, c->displace[s], body, c->volumeweight[s]);
          body_tags->set(bodies->n_body() - 1, body);
        }
      }
      tag += particle->nparticles;
    }
  }
  if (listed == 0) fail("file " + file_ + ": names no particle");

  MPI_Allreduce(&mine, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  if (all != listed)
    fail("only " + std::to_string(all) + " of the " + std::to_string(listed) + " particles of file " + file_ +
         " were placed");
  placed_ += all;

  atom->natoms += tag - first;
  if (atom->map_style) {
    atom->nghost = 0;
    atom->map_init();
    atom->map_set();
  }
  if (bodies) {
    int len1, len2;
    bodies->data().id_extend_body_extend(static_cast<int *>(bodies->extract("body", len1, len2)));
    bodies->data().generate_map();
    bodies->data().reset_forces(true);
  }

  if (!verbose_ || comm->me != 0) return;
  FILE *streams[2] = {screen, logfile};
  for (FILE *out : streams)
    if (out)
      fprintf(out, "Fix %s insert/placed: " BIGINT_FORMAT " particles of %d spheres and %.9g kg from file %s\n", id,
              all, tag - first, mass_, file_.c_str());
}

/* ---------------------------------------------------------------------- */

void FixInsertPlaced::write_restart(FILE *fp)
{
  if (comm->me != 0) return;
  const double kept[2] = {placed_, mass_};
  const int size = sizeof kept;
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(kept, sizeof(double), 2, fp);
}

void FixInsertPlaced::restart(char *buf)
{
  memcpy(&placed_, buf, sizeof placed_);
  memcpy(&mass_, buf + sizeof placed_, sizeof mass_);
}

double FixInsertPlaced::compute_vector(int i) { return i == 0 ? placed_ : mass_; }
