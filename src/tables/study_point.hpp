#pragma once
// One method of solving the case, with its measured cost and its error against the reference.
#include <limits>
#include <optional>
#include <string>

#include "base/column.hpp"
#include "base/si_units.hpp"
#include "tables/study_plan.hpp"

namespace ehl::program {

/// The cost of a solution over several repetitions; NaN: not known.
struct Cost {
  double seconds = std::numeric_limits<double>::quiet_NaN();       ///< the least time of the repetitions
  double seconds_most = std::numeric_limits<double>::quiet_NaN();  ///< the greatest time of the repetitions
  double peak_memory = std::numeric_limits<double>::quiet_NaN();   ///< [bytes]
};

/// Adds one more repetition.
void add_repetition(const Cost& again, Cost& cost);

/// A value that is not known is NaN.
struct StudyPoint : Cost {
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  StudyCase variant{};
  int nx = 0;  ///< number of cells along x
  int ny = 0;
  /// converged; stopped (the fixed number of cycles is done, but not all checks pass); not-converged; failed
  /// (an error of the program).
  std::string status{};
  double Hc = unknown;
  double Hm = unknown;
  double deviation_Hc = unknown;  ///< relative difference from the reference
  double deviation_Hm = unknown;
  double estimate_Hc = unknown;  ///< the relative discretization error that the run itself estimates
  double estimate_Hm = unknown;
  double residual = unknown;
  std::string cycles_by_level{};  ///< "6;2;2": cycles from the coarsest grid to the finest
  int attempts = 0;
  double work_units = unknown;   ///< work of the whole solution, in relaxations of the finest grid
  bool at_reference_Hc = false;  ///< the error is below that of the reference
  bool at_reference_Hm = false;
  bool front_Hc = false;  ///< on the Pareto front of Hc
  bool front_Hm = false;
  std::string reason{};
};

/// The columns of the table; the films are in nm if the contact is in SI.
std::vector<Column<StudyPoint>> study_columns(const std::optional<SiScales>& si = std::nullopt);

/// Converts a point to one line of text and back. errors: core::FileError for another text.
std::string text_of(const StudyPoint& point);
void read_text(const std::string& text, StudyPoint& point);

/// Solves the case by one method and measures it once. in: the case on the grid of this method, with
/// the settings of the deck.
/// errors: core::Interrupted; core::InputError if the evaluator does not fit the grid. A solution that does not
/// converge is not an error but a status.
StudyPoint measure(Case input, const StudyCase& variant);

}  // namespace ehl::program
