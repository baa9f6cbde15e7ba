// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file coupledRun.h
/// Runs clayFoam on a box of cells beside the stand-in DEM half.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

/// A coupled run in a folder of its own.
class CoupledRun {
 public:
  /// Makes the folder from the template box.
  explicit CoupledRun(const std::string& name);

  /// Sets entries of the case's file "parameters" (later ones win).
  CoupledRun& box(const std::string& entries);
  /// The body of constant/couplingProperties.
  CoupledRun& properties(const std::string& body);
  /// An argument key=value of the stand-in DEM half.
  CoupledRun& dem(const std::string& key, const std::string& value);
  CoupledRun& dem(const std::string& key, double value);
  /// Ranks of either half.
  CoupledRun& ranks(int dem, int cfd);
  /// Replaces text in a file of the case.
  CoupledRun& edit(const std::string& file, const std::string& from, const std::string& to);

  /// Meshes (and decomposes) the box.
  void mesh();
  /// Runs both halves; returns mpirun's exit status.
  int run();
  int meshAndRun() {
    mesh();
    return run();
  }

  /// What both halves printed.
  const std::string& log() const { return log_; }
  /// Whether it holds the text.
  bool says(const std::string& text) const { return log_.find(text) != std::string::npos; }
  /// cfd.json of the last run.
  nlohmann::json cfd() const;
  /// The stand-in's history: mean velocity and height of spheres at each exchange.
  nlohmann::json history() const;
  /// z velocity at the last exchange [m/s].
  double lastVelocity(int component = 2) const;
  /// A written vector field of the last time, cell by cell (one value if uniform).
  std::vector<std::array<double, 3>> values(const std::string& field) const;
  /// The same of a scalar field that is not uniform.
  std::vector<double> scalars(const std::string& field) const;
  /// Mean over the cells of a written vector field of the last time.
  std::array<double, 3> meanOfField(const std::string& field) const;
  /// A scalar field's mean value on a patch, at the last time.
  double onPatch(const std::string& field, const std::string& patch) const;
  const std::filesystem::path& path() const { return path_; }

 private:
  /// The text of a written field of the last time.
  std::string written(const std::string& field) const;
  int shell(const std::string& command, const std::string& logName);

  std::filesystem::path path_;
  std::string entries_, properties_, log_;
  std::map<std::string, std::string> dem_;
  int demRanks_ = 1, cfdRanks_ = 1;
};

/// A small column with spheres in its upper half, that runs well as it is.
CoupledRun smallColumn(const std::string& name);
