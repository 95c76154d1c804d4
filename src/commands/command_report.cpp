// ehl report: writes results and tables as one page that needs only a browser, with figures drawn by gnuplot.
#include <filesystem>
#include <span>

#include "base/exit_status.hpp"
#include "commands/commands.hpp"
#include "commands/page_figures.hpp"
#include "page/section.hpp"
#include "results/atomic_file.hpp"
#include "results/outputs.hpp"
#include "tables/asperity_table.hpp"
#include "tables/study_report.hpp"
#include "tables/sweep_data.hpp"
#include "tables/sweep_table.hpp"

namespace ehl::program {
namespace {

PageSection section_of(const std::string& path, const DrawnFigures& figures) {
  if (!path.ends_with(".csv")) return result_section(path, figures);
  const std::string mark = mark_of(path);
  if (mark == asperity_mark) refuse(path + ": the table of a map's asperities has no page; `ehl plot` draws it");
  return mark == sweep_mark   ? sweep_section(path, figures)
         : mark == study_mark ? study_section(path, figures)
                              : time_study_section(path, figures);
}
// in: number: that of the file on the page.
PageSection section_on(const std::string& path, std::size_t number, const Arguments& arguments) {
  section_of(path, {});  // refuses a damaged file before gnuplot reads it
  return section_of(path, figures_for_page(path, number, arguments));
}

// The default name: that of the first file, in the same folder.
std::string page_name(const Arguments& arguments) {
  std::filesystem::path beside = arguments.operands[0];
  beside.replace_extension();
  const std::string path = arguments.value("output", beside.string() + "_report.html");
  if (!path.ends_with(".html")) refuse("--output " + path + ": the name of the page must end with .html");
  return path;
}

}  // namespace

int report(const Arguments& arguments) {
  const std::string path = page_name(arguments);
  const bool overwrite = arguments.has("overwrite");
  results::check_files(arguments.operands, {{path, results::FileKind::page, overwrite}});
  std::vector<PageSection> sections;
  for (const std::string& operand : arguments.operands)
    sections.push_back(section_on(operand, sections.size() + 1, arguments));
  const std::string page = page_of(arguments.value("title", ""), sections);
  results::write_atomically(path, std::as_bytes(std::span(page)), overwrite);
  print(path + "\n");
  return solved;
}

}  // namespace ehl::program
