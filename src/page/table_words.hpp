#pragma once
// The comment lines above a table.
#include <string>

#include "tables/sweep_data.hpp"

namespace ehl::program {

/// The text after "NAME: " in a comment line; empty if there is no such line.
std::string comment(const SweepData& table, const std::string& name);

/// Deck, fixed settings, varied keys and program, as a table in markup.
std::string origin_of(const SweepData& table);

/// All comment lines, collapsed.
std::string comments_of(const SweepData& table);

}  // namespace ehl::program
