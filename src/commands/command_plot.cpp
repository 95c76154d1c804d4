// ehl plot: the gnuplot scripts of postprocess/, fed with a result or with the table of a sweep or a study.
#include <spawn.h>
#include <sys/wait.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <sstream>

#include "base/exit_status.hpp"
#include "base/machine.hpp"
#include "commands/commands.hpp"
#include "core/errors.hpp"
#include "deck/text.hpp"
#include "results/read.hpp"
#include "tables/study_report.hpp"
#include "tables/sweep_table.hpp"
#include "tables/time_study_report.hpp"

extern char** environ;

namespace ehl::program {
namespace {

namespace files = std::filesystem;

struct Figure {
  std::string name;
  std::string title;
  std::string script;
  std::vector<std::string> needs;  // datasets without which there is nothing to draw; or what it draws instead,
                                   // "sweep", "study" or "time_study", and columns without which there is nothing
  bool movie = false;              // a GIF whatever the format, and only when asked for
};

// The kind of file that a figure draws: sweep, study, time_study or result.
std::string kind_of(const Figure& figure) {
  const std::string need = figure.needs.empty() ? "" : figure.needs[0];
  return need == "sweep" || need == "study" || need == "time_study" ? need : "result";
}

std::string told(const std::string& kind) {
  if (kind == "result") return "a result, FILE.h5";
  return "the table of a " + (kind == "time_study" ? "study of a run in time" : kind) + ", FILE.csv";
}

// What there is to draw: what scripts are told about it, and whether it has what a figure needs.
struct Source {
  std::string settings;
  std::string kind;
  std::function<bool(const std::string&)> has;
};

// A script is a figure when its first line says "# figure: title"; "# needs: name..." may follow, and "# movie".
std::vector<Figure> figures(const files::path& folder) {
  std::error_code error;
  if (!files::is_directory(folder, error))
    throw core::FileError(folder.string() +
                          ": there is no such folder: set EHL_POSTPROCESS to the folder of the scripts");
  std::vector<Figure> found;
  for (const files::directory_entry& entry : files::directory_iterator(folder)) {
    if (entry.path().extension() != ".gp") continue;
    std::ifstream script(entry.path());
    std::string first, second, third;
    std::getline(std::getline(std::getline(script, first), second), third);
    const std::string mark = "# figure:", needs = "# needs:";
    if (!first.starts_with(mark)) continue;
    Figure figure{entry.path().stem(), deck::trimmed(first.substr(mark.size())), entry.path(), {}, third == "# movie"};
    if (second.starts_with(needs)) figure.needs = deck::split_words(second.substr(needs.size()));
    found.push_back(figure);
  }
  std::ranges::sort(found, {}, &Figure::name);
  if (found.empty()) throw core::FileError(folder.string() + ": no script in it draws a figure");
  return found;
}

// The figure of this name, which must be one that draws this file.
Figure named(const std::vector<Figure>& all, const std::string& name, const Source& source) {
  const std::string said = "--figure " + name;
  const auto found = std::ranges::find(all, name, &Figure::name);
  if (found == all.end()) {
    std::vector<std::string> known;
    std::string list;
    for (const Figure& figure : all) {
      known.push_back(figure.name);
      list += "\n  " + figure.name + ": " + figure.title;
    }
    refuse(said + ": there is no such figure" + suggestion(name, known) + " Figures are" + list);
  }
  if (kind_of(*found) != source.kind) refuse(said + " draws " + told(kind_of(*found)));
  for (const std::string& need : found->needs)
    if (!source.has(need)) refuse(said + ": this file has no " + need + ", which it draws");
  return *found;
}

std::vector<Figure> selected(const std::vector<Figure>& all, const std::vector<std::string>& names,
                             const Source& source) {
  std::vector<Figure> chosen;
  for (const std::string& name : names) chosen.push_back(named(all, name, source));
  if (!names.empty()) return chosen;
  for (const Figure& figure : all)
    if (!figure.movie && std::ranges::all_of(figure.needs, source.has)) chosen.push_back(figure);
  return chosen;
}

// A text between single quotes, in which gnuplot writes a quote as two.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("''") : std::string(1, c);
  return result + "'";
}

std::vector<char*> pointers_to(const std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));  // spawn does not write
  pointers.push_back(nullptr);
  return pointers;
}

