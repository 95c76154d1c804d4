#pragma once
// One case of a sweep: what is computed for it, and its row in the table.
#include <functional>
#include <string>
#include <vector>

#include "case/film_solution.hpp"
#include "results/content.hpp"
#include "tables/si_columns.hpp"

namespace ehl::program {

struct SweepHeader;

/// A value for every column. The first is the status: converged, not-converged, refused (the deck is wrong for this
/// case), failed (the program); then the exit status that `ehl run` would end with. The films, the pressure and their
/// errors are known only of a solution that converged. The last is the reason.
using SweepRow = std::vector<results::Quantity>;

/// What the cases of a sweep have that not every case has: columns for it.
struct SweepKind {
  bool friction = false;
  bool thermal = false;
  bool starved = false;
  bool roller = false;
  bool in_time = false;                      ///< has no column
  bool stress = false;                       ///< likewise
  bool timing = false;                       ///< seconds and memory, which are others each time
  bool si = false;                           ///< nm, GPa and formulas beside them
  Bodies bodies = Bodies::circular;          ///< looked at in SI only
  bool rough = false;                        ///< likewise
  std::vector<results::Quantity> machine{};  ///< the numbers of a bearing or of gears; their values are not looked at
};

/// That of a deck with these overrides.
SweepKind kind_of_sweep(const std::string& path, const std::vector<std::string>& overrides);

/// What the deck asks for and a row does not tell, a line each.
std::vector<std::string> left_out(const SweepKind& kind);

/// The row of a case of which nothing is known: its names and units are those of the table.
SweepRow sweep_row(const SweepKind& kind);

/// The value of a column. limits: there is one of this name.
results::Value& in_row(SweepRow& row, const std::string& name);

/// Solves one case with one thread. in: what the sweep is about (sweep_table.hpp): deck and files must still say what
/// they said; overrides; where it says how far it has come. errors: none of the case's own: they are rows.
/// core::Interrupted, std::bad_alloc and what nobody foresaw pass through.
SweepRow sweep_case(const SweepHeader& sweep, const std::vector<std::string>& overrides,
                    const std::function<void(const std::string&)>& say, std::string* kept = nullptr);

/// The row of a solved case, converged or not. in: what the solver was given and gave back; an empty row.
SweepRow row_of_solution(const Case& input, const FilmSolution& found, SweepRow row);

/// The row of a case without a solution.
SweepRow row_without_solution(SweepRow row, const std::string& status, int exit_status, const std::string& reason);

}  // namespace ehl::program
