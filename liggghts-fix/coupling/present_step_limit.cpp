// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "atom.h"
#include "comm.h"
#include "contacts/granular_script.h"
#include "coupling/run_checks.h"
#include "clumps/to_ranks.h"
#include "domain.h"
#include "error.h"
#include "fix_multisphere.h"
#include "fix_wall_gran.h"
#include "lammps.h"
#include "modify.h"
#include "neigh_list.h"
#include "pair_gran.h"
#include "primitive_wall.h"
#include "vector_container.h"

using namespace LAMMPS_NS;

namespace {

using Eigen::Map;
using Eigen::Matrix3d;
using Eigen::Vector3d;

const double infinity = std::numeric_limits<double>::infinity();

struct Body {
  Vector3d centre;
  double mass, least;  // least: smallest principal moment of inertia
  Matrix3d inertia;    // in space axes
  clay::ContactBound bound;
  clay::ContactMatrices matrices;
};

struct BodyContact {
  int body;
  double at[3], normal[3];
  clay::ContactCoefficients coefficients;
  bool fixed;
};

// Of each sphere here the processor that owns its body, as that one tells: it has all
// of the body's spheres, some of them as ghosts. A fix only to LIGGGHTS's communication.
class BodyOwners : public Fix {
 public:
  BodyOwners(LAMMPS *lmp, FixMultisphere *bodies) : BodyOwners(lmp, bodies, words()) {}

  int of(int i) const { return static_cast<int>(owner_[i]) - 1; }

  int setmask() { return 0; }
  int pack_reverse_comm(int n, int first, double *buf)
  {
    std::copy_n(&owner_[first], n, buf);
    return 1;
  }
  void unpack_reverse_comm(int n, int *list, double *buf)
  {
    for (int k = 0; k < n; k++) owner_[list[k]] += buf[k];
  }

 private:
  static char **words()
  {
    static char id[] = "owners", group[] = "all", style[] = "owners";
    static char *w[] = {id, group, style};
    return w;
  }

  BodyOwners(LAMMPS *lmp, FixMultisphere *bodies, char **w) : Fix(lmp, 3, w)
  {
    comm_reverse = 1;
    const int n = atom->nlocal + atom->nghost;
    owner_.assign(n, 0.0);
    for (int i = 0; i < n; i++) {
      const int tag = bodies->belongs_to(i);
      if (tag >= 0 && bodies->data().map(tag) >= 0 && domain->is_owned_or_first_ghost(i)) owner_[i] = comm->me + 1;
    }
    comm->reverse_comm_fix(this);
  }

  std::vector<double> owner_;  // rank + 1
};

// this processor's bodies without contacts
std::vector<Body> bodies_here(FixMultisphere *ms)
{
  std::vector<Body> bodies(ms->n_body());
  const auto vectors = [ms](const char *name) {
    return ms->data().prop().getElementProperty<VectorContainer<double, 3>>(name)->begin();
  };
  double **moments = vectors("inertia"), **ex = vectors("ex_space"), **ey = vectors("ey_space"),
         **ez = vectors("ez_space");
  for (std::size_t b = 0; b < bodies.size(); b++) {
    Body &body = bodies[b];
    ms->data().xcm(body.centre.data(), b);
    body.mass = ms->data().mass(b);
    body.least = *std::min_element(moments[b], moments[b] + 3);
    Matrix3d axes;
    axes << Map<Vector3d>(ex[b]), Map<Vector3d>(ey[b]), Map<Vector3d>(ez[b]);
    body.inertia = axes * Map<Vector3d>(moments[b]).asDiagonal() * axes.transpose();
  }
  return bodies;
}

// calls add(i, at, coefficients, fixed) for each end of each contact there is
template <class Add>
void each_contact(LAMMPS *lmp, const NeighList *list, const ContactModel &model, Add add)
{
  const Atom &atom = *lmp->atom;
  for (int a = 0; a < list->inum; a++) {
    const int i = list->ilist[a];
    for (int n = 0; n < list->numneigh[i]; n++) {
      const int j = list->firstneigh[i][n] & NEIGHMASK;
      const double reach = atom.radius[i] + atom.radius[j];
      double r2 = 0, at[3];
      for (int d = 0; d < 3; d++) {
        const double apart = atom.x[j][d] - atom.x[i][d];
        r2 += apart * apart;
        at[d] = atom.x[i][d] + apart * atom.radius[i] / reach;
      }
      if (r2 >= reach * reach) continue;
      const auto c =
          model.between(atom.type[i], atom.type[j], atom.rmass[i] * atom.rmass[j] / (atom.rmass[i] + atom.rmass[j]),
                        atom.radius[i] * atom.radius[j] / reach);
      add(i, at, c, false);
      add(j, at, c, false);
    }
  }
  for (FixWallGran *w : primitive_walls(lmp))
    for (int i = 0; i < atom.nlocal; i++) {
      if (!(atom.mask[i] & w->groupbit)) continue;
      double to_wall[3] = {0, 0, 0};
      if (w->primitiveWall()->resolveContact(atom.x[i], atom.radius[i], to_wall) >= 0) continue;
      double at[3];
      for (int d = 0; d < 3; d++) at[d] = atom.x[i][d] + to_wall[d];
      add(i, at, model.between(atom.type[i], w->atom_type_wall(), atom.rmass[i], atom.radius[i]), true);
    }
}

struct Least {
  double step = infinity;
  int contacts = 0;

