// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/value_readers.h"

#include <algorithm>
#include <cstring>

#include "compute_reduce.h"
#include "compute_slice.h"
#include "dump_custom.h"
#include "dump_local.h"
#include "fix_ave_atom.h"
#include "fix_ave_correlate.h"
#include "fix_ave_histo.h"
#include "fix_ave_spatial.h"
#include "fix_ave_time.h"
#include "fix_store_state.h"
#include "input.h"
#include "lammps.h"
#include "modify.h"
#include "output.h"
#include "variable.h"

namespace LAMMPS_NS {

namespace {

template <int>
struct Which {
};

using Names = std::vector<std::string>;

Names list(int n, char *const *names)
{
  Names all;
  for (int k = 0; k < n; k++)
    if (names[k]) all.push_back(names[k]);
  return all;
}

}  // namespace

// LIGGGHTS's styles keep to themselves what they read
template <class Style, int which, int Style::*n, char **Style::*ids>
struct Reads {
  friend Names reads(const Style &style, Which<which>) { return list(style.*n, style.*ids); }
};

#define CLAY_READS(Style, which, n, ids)                                                                               \
  Names reads(const Style &, Which<which>);                                                                            \
  template struct Reads<Style, which, &Style::n, &Style::ids>;

CLAY_READS(ComputeReduce, 0, nvalues, ids)
CLAY_READS(ComputeSlice, 0, nvalues, ids)
CLAY_READS(FixAveAtom, 0, nvalues, ids)
CLAY_READS(FixAveCorrelate, 0, nvalues, ids)
CLAY_READS(FixAveHisto, 0, nvalues, ids)
CLAY_READS(FixAveSpatial, 0, nvalues, ids)
CLAY_READS(FixAveTime, 0, nvalues, ids)
CLAY_READS(FixStoreState, 0, nvalues, ids)
CLAY_READS(DumpCustom, 0, nfix, id_fix)
CLAY_READS(DumpCustom, 1, ncompute, id_compute)
CLAY_READS(DumpCustom, 2, nvariable, id_variable)
CLAY_READS(DumpLocal, 0, nfix, id_fix)
CLAY_READS(DumpLocal, 1, ncompute, id_compute)

struct Variables {
  int n;
  char **names;
  char ***texts;
};
template <int Variable::*n, char **Variable::*names, char ***Variable::*texts>
struct Inside {
  friend Variables inside(const Variable &v) { return {v.*n, v.*names, v.*texts}; }
};
Variables inside(const Variable &);
template struct Inside<&Variable::nvar, &Variable::names, &Variable::data>;

namespace {

// names and formulas of the variables that have one; of a loop's there is no text
std::vector<std::pair<std::string, std::string>> formulas(Variable &variable)
{
  const Variables v = inside(variable);
  std::vector<std::pair<std::string, std::string>> all;
  for (int i = 0; i < v.n; i++)
    if (variable.equalstyle(i) || variable.atomstyle(i)) all.push_back({v.names[i], v.texts[i][0]});
  return all;
}

bool begins(const char *style, const char *with) { return !strncmp(style, with, strlen(with)); }

// what has values of that fix, by its own or another's name
class Known {
 public:
  explicit Known(const std::string &id) : names_{id} {}

  bool any_of(const Names &read) const
  {
    return std::any_of(read.begin(), read.end(), [this](const std::string &r) { return knows(r); });
  }
  // of those but the fix itself
  bool any_behind(const Names &read) const
  {
    return std::any_of(read.begin(), read.end(), [this](const std::string &r) { return r != names_[0] && knows(r); });
  }
  bool within(const std::string &formula) const
  {
    return std::any_of(names_.begin(), names_.end(), [&](const std::string &n) {
      for (const char *kind : {"f_", "c_", "v_"})
        if (formula.find(kind + n) != std::string::npos) return true;
      return false;
    });
  }
  // false when it was known
  bool add(const std::string &name)
  {
    if (knows(name)) return false;
    names_.push_back(name);
    return true;
  }
  bool more() const { return names_.size() > 1; }

 private:
  bool knows(const std::string &name) const { return std::find(names_.begin(), names_.end(), name) != names_.end(); }
  Names names_;
};

// true and its names when the object is one of this style
template <class Style, class Base>
bool is(const Base *object, Names &names)
{
  const Style *style = dynamic_cast<const Style *>(object);
  if (!style) return false;
  names = reads(*style, Which<0>());
  return true;
}

bool reads_it(const Compute *compute, const Known &known)
{
  Names names;
  if (is<ComputeReduce>(compute, names) || is<ComputeSlice>(compute, names)) return known.any_of(names);
  return begins(compute->style, "atom/molecule");
}

bool reads_it(const Fix *fix, const Known &known)
{
  Names names;
  // these take a fix's global values
  if (is<FixAveTime>(fix, names) || is<FixAveCorrelate>(fix, names)) return known.any_behind(names);
  return (is<FixAveAtom>(fix, names) || is<FixAveHisto>(fix, names) || is<FixAveSpatial>(fix, names) ||
          is<FixStoreState>(fix, names)) &&
      known.any_of(names);
}

bool reads_it(const Dump *dump, const Known &known)
{
  if (const DumpCustom *d = dynamic_cast<const DumpCustom *>(dump))
    return known.any_of(reads(*d, Which<0>())) || known.any_of(reads(*d, Which<1>())) ||
        known.any_of(reads(*d, Which<2>()));
  if (const DumpLocal *d = dynamic_cast<const DumpLocal *>(dump))
    return known.any_of(reads(*d, Which<0>())) || known.any_of(reads(*d, Which<1>()));
  // those that have columns of their own alone
  for (const char *style : {"xyz", "mesh/", "stl", "euler/", "decomposition/", "local/gran"})
    if (begins(dump->style, style)) return false;
  return strcmp(dump->style, "atom") != 0;
}

}  // namespace

/* ---------------------------------------------------------------------- */

ValueReaders ValueReaders::of(LAMMPS *lmp, const std::string &id)
{
  const Modify &modify = *lmp->modify;
  ValueReaders found;
  Known known(id);
  // one may stand behind another
  for (bool more = true; more;) {
    more = false;
    for (int i = 0; i < modify.ncompute; i++)
      if (reads_it(modify.compute[i], known)) more |= known.add(modify.compute[i]->id);
    for (const auto &v : formulas(*lmp->input->variable))
      if (known.within(v.second)) {
        more |= known.add(v.first);
        found.within = true;
      }
  }
  for (int i = 0; i < modify.nfix; i++) found.within |= reads_it(modify.fix[i], known);
  found.any = found.within || known.more();
  for (int i = 0; i < lmp->output->ndump; i++) found.any |= reads_it(lmp->output->dump[i], known);
  return found;
}

}  // namespace LAMMPS_NS
