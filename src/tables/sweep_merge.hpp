#pragma once
// Merges the parts of a sweep into one table.
#include <cstddef>
#include <string>
#include <vector>

namespace ehl::program {

struct MergedSweep {
  std::string text{};  ///< the table as one run would have written it
  std::size_t cases = 0;
  std::vector<std::size_t> missing{};  ///< cases without a row
  std::size_t converged = 0;
};

/// in: the tables of the shards, in any order; a row that a kill left incomplete is ignored.
/// errors: core::FileError if a file cannot be read, is not a shard, belongs to another sweep or another number of
/// shards, has a damaged row, or has a case that another file has too.
MergedSweep merged_sweep(const std::vector<std::string>& paths);

}  // namespace ehl::program
