#pragma once
// What the lines above a table say of it.
#include <string>

#include "tables/sweep_data.hpp"

namespace ehl::program {

/// What follows "deck: " and the like; empty where there is no such line.
std::string comment(const SweepData& table, const std::string& name);

/// Deck, what was set and varied, program: a table of markup.
std::string origin_of(const SweepData& table);

/// All lines, folded away.
std::string comments_of(const SweepData& table);

}  // namespace ehl::program
