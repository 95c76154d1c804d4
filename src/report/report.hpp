#pragma once
// What is printed about a case and its solution.
#include <string>

#include "report/outcome.hpp"

namespace ehl::program {

/// One row per level: what accuracy cost in time.
std::string level_table(const steady::Solution& solution);

/// One row per load that a load continuation solved for; empty where there was none.
std::string continuation_table(const Case& input, const steady::Solution& solution);

/// What a person wants to know after the table; says it first when the solution did not converge.
std::string summary(const Case& input, const steady::Solution& solution, const Outcome& outcome);

/// Where the time went: seconds and share of every part of the cycles.
std::string profile_table(const core::PartTimes& times, double seconds);

/// Everything that follows from the deck before anything is solved.
std::string derived(const Case& input);

struct Computed;

/// One JSON object with the same content, that of the effects included. in: bytes of the whole program.
std::string json_report(const Case& input, const Computed& computed, const Outcome& outcome, double peak_memory);

/// The JSON object for a case that ended without a solution.
std::string json_failure(const Case& input, const std::string& reason);

}  // namespace ehl::program
