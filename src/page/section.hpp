#pragma once
// A page consists of one section for each file.
#include <optional>
#include <string>
#include <vector>

#include "case/numbers/names.hpp"
#include "page/svg.hpp"

namespace ehl::program {

/// One row of the table that compares several files.
struct Compared {
  std::string kind{};                ///< "run", "run in time", "sweep", "study"
  std::vector<std::string> cells{};  ///< markup; for a result file: the cells of `compared_columns`
};
constexpr const char* compared_columns[] = {id::M, id::L, id::load, "u_m", id::Hc_best, id::Hm_best, id::P_max, id::mu};

struct PageSection {
  std::string title{};   ///< the title in the file
  std::string path{};    ///< path of the file
  std::string markup{};  ///< the content below the heading
  Compared compared{};
};

/// A section about a result file, or about the table of a sweep or a study. errors: core::FileError if the file cannot
/// be read, is damaged, or was not written by this program.
PageSection result_section(const std::string& path, const DrawnFigures& figures);
PageSection sweep_section(const std::string& path, const DrawnFigures& figures);
PageSection study_section(const std::string& path, const DrawnFigures& figures);
PageSection time_study_section(const std::string& path, const DrawnFigures& figures);

/// The whole page. in: its heading; empty: the heading of the only section, or one that gives the number of files.
std::string page_of(const std::string& heading, const std::vector<PageSection>& sections);

}  // namespace ehl::program
