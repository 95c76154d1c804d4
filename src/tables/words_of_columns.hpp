#pragma once
// Columns of a sweep's table in the words of the field, in gnuplot's letters.
#include <string>
#include <vector>

#include "tables/sweep_data.hpp"

namespace ehl::program {

/// "smallest film h_m", "central film h_c": without the unit.
std::string words_for(const std::string& column);

/// "entrainment speed u_m [m/s]".
std::string with_unit(const SweepData& table, const std::string& column);

/// Of an axis that several columns share.
std::string words_of_all(const SweepData& table, const std::vector<std::string>& columns);

/// "F = 20 N, pao4": what tells the curve of this row apart.
std::string name_of_curve(const SweepData& table, const std::vector<std::string>& by, std::size_t row);

}  // namespace ehl::program
