#pragma once
// A study as a table in a file and as a printed report.
#include <string>
#include <vector>

#include "deck/file.hpp"
#include "tables/study_judge.hpp"

namespace ehl::program {

/// The beginning of the first line of the table of a study. In table 1, deviation_Hc was called error_Hc.
constexpr char study_mark[] = "# ehl study, table 2";

/// The subject of a study and the conditions of its measurement.
struct StudyHeader {
  std::string program{};  ///< version, commit, compiler
  std::string deck{};     ///< path of the deck, for the reader
  std::string deck_text{};
  std::string title{};
  std::vector<std::string> set{};
  std::string machine{};  ///< name of the processor
  std::string date{};
  int threads = 1;  ///< threads of each solution
  int jobs = 1;     ///< solutions that run at a time
  int repeats = 1;
  std::optional<SiScales> si{};          ///< set if the contact is in SI
  std::vector<deck::NamedFile> files{};  ///< the files that the deck names

  /// The files that the study reads.
  std::vector<std::string> inputs() const {
    std::vector<std::string> paths{deck};
    for (const deck::NamedFile& file : files) paths.push_back(file.path);
    return paths;
  }
};

/// How the times were measured: "least of 3, 1 thread each, one solution after another".
std::string times_of(const StudyHeader& header);

/// The comment lines of a table: program, deck, machine, date, times. in: times: how the times were measured.
std::string origin_lines(const StudyHeader& header, const std::string& times);

/// The table as CSV: comments, names of the columns, one row per point.
std::string study_csv(const StudyHeader& header, const Reference& reference, const std::vector<StudyPoint>& points);

/// The printed report: the reference, all points, the Pareto fronts, the seconds needed for given accuracies, and two
/// extracts arranged as Tables 1 and 2 of Venner and ten Napel (1992).
std::string study_report(const StudyHeader& header, const Reference& reference, const std::vector<StudyPoint>& points);

}  // namespace ehl::program
