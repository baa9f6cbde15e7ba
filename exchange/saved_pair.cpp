// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/saved_pair.h"

#include <zlib.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace clay {

namespace fs = std::filesystem;

namespace {

constexpr const char* sumsName = "sums";

std::string firstLine(const SavedPair& pair) {
  char s[64];
  std::snprintf(s, sizeof s, "pair %.0f step %.0f", pair.number, pair.step);
  return s;
}

// "checksum size name", the name from that folder on
std::string line(const fs::path& file, const fs::path& folder) {
  std::ifstream in(file, std::ios::binary);
  std::vector<char> part(1 << 20);
  uLong sum = 0;
  std::uintmax_t size = 0;
  while (in.read(part.data(), static_cast<std::streamsize>(part.size())), in.gcount() > 0) {
    sum = crc32_z(sum, reinterpret_cast<const Bytef*>(part.data()),
                  static_cast<z_size_t>(in.gcount()));
    size += static_cast<std::uintmax_t>(in.gcount());
  }
  if (!in.eof()) throw std::runtime_error("cannot read " + file.string());
  char s[48];
  std::snprintf(s, sizeof s, "%08lx %ju ", sum, size);
  return s + file.lexically_relative(folder).string();
}

std::vector<fs::path> files(const fs::path& folder) {
  std::vector<fs::path> all;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().filename() != sumsName) all.push_back(entry.path());
  std::sort(all.begin(), all.end());
  return all;
}

bool isPair(const std::string& name) {
  return name.size() >= 9 &&
         std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isdigit(c); });
}

}  // namespace

std::string pairFolder(const std::string& folder, const SavedPair& pair) {
  char s[32];
  std::snprintf(s, sizeof s, "/%09.0f", pair.step);
  return folder + s;
}

std::string unfinishedPair(const std::string& folder, const SavedPair& pair) {
  return pairFolder(folder, pair) + ".part";
}

double newPairNumber() {
  std::random_device random;
  const std::uint64_t high = random(), low = random();
  return pairNumber(high << 32 | low);
}

double pairNumber(std::uint64_t random) { return static_cast<double>(random >> 11 | 1); }

void makeEmpty(const std::string& folder) {
  try {
    fs::remove_all(folder);
    fs::create_directories(folder);
  } catch (const fs::filesystem_error& e) {
    throw std::runtime_error("cannot make folder " + folder + ": " + e.code().message());
  }
}

void writeSums(const std::string& folder, const SavedPair& pair) {
  const fs::path name = fs::path(folder) / sumsName;
  std::ofstream out(name);
  out << firstLine(pair) << '\n';
  for (const auto& file : files(folder)) out << line(file, folder) << '\n';
  out.flush();
  if (!out) throw std::runtime_error("cannot write " + name.string());
}

std::string damage(const std::string& folder, const SavedPair& pair) {
  std::ifstream in(fs::path(folder) / sumsName);
  std::string text, name;
  if (!std::getline(in, text)) return folder + ": has no sums";
  if (text != firstLine(pair)) return folder + ": is of " + text + ", not of " + firstLine(pair);
  while (std::getline(in, text)) {
    const auto at = text.find(' ', text.find(' ') + 1);
    if (at == std::string::npos) return folder + ": sums is torn";
    const fs::path file = fs::path(folder) / text.substr(at + 1);
    if (!fs::is_regular_file(file)) return file.string() + ": is missing";
    if (line(file, folder) != text) return file.string() + ": is not what was written";
  }
  return "";
}

void completePair(const std::string& folder, const SavedPair& pair, int kept) {
  const std::string whole = pairFolder(folder, pair);
  std::error_code error;
  // one of that step, by a run that went on from before it
  fs::remove_all(whole, error);
  fs::rename(unfinishedPair(folder, pair), whole, error);
  if (error) throw std::runtime_error("cannot make " + whole + ": " + error.message());

  std::vector<std::string> pairs;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (isPair(name) && std::stod(name) <= pair.step) pairs.push_back(name);
  }
  std::sort(pairs.begin(), pairs.end(),
            [](const auto& a, const auto& b) { return std::stod(a) < std::stod(b); });
  for (std::size_t n = 0; n + static_cast<std::size_t>(kept) < pairs.size(); ++n)
    fs::remove_all(fs::path(folder) / pairs[n], error);
}

void dropPair(const std::string& folder, const SavedPair& pair) {
  std::error_code error;
  fs::remove_all(unfinishedPair(folder, pair), error);
}

}  // namespace clay
