// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <mpi.h>

#include <stdlib.h>

#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "exchange/world.h"

const clay::Half clay::programHalf = clay::Half::dem;

namespace {

std::filesystem::path started_in;

// A folder of its own for what scripts write, the same on all processors of one machine;
// they are in it while this lives, and it is removed with all that is there
class OwnFolder {
 public:
  OwnFolder()
  {
    started_in = std::filesystem::current_path();
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    char name[4096] = "";
    if (rank_ == 0) {
      const std::string wanted = (std::filesystem::temp_directory_path() / "clayfoam-tests-XXXXXX").string();
      std::strncpy(name, wanted.c_str(), sizeof name - 1);
      if (!mkdtemp(name)) name[0] = '\0';
    }
    MPI_Bcast(name, sizeof name, MPI_CHAR, 0, MPI_COMM_WORLD);
    if (!name[0]) throw std::runtime_error("the tests cannot make a folder for temporary files");
    folder_ = name;
    std::filesystem::current_path(folder_);
  }

  ~OwnFolder()
  {
    std::filesystem::current_path(started_in);
    MPI_Barrier(MPI_COMM_WORLD);
    std::error_code none;
    if (rank_ == 0) std::filesystem::remove_all(folder_, none);
  }

 private:
  int rank_ = 0;
  std::filesystem::path folder_;
};

}  // namespace

// what the scripts of tests write is not left where the tests were started
TEST(Host, scriptsWriteIntoATemporaryFolder)
{
  const std::filesystem::path here = std::filesystem::current_path();
  EXPECT_NE(here, started_in);
  EXPECT_EQ(here.parent_path(), std::filesystem::canonical(std::filesystem::temp_directory_path()));
}

int main(int argc, char **argv)
{
  MPI_Init(&argc, &argv);
  ::testing::InitGoogleTest(&argc, argv);
  int failed, any;
  {
    OwnFolder folder;
    failed = RUN_ALL_TESTS();
  }
  MPI_Allreduce(&failed, &any, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  MPI_Finalize();
  return any;
}
