#pragma once
// One case of a sweep: its computation, and its row in the table.
#include <functional>
#include <string>
#include <vector>

#include "case/computed.hpp"
#include "case/numbers/number.hpp"
#include "results/content.hpp"

namespace ehl::program {

struct SweepHeader;

/// One value per column. The first is the status: converged; not-converged; refused (the deck is wrong for this case);
/// failed (an error of the program). The second is the exit status that `ehl run` would return. Films, pressure and
/// their errors are known only if the case converged. The last is the reason.
using SweepRow = std::vector<results::Quantity>;
using SweepColumns = std::vector<numbers::SweepColumn>;

/// The settings of a deck that a row does not report, one line each.
std::vector<std::string> left_out(const deck::Deck& deck);

/// An empty row, with the names and units of the table.
SweepRow sweep_row(const SweepColumns& columns);

/// The value in a column. limits: a column of this name must exist.
results::Value& in_row(SweepRow& row, const std::string& name);

/// Solves one case with one thread. in: the sweep (sweep_table.hpp), whose deck and files must be unchanged; the
/// overrides; say: reports progress.
/// errors: an error of the case becomes a row. core::Interrupted, std::bad_alloc and
/// unexpected exceptions pass through.
SweepRow sweep_case(const SweepHeader& sweep, const std::vector<std::string>& overrides,
                    const std::function<void(const std::string&)>& say, std::string* kept = nullptr);

/// The row of a case, converged or not. in: the columns; the case, computed to Extent::row.
SweepRow row_of_solution(const SweepColumns& columns, const Case& input, const Computed& computed);

/// The row of a case without a solution.
SweepRow row_without_solution(SweepRow row, const std::string& status, int exit_status, const std::string& reason);

}  // namespace ehl::program
