// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file test_wrappers.cpp
/// Every MPI call of the host codes' libraries that takes a communicator must
/// be found in the executable, not in libmpi. Arguments: mpi.h, libraries...
#include <gtest/gtest.h>

#include <dlfcn.h>

#include <cstdio>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "exchange/world.h"

const clay::Half clay::programHalf = clay::Half::dem;

namespace {

using Names = std::set<std::string>;

std::string mpiHeader;
std::vector<std::string> hostLibraries;

std::vector<std::string> lines(const std::string& command) {
  std::vector<std::string> list;
  FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) return list;
  std::string line;
  for (int c; (c = fgetc(pipe)) != EOF;) {
    if (c != '\n') {
      line += static_cast<char>(c);
      continue;
    }
    list.push_back(line);
    line.clear();
  }
  pclose(pipe);
  return list;
}

// A library and all that it is linked with, except MPI's own
Names withDependencies(const std::string& library) {
  Names all{library};
  for (const auto& line : lines("ldd '" + library + "'")) {
    std::smatch m;
    if (std::regex_search(line, m, std::regex("=> (/\\S+)"))) all.insert(m[1]);
  }
  const std::regex ofMpi("/lib(mpi|open-rte|open-pal|pmix)[^/]*$");
  for (auto it = all.begin(); it != all.end();)
    it = std::regex_search(*it, ofMpi) ? all.erase(it) : std::next(it);
  return all;
}

Names calledBy(const std::string& library) {
  Names names;
  for (const auto& line : lines("nm -D --undefined-only '" + library + "'")) {
    std::smatch m;
    if (std::regex_search(line, m, std::regex("\\bU (MPI_\\w+)"))) names.insert(m[1]);
  }
  return names;
}

// Functions of mpi.h, and those of them that take a communicator
void readHeader(Names& all, Names& withCommunicator) {
  std::ifstream file(mpiHeader);
  std::stringstream s;
  s << file.rdbuf();
  const std::string text = s.str();
  const std::regex prototype("\\b(MPI_[A-Z]\\w+)\\s*\\(([^()]*)\\)");
  const std::regex communicator("\\bMPI_Comm\\s+\\w");
  for (std::sregex_iterator it(text.begin(), text.end(), prototype), end; it != end; ++it) {
    all.insert((*it)[1]);
    const std::string parameters = (*it)[2];
    if (std::regex_search(parameters, communicator)) withCommunicator.insert((*it)[1]);
  }
}

// True when the dynamic linker finds the call in this executable
bool confined(const std::string& name) {
  static const int here = 0;
  Dl_info mine{}, its{};
  void* symbol = dlsym(RTLD_DEFAULT, name.c_str());
  return symbol && dladdr(&here, &mine) && dladdr(symbol, &its) && its.dli_fbase == mine.dli_fbase;
}

std::string missing(const Names& names) {
  std::string list;
  for (const auto& name : names)
    if (!confined(name)) list += " " + name;
  return list;
}

class Wrappers : public testing::Test {
 protected:
  void SetUp() override {
    readHeader(all, withCommunicator);
    ASSERT_GT(withCommunicator.size(), 100u) << "mpi.h was not read: " << mpiHeader;
    // start and end take none, but belong to the wrappers as well
    for (const char* name : {"MPI_Init", "MPI_Init_thread", "MPI_Finalize"})
      withCommunicator.insert(name);
  }
  Names all, withCommunicator;
};

TEST_F(Wrappers, HoldEveryCallOfTheHostLibraries) {
  ASSERT_FALSE(hostLibraries.empty()) << "neither LIGGGHTS nor OpenFOAM was found";
  int calls = 0;
  for (const auto& host : hostLibraries) {
    int callsOfHost = 0;
    for (const auto& library : withDependencies(host)) {
      Names needed;
      for (const auto& name : calledBy(library)) {
        EXPECT_TRUE(all.count(name)) << library << " calls " << name << ", unknown to mpi.h";
        if (withCommunicator.count(name)) needed.insert(name);
      }
      EXPECT_EQ(missing(needed), "") << "called by " << library << ", without a wrapper";
      callsOfHost += static_cast<int>(needed.size());
    }
    EXPECT_GT(callsOfHost, 0) << host << " makes no MPI call: the wrong library?";
    calls += callsOfHost;
  }
  EXPECT_GT(calls, 10);
}

TEST_F(Wrappers, HoldEveryCallOfMpi) {
  // these start further programs or join foreign ones, or are handed a
  // communicator that cannot be MPI_COMM_WORLD, or are gone from MPI
  for (const char* name : {"MPI_Comm_spawn", "MPI_Comm_spawn_multiple", "MPI_Comm_accept",
                           "MPI_Comm_connect", "MPI_Errhandler_get", "MPI_Errhandler_set",
                           "MPI_Attr_get", "MPI_Attr_put", "MPI_Attr_delete"})
    withCommunicator.erase(name);
  EXPECT_EQ(missing(withCommunicator), "");
}

TEST_F(Wrappers, AreMissedWhenTheyAreNotThere) {
  EXPECT_EQ(missing({"MPI_Comm_spawn", "MPI_Send"}), " MPI_Comm_spawn");
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (argc > 1) mpiHeader = argv[1];
  for (int i = 2; i < argc; ++i) hostLibraries.push_back(argv[i]);
  return RUN_ALL_TESTS();
}
