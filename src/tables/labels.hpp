#pragma once
// Labels for the columns of a sweep's table, written for gnuplot.
#include <string>
#include <vector>

#include "tables/sweep_data.hpp"

namespace ehl::program {

/// The label without unit: "minimum film h_m", "central film h_c".
std::string words_for(const std::string& column);

/// The label with unit: "entrainment speed u_m [m/s]".
std::string with_unit(const SweepData& table, const std::string& column);

/// The label of an axis that several columns share.
std::string words_of_all(const SweepData& table, const std::vector<std::string>& columns);

/// The name of the curve that a row belongs to: "F = 20 N, pao4".
std::string name_of_curve(const SweepData& table, const std::vector<std::string>& by, std::size_t row);

}  // namespace ehl::program
