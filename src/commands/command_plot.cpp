// ehl plot: runs the gnuplot scripts of postprocess/ with a result or with the table of a sweep or a study.
#include <fmt/core.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>

#include "base/exit_status.hpp"
#include "base/machine.hpp"
#include "case/numbers/number.hpp"
#include "commands/commands.hpp"
#include "commands/curves.hpp"
#include "commands/gnuplot.hpp"
#include "commands/pictures.hpp"
#include "core/errors.hpp"
#include "deck/file.hpp"
#include "deck/text.hpp"
#include "results/outputs.hpp"
#include "results/read.hpp"
#include "tables/measured.hpp"
#include "tables/series.hpp"
#include "tables/study_report.hpp"
#include "tables/sweep_table.hpp"
#include "tables/time_study_report.hpp"

namespace ehl::program {
namespace {

namespace files = std::filesystem;

// True if the times of a deck are in seconds.
bool counts_in_seconds(const std::string& deck) { return deck.find("\ntime_unit = seconds") != std::string::npos; }

// The frame that --time asks for, else the last one: its number, and its time in words.
std::vector<Setting> chosen_frame(const results::ResultFile& result, const Arguments& arguments) {
  const bool in_time = result.kind("/transient/frames/time") == results::ResultFile::Kind::numbers;
  if (!in_time && arguments.has("time")) refuse("--time: " + result.path() + " does not contain a run in time");
  if (!in_time) return {};
  const std::vector<double> times = result.numbers("/transient/frames/time").values;
  if (times.empty()) throw core::FileError(result.path() + ": the file is damaged: no field in time");
  const bool seconds = counts_in_seconds(result.text("/deck"));
  const double unit = seconds ? result.numbers(numbers::path_of(id::time)).values.at(0) : 1.0;
  std::size_t frame = times.size() - 1;
  if (arguments.has("time")) {
    const std::string given = arguments.value("time", "");
    const deck::ReadNumber read = deck::read_number(given);
    const double first = times.front() * unit, last = times.back() * unit;
    if (read.status != deck::ReadNumber::Status::number || read.value < first || read.value > last)
      refuse("--time " + given + ": must be a number from " + deck::shortest(first) + " to " + deck::shortest(last) +
             (seconds ? " s" : " a/u_m"));
    const auto distance = [&](double time) { return std::abs(time * unit - read.value); };
    frame = static_cast<std::size_t>(std::ranges::min_element(times, {}, distance) - times.begin());
  }
  const double shown = times[frame] * unit;
  return {{"frame", std::to_string(frame), false},
          {"seconds", seconds ? "1" : "0", false},
          {"when", seconds ? fmt::format("t = {:.4g} ms", 1e3 * shown) : fmt::format("T = {:.4g}", shown)}};
}

// True if there is any pressure in the field that is shown; the bodies may be separated.
bool any_pressure(const results::ResultFile& result, const std::vector<Setting>& settings) {
  const std::string frames = "/transient/frames/P";
  const auto frame = std::ranges::find(settings, "frame", &Setting::name);
  if (frame == settings.end() || result.kind(frames) == results::ResultFile::Kind::missing) return true;
  const results::Array P = result.frame(frames, std::stoul(frame->value));
  return std::ranges::any_of(P.values, [](double p) { return p > 0.0; });
}

FigureSource result_source(const std::string& path, const Arguments& arguments) {
  const auto result = std::make_shared<results::ResultFile>(path);
  std::vector<Setting> settings = chosen_frame(*result, arguments);
  const bool pressed = any_pressure(*result, settings);
  // The map of a roller would be a strip many times as long as wide, so it is not drawn.
  const bool roller = result->kind("/roller") != results::ResultFile::Kind::missing;
  const bool map = result->dims("/grid/y").at(0) > 1 && !roller;
  const auto has = [result, pressed, map](const std::string& need) {
    if (need == map_need) return map;
    return need == pressure_need ? pressed : result->kind(need) != results::ResultFile::Kind::missing;
  };
  const std::string own = result->attribute("/", "title");
  settings.push_back({"title", own == "untitled" ? "" : own});
  if (has(numbers::path_of(id::a))) settings.push_back({"si", "1", false});
  return {settings, "result", has};
}

bool names_axes(const Arguments& arguments) { return arguments.has("x") || arguments.has("y") || arguments.has("by"); }

FigureSource table_source(const std::string& path, const Arguments& arguments) {
  if (arguments.has("time")) refuse("--time chooses a field of a run in time, and a table has none");
  const std::string mark = mark_of(path);
  const std::string kind = mark == sweep_mark ? "sweep" : mark == study_mark ? "study" : "time_study";
  if (kind != "sweep") return {{}, kind, [kind](const std::string& need) { return need == kind; }};
  const auto table = std::make_shared<SweepData>(read_sweep(path));
  const bool chosen = names_axes(arguments);
  const auto has = [table, chosen](const std::string& need) {
    return need == "sweep" || (need == curves_need ? chosen || makes_curves(*table) : table->has(need));
  };
  return {{}, kind, has, table};
}

// The rows of a sweep as a figure needs them, in a temporary file that gnuplot reads and that ends with this process.
class ArrangedRows {
 public:
  ArrangedRows() : descriptor_(::memfd_create("rows", 0)) {
    if (descriptor_ < 0) throw core::FileError(std::string("no memory for a picture: ") + std::strerror(errno));
  }
  ~ArrangedRows() { ::close(descriptor_); }
  ArrangedRows(const ArrangedRows&) = delete;
  ArrangedRows& operator=(const ArrangedRows&) = delete;

