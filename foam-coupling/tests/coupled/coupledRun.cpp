// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coupledRun.h"

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace fs = std::filesystem;

namespace {

std::string slurp(const fs::path& file) {
  std::ifstream is(file);
  std::ostringstream os;
  os << is.rdbuf();
  return os.str();
}

nlohmann::json readJson(const fs::path& file) {
  std::ifstream is(file);
  if (!is) throw std::runtime_error("no file " + file.string());
  return nlohmann::json::parse(is);
}

}  // namespace

CoupledRun::CoupledRun(const std::string& name) : path_(fs::path(CLAYFOAM_TEST_RUNS) / name) {
  fs::remove_all(path_);
  fs::create_directories(path_.parent_path());
  fs::copy(CLAYFOAM_TEST_BOX, path_, fs::copy_options::recursive);
  entries_ =
      "x0 0; y0 0; z0 0; x1 0.05; y1 0.05; z1 0.1; nx 5; ny 5; nz 10;\n"
      "sideType wall; bottomType wall; topType wall;\n"
      "sideU noSlip; bottomU noSlip; topU noSlip;\n"
      "sideP zeroGradient; bottomP zeroGradient; topP zeroGradient;\n"
      "U0 (0 0 0); deltaT 1e-3; writeInterval 1e9; adjust yes; nu 8.94e-7; rho 1000;\n";
}

CoupledRun& CoupledRun::box(const std::string& entries) {
  entries_ += entries + "\n";
  return *this;
}

CoupledRun& CoupledRun::properties(const std::string& body) {
  properties_ = body;
  return *this;
}

CoupledRun& CoupledRun::dem(const std::string& key, const std::string& value) {
  dem_[key] = value;
  return *this;
}

CoupledRun& CoupledRun::dem(const std::string& key, double value) {
  std::ostringstream os;
  os.precision(17);
  os << value;
  return dem(key, os.str());
}

CoupledRun& CoupledRun::ranks(int dem, int cfd) {
  demRanks_ = dem;
  cfdRanks_ = cfd;
  return *this;
}

CoupledRun& CoupledRun::edit(const std::string& file, const std::string& from,
                             const std::string& to) {
  std::string text = slurp(path_ / file);
  const auto at = text.find(from);
  if (at == std::string::npos) throw std::runtime_error(file + " has no " + from);
  std::ofstream(path_ / file) << text.replace(at, from.size(), to);
  return *this;
}

