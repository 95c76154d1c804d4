#pragma once
// One way to solve the case, measured: what it costs and, beside the reference, how wrong it is.
#include <limits>
#include <optional>
#include <string>

#include "base/column.hpp"
#include "base/si_units.hpp"
#include "tables/study_plan.hpp"

namespace ehl::program {

/// What a solution took, of several repetitions; NaN: not known.
struct Cost {
  double seconds = std::numeric_limits<double>::quiet_NaN();       ///< the least of the repetitions
  double seconds_most = std::numeric_limits<double>::quiet_NaN();  ///< the most
  double peak_memory = std::numeric_limits<double>::quiet_NaN();   ///< [bytes]
};

/// One more repetition.
void add_repetition(const Cost& again, Cost& cost);

/// NaN: not known.
struct StudyPoint : Cost {
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  StudyCase way{};
  int nx = 0;  ///< cells
  int ny = 0;
  /// converged; stopped (the fixed number of cycles is done and the checks are not content); not-converged; failed (the
  /// program).
  std::string status{};
  double Hc = unknown;
  double Hm = unknown;
  double deviation_Hc = unknown;  ///< from the reference, relative
  double deviation_Hm = unknown;
  double estimate_Hc = unknown;  ///< of its discretization error, by the run itself, relative
  double estimate_Hm = unknown;
  double residual = unknown;
  std::string cycles_by_level{};  ///< "6;2;2": from the first grid to the finest
  int attempts = 0;
  double work_units = unknown;   ///< of the whole solution, in units of the finest grid
  bool at_reference_Hc = false;  ///< the error is below that of the reference
  bool at_reference_Hm = false;
  bool front_Hc = false;  ///< nothing cheaper is as accurate
  bool front_Hm = false;
  std::string reason{};
};

/// The columns of the table; of a contact in SI with the films in nm.
std::vector<Column<StudyPoint>> study_columns(const std::optional<SiScales>& si = std::nullopt);

/// A point as a row of it, and back. errors: core::FileError: no such row.
std::string text_of(const StudyPoint& point);
void read_text(const std::string& text, StudyPoint& point);

/// Solves the case by one way and measures it once. in: the case on this way's grid, as the deck has it.
/// errors: core::Interrupted, core::InputError (the evaluator does not fit the grid). Not converging is a status.
StudyPoint measure(Case input, const StudyCase& way);

}  // namespace ehl::program
