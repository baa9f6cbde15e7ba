// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file coupling_report.h
/// What the DEM half tells of a coupled run: the progress line and dem.json.
#ifndef LMP_COUPLING_REPORT_H
#define LMP_COUPLING_REPORT_H

#include <ctime>
#include <string>
#include <utility>
#include <vector>

#include "coupling/run_measures.h"
#include "pointers.h"

namespace clay {
class DemSession;
}

namespace LAMMPS_NS {

class CouplingReport : protected Pointers {
 public:
  /// file: where dem.json goes, empty for nowhere; seconds: wall time between
  /// two progress lines, 0 for none.
  CouplingReport(class LAMMPS *lmp, const std::string &file, double seconds);

  /// Marks the start of a run.
  void start();
  /// Around a wait for the other half, whose processor time is no work.
  void wait_begins() { cpu_wait_ = std::clock(); }
  void wait_ends() { cpu_waited_ += std::clock() - cpu_wait_; }
  /// After each exchange: takes the measures, prints the line when it is due.
  void exchange(const clay::DemSession &session, bool last);
  /// Marks the end of a run and writes dem.json. wall_overlap: largest with a wall, over d.
  void finish(const clay::DemSession &session, int interval, double wall_overlap);

  /// Looks for the largest overlap there is now.
  void measure_overlap();
  /// What it was at the last look on this rank, over d, and whose it is.
  double overlap() const { return now_.depth; }
  int first() const { return now_.first; }
  int second() const { return now_.second; }

  /// A setting for dem.json.
  void setting(const std::string &name, const std::string &value) { settings_.push_back({name, value}); }

  /// A particle has come.
  void inserted() { inserted_++; }
  /// Before particles change places: counts those that LIGGGHTS drops at a border of the box.
  void places();

  /// Time when the first run began [s]; that of a run that goes on from a saved state is its file's.
  double start_time() const { return start_time_; }
  void goes_on_from(double start) { start_time_ = start; }

  /// A warning for the screen, the log and dem.json.
  void warn(const std::string &text);

 private:
  long all(long mine) const;
  void count();
  void line(const clay::DemSession &session);

  std::string file_;
  double seconds_;
  bool counted_, running_;
  std::clock_t cpu_began_, cpu_wait_, cpu_waited_;
  double cpu_;
  double began_, last_line_, wall_, output_;
  long steps_;
  long at_start_, before_;              // particles at the start of the first run, and of this one
  long inserted_, left_;                // on this rank
  long deleted_, lost_;                 // of all
  long inserted_before_, left_before_;  // of all, at the end of the last run
  std::vector<std::pair<std::string, std::string>> settings_;
  double start_time_, overlap_;
  clay::Overlap now_;  // the largest at the last exchange
  std::vector<std::string> warnings_;
};

}  // namespace LAMMPS_NS

#endif