  /// Replaces the contents. out: the file's name for gnuplot.
  std::string hold(const std::string& text) const {
    const bool done = ::ftruncate(descriptor_, 0) == 0 &&
                      ::pwrite(descriptor_, text.data(), text.size(), 0) == static_cast<ssize_t>(text.size());
    if (!done) throw core::FileError(std::string("no memory for a picture: ") + std::strerror(errno));
    return "/proc/self/fd/" + std::to_string(descriptor_);
  }

 private:
  int descriptor_;
};

// The curves of a figure: --x, --y and --by for `curves`; for the other figure, friction and film
// against the slide-roll ratio.
CurvesWanted curves_for(const Figure& figure, const SweepData& table, const Arguments& arguments) {
  if (figure.name == "curves") return chosen_curves(table, arguments);
  const std::vector<std::string> film = films(table);
  if (film.empty()) refuse(table.path + ": the table has no film");
  CurvesWanted wanted{"motion.srr", {id::mu, film[0]}, {}, arguments.value("axes", "linear")};
  for (const std::string& key : table.varied)
    if (key != wanted.x) wanted.by.push_back(key);
  return wanted;
}

// Measured points as rows for gnuplot.
std::string measured_rows(const std::string& path) {
  std::string text;
  for (const MeasuredPoint& point : read_measured(path))
    text += fmt::format("{:.9g} {:.9g} {:.9g}\n", point.srr, point.mu, point.sigma);
  return text;
}

std::string gnuplot_text(const std::vector<Setting>& settings) {
  std::string text;
  for (const Setting& one : settings)
    text += (text.empty() ? "" : "; ") + one.name + "=" + (one.is_text ? gnuplot_literal(one.value) : one.value);
  return text;
}

std::vector<std::string> wanted_figures(const Arguments& arguments, bool is_sweep) {
  std::vector<std::string> names = arguments.values("figure");
  if (!names_axes(arguments)) return names;
  if (!is_sweep) refuse("--x, --y and --by need the table of a sweep");
  if (names.empty()) names = {"curves"};
  if (names != std::vector<std::string>{"curves"}) refuse("--x, --y and --by need --figure curves");
  return names;
}

}  // namespace

int plot(const Arguments& arguments) {
  const std::string& path = arguments.operands[0];
  const FigureSource source = path.ends_with(".csv") ? table_source(path, arguments) : result_source(path, arguments);
  const std::vector<Figure> chosen =
      selected_figures(figures_in(folder_of_scripts()), wanted_figures(arguments, source.table != nullptr), source);
  if (chosen.empty() && source.table == nullptr) refuse(path + ": no figure can draw its content");
  if (chosen.empty())
    refuse(path +
           ": no figure draws this table automatically, because no key has three values or more; --x KEY draws curves "
           "over a key with fewer (`ehl help plot` lists the figures)");
  const Pictures pictures = pictures_of(arguments, chosen);
  std::vector<std::string> inputs{path};
  if (arguments.has("measured")) inputs.push_back(arguments.value("measured", ""));
  std::vector<results::Output> outputs;
  for (const std::string& name : pictures.names) outputs.push_back({name, results::FileKind::picture, true});
  results::check_files(inputs, outputs);
  PlainNames names;
  const std::string scripts = names.of(folder_of_scripts(), "scripts");
  std::vector<Setting> settings{
      {"file", names.of(path, "data")}, {"ehl", names.of(program_path(), "ehl")}, {"format", pictures.format}};
  settings.insert(settings.end(), source.settings.begin(), source.settings.end());
  settings.insert(settings.end(), pictures.settings.begin(), pictures.settings.end());
  if (arguments.has("title")) settings.push_back({"title", arguments.value("title", "")});
  const ArrangedRows rows, measured;
  if (arguments.has("measured")) {
    if (std::ranges::find(chosen, "traction_curve", &Figure::name) == chosen.end())
      refuse("--measured: no figure of this file is a traction curve");
    settings.push_back({"measured", measured.hold(measured_rows(arguments.value("measured", "")))});
  }
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    std::vector<Setting> own = settings;
    own.push_back({"output", no_pipe(pictures.names[k])});
    if (chosen[k].of_curves) {
      const Curves curves = curves_of(*source.table, curves_for(chosen[k], *source.table, arguments));
      own.insert(own.end(), curves.settings.begin(), curves.settings.end());
      own.push_back({"data", rows.hold(curves.data)});
    }
    run_gnuplot(gnuplot_text(own), scripts + "/" + files::path(chosen[k].script).filename().string(), chosen[k].name);
    std::error_code error;
    if (files::file_size(pictures.names[k], error) == 0 || error)
      throw core::FileError(pictures.names[k] + ": gnuplot could not write the picture");
    print(pictures.names[k] + "\n");
  }
  return solved;
}

}  // namespace ehl::program
