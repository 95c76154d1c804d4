#include "commands/figure_source.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "case/numbers/number.hpp"
#include "core/errors.hpp"
#include "deck/text.hpp"
#include "results/read.hpp"
#include "tables/asperity_table.hpp"
#include "tables/series.hpp"
#include "tables/study_report.hpp"
#include "tables/sweep_table.hpp"
#include "tables/time_study_report.hpp"

namespace ehl::program {
namespace {

// True if the times of an effective deck are in seconds; what follows from a machine stands there as a comment.
bool counts_in_seconds(const std::string& deck) {
  const auto says = [&](const char* line) { return deck.find(line) != std::string::npos; };
  return says("\ntime_unit = seconds") || says("\n# time_unit = seconds");
}

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

FigureSource table_source(const std::string& path, const Arguments& arguments) {
  if (arguments.has("time")) refuse("--time chooses a field of a run in time, and a table has none");
  const std::string mark = mark_of(path);
  const std::string kind = mark == sweep_mark        ? "sweep"
                           : mark == study_mark      ? "study"
                           : mark == time_study_mark ? "time_study"
                                                     : "asperities";
  if (kind != "sweep") return {{}, kind, [kind](const std::string& need) { return need == kind; }};
  const auto table = std::make_shared<SweepData>(read_sweep(path));
  const bool chosen = names_axes(arguments);
  const auto has = [table, chosen](const std::string& need) {
    return need == "sweep" || (need == curves_need ? chosen || makes_curves(*table) : table->has(need));
  };
  return {{}, kind, has, table};
}

}  // namespace

FigureSource source_of(const std::string& path, const Arguments& arguments) {
  return path.ends_with(".csv") ? table_source(path, arguments) : result_source(path, arguments);
}

bool names_axes(const Arguments& arguments) { return arguments.has("x") || arguments.has("y") || arguments.has("by"); }

CurvesWanted curves_for(const Figure& figure, const SweepData& table, const Arguments& arguments) {
  if (figure.name == "curves") return chosen_curves(table, arguments);
  const std::vector<std::string> film = films(table);
  if (film.empty()) refuse(table.path + ": the table has no film");
  CurvesWanted wanted{"motion.srr", {id::mu, film[0]}, {}, arguments.value("axes", "linear")};
  for (const std::string& key : table.varied)
    if (key != wanted.x) wanted.by.push_back(key);
  return wanted;
}

}  // namespace ehl::program
