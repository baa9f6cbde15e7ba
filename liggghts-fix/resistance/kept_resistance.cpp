// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file kept_resistance.cpp
/// Stokes resistances in files, from one run to the next.
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sys/stat.h>
#include <sstream>
#include <unistd.h>

#include "resistance/clump_drag.h"

namespace clay {
namespace {

// all that the result depends on, in metres over the largest radius
std::string keyOf(const Clump& clump, double unit)
{
  const StokesOptions o;
  std::ostringstream s;
  s << "clayFoam Stokes resistance 1: tolerance " << o.tolerance << " unknowns " << o.maxUnknowns << " frequency "
    << o.maxFrequency << " extrapolate " << o.extrapolate << " spheres " << clump.size();
  char text[100];
  for (const auto& c : clump) {
    // + 0.0: there is but one zero
    std::snprintf(text, sizeof text, "; %.9f %.9f %.9f %.9f", c.x[0] / unit + 0.0, c.x[1] / unit + 0.0,
                  c.x[2] / unit + 0.0, c.r / unit);
    s << text;
  }
  return s.str();
}

std::string fileOf(const std::string& folder, const std::string& key)
{
  std::uint64_t hash = 14695981039346656037u;  // FNV-1a
  for (unsigned char c : key) hash = (hash ^ c) * 1099511628211u;
  char text[40];
  std::snprintf(text, sizeof text, "/resistance-%016llx.txt", (unsigned long long)hash);
  return folder + text;
}

Matrix6d sized(Matrix6d R, double length)
{
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) R(i, j) *= std::pow(length, 1 + i / 3 + j / 3);
  return R;
}

bool read(const std::string& file, const std::string& key, StokesResistance& r)
{
  std::ifstream in(file);
  std::string line;
  std::size_t levels = 0;
  if (!std::getline(in, line) || line != key || !(in >> r.converged >> levels) || levels > 100) return false;
  r.levels.resize(levels);
  for (auto& l : r.levels) in >> l.frequency >> l.blobs >> l.change;
  for (int i = 0; i < 36; ++i) in >> r.R.data()[i];
  std::string end;
  return in >> end && end == "end" && r.R.allFinite() && r.R.llt().info() == Eigen::Success;
}

void makeFolders(const std::string& folder)
{
  for (std::size_t at = folder.find('/', 1);; at = folder.find('/', at + 1)) {
    ::mkdir(folder.substr(0, at).c_str(), 0777);
    if (at == std::string::npos) return;
  }
}

bool write(const std::string& folder, const std::string& file, const std::string& key, const StokesResistance& r)
{
  makeFolders(folder);
  const std::string part = file + "." + std::to_string(::getpid());
  std::ofstream out(part);
  out.precision(17);
  out << key << '\n' << r.converged << ' ' << r.levels.size() << '\n';
  for (const auto& l : r.levels) out << l.frequency << ' ' << l.blobs << ' ' << l.change << '\n';
  for (int i = 0; i < 36; ++i) out << r.R.data()[i] << (i % 6 == 5 ? '\n' : ' ');
  out << "end\n";
  out.close();
  if (out && std::rename(part.c_str(), file.c_str()) == 0) return true;
  std::remove(part.c_str());
  return false;
}

}  // namespace

StokesResistance keptResistance(const Clump& clump, const std::string& folder, std::string& from, double worth)
{
  double unit = 0;
  for (const auto& s : clump) unit = std::max(unit, s.r);
  const std::string key = keyOf(clump, unit), file = fileOf(folder, key);

  StokesResistance r;
  if (!folder.empty() && unit > 0 && read(file, key, r)) {
    from = "read from " + file;
    r.R = sized(r.R, unit);
    return r;
  }
  const auto start = std::chrono::steady_clock::now();
  r = stokesResistance(clump, Eigen::Vector3d::Zero());
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  char text[60];
  std::snprintf(text, sizeof text, "computed in %.2g s", spent.count());
  from = text;
  if (!folder.empty() && spent.count() > worth) {
    StokesResistance unitSized = r;
    unitSized.R = sized(r.R, 1 / unit);
    if (write(folder, file, key, unitSized)) from += ", kept in " + file;
  }
  return r;
}

std::string cacheFolder()
{
  if (const char* named = std::getenv("CLAYFOAM_CACHE")) {
    const std::string folder = named;
    return folder == "none" ? "" : folder;
  }
  if (const char* cache = std::getenv("XDG_CACHE_HOME"))
    if (*cache == '/') return std::string(cache) + "/clayfoam";
  if (const char* home = std::getenv("HOME"))
    if (*home == '/') return std::string(home) + "/.cache/clayfoam";
  return "";
}

}  // namespace clay
