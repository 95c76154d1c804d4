#pragma once
// One run in time with one tolerance: its measured cost, and its results at the times of comparison.
#include <string>
#include <vector>

#include "tables/study_point.hpp"

namespace ehl::program {

/// The control of the time integration.
struct TimeVariant {
  double rtol = 0.0;
  double longest_step = 0.0;  ///< [a/u_m]
};

/// The contact at one time. The values are Hc, Hm, P_max, and P at every probe.
struct TimeSample {
  double T = 0.0;
  std::vector<double> values{};
};

/// One run; NaN: not known. The seconds are those of the run in time without its steady start.
struct TimeStudyPoint : Cost {
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  TimeVariant variant{};
  /// complete; not-complete (the run ended early, or the steady start was not found); failed (an error of the program).
  std::string status{};
  double T = unknown;  ///< the time that was reached
  int steps = 0, cycles = 0, rejected = 0, not_solved = 0, jumps = 0;
  std::vector<double> errors{};  ///< largest error over the run against the reference, for each quantity of a sample
  std::vector<TimeSample> samples{};
  std::string reason{};
};

/// The names of the quantities: "Hc", "Hm", "P_max", "P_1", ...
std::vector<std::string> time_study_quantities(std::size_t probes);

/// The columns of the table; times are in ms if the contact is in SI. in: names of the quantities that have errors.
std::vector<Column<TimeStudyPoint>> time_study_columns(const std::vector<std::string>& quantities,
                                                       const std::optional<SiScales>& si = std::nullopt);

/// Converts a point with its samples to text and back, to pass it between processes. errors:
/// core::FileError for another text.
std::string text_of(const TimeStudyPoint& point);
void read_text(const std::string& text, TimeStudyPoint& point);

/// Runs the case once. in: the case; its tolerances; samples: the number of equal intervals of comparison, 0: the run
/// is only timed. The samples come from the dense output of the integrator and do not change its steps.
/// errors: core::Interrupted. A run that ends early is not an error but a status.
TimeStudyPoint measure_in_time(Case input, const TimeVariant& variant, int samples);

/// The mean number of cycles per time step.
double cycles_per_step(const TimeStudyPoint& point);

/// The name of a run, "rtol 0.001, steps of at most 0.05".
std::string name_of_variant(const TimeVariant& variant);

/// True if the run reached its end.
bool is_complete(const TimeStudyPoint& point);

}  // namespace ehl::program
