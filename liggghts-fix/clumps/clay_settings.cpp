// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "clumps/clay_settings.h"

#include <climits>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "error.h"
#include "lammps.h"
#include "pointers.h"
#include "script/values.h"

using namespace LAMMPS_NS;

namespace {

class Reader {
 public:
  Reader(LAMMPS *lmp, int narg, char **arg) : lmp_(lmp), narg_(narg), arg_(arg), at_(3) {}

  bool more() const { return at_ < narg_; }

  std::string word(const std::string &what)
  {
    if (!more()) fail(what + " is missing at the end of the command");
    return arg_[at_++];
  }

  double number(const std::string &what)
  {
    return read([&] { return clay::number(what, word(what)); });
  }

  double positive(const std::string &what)
  {
    return read([&] { return clay::positiveNumber(what, word(what)); });
  }

  int count(const std::string &what)
  {
    return static_cast<int>(read([&] { return clay::wholeNumber(what, word(what), 1, INT_MAX); }));
  }

  bool choice(const std::string &what, const char *no, const char *yes)
  {
    return read([&] { return clay::choice(what, word(what), no, yes); });
  }

  // sphere of a generic clump: x y z radius and P or N
  clay::ClumpSphere sphere(const std::string &what)
  {
    clay::ClumpSphere s;
    for (int d = 0; d < 3; d++) s.x[d] = number(what + ", a coordinate");
    s.r = positive(what + ", its radius");
    s.positive = choice(what + ", its charge", "N", "P");
    return s;
  }

  [[noreturn]] void fail(const std::string &why)
  {
    lmp_->error->all(FLERR, ("Fix particletemplate/clay (id " + std::string(arg_[0]) + "): " + why).c_str());
    std::abort();
  }

 private:
  // what is refused ends the run
  template <class Read>
  auto read(Read value) -> decltype(value())
  {
    try {
      return value();
    } catch (const std::invalid_argument &e) {
      fail(e.what());
    }
  }

  LAMMPS *lmp_;
  int narg_;
  char **arg_;
  int at_;
};

}

// an atom type for each sphere, by its sign or as it was given
static void give_types(ClaySettings &s, Reader &in)
{
  if (s.types.empty()) {
    for (const auto &sphere : s.clump) s.types.push_back(sphere.positive ? s.positive : s.negative);
    return;
  }
  if (s.types.size() != s.clump.size())
    in.fail("sphere_types are " + std::to_string(s.types.size()) + "; the clump has " + std::to_string(s.clump.size()) +
            " spheres, and each needs one");
}

ClaySettings LAMMPS_NS::read_clay_settings(LAMMPS *lmp, int narg, char **arg)
{
  Reader in(lmp, narg, arg);
  ClaySettings s;
  clay::PlateShape plate;
  double height = 0;

  s.shape = in.word("the shape");
  const bool generic = s.shape == "generic";
  if (!generic && s.shape != "illite" && s.shape != "kaolinite")
    in.fail("shape is '" + s.shape + "': choose illite, kaolinite or generic");

  while (in.more()) {
    const std::string key = in.word("keyword");
    if (key == "seed") s.seed = in.word(key);
    else if (key == "density") s.density = in.positive(key);
    else if (key == "type") s.type = in.count(key);
    else if (key == "atom_types") {
      s.positive = in.count("atom_types, of positive spheres");
      s.negative = in.count("atom_types, of negative spheres");
    } else if (key == "sphere_types") {
      const int n = in.count(key + ", their number");
      for (int i = 0; i < n; i++) s.types.push_back(in.count("sphere_types, of sphere " + std::to_string(i + 1)));
    } else if (key == "volume") s.overlaps_once = in.choice(key, "sum", "union");
    else if (key == "verbose") s.verbose = in.choice(key, "no", "yes");
    else if (key == "region" || key == "additional_group" || key == "volume_limit") {
      s.passed_on.push_back(key);
      s.passed_on.push_back(in.word(key));
    } else if (!generic && key == "radius") plate.radius = in.positive(key);
    else if (!generic && key == "spacing") plate.spacing = in.positive(key);
    else if (!generic && key == "layer_spacing") plate.layerSpacing = in.positive(key);
    else if (!generic && key == "height") height = in.positive(key);
    else if (!generic && key == "layers") plate.layers = in.count(key);
    else if (generic && key == "spheres") {
      const int n = in.count(key);
      for (int i = 0; i < n; i++) s.clump.push_back(in.sphere("sphere " + std::to_string(i + 1)));
    } else in.fail("unknown keyword '" + key + "'" + (generic ? " for a generic clump" : ""));
  }

  if (s.seed.empty()) in.fail("'seed' is missing: a prime number above 10000 is needed");
  if (s.density == 0) in.fail("'density' is missing (kg/m3)");
  if (s.type == 0) in.fail("'type' is missing: the clump type, 1 for the first template");
  if (s.positive == 0 && s.types.empty())
    in.fail("'atom_types' is missing: the atom types of positive and negative spheres");
  if (s.positive != 0 && !s.types.empty()) in.fail("'atom_types' and 'sphere_types' say the same thing: give one");

  if (generic) {
    if (s.clump.size() < 2) in.fail("'spheres' is missing or below 2: a clump has at least two spheres");
    give_types(s, in);
    return s;
  }
  if (plate.radius == 0) in.fail("'radius' of the spheres is missing (m)");
  if (plate.spacing == 0) plate.spacing = 2 * plate.radius;
  if (height > 0 && plate.layerSpacing > 0) in.fail("'height' and 'layer_spacing' say the same thing: give one");
  if (height > 0) {
    if (plate.layers < 2 || height <= 2 * plate.radius) {
      std::ostringstream why;
      why << "height is " << height << " with " << plate.layers << " layer(s): it must exceed the spheres' diameter, "
          << 2 * plate.radius;
      in.fail(why.str());
    }
    plate.layerSpacing = (height - 2 * plate.radius) / (plate.layers - 1);
  }
  if (plate.layerSpacing == 0) plate.layerSpacing = plate.radius;
  s.clump = s.shape == "illite" ? clay::illitePlate(plate) : clay::kaolinitePlate(plate);
  give_types(s, in);
  return s;
}
