// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "placing/places_file.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "script/values.h"

namespace clay {
namespace {

// a line of the file, cut into words
class Line {
 public:
  Line(const std::string& text, const std::string& file, int number) : file_(file), number_(number)
  {
    std::istringstream in(text);
    for (std::string w; in >> w && w[0] != '#';) words_.push_back(w);
  }

  const std::vector<std::string>& words() const { return words_; }

  [[noreturn]] void fail(const std::string& why) const
  {
    throw std::runtime_error("file " + file_ + ", line " + std::to_string(number_) + ": " + why);
  }

  double number(std::size_t i, const char* what) const
  {
    return read([&] { return clay::number(what, words_[i]); });
  }

  double positive(std::size_t i, const char* what) const
  {
    return read([&] { return clay::positiveNumber(what, words_[i]); });
  }

 private:
  template <class Read>
  double read(Read value) const
  {
    try {
      return value();
    } catch (const std::invalid_argument& e) {
      fail(e.what());
    }
  }

  const std::string& file_;
  int number_;
  std::vector<std::string> words_;
};

int kindOf(const Line& line, const std::vector<PlaceKind>& kinds)
{
  const std::string& w = line.words().front();
  std::string known;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    if (w == kinds[k].name || w == std::to_string(k + 1)) return static_cast<int>(k);
    known += (k ? ", " : "") + std::to_string(k + 1) + " = " + kinds[k].name;
  }
  line.fail("template '" + w + "' is not known; known are " + known);
}

}  // namespace

std::vector<Place> readPlaces(const std::string& text, const std::string& file, const std::vector<PlaceKind>& kinds,
                              int first)
{
  std::vector<Place> places;
  std::istringstream in(text);
  int number = first - 1;
  for (std::string row; std::getline(in, row);) {
    const Line line(row, file, ++number);
    const std::size_t n = line.words().size();
    if (n == 0) continue;

    Place p;
    p.line = number;
    p.kind = kindOf(line, kinds);
    const bool clump = kinds[p.kind].clump;
    if (clump ? n != 8 : n != 4 && n != 5)
      line.fail(std::to_string(n) + " words; needed are " +
                (clump ? "8: template x y z q0 q1 q2 q3" : "4 or 5: template x y z [radius]"));
    for (int d = 0; d < 3; ++d) p.x[d] = line.number(1 + d, "a coordinate");
    if (clump) {
      double norm = 0;
      for (int d = 0; d < 4; ++d) {
        p.q[d] = line.number(4 + d, "a part of the quaternion");
        norm += p.q[d] * p.q[d];
      }
      norm = std::sqrt(norm);
      if (!(std::abs(norm - 1) < 1e-6)) {
        std::ostringstream says;
        says << "the quaternion has length " << norm << ": 1 is needed";
        line.fail(says.str());
      }
      for (double& c : p.q) c /= norm;
    } else if (n == 5) {
      p.radius = line.positive(4, "the radius");
    }
    places.push_back(p);
  }
  return places;
}

}  // namespace clay
