#pragma once
// One method of solving the case, with its measured cost and its error against the reference: a row of a study.
#include <optional>
#include <string>
#include <vector>

#include "base/column.hpp"
#include "base/si_units.hpp"
#include "core/constants.hpp"
#include "tables/study_plan.hpp"

namespace ehl::program {

/// The contact at one time. The values are Hc, Hm, P_max, and P at every probe.
struct TimeSample {
  double T = 0.0;
  std::vector<double> values{};
};

/// The films among the judged quantities of a row.
constexpr std::size_t of_Hc = 0, of_Hm = 1;

/// One quantity of a row, judged against the reference.
struct Judged {
  double deviation = core::unknown;  ///< relative; in time the largest over the run
  bool at_reference = false;         ///< the deviation is below the error of the reference
  bool front = false;                ///< on the Pareto front of deviation and seconds
};

/// A value that is not known is NaN.
struct StudyPoint {
  StudyCase variant{};
  /// converged, or complete for a run in time; stopped (the fixed number of cycles is done, but not all checks pass);
  /// not-converged, not-complete (the run ended early, or its steady start was not found); failed (an error of the
  /// program).
  std::string status{};
  double seconds = core::unknown;  ///< the least time of the repetitions; of a run in time without its steady start
  double seconds_most = core::unknown;  ///< the greatest time of the repetitions
  double peak_memory = core::unknown;   ///< [bytes]
  std::string reason{};

  int nx = 0;  ///< number of cells along x
  int ny = 0;
  double Hc = core::unknown;
  double Hm = core::unknown;
  double estimate_Hc = core::unknown;  ///< the relative discretization error that the run itself estimates
  double estimate_Hm = core::unknown;
  double residual = core::unknown;
  std::string cycles_by_level{};  ///< "6;2;2": cycles from the coarsest grid to the finest
  int attempts = 0;
  double work_units = core::unknown;  ///< work of the whole solution, in relaxations of the finest grid

  double T = core::unknown;  ///< the time that a run in time reached
  int steps = 0, cycles = 0, rejected = 0, not_solved = 0, jumps = 0;
  std::vector<TimeSample> samples{};

  std::vector<Judged> judged{};  ///< Hc, Hm; in time as the values of a sample. Empty before the judgement
  Judged of(std::size_t quantity) const { return quantity < judged.size() ? judged[quantity] : Judged{}; }
};

/// True if the solution reached its end.
bool is_complete(const StudyPoint& point);

/// Adds one more repetition. A row that failed is replaced by one that did not.
void add_repetition(const StudyPoint& again, StudyPoint& point);

/// The mean number of cycles per time step.
double cycles_per_step(const StudyPoint& point);

/// The names of the quantities of a run in time: "Hc", "Hm", "P_max", "P_1", ...
std::vector<std::string> time_study_quantities(std::size_t probes);

/// The columns of the table; the films are in nm if the contact is in SI.
std::vector<Column<StudyPoint>> study_columns(const std::optional<SiScales>& si = std::nullopt);
/// Those of runs in time; times are in ms if the contact is in SI. in: names of the quantities that are judged.
std::vector<Column<StudyPoint>> time_study_columns(const std::vector<std::string>& quantities,
                                                   const std::optional<SiScales>& si = std::nullopt);

/// Converts a point before its judgement, with its samples, to text and back, to pass it between processes. in: the
/// point, whose variant is that of the text. errors: core::FileError for another text.
std::string text_of(const StudyPoint& point);
void read_text(const std::string& text, StudyPoint& point);

}  // namespace ehl::program
