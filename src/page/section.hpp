#pragma once
// A page has a section for each file.
#include <optional>
#include <string>
#include <vector>

namespace ehl::program {

/// What the table that compares several files says of one.
struct Compared {
  std::string kind{};                ///< "run", "run in time", "sweep", "study"
  std::vector<std::string> cells{};  ///< markup; of a result: those of `compared_columns`
};
constexpr const char* compared_columns[] = {"M",     "L",       "load", "u_m", "central film", "smallest film",
                                            "p_max", "friction"};

struct PageSection {
  std::string title{};   ///< as it is in the file
  std::string path{};    ///< of the file
  std::string markup{};  ///< what stands below the heading
  Compared compared{};
};

/// A section on a result file, or on the table of a sweep or a study. errors: core::FileError: it cannot be read, is no
/// file of this program, is damaged.
PageSection result_section(const std::string& path);
PageSection sweep_section(const std::string& path);
PageSection study_section(const std::string& path);
PageSection time_study_section(const std::string& path);

/// The whole page. in: its heading; empty: that of the only file, or one that counts them.
std::string page_of(const std::string& heading, const std::vector<PageSection>& sections);

}  // namespace ehl::program
