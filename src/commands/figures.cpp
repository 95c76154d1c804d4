#include "commands/figures.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/machine.hpp"
#include "commands/arguments.hpp"
#include "core/errors.hpp"
#include "deck/text.hpp"

namespace ehl::program {
namespace {

namespace files = std::filesystem;

constexpr std::array table_kinds{"sweep", "study", "time_study", "asperities"};

// The kind of file that a figure draws: one of the tables, or result.
std::string kind_of(const Figure& figure) {
  const std::string need = figure.needs.empty() ? "" : figure.needs[0];
  return std::ranges::find(table_kinds, need) != table_kinds.end() ? need : "result";
}

std::string told(const std::string& kind) {
  if (kind == "result") return "a result, FILE.h5";
  if (kind == "asperities") return "the table of a map's asperities, FILE.csv";
  return "the table of a " + (kind == "time_study" ? "study of a run in time" : kind) + ", FILE.csv";
}

// The figure with this name, which must draw this kind of file.
Figure named(const std::vector<Figure>& all, const std::string& name, const FigureSource& source) {
  const std::string said = "--figure " + name;
  const auto found = std::ranges::find(all, name, &Figure::name);
  if (found == all.end()) {
    std::vector<std::string> known;
    for (const Figure& figure : all) known.push_back(figure.name);
    refuse(said + ": there is no such figure" + suggestion(name, known) + "\n" + list_of_figures(all));
  }
  if (kind_of(*found) != source.kind) refuse(said + " draws " + told(kind_of(*found)));
  for (const std::string& need : found->needs)
    if (!source.has(need)) refuse(said + ": this file has no " + need + ", which it needs");
  return *found;
}

}  // namespace

std::vector<Figure> figures_in(const std::string& folder) {
  std::error_code error;
  if (!files::is_directory(folder, error))
    throw core::FileError(folder + ": there is no such folder: set EHL_POSTPROCESS to the folder of the scripts");
  std::vector<Figure> found;
  for (const files::directory_entry& entry : files::directory_iterator(folder)) {
    if (entry.path().extension() != ".gp") continue;
    std::ifstream script(entry.path());
    std::string first, second, third;
    std::getline(std::getline(std::getline(script, first), second), third);
    const std::string mark = "# figure:", needs = "# needs:";
    if (!first.starts_with(mark)) continue;
    const bool movie = third == "# movie";
    Figure figure{entry.path().stem(),
                  deck::trimmed(first.substr(mark.size())),
                  entry.path(),
                  {},
                  movie,
                  movie || third == "# on demand" || third == "# on the page",
                  !movie && third != "# on demand" && third != "# not on the page",
                  third == "# curves"};
    if (second.starts_with(needs)) figure.needs = deck::split_words(second.substr(needs.size()));
    found.push_back(figure);
  }
  std::ranges::sort(found, {}, &Figure::name);
  if (found.empty()) throw core::FileError(folder + ": no script in it draws a figure");
  return found;
}

std::string folder_of_scripts() {
  const char* own = std::getenv("EHL_POSTPROCESS");
  if (own != nullptr) return own;
  // An installed program has its scripts in a folder next to it; a program that was only built
  // uses those of the source.
  const files::path installed = files::path(program_path()).parent_path() / EHL_POSTPROCESS_INSTALLED;
  std::error_code error;
  return files::is_directory(installed, error) ? installed.lexically_normal().string() : EHL_POSTPROCESS_FOLDER;
}

std::vector<Figure> selected_figures(const std::vector<Figure>& all, const std::vector<std::string>& names,
                                     const FigureSource& source) {
  std::vector<Figure> chosen;
  for (const std::string& name : names) chosen.push_back(named(all, name, source));
  if (!names.empty()) return chosen;
  for (const Figure& figure : all)
    if (!figure.on_demand && kind_of(figure) == source.kind && std::ranges::all_of(figure.needs, source.has))
      chosen.push_back(figure);
  return chosen;
}

std::vector<Figure> figures_of_page(const std::vector<Figure>& all, const FigureSource& source) {
  const bool in_time = std::ranges::find(source.settings, "frame", &Setting::name) != source.settings.end();
  const auto fits = [&](const Figure& figure) {
    const bool of_course =
        std::ranges::any_of(figure.needs, [](const std::string& need) { return need.starts_with("/transient"); });
    return figure.on_page && kind_of(figure) == source.kind && std::ranges::all_of(figure.needs, source.has) &&
           (!in_time || of_course || figure.on_demand);
  };
  std::vector<Figure> chosen;
  std::ranges::copy_if(all, std::back_inserter(chosen), fits);
  return chosen;
}

std::string list_of_figures(const std::vector<Figure>& all) {
  std::string text;
  std::vector<std::string> kinds{"result"};
  kinds.insert(kinds.end(), table_kinds.begin(), table_kinds.end());
  for (const std::string& kind : kinds) {
    text += "\nfigures of " + told(kind) + "\n";
    for (const Figure& figure : all) {
      if (kind_of(figure) != kind) continue;
      std::vector<std::string> words(figure.needs);
      std::erase(words, kind);
      std::ranges::replace(words, std::string(curves_need), std::string("a swept key of three values or more"));
      const std::string needs = deck::joined(words, ", ");
      text += "  " + figure.name +
              (figure.movie       ? " (GIF, on demand)"
               : figure.on_demand ? " (on demand)"
                                  : "") +
              ": " + figure.title + "\n" + (needs.empty() ? "" : "      needs " + needs + "\n");
    }
  }
  return text;
}

}  // namespace ehl::program