int CoupledRun::shell(const std::string& command, const std::string& logName) {
  const auto log = path_ / logName;
  const int status = std::system((command + " > " + log.string() + " 2>&1 < /dev/null").c_str());
  log_ = slurp(log);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

void CoupledRun::mesh() {
  std::ofstream(path_ / "parameters") << entries_;
  const std::string tool = "WM_PROJECT_DIR=" CLAYFOAM_OPENFOAM_DIR " ";
  if (shell(tool + "blockMesh -case " + path_.string(), "log.blockMesh"))
    throw std::runtime_error("blockMesh failed:\n" + log_);
  if (cfdRanks_ > 1 &&
      shell(tool + "decomposePar -force -case " + path_.string(), "log.decomposePar"))
    throw std::runtime_error("decomposePar failed:\n" + log_);
}

int CoupledRun::run() {
  std::ofstream(path_ / "parameters") << entries_;
  std::ofstream(path_ / "constant" / "couplingProperties")
      << "FoamFile\n{\n    version 2.0;\n    format ascii;\n    class dictionary;\n"
         "    object couplingProperties;\n}\n"
      << properties_ << "\n";
  std::ostringstream os;
  os << "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 " CLAYFOAM_MPIEXEC
        " --map-by :OVERSUBSCRIBE -np "
     << demRanks_ << " " CLAYFOAM_STANDIN " out=" << (path_ / "dem.json").string();
  for (const auto& [key, value] : dem_) os << " " << key << "=" << value;
  os << " : -np " << cfdRanks_ << " " CLAYFOAM_PROGRAM " -case " << path_.string();
  return shell(os.str(), "log.coupled");
}

nlohmann::json CoupledRun::cfd() const { return readJson(path_ / "cfd.json"); }

nlohmann::json CoupledRun::history() const { return readJson(path_ / "dem.json"); }

double CoupledRun::lastVelocity(int component) const {
  return history().back()["velocity"][static_cast<std::size_t>(component)];
}

std::string CoupledRun::written(const std::string& field) const {
  double latest = -1;
  fs::path file;
  for (const auto& entry : fs::directory_iterator(path_)) {
    char* end = nullptr;
    const std::string name = entry.path().filename().string();
    const double time = std::strtod(name.c_str(), &end);
    if (*end == '\0' && time > latest && fs::exists(entry.path() / field)) {
      latest = time;
      file = entry.path() / field;
    }
  }
  return slurp(file);
}

std::vector<double> CoupledRun::scalars(const std::string& field) const {
  const std::string text = written(field);
  const auto at = text.find("List<scalar>");
  if (at == std::string::npos) throw std::runtime_error("no scalars " + field);
  std::istringstream is(text.substr(at + 12));
  std::size_t count = 0;
  is >> count;
  is.ignore(1000, '(');
  std::vector<double> all(count);
  for (double& x : all) is >> x;
  if (!is) throw std::runtime_error("cannot read " + field);
  return all;
}

double CoupledRun::onPatch(const std::string& field, const std::string& patch) const {
  const std::string text = written(field);
  auto at = text.find(patch, text.find("boundaryField"));
  at = text.find(" value ", at);
  if (at == std::string::npos) throw std::runtime_error("no value of " + field + " on " + patch);
  std::istringstream is(text.substr(at + 7));
  std::string kind;
  is >> kind;
  double sum = 0;
  std::size_t count = 1;
  if (kind == "uniform") {
    is >> sum;
  } else {
    is >> kind >> count;
    is.ignore(1000, '(');
    for (std::size_t i = 0; i < count; ++i) {
      double x;
      is >> x;
      sum += x;
    }
  }
  if (!is) throw std::runtime_error("cannot read " + field + " on " + patch);
  return sum / static_cast<double>(count);
}

std::vector<std::array<double, 3>> CoupledRun::values(const std::string& field) const {
  const std::string text = written(field);
  auto at = text.find("internalField");
  if (at == std::string::npos) throw std::runtime_error("no field " + field);
  const bool uniform = text.compare(text.find_first_not_of(' ', at + 13), 7, "uniform") == 0;
  at = text.find('(', at);
  long count = 1;
  std::istringstream is(text.substr(uniform ? at : at + 1));
  if (!uniform) {
    const auto last = text.find_last_not_of(" \n", at - 1);
    const auto before = text.find_last_not_of("0123456789", last);
    count = std::stol(text.substr(before + 1));
  }
  std::vector<std::array<double, 3>> all(static_cast<std::size_t>(count));
  for (auto& value : all) {
    is.ignore(1000, '(');
    for (double& x : value) is >> x;
    is.ignore(1000, ')');
  }
  return all;
}

std::array<double, 3> CoupledRun::meanOfField(const std::string& field) const {
  const auto all = values(field);
  std::array<double, 3> mean{};
  for (const auto& value : all)
    for (std::size_t c = 0; c < 3; ++c) mean[c] += value[c] / static_cast<double>(all.size());
  return mean;
}

CoupledRun smallColumn(const std::string& name) {
  CoupledRun run(name);
  run.box(
      "x1 0.02; y1 0.02; z1 0.04; nx 2; ny 2; nz 4; topType patch; topU zeroGradient;"
      "topP fixedValue;");
  run.dem("hi", "0.02,0.02,0.04").dem("from", "0,0,0.02").dem("count", "4,4,4");
  run.dem("to", "0.02,0.02,0.04").dem("gravity", "0,0,-9.81").dem("steps", 200);
  return run;
}
