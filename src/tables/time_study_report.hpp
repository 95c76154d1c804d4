#pragma once
// Judges the points of a study in time, and writes the study as a table and as a printed report.
#include <string>
#include <vector>

#include "tables/study_report.hpp"
#include "tables/time_study_point.hpp"
#include "transient/march.hpp"

namespace ehl::program {

/// The beginning of the first line of the table of a study in time. Table 1 named its columns
/// as table 1 of a study did.
constexpr char time_study_mark[] = "# ehl study in time, table 2";

/// The reference run of the errors.
struct TimeReference {
  TimeStudyPoint run{};
  TimeStudyPoint coarser{};      ///< a run with a larger tolerance and larger steps; it shows the
                                 ///< accuracy of the reference
  std::vector<double> errors{};  ///< the difference between the two runs, for each quantity
  std::vector<transient::Place> probes{};
};

/// The largest difference of two runs over their common times, for each quantity. Hc, Hm and P_max are relative to
/// the reference at the same time. The pressure at a probe, which may be zero, is relative to the largest value of
/// the reference at that probe.
/// limits: NaN if a run is not complete or there is no common time; NaN for a probe if the reference is zero at all
/// times and the other run is not.
std::vector<double> errors_in_time(const TimeStudyPoint& reference, const TimeStudyPoint& point);

/// The table as CSV: comments, names of the columns, one row per tolerance.
std::string time_study_csv(const StudyHeader& header, const TimeReference& reference,
                           const std::vector<TimeStudyPoint>& points);

/// The printed report.
std::string time_study_report(const StudyHeader& header, const TimeReference& reference,
                              const std::vector<TimeStudyPoint>& points);

}  // namespace ehl::program
