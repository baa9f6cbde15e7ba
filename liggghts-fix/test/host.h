// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file host.h
/// A LIGGGHTS within a test: commands in, atoms out.
#pragma once

#include <mpi.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "atom.h"
#include "fix_multisphere.h"
#include "force.h"
#include "input.h"
#include "lammps.h"
#include "modify.h"
#include "driver/register_styles.h"

namespace test {

/// How many processors this program runs on.
inline int processors()
{
  int n;
  MPI_Comm_size(MPI_COMM_WORLD, &n);
  return n;
}

struct Atom {
  int tag, type, body;
  double x[3], v[3], f[3], torque[3], radius, rmass, density, weight;
};

class Host {
 public:
  explicit Host(MPI_Comm comm = MPI_COMM_WORLD) : comm_(comm)
  {
    static const char *words[] = {"test", "-screen", "/dev/null", "-log", "none"};
    for (const char *w : words) words_.push_back(const_cast<char *>(w));
    // LIGGGHTS complains of its own contact models when it is made a second time
    std::streambuf *errors = std::cerr.rdbuf(nullptr);
    lmp.reset(new LAMMPS_NS::LAMMPS(static_cast<int>(words_.size()), words_.data(), comm));
    std::cerr.rdbuf(errors);
    LAMMPS_NS::register_clay_styles(lmp.get());
  }

  /// Runs a script, line by line.
  void operator()(const std::string &script)
  {
    std::istringstream in(script);
    for (std::string line; std::getline(in, line);)
      if (!line.empty()) lmp->input->one(line.c_str());
  }

  LAMMPS_NS::FixMultisphere *multisphere()
  {
    return static_cast<LAMMPS_NS::FixMultisphere *>(lmp->modify->find_fix_style("multisphere", 0));
  }

  LAMMPS_NS::Fix *fix(const std::string &id) { return lmp->modify->find_fix_id(id.c_str()); }

  /// All atoms of all processors, by tag.
  std::vector<Atom> atoms()
  {
    LAMMPS_NS::Atom &a = *lmp->atom;
    LAMMPS_NS::FixMultisphere *ms = multisphere();
    std::vector<Atom> mine(a.nlocal);
    for (int i = 0; i < a.nlocal; i++) {
      Atom &o = mine[i];
      o.tag = a.tag[i];
      o.type = a.type[i];
      o.body = ms ? ms->belongs_to(i) : -1;
      o.radius = a.radius[i];
      o.rmass = a.rmass[i];
      o.density = a.density[i];
      o.weight = ms ? ms->get_volumeweight()->vector_atom[i] : 1.0;
      for (int d = 0; d < 3; d++) {
        o.x[d] = a.x[i][d];
        o.v[d] = a.v[i][d];
        o.f[d] = a.f[i][d];
        o.torque[d] = a.torque_flag ? a.torque[i][d] : 0.0;
      }
    }
    int size, bytes = static_cast<int>(mine.size() * sizeof(Atom));
    MPI_Comm_size(comm_, &size);
    std::vector<int> counts(size), from(size, 0);
    MPI_Allgather(&bytes, 1, MPI_INT, counts.data(), 1, MPI_INT, comm_);
    for (int r = 1; r < size; r++) from[r] = from[r - 1] + counts[r - 1];
    std::vector<Atom> all((from.back() + counts.back()) / sizeof(Atom));
    MPI_Allgatherv(mine.data(), bytes, MPI_BYTE, all.data(), counts.data(), from.data(), MPI_BYTE, comm_);
    std::sort(all.begin(), all.end(), [](const Atom &p, const Atom &q) { return p.tag < q.tag; });
    return all;
  }

  std::unique_ptr<LAMMPS_NS::LAMMPS> lmp;

 private:
  MPI_Comm comm_;
  std::vector<char *> words_;
};

/// Start of every script: a box of atom types 1 and 2 with soft contacts.
inline std::string opening(const std::string &boundary, const std::string &box)
{
  return "atom_style granular\natom_modify map array\nnewton off\nboundary " + boundary +
      "\nunits si\ncommunicate single vel yes\nprocessors * * *\n"
      "region box block " +
      box +
      " units box\ncreate_box 2 box\n"
      "neighbor 0.0005 bin\nneigh_modify delay 0\n";
}

inline std::string material(const std::string &style)
{
  return "fix m1 all property/global youngsModulus peratomtype 5e6 5e6\n"
         "fix m2 all property/global poissonsRatio peratomtype 0.25 0.25\n"
         "fix m3 all property/global coefficientRestitution peratomtypepair 2 0.3 0.3 0.3 0.3\n"
         "fix m4 all property/global coefficientFriction peratomtypepair 2 0.5 0.5 0.5 0.5\n"
         "fix m5 all property/global characteristicVelocity scalar 0.1\n"
         "pair_style hybrid/overlay gran model hooke tangential history " +
      style + "\npair_coeff * * gran\n";
}

/// Clumps of both kinds, n of them, at random in region `ins`.
inline std::string clumps(int n, const std::string &more = "")
{
  return "fix ill all particletemplate/clay illite seed 15485863 type 1 atom_types 1 2 radius 1e-3 density 2600 " +
      more +
      "\nfix kao all particletemplate/clay kaolinite seed 15485867 type 2 atom_types 1 2 radius 1e-3 density 2600 " +
      more +
      "\nfix pdd all particledistribution/discrete 32452843 2 ill 0.5 kao 0.5\n"
      "fix ms all multisphere\n"
      "fix ins all insert/pack seed 49979687 distributiontemplate pdd insert_every once overlapcheck yes "
      "orientation random all_in yes maxattempt 400 vel constant 0 0 0 region ins particles_in_region " +
      std::to_string(n) + " ntry_mc 10000\n";
}

}  // namespace test
