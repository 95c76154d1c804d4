#pragma once
// What accuracy costs in a run in time.
#include "commands/commands.hpp"
#include "tables/study_report.hpp"

namespace ehl::program {

/// `ehl study` of a deck with [transient]: runs the case with every tolerance of --rtol and one run of a smaller
/// tolerance and shorter steps as reference; writes the table to `path`, prints the report. out: the exit status, 3
/// where a run did not come to its end. errors: core::InputError: options for steady decks, a wrong list;
/// core::SolverError: no reference.
int study_in_time(const Arguments& arguments, const StudyHeader& header, const std::string& path, const Case& input);

}  // namespace ehl::program
