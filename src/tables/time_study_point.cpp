#include "tables/time_study_point.hpp"

#include <cmath>
#include <sstream>

#include "commands/machine.hpp"
#include "commands/transient_run.hpp"
#include "core/errors.hpp"
#include "core/norms.hpp"
#include "deck/text.hpp"
#include "report/text_format.hpp"
#include "steady/solve.hpp"
#include "judgement/measures.hpp"
#include "tables/csv.hpp"

namespace ehl::program {
namespace {

constexpr std::size_t columns_before_errors = 13;
/// Of times.
constexpr double rounding = 1e-9;

double number_in(const std::string& cell) {
  if (cell == "NaN") return TimeStudyPoint::unknown;
  const deck::ReadNumber read = deck::read_number(cell);
  if (read.status != deck::ReadNumber::Status::number)
    throw core::FileError("this is no number of a study: " + cell.substr(0, 40));
  return read.value;
}

std::vector<double> numbers_in(const std::string& line) {
  std::vector<double> numbers;
  for (const std::string& word : deck::split_words(line)) numbers.push_back(number_in(word));
  return numbers;
}

std::string numbers_text(const std::vector<double>& numbers) {
  std::vector<std::string> texts;
  for (const double value : numbers) texts.push_back(csv_number(value));
  return deck::joined(texts, ",");
}

std::vector<double> counts_of(const TimeStudyPoint& point) {
  return {point.way.rtol,
          point.way.longest_step,
          point.T,
          static_cast<double>(point.steps),
          static_cast<double>(point.cycles),
          static_cast<double>(point.cycles) / point.steps,
          static_cast<double>(point.rejected),
          static_cast<double>(point.not_solved),
          static_cast<double>(point.jumps),
          point.seconds,
          point.seconds_most,
          point.peak_memory};
}

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
  std::vector<std::string> names{"Hc", "Hm", "P_max"};
  for (std::size_t k = 1; k <= probes; ++k) names.push_back(formatted("P_%zu", k));
  return names;
}

std::string time_study_columns(std::size_t probes) {
  std::string text =
      "rtol,longest_step,time,steps,cycles,cycles_per_step,rejected,not_solved,jumps,seconds,seconds_most,peak_memory,"
      "status";
  for (const std::string& name : time_study_quantities(probes)) text += ",error_" + name;
  return text + ",reason";
}

std::string time_study_row(const TimeStudyPoint& point) {
  return numbers_text(counts_of(point)) + "," + csv_word(point.status) + "," + numbers_text(point.errors) + "," +
         csv_quoted(point.reason);
}

std::string text_of(const TimeStudyPoint& point) {
  std::string text = numbers_text(counts_of(point)) + "," + csv_word(point.status) + "," + csv_quoted(point.reason);
  for (const TimeSample& sample : point.samples)
    text += "\n" + csv_number(sample.T) + "," + numbers_text(sample.values);
  return text;
}

TimeStudyPoint time_study_point(const std::string& text) {
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> cells = csv_cells(line, columns_before_errors + 1);
  if (cells.size() != columns_before_errors + 1)
    throw core::FileError("this is no point of a study: " + line.substr(0, 120));
  const auto whole = [&](std::size_t k) { return static_cast<int>(number_in(cells[k])); };
  TimeStudyPoint point;
  point.way = {number_in(cells[0]), number_in(cells[1])};
  point.T = number_in(cells[2]);
  point.steps = whole(3);
  point.cycles = whole(4);
  point.rejected = whole(6);
  point.not_solved = whole(7);
  point.jumps = whole(8);
  point.seconds = number_in(cells[9]);
  point.seconds_most = number_in(cells[10]);
  point.peak_memory = number_in(cells[11]);
  point.status = cells[12];
  point.reason = cells[13];
  while (std::getline(lines, line)) {
    const std::vector<double> numbers = numbers_in(line);
    if (numbers.empty()) throw core::FileError("a sample of a study is empty");
    point.samples.push_back({numbers.front(), {numbers.begin() + 1, numbers.end()}});
  }
  return point;
}

TimeStudyPoint measure_in_time(Case input, const TimeWay& way, int samples) {
  TimeStudyPoint point;
  point.way = way;
  point.status = "not-complete";
  transient::MarchParameters& march = input.transient->parameters;
  march.rtol = way.rtol;
  march.longest_step = way.longest_step;
  march.output_interval = samples > 0 ? march.end / samples : transient::MarchParameters::none;
  transient::Observer observer;
  if (samples > 0)
    observer.frame = [&](transient::Frame&& frame) {
      // The last one may stand between the times of comparison, where the run ends before its end time.
      const double parts = frame.T / march.output_interval;
      if (std::abs(parts - std::round(parts)) < rounding * samples) point.samples.push_back(sample_of(input, frame));
    };
  try {
    const steady::Solution start = steady::solve(input.scene);
    if (!start.converged) throw core::SolverError("the steady start did not converge: " + start.failed_check);
    take(transient::march(input.scene, start, input.transient->conditions, march, observer), point);
  } catch (const core::SolverError& error) {
    point.reason = error.what();
  }
  point.peak_memory = peak_memory();
  return point;
}

void add_repetition(const TimeStudyPoint& again, TimeStudyPoint& point) {
  point.seconds = std::fmin(point.seconds, again.seconds);
  point.seconds_most = std::fmax(point.seconds_most, again.seconds_most);
  point.peak_memory = std::fmax(point.peak_memory, again.peak_memory);
}

bool is_complete(const TimeStudyPoint& point) { return point.status == "complete"; }

}  // namespace ehl::program
