#pragma once
// A sweep as curves: a quantity against a varied key, one curve for each combination of the other keys.
#include <string>
#include <vector>

#include "commands/arguments.hpp"
#include "commands/figures.hpp"
#include "tables/sweep_data.hpp"

namespace ehl::program {

/// The choice of curves; an empty member is chosen by `chosen_curves`.
struct CurvesWanted {
  std::string x{};                ///< a numeric column
  std::vector<std::string> y{};   ///< numeric columns
  std::vector<std::string> by{};  ///< columns whose values distinguish the curves
  std::string axes{};             ///< log or linear; empty: chosen by the range of the values
};

/// The choice given by --x, --y and --by. The defaults are: for x the varied key with most values (at least three); for
/// y the films, in SI if the table has them; for by all other varied keys.
/// errors: core::InputError for a column that does not exist or is not numeric, or for more curves than colours.
CurvesWanted chosen_curves(const SweepData& table, const Arguments& arguments);

/// True if the default choice gives curves for a table.
bool makes_curves(const SweepData& table);

/// True if the default choice gives more curves than a picture can show.
bool too_many_curves(const SweepData& table);

/// True if a converged case has a number in one of the columns.
bool has_points(const SweepData& table, const std::vector<std::string>& columns);

struct Curves {
  std::string data{};  ///< for gnuplot: one block per series, with rows "x y error formula..." in the order of x
  std::vector<Setting> settings{};
};

/// The converged rows as series: each quantity of each curve, with the error bars and the formulas of the table.
Curves curves_of(const SweepData& table, const CurvesWanted& wanted);

}  // namespace ehl::program
