#pragma once
// The parts of a sweep as one table.
#include <cstddef>
#include <string>
#include <vector>

namespace ehl::program {

struct MergedSweep {
  std::string text{};  ///< the table that one run would have written
  std::size_t cases = 0;
  std::vector<std::size_t> missing{};  ///< cases without a row
  std::size_t converged = 0;
};

/// in: tables of shards, in any order; a row that was cut short by a kill is left out.
/// errors: core::FileError: unreadable, no shard, of another sweep or of another number of shards, a damaged row, a
/// case in two of them.
MergedSweep merged_sweep(const std::vector<std::string>& paths);

}  // namespace ehl::program
