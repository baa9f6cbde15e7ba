// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file beside_stand_in.h
/// Runs liggghts-clay beside the stand-in CFD half, and reads what both tell.
#pragma once

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace test {

using Vec = std::array<double, 3>;

class BesideStandIn {
 public:
  BesideStandIn(const std::string &name, int ranks) :
    path_(std::filesystem::path(CLAYFOAM_TEST_RUNS) / name), ranks_(ranks)
  {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }

  /// Runs the script; the fluid is told by key=value. True when all went well.
  bool run(const std::string &script, const std::string &fluid)
  {
    std::ofstream(path_ / "in.lig") << script;
    setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
    setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
    const std::string command = "cd '" + path_.string() + "' && " + CLAYFOAM_MPIEXEC +
        " --map-by :OVERSUBSCRIBE --bind-to none -np " + std::to_string(ranks_) + " " + CLAYFOAM_LIGGGHTS +
        " -in in.lig -log dem.log : -np 1 " + CLAYFOAM_STAND_IN + " out=told.json " + fluid + " > out.log 2>&1";
    const int status = std::system(command.c_str());
    std::ifstream is(path_ / "out.log");
    std::ostringstream os;
    os << is.rdbuf();
    log_ = os.str();
    return status == 0;
  }

  const std::filesystem::path &path() const { return path_; }

  const std::string &log() const { return log_; }

  /// What the CFD half was told.
  nlohmann::json told() const { return nlohmann::json::parse(std::ifstream(path_ / "told.json")); }

  /// A dump of columns "id ...": step, then the columns by number. Local dumps have the
  /// body's number first.
  std::map<long, std::map<int, std::vector<double>>> dump(const std::string &file) const
  {
    std::map<long, std::map<int, std::vector<double>>> all;
    std::ifstream is(path_ / file);
    std::string line;
    long step = 0;
    bool rows = false;
    while (std::getline(is, line)) {
      if (line.rfind("ITEM: TIMESTEP", 0) == 0) {
        is >> step;
        std::getline(is, line);
        all[step];
        rows = false;
      } else if (line.rfind("ITEM: ATOMS", 0) == 0 || line.rfind("ITEM: ENTRIES", 0) == 0) rows = true;
      else if (line.rfind("ITEM:", 0) == 0) rows = false;
      else if (rows) {
        std::istringstream numbers(line);
        double id, x;
        numbers >> id;
        std::vector<double> &row = all[step][static_cast<int>(id)];
        while (numbers >> x) row.push_back(x);
      }
    }
    return all;
  }

  /// The thermo table: step, then its columns.
  std::map<long, std::vector<double>> thermo() const
  {
    std::map<long, std::vector<double>> all;
    std::ifstream is(path_ / "dem.log");
    std::string line;
    bool rows = false;
    while (std::getline(is, line)) {
      if (line.find("Step ") < 8) rows = true;
      else if (line.rfind("Loop", 0) == 0) rows = false;
      else if (rows) {
        std::istringstream numbers(line);
        double step, x;
        if (!(numbers >> step)) continue;
        std::vector<double> row;
        while (numbers >> x) row.push_back(x);
        if (!row.empty()) all[static_cast<long>(step)] = row;
      }
    }
    return all;
  }

 private:
  std::filesystem::path path_;
  int ranks_;
  std::string log_;
};

}  // namespace test
