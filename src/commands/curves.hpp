#pragma once
// A sweep as curves: a quantity against a swept key, one curve for each choice of the other keys.
#include <string>
#include <vector>

#include "commands/arguments.hpp"
#include "commands/figures.hpp"
#include "tables/sweep_data.hpp"

namespace ehl::program {

/// What is drawn. Empty: chosen (`chosen_curves`).
struct CurvesWanted {
  std::string x{};                ///< a column of numbers
  std::vector<std::string> y{};   ///< columns of numbers
  std::vector<std::string> by{};  ///< columns whose words tell curves apart
  std::string axes{};             ///< log or linear; empty: by the range of the values
};

/// The axes that --x, --y and --by name; where they do not: the swept key with most values (at least three), the films
/// in SI where the table has them, all other swept keys. errors: core::InputError: a column that there is not or that
/// has no numbers, more curves than colours.
CurvesWanted chosen_curves(const SweepData& table, const Arguments& arguments);

/// True where a table makes curves without being told which.
bool makes_curves(const SweepData& table);

struct Curves {
  std::string data{};  ///< for gnuplot: a block for each series, rows "x y error formula..." in the order of x
  std::vector<Setting> settings{};
};

/// The converged rows as series: each curve of each quantity, with the error bars and the formulas that the table has.
Curves curves_of(const SweepData& table, const CurvesWanted& wanted);

}  // namespace ehl::program
