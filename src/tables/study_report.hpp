#pragma once
// A study as a file and on the screen.
#include <string>
#include <vector>

#include "deck/file.hpp"
#include "tables/study_judge.hpp"

namespace ehl::program {

/// How the first line of every table of a study begins. Table 1 called error_Hc what is deviation_Hc now.
constexpr char study_mark[] = "# ehl study, table 2";

/// What a study is about and how it was measured.
struct StudyHeader {
  std::string program{};  ///< version, commit, compiler
  std::string deck{};     ///< its path, for the reader
  std::string deck_text{};
  std::string title{};
  std::vector<std::string> set{};
  std::string machine{};  ///< processor
  std::string date{};
  int threads = 1;  ///< of each solution
  int jobs = 1;     ///< solutions at a time
  int repeats = 1;
  std::optional<SiScales> si{};          ///< of a contact in SI
  std::vector<deck::NamedFile> files{};  ///< that the deck names

  /// What the study reads.
  std::vector<std::string> inputs() const {
    std::vector<std::string> paths{deck};
    for (const deck::NamedFile& file : files) paths.push_back(file.path);
    return paths;
  }
};

/// "least of 3, 1 thread each, one solution after another".
std::string times_of(const StudyHeader& header);

/// Comments of a table: program, deck, machine, date, times. in: what is said of the times.
std::string origin_lines(const StudyHeader& header, const std::string& times);

/// The table as CSV: comments, the names of the columns, a row per point.
std::string study_csv(const StudyHeader& header, const Reference& reference, const std::vector<StudyPoint>& points);

/// For people: the reference, every point, the Pareto fronts, the seconds to an accuracy, and two cuts, Tables 1 and 2
/// of Venner and ten Napel (1992).
std::string study_report(const StudyHeader& header, const Reference& reference, const std::vector<StudyPoint>& points);

}  // namespace ehl::program
