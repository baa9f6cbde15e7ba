// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "clumps/script_gravity.h"

#include <cstring>

#include "fix_gravity.h"
#include "input.h"
#include "modify.h"
#include "variable.h"

using namespace LAMMPS_NS;

namespace {

// what only the family of fix gravity may see
struct Inside : FixGravity {
  // names of the variables in place of its numbers, null for none
  static std::vector<char *> names(FixGravity *g)
  {
    return {g->*&Inside::mstr, g->*&Inside::vstr, g->*&Inside::pstr, g->*&Inside::tstr,
            g->*&Inside::xstr, g->*&Inside::ystr, g->*&Inside::zstr};
  }
  static std::vector<double *> numbers(FixGravity *g)
  {
    return {&(g->*&Inside::magnitude), &(g->*&Inside::vert), &(g->*&Inside::phi), &(g->*&Inside::theta),
            &(g->*&Inside::xdir),      &(g->*&Inside::ydir), &(g->*&Inside::zdir)};
  }
  static void work_out(FixGravity *g) { (g->*&Inside::set_acceleration)(); }
};

}  // namespace

/* ---------------------------------------------------------------------- */

void ScriptGravity::find()
{
  fixes_.clear();
  for (int i = 0; i < modify->nfix; i++)
    if (FixGravity *g = dynamic_cast<FixGravity *>(modify->fix[i])) fixes_.push_back(g);
}

/* ---------------------------------------------------------------------- */

void ScriptGravity::evaluate()
{
  for (FixGravity *g : fixes_) {
    const std::vector<char *> names = Inside::names(g);
    const std::vector<double *> numbers = Inside::numbers(g);
    bool any = false;
    for (size_t n = 0; n < names.size(); n++) {
      const int found = names[n] ? input->variable->find(names[n]) : -1;
      if (found < 0) continue;  // fix gravity itself says so
      if (!any) modify->clearstep_compute();
      *numbers[n] = input->variable->compute_equal(found);
      any = true;
    }
    if (any) Inside::work_out(g);
  }
}

/* ---------------------------------------------------------------------- */

bool ScriptGravity::changes() const
{
  for (FixGravity *g : fixes_)
    for (const char *name : Inside::names(g))
      if (name) return true;
  return false;
}

bool ScriptGravity::differs(int group) const
{
  for (const FixGravity *g : fixes_)
    if (g->igroup != 0 && g->igroup != group) return true;
  return changes();
}

/* ---------------------------------------------------------------------- */

clay::GroupGravity ScriptGravity::now() const
{
  clay::GroupGravity all;
  for (FixGravity *g : fixes_) {
    std::array<double, 3> one;
    g->get_gravity(one.data());
    all.add(g->groupbit, one);
  }
  return all;
}
