#pragma once
// A sweep as series of rows: the key along a series, the keys that distinguish series, and the published formulas.
#include <array>
#include <string>
#include <vector>

#include "case/published.hpp"
#include "tables/sweep_data.hpp"

namespace ehl::program {

using FormulasOfTable = std::array<Publication, 3>;  // as many as the scripts can draw; empty: none

/// The formulas for point contacts or for line contacts.
FormulasOfTable published_for(const SweepData& table);

/// The column that holds the value of a formula for a quantity, "hd_h_c_nm".
std::string column_of(const Publication& formula, const std::string& y);

/// The varied key with most values; empty if no key has three or more numbers.
std::string longest_key(const SweepData& table);

/// The columns of the films in SI: h_c_nm, h_m_nm.
std::vector<std::string> films_in_si();

/// The columns of the films; in SI if the table has them.
std::vector<std::string> films(const SweepData& table);

/// The rows of each curve, in the order of the table. in: by: the columns whose values distinguish the curves.
std::vector<std::vector<std::size_t>> curves_by(const SweepData& table, const std::vector<std::string>& by);

/// The error bar of a quantity in the unit of the quantity; 0 if the table has none.
double error_bar(const SweepData& table, std::size_t row, const std::string& y);

}  // namespace ehl::program
