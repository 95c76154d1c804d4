#pragma once
// A sweep as series of rows: what runs along them, what tells them apart, what stands beside their numbers.
#include <array>
#include <string>
#include <vector>

#include "tables/sweep_data.hpp"

namespace ehl::program {

/// A published formula, by how its columns begin; empty: none.
struct PublishedFormula {
  const char* code;
  const char* name;
};
using FormulasOfTable = std::array<PublishedFormula, 3>;  // as many as the scripts draw

/// Those of point contacts, or of line contacts.
FormulasOfTable published_for(const SweepData& table);

/// The column of a formula for a quantity, "hd_h_c_nm".
std::string column_of(const PublishedFormula& formula, const std::string& y);

/// The varied key with most values; empty where none has three numbers.
std::string longest_key(const SweepData& table);

/// The columns of the films, in SI where the table has them.
std::vector<std::string> films(const SweepData& table);

/// Rows of each curve, in the order of the table. in: the columns whose words tell curves apart.
std::vector<std::vector<std::size_t>> curves_by(const SweepData& table, const std::vector<std::string>& by);

/// The error bar of a quantity in its unit, 0 where the table has none.
double error_bar(const SweepData& table, std::size_t row, const std::string& y);

}  // namespace ehl::program
