// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/state_saver.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <vector>

#include "atom.h"
#include "atom_vec.h"
#include "comm.h"
#include "universe.h"
#include "update.h"
#include "write_restart.h"

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

StateSaver::StateSaver(LAMMPS *lmp, const clay::CoupleSettings &settings) :
  Pointers(lmp), folder_(std::filesystem::absolute(settings.checkpoint).lexically_normal()),
  seconds_(settings.checkpointEvery), steps_(settings.checkpointSteps), last_(0.)
{
  while (folder_.size() > 1 && folder_.back() == '/') folder_.pop_back();
}

/* ---------------------------------------------------------------------- */

void StateSaver::start() { last_ = MPI_Wtime(); }

/* ---------------------------------------------------------------------- */

bool StateSaver::due()
{
  if (update->ntimestep == update->laststep) return true;
  if (steps_) return update->ntimestep % steps_ == 0;
  // the first processor's clock counts
  int now = comm->me == 0 && MPI_Wtime() - last_ > seconds_;
  MPI_Bcast(&now, 1, MPI_INT, 0, world);
  return now;
}

/* ---------------------------------------------------------------------- */

clay::SavedPair StateSaver::write()
{
  why_.clear();
  pair_ = {0., static_cast<double>(update->ntimestep)};
  if (comm->me == 0) pair_.number = clay::newPairNumber();
  const std::string part = clay::unfinishedPair(folder_, pair_) + "/dem";
  int good = 1;
  if (comm->me == 0) try {
      clay::makeEmpty(clay::unfinishedPair(folder_, pair_));
      clay::makeEmpty(part);
    } catch (const std::runtime_error &e) {
      why_ = e.what();
      good = 0;
    }
  double told[2] = {pair_.number, double(good)};
  MPI_Bcast(told, 2, MPI_DOUBLE, 0, world);
  pair_.number = told[0];
  if (told[1] != 0.) {
    write_file(part);
    good = why_.empty();
    MPI_Bcast(&good, 1, MPI_INT, 0, world);
  } else good = 0;

  start();
  if (!good) {
    if (comm->me == 0) clay::dropPair(folder_, pair_);
    pair_.number = 0.;
  } else written_ = update->ntimestep;
  const clay::SavedPair written = pair_;
  pair_.number = 0.;
  return written;
}

/* ---------------------------------------------------------------------- */

void StateSaver::look_for_it()
{
  // the other half has finished it before it answers, but not every processor has particles
  MPI_Barrier(world);
  int there = comm->me == 0 && std::filesystem::is_directory(clay::pairFolder(folder_, {0., double(written_)}));
  MPI_Bcast(&there, 1, MPI_INT, 0, world);
  if (there && written_ >= 0) saved_ = written_;
}

std::string StateSaver::last_words() const
{
  return saved_ < 0 ? "" : "; the last saved state is that of step " + std::to_string(saved_);
}

/* ---------------------------------------------------------------------- */

void StateSaver::write_file(const std::string &part)
{
  std::string file = part + "/state";
  const int mine = atom->avec->size_restart();
  std::vector<int> atoms(comm->nprocs);
  MPI_Gather(&mine, 1, MPI_INT, atoms.data(), 1, MPI_INT, 0, world);
  WriteRestart(lmp).write(&file[0]);
  if (comm->me) return;
  try {
    check_end(file, atoms.back());
    std::ofstream about(part + "/about");
    about << "step " << update->ntimestep << "\nranks " << comm->nprocs << "\nprogram " << universe->version << '\n';
    about.flush();
    if (!about) throw std::runtime_error("cannot write " + part + "/about");
    clay::writeSums(part, pair_);
  } catch (const std::exception &e) {
    why_ = e.what();
  }
}

/* ----------------------------------------------------------------------
   LIGGGHTS does not look whether there was room on the disk: the file must
   end with the atoms of the last processor
------------------------------------------------------------------------- */

void StateSaver::check_end(const std::string &file, int atoms) const
{
  std::ifstream in(file, std::ios::binary);
  int found = -1;
  in.seekg(-std::streamoff(sizeof(int) + atoms * sizeof(double)), std::ios::end);
  in.read(reinterpret_cast<char *>(&found), sizeof found);
  if (!in || found != atoms)
    throw std::runtime_error("cannot write " + file + ": it ends too early; is the disk full?");
}