  void take(double other, int n)
  {
    if (other >= step) return;
    step = other;
    contacts = n;
  }
};

}  // namespace

/* ---------------------------------------------------------------------- */

double LAMMPS_NS::present_step_limit(LAMMPS *lmp, int *contacts)
{
  const ContactModel model(lmp);
  PairGran *gran = granular_pair(lmp);
  if (contacts) *contacts = 0;
  if (!model.known() || !gran || !gran->list) return infinity;

  const Atom &atom = *lmp->atom;
  FixMultisphere *ms = static_cast<FixMultisphere *>(lmp->modify->find_fix_style("multisphere", 0));
  std::vector<Body> bodies;
  std::vector<clay::ContactBound> spheres(atom.nlocal);
  std::vector<std::vector<BodyContact>> elsewhere(lmp->comm->nprocs);
  const auto touch = [&](const BodyContact &c) {
    Body &b = bodies[ms->data().map(c.body)];
    Vector3d arm = Map<const Vector3d>(c.at) - b.centre;
    lmp->domain->minimum_image(arm.x(), arm.y(), arm.z());  // the sphere may have gone through a periodic side
    b.bound.add(b.mass, b.least, arm.squaredNorm(), c.coefficients, c.fixed);
    b.matrices.add({arm, Map<const Vector3d>(c.normal), c.coefficients, c.fixed});
  };

  if (ms) bodies = bodies_here(ms);
  const std::unique_ptr<BodyOwners> owners(ms ? new BodyOwners(lmp, ms) : nullptr);
  each_contact(lmp, gran->list, model, [&](int i, const double *at, const clay::ContactCoefficients &c, bool fixed) {
    if (i >= atom.nlocal) return;
    const int tag = ms ? ms->belongs_to(i) : -1;
    const Vector3d reach = Map<const Vector3d>(at) - Map<const Vector3d>(atom.x[i]);
    if (tag < 0) {
      const double m = atom.rmass[i], r = atom.radius[i];
      spheres[i].add(m, 0.4 * m * r * r, reach.squaredNorm(), c, fixed);
      return;
    }
    BodyContact contact = {tag, {at[0], at[1], at[2]}, {}, c, fixed};
    Map<Vector3d>(contact.normal) = reach.normalized();
    const int rank = owners->of(i);
    if (rank < 0) lmp->error->one(FLERR, "Contact check: no processor owns the clump of a sphere");
    if (rank == lmp->comm->me) touch(contact);
    else elsewhere[rank].push_back(contact);
  });
  for (const BodyContact &c : clay::sendToRanks(elsewhere, lmp->world)) touch(c);

  Least mine;
  for (const clay::ContactBound &s : spheres) mine.take(s.step(), s.contacts);
  // the cheap bounds first: once they are above the best, so are all that follow
  std::vector<std::pair<double, int>> order;
  for (std::size_t b = 0; b < bodies.size(); b++)
    if (bodies[b].bound.contacts > 0) order.emplace_back(bodies[b].bound.step(), b);
  std::sort(order.begin(), order.end());
  for (const auto &next : order) {
    if (next.first >= mine.step) break;
    const Body &b = bodies[next.second];
    mine.take(b.matrices.step(b.mass, b.inertia), b.bound.contacts);
  }
  struct {
    double step;
    int contacts;
  } sent = {mine.step, mine.contacts}, least;
  MPI_Allreduce(&sent, &least, 1, MPI_DOUBLE_INT, MPI_MINLOC, lmp->world);
  if (contacts) *contacts = least.contacts;
  return least.step;
}
