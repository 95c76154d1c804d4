#pragma once
// A study of a run in time as a table in a file and as a printed report.
#include <string>
#include <vector>

#include "tables/study_report.hpp"

namespace ehl::program {

/// The beginning of the first line of the table of a study in time. Table 1 named its columns
/// as table 1 of a study did.
constexpr char time_study_mark[] = "# ehl study in time, table 2";

/// The table as CSV: comments, names of the columns, one row per tolerance.
std::string time_study_csv(const StudyHeader& header, const TimeReference& reference,
                           const std::vector<StudyPoint>& points);

/// The printed report.
std::string time_study_report(const StudyHeader& header, const TimeReference& reference,
                              const std::vector<StudyPoint>& points);

}  // namespace ehl::program
