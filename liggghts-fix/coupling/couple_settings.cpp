// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/couple_settings.h"

#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace clay {

namespace {

// a number that is all of the text; false when it is none
bool whole(const std::string &text, long &value)
{
  char *end = nullptr;
  value = std::strtol(text.c_str(), &end, 10);
  return !text.empty() && !*end;
}

bool yes(const std::string &key, const std::string &value)
{
  if (value != "yes" && value != "no") throw std::invalid_argument(key + " is '" + value + "'; it must be yes or no");
  return value == "yes";
}

int parse_interval(const std::string &text)
{
  const long most = 100000000;
  long value;
  if (!whole(text, value) || value < 1 || value > most)
    throw std::invalid_argument("every is '" + text + "'; it must be a whole number of DEM steps from 1 to " +
                                std::to_string(most));
  return static_cast<int>(value);
}

int parse_lag(const std::string &text, int interval)
{
  if (text == "auto") return interval / 4;
  long value;
  if (!whole(text, value) || value < 0 || value >= interval)
    throw std::invalid_argument("lag is '" + text + "'; it must be auto or a whole number of DEM steps from 0 to " +
                                std::to_string(interval - 1) + ", below every");
  return static_cast<int>(value);
}

double parse_progress(const std::string &text)
{
  char *end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end || !std::isfinite(value) || value < 0)
    throw std::invalid_argument("progress is '" + text + "'; it must be a number of seconds, 0 for no line");
  return value;
}

double parse_checkpoint_every(const std::string &text)
{
  char *end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end || !std::isfinite(value) || !(value > 0))
    throw std::invalid_argument("checkpoint_every is '" + text + "'; it must be a number of seconds above 0");
  return value;
}

int parse_checkpoint_steps(const std::string &text, int interval)
{
  long value;
  if (text == "0") return 0;
  if (!whole(text, value) || value < interval || value > 2000000000 || value % interval)
    throw std::invalid_argument("checkpoint_steps is '" + text + "'; it must be 0 or a multiple of every, " +
                                std::to_string(interval) + " DEM steps");
  return static_cast<int>(value);
}

// parse(text) with the key named in what it throws
template <class Parse>
auto named(const std::string &what, Parse parse)
{
  try {
    return parse();
  } catch (const std::invalid_argument &e) {
    throw std::invalid_argument(what + e.what());
  }
}

}  // namespace

/* ---------------------------------------------------------------------- */

CoupleSettings CoupleSettings::parse(const std::vector<std::string> &words)
{
  CoupleSettings s;
  std::string lag = "0", law, seconds, steps;
  for (std::size_t n = 0; n < words.size(); n += 2) {
    const std::string &key = words[n];
    if (n + 1 == words.size()) throw std::invalid_argument("keyword '" + key + "' needs a value");
    const std::string &value = words[n + 1];
    if (key == "every") s.interval = parse_interval(value);
    else if (key == "stats") s.stats = value;
    else if (key == "lag") lag = value;
    else if (key == "progress") s.progress = parse_progress(value);
    else if (key == "contact_limit") s.contactLimit = yes(key, value);
    else if (key == "watch") s.watch = yes(key, value);
    else if (key == "clumpDrag") s.clumpDrag = named("clumpDrag is ", [&] { return clumpDragKind(value); });
    else if (key == "shapeLaw") law = value;
    else if (key == "checkpoint") s.checkpoint = value;
    else if (key == "checkpoint_every") seconds = value;
    else if (key == "checkpoint_steps") steps = value;
    else
      throw std::invalid_argument(
          "unknown keyword '" + key +
          "'; known are every, lag, stats, progress, "
          "contact_limit, watch, clumpDrag, shapeLaw, checkpoint, checkpoint_every, checkpoint_steps");
  }
  if (s.interval < 1)
    throw std::invalid_argument("'every N' is missing; N is the number of DEM steps between two exchanges");
  s.lag = parse_lag(lag, s.interval);

  if (s.checkpoint.empty() && !(seconds.empty() && steps.empty()))
    throw std::invalid_argument("checkpoint_every and checkpoint_steps belong to checkpoint FOLDER, which is not set");
  if (!seconds.empty()) s.checkpointEvery = parse_checkpoint_every(seconds);
  if (!steps.empty()) s.checkpointSteps = parse_checkpoint_steps(steps, s.interval);

  if (s.clumpDrag == ClumpDragKind::resistance) {
    s.shapeLaw = law.empty() ? "tranCong" : law;
    named("shapeLaw: ", [&] { return clay::shapeLaw(s.shapeLaw); });
  } else if (!law.empty()) throw std::invalid_argument("shapeLaw belongs to clumpDrag resistance, which is not set");
  return s;
}

}  // namespace clay
