#pragma once
// A run in time with one tolerance, measured: what it costs and what it gives at the times of comparison.
#include <string>
#include <vector>

#include "tables/study_point.hpp"

namespace ehl::program {

/// How time is integrated.
struct TimeWay {
  double rtol = 0.0;
  double longest_step = 0.0;  ///< [a/u_m]
};

/// The contact at one time: Hc, Hm, P_max, and P of every probe.
struct TimeSample {
  double T = 0.0;
  std::vector<double> values{};
};

/// NaN: not known. The seconds are those of the run in time without its steady start.
struct TimeStudyPoint : Cost {
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  TimeWay way{};
  /// complete; not-complete (it ended before, or the steady start was not found); failed (the program).
  std::string status{};
  double T = unknown;  ///< reached
  int steps = 0, cycles = 0, rejected = 0, not_solved = 0, jumps = 0;
  std::vector<double> errors{};  ///< of the quantities of a sample, against the reference, largest over the run
  std::vector<TimeSample> samples{};
  std::string reason{};
};

/// "Hc", "Hm", "P_max", "P_1", ...
std::vector<std::string> time_study_quantities(std::size_t probes);

/// The columns of the table; of a contact in SI with the times in ms. in: names of the quantities that have errors.
std::vector<Column<TimeStudyPoint>> time_study_columns(const std::vector<std::string>& quantities,
                                                       const std::optional<SiScales>& si = std::nullopt);

/// A point with its samples, for the way from one process to another, and back. errors: core::FileError: no such text.
std::string text_of(const TimeStudyPoint& point);
void read_text(const std::string& text, TimeStudyPoint& point);

/// Runs the case once. in: the case, its way; samples, how many equal parts of the end time are looked at (by the dense
/// output of the integration, so that no step is another for it), 0: none, the run is only timed.
/// errors: core::Interrupted. What does not come to its end is a status.
TimeStudyPoint measure_in_time(Case input, const TimeWay& way, int samples);

double cycles_per_step(const TimeStudyPoint& point);

/// "rtol 0.001, steps of at most 0.05".
std::string name_of_way(const TimeWay& way);

bool is_complete(const TimeStudyPoint& point);

}  // namespace ehl::program
