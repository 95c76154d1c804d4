#include "tables/time_study_point.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "base/machine.hpp"
#include "case/numbers/number.hpp"
#include "core/errors.hpp"
#include "core/norms.hpp"
#include "deck/text.hpp"
#include "judgement/measures.hpp"
#include "run/pipeline.hpp"
#include "tables/csv.hpp"

namespace ehl::program {
namespace {

/// Tolerance for the comparison of two times.
constexpr double rounding = 1e-9;

TimeSample sample_of(const Case& input, const transient::Frame& frame) {
  const core::Grid& grid = input.scene.grid;
  TimeSample sample{frame.T, {}};
  sample.values = {judgement::value_at(grid, frame.H, 0.0, 0.0), core::minimum(frame.H).value,
                   core::maximum(frame.P).value};
  for (const transient::Probed& probed :
       transient::probed_at(grid, frame.P, frame.H, input.transient->parameters.probes))
    sample.values.push_back(probed.P);
  return sample;
}

void take(const transient::MarchReport& report, TimeStudyPoint& point) {
  using transient::MarchEnd;
  const bool complete = report.end != MarchEnd::failed && report.end != MarchEnd::interrupted;
  point.status = complete ? "complete" : "not-complete";
  if (!complete) point.reason = how_it_ended(report);
  point.T = report.T;
  point.steps = report.steps;
  point.cycles = report.cycles;
  point.rejected = report.rejected;
  point.not_solved = report.not_solved;
  point.jumps = report.restarts;
  point.seconds = point.seconds_most = report.seconds;
}

}  // namespace

std::vector<std::string> time_study_quantities(std::size_t probes) {
  std::vector<std::string> list{id::Hc, id::Hm, id::P_max};
  for (std::size_t k = 1; k <= probes; ++k) list.push_back("P_" + std::to_string(k));
  return list;
}

std::string name_of_variant(const TimeVariant& variant) {
  return fmt::format("rtol {:g}, steps of at most {:.3g}", variant.rtol, variant.longest_step);
}

double cycles_per_step(const TimeStudyPoint& point) { return static_cast<double>(point.cycles) / point.steps; }

std::vector<Column<TimeStudyPoint>> time_study_columns(const std::vector<std::string>& quantities,
                                                       const std::optional<SiScales>& si) {
  using Point = TimeStudyPoint;
  std::vector<Column<Point>> list{
      {"rtol", "-", "tolerance of the time integration", part(&Point::variant, &TimeVariant::rtol)},
      {"longest_step", "a/u_m", "longest allowed step", part(&Point::variant, &TimeVariant::longest_step)},
      {id::time, "a/u_m", "reached", &Point::T},
      {"steps", "-", "number of time steps", &Point::steps},
      {id::cycles, "-", "cycles of all steps", &Point::cycles},
      {"cycles_per_step", "-", "mean", cycles_per_step},
      {"rejected", "-", "attempts that failed the error test", &Point::rejected},
      {"not_solved", "-", "attempts that the cycles did not solve", &Point::not_solved},
      {"jumps", "-", "jumps of load or speed", &Point::jumps},
      {id::seconds, "s", "time of the run in time; the shortest of the repetitions", &Point::seconds},
      {"seconds_most", "s", "longest time of the repetitions", &Point::seconds_most},
      numbers::column<Point>(id::peak_memory, &Point::peak_memory),
      {id::status, "", "how the run ended", &Point::status}};
  if (si) {
    const double ms = si_unit("a/u_m", *si).factor;
    list.insert(list.begin() + 1, {{"longest_step_ms", "ms", "longest allowed step",
                                    [ms](const Point& point) { return ms * point.variant.longest_step; }},
                                   {"time_ms", "ms", "reached", [ms](const Point& point) { return ms * point.T; }}});
  }
  for (std::size_t k = 0; k < quantities.size(); ++k)
    list.push_back({"deviation_" + quantities[k], "-", "relative deviation from the reference, largest over the run",
                    [k](const Point& point) { return k < point.errors.size() ? point.errors[k] : Point::unknown; }});
  list.push_back({id::reason, "", "why it is not complete", &Point::reason});
  return list;
}

std::string text_of(const TimeStudyPoint& point) {
  std::string text = csv_text(time_study_columns({}), point);
  for (const TimeSample& sample : point.samples) {
    text += "\n" + csv_cell(sample.T);
    for (const double value : sample.values) text += "," + csv_cell(value);
  }
  return text;
}

void read_text(const std::string& text, TimeStudyPoint& point) {
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  point = csv_read(time_study_columns({}), line);
  while (std::getline(lines, line)) {
    TimeSample sample;
    for (const std::string& word : deck::split_words(line))
      sample.values.push_back(std::get<double>(csv_value(word, 0.0)));
    if (sample.values.empty()) throw core::FileError("a sample of a study is empty");
    sample.T = sample.values.front();
    sample.values.erase(sample.values.begin());
    point.samples.push_back(std::move(sample));
  }
}

TimeStudyPoint measure_in_time(Case input, const TimeVariant& variant, int samples) {
  TimeStudyPoint point;
  point.variant = variant;
  point.status = "not-complete";
  transient::MarchParameters& march = input.transient->parameters;
  march.rtol = variant.rtol;
  march.longest_step = variant.longest_step;
  march.output_interval = samples > 0 ? march.end / samples : transient::MarchParameters::none;
  Progress silent(true);
  RunSettings settings{.progress = silent};
  settings.frame = [&](transient::Frame&& frame) {
    // If the run ends early, its last frame may lie between two times of comparison; that frame is ignored.
    const double parts = frame.T / march.output_interval;
    if (std::abs(parts - std::round(parts)) < rounding * samples) point.samples.push_back(sample_of(input, frame));
  };
  Computed computed;
  solve_case(input, settings, computed);
  if (computed.in_time)
    take(computed.in_time->report, point);
  else
    point.reason =
        (computed.unsolved.empty() ? "the steady start did not converge: " : "") + computed.solution.failed_check;
  point.peak_memory = peak_memory();
  return point;
}

bool is_complete(const TimeStudyPoint& point) { return point.status == "complete"; }

}  // namespace ehl::program
