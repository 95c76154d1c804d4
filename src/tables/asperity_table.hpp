#pragma once
// The result of `ehl asperities` as a table in a file and as a printed report.
#include <string>
#include <vector>

#include "asperities/rough_map.hpp"
#include "core/warning.hpp"

namespace ehl::program {

/// The beginning of the first line of the table.
constexpr char asperity_mark[] = "# ehl asperities, table 1";

/// What was computed.
struct AsperityRun {
  std::string map{};          ///< name of the file
  int filled = 0;             ///< missing points that were filled
  int nx = 0, ny = 0;         ///< points of the file
  double dx = 0.0, dy = 0.0;  ///< their distances [m]
  std::string filters{};      ///< "waves longer than 80 um taken away"; empty: none
  asperities::MapParameters parameters{};
  asperities::MapResult result{};
};

/// The table as CSV: comments, one heading with units, one row per gap. `[mixed] table` and `ehl plot` read it.
std::string asperity_csv(const AsperityRun& run);

/// The printed report, without the warnings.
std::string asperity_report(const AsperityRun& run);

core::Warnings asperity_warnings(const AsperityRun& run);

}  // namespace ehl::program
