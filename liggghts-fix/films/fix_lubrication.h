/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   fix ID group lubrication ...: resistance of the films of fluid between
   spheres, and between spheres and walls. Described in doc/fix_lubrication.md.
------------------------------------------------------------------------- */

#ifdef FIX_CLASS

FixStyle(lubrication,FixLubrication)

#else

#ifndef LMP_FIX_LUBRICATION_H
#define LMP_FIX_LUBRICATION_H

#include <utility>
#include <vector>

#include "fix.h"
#include "films/lubrication_step.h"

namespace LAMMPS_NS {

class FixLubrication : public Fix {
 public:
  FixLubrication(class LAMMPS *, int, char **);
  int setmask();
  void init();
  void setup(int);
  void post_force(int);
  double compute_vector(int);
  int pack_comm(int, int *, double *, int, int *);
  void unpack_comm(int, int, double *);
  double memory_usage();

  const clay::LubricationLaw &law() const { return law_; }

 private:
  // of each sphere, ghosts among them: what its films need to know
  struct State {
    clay::FilmLoad load;
    double a[3], b[3];  // accelerations by all other forces
  };
  enum { SIZE = sizeof(State) / sizeof(double) };
  struct Thin {
    clay::Film film;
    int i, j;
    double n[3];
  };  // j < 0: a wall

  void parse(int, char **);
  void seek_pairs();
  void seek_walls();
  void find_films();
  void find_wall_films();
  void add(const Thin &);
  void mass_and_inertia(int i, double &m, double &I) const;

  clay::LubricationLaw law_;
  bool given_;  // the viscosity
  bool pairs_on_, walls_on_;
  class FixMultisphere *bodies_;
  std::vector<class FixWallGran *> walls_;
  std::vector<std::pair<int, int>> pairs_;
  std::vector<std::pair<int, int>> beside_;  // spheres near a wall: which wall, which sphere
  std::vector<State> state_;
  std::vector<Thin> films_;
  bigint built_;  // time step of the neighbour lists pairs_ is of
  int nall_;
  double mine_[3];  // films of pairs, of walls, smallest gap over mean radius
};

}

#endif
#endif
