#pragma once
// One case of a sweep: what is computed for it, and its row in the table.
#include <array>
#include <limits>
#include <string>
#include <vector>

#include "case/scene.hpp"
#include "steady/solution.hpp"

namespace ehl::program {

/// NaN: not known. The films, the pressure and their errors are known only of a solution that converged.
struct SweepRow {
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  std::string status{};  ///< converged, not-converged, refused (the deck is wrong for this case), failed (the program)
  int exit_status = 0;   ///< what `ehl run` would end with
  std::string method = "none";  ///< the way that led to what is shown, in words
  std::string path = "none";    ///< and as a code for scripts (report/outcome.hpp)
  int attempts = 0;
  double M = unknown;
  double L = unknown;
  double p_h = unknown;  ///< [Pa]
  int nx = 0;            ///< cells
  int ny = 0;
  double Hc = unknown;
  double Hm = unknown;
  double P_max = unknown;
  double error_Hc = unknown;
  double error_Hm = unknown;
  double residual = unknown;
  double load_error = unknown;
  double cycle_factor = unknown;
  int cycles = 0;               ///< on the finest grid
  double work_units = unknown;  ///< on the finest grid
  double seconds = unknown;
  double peak_memory = unknown;  ///< [bytes]
  bool with_friction = false;    ///< the case asks for it; these are columns only then
  std::array<double, 4> friction{unknown, unknown, unknown, unknown};  ///< mu, mu_rolling, mu_1, mu_2
  int warnings = 0;
  std::string reason{};
};

/// Names of the columns after the varied keys, between commas, and their units as a comment. in: whether the cases may
/// ask for friction.
std::string sweep_columns(bool with_friction);
std::string sweep_units();

/// The row as text between commas, in the order of sweep_columns(); words without commas, the reason in quotes.
std::string sweep_text(const SweepRow& row);

/// Solves one case with one thread. in: path of the deck, the text it must still have, overrides.
/// errors: none of the case's own: they are rows. core::Interrupted, std::bad_alloc and what nobody foresaw pass
/// through.
SweepRow sweep_case(const std::string& path, const std::string& deck_text, const std::vector<std::string>& overrides);

/// Whether a deck with these overrides names friction: then the table has columns for it. in: as above.
bool names_friction(const std::string& path, const std::vector<std::string>& overrides);

/// The row of a solved case, converged or not. in: what the solver was given and gave back.
SweepRow row_of_solution(const Case& input, const steady::Solution& solution);

/// The row of a case whose process did not live to tell.
SweepRow row_of_failure(int exit_status, const std::string& reason);

}  // namespace ehl::program