// The scripts are in UTF-8, and their numbers have points, whatever the locale.
std::vector<std::string> environment_of_scripts() {
  std::vector<std::string> variables;
  for (char** one = environ; *one != nullptr; ++one)
    if (const std::string variable = *one; !variable.starts_with("LC_ALL=")) variables.push_back(variable);
  variables.emplace_back("LC_ALL=C.UTF-8");
  return variables;
}

void run_gnuplot(const std::vector<std::string>& words, const std::string& figure) {
  pid_t child = 0;
  const int error = ::posix_spawnp(&child, "gnuplot", nullptr, nullptr, pointers_to(words).data(),
                                   pointers_to(environment_of_scripts()).data());
  if (error != 0)
    throw core::FileError(std::string("gnuplot cannot be started: ") + std::strerror(error) +
                          ": install it (Debian: gnuplot-nox)");
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGINT || WTERMSIG(status) == SIGTERM)) throw core::Interrupted();
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw core::FileError("gnuplot failed on figure " + figure + "; its message is above");
}

std::string picture_name(const std::string& result, const std::string& figure, const std::string& format) {
  const files::path path(result);
  return (path.parent_path() / (path.stem().string() + "_" + figure + "." + format)).string();
}

std::string folder_of_scripts() {
  const char* own = std::getenv("EHL_POSTPROCESS");
  if (own != nullptr) return own;
  // An installed program has its scripts beside it; one that was only built takes them from the source.
  const files::path installed = files::path(program_path()).parent_path() / EHL_POSTPROCESS_INSTALLED;
  std::error_code error;
  return files::is_directory(installed, error) ? installed.lexically_normal().string() : EHL_POSTPROCESS_FOLDER;
}

Source result_source(const std::string& path) {
  const auto result = std::make_shared<results::ResultFile>(path);
  const auto has = [result](const std::string& need) {
    return result->kind(need) != results::ResultFile::Kind::missing;
  };
  std::string settings = "; title=" + quoted(result->attribute("/", "title"));
  if (has("/scales/h")) settings += "; film_nm=" + deck::shortest(1e9 * result->numbers("/scales/h").values[0]);
  return {settings, "result", has};
}

Source table_source(const std::string& path) {
  std::ifstream file(path);
  std::string first;
  if (!std::getline(file, first)) throw core::FileError(path + ": cannot be read, or is empty");
  const std::string kind = first.starts_with(sweep_mark)        ? "sweep"
                           : first.starts_with(study_mark)      ? "study"
                           : first.starts_with(time_study_mark) ? "time_study"
                                                                : "";
  if (kind.empty()) throw core::FileError(path + ": this is no table of `ehl sweep` or `ehl study`");
  std::string columns = first;
  while (columns.starts_with('#') && std::getline(file, columns)) {
  }
  return {"", kind, [kind, columns](const std::string& need) {
            return need == kind || ("," + columns + ",").find("," + need + ",") != std::string::npos;
          }};
}

}  // namespace

int plot(const Arguments& arguments) {
  const std::string& path = arguments.operands[0];
  const std::string format = arguments.value("format", "png");
  if (format != "png" && format != "svg" && format != "pdf") refuse("--format " + format + ": must be png, svg or pdf");
  const Source source = path.ends_with(".csv") ? table_source(path) : result_source(path);
  // The scripts hand the name to a shell between single quotes.
  if (path.find('\'') != std::string::npos)
    refuse(path + ": gnuplot's scripts cannot take a file name with a quote: rename it");

  const std::vector<Figure> chosen = selected(figures(folder_of_scripts()), arguments.values("figure"), source);
  if (chosen.empty()) refuse(path + ": no figure draws such a table (--figure NAME lists them)");
  const std::string settings =
      "file=" + quoted(path) + "; format=" + quoted(format) + "; ehl=" + quoted(program_path()) + source.settings;
  for (const Figure& figure : chosen) {
    const std::string picture = picture_name(path, figure.name, figure.movie ? "gif" : format);
    run_gnuplot({"gnuplot", "-e", settings + "; output=" + quoted(picture), figure.script}, figure.name);
    std::error_code error;
    if (files::file_size(picture, error) == 0 || error)
      throw core::FileError(picture + ": gnuplot could not write the picture");
    print(picture + "\n");
  }
  return solved;
}

}  // namespace ehl::program
