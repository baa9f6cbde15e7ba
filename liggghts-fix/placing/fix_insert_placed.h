/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

   fix ID group insert/placed file FILE templates T1 T2 ...
   Puts every particle of a list where the list says, clumps also as the
   list turns them.
------------------------------------------------------------------------- */

#ifdef FIX_CLASS

FixStyle(insert/placed,FixInsertPlaced)

#else

#ifndef LMP_FIX_INSERT_PLACED_H
#define LMP_FIX_INSERT_PLACED_H

#include <iosfwd>
#include <string>
#include <vector>

#include "fix.h"
#include "placing/places_file.h"

namespace LAMMPS_NS {

class FixInsertPlaced : public Fix {
 public:
  FixInsertPlaced(class LAMMPS *, int, char **);

  int setmask() { return 0; }
  void post_create();
  void write_restart(FILE *);
  void restart(char *);

  /// 0: particles placed, 1: their mass [kg].
  double compute_vector(int);

 private:
  void fail(const std::string &why);
  std::string next_lines(std::ifstream &);
  std::vector<clay::Place> parse(const std::string &text, int first);
  void check_box(const clay::Place &, class ParticleToInsert *);
  void set_arrays_of_new_fixes();
  void place();

  std::string file_;
  std::vector<class FixTemplateSphere *> templates_;
  std::vector<clay::PlaceKind> kinds_;
  bool verbose_;
  double placed_, mass_;
};

}

#endif
#endif
