#pragma once
// Accuracy against computing time for a run in time.
#include "commands/commands.hpp"
#include "tables/study_report.hpp"

namespace ehl::program {

/// `ehl study` for a deck with [transient]: runs the case with every tolerance of --rtol, and with a smaller tolerance
/// and shorter steps as the reference. Writes the table to `path` and prints the report.
/// out: the exit status; 3 if a run ended early.
/// errors: core::InputError for options of steady decks or a wrong list; core::SolverError if there is no reference.
int study_in_time(const Arguments& arguments, const StudyHeader& header, const std::string& path, const Case& input);

}  // namespace ehl::program
