#pragma once
// What the points of a study in time are held against, and the study as a file and on the screen.
#include <string>
#include <vector>

#include "tables/study_report.hpp"
#include "tables/time_study_point.hpp"
#include "transient/march.hpp"

namespace ehl::program {

/// How the first line of every table of a study in time begins; of table 1 as above.
constexpr char time_study_mark[] = "# ehl study in time, table 2";

/// The run that errors are relative to.
struct TimeReference {
  TimeStudyPoint run{};
  TimeStudyPoint coarser{};      ///< of the larger tolerance and step that tell how well it is known
  std::vector<double> errors{};  ///< of its quantities: the difference of the two
  std::vector<transient::Place> probes{};
};

/// Largest difference of two runs at the times that both have, quantity by quantity: Hc, Hm and P_max relative to what
/// the reference has at that time; the pressure at a probe, which may be zero, to the largest that the reference has
/// there. limits: NaN where either is not complete, or no time is common; of a probe where the reference is zero at all
/// times and the other is not.
std::vector<double> errors_in_time(const TimeStudyPoint& reference, const TimeStudyPoint& point);

/// The table as CSV: comments, the names of the columns, a row per tolerance.
std::string time_study_csv(const StudyHeader& header, const TimeReference& reference,
                           const std::vector<TimeStudyPoint>& points);

/// For people.
std::string time_study_report(const StudyHeader& header, const TimeReference& reference,
                              const std::vector<TimeStudyPoint>& points);

}  // namespace ehl::program
