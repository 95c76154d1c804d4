#include "tables/study_point.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "case/numbers/number.hpp"
#include "core/errors.hpp"
#include "deck/text.hpp"
#include "tables/csv.hpp"

namespace ehl::program {
namespace {

constexpr char at_reference[] = "1: the deviation is below the error of the reference";
constexpr char on_front[] = "1: on the Pareto front, no cheaper variant is as accurate";

auto deviation(std::size_t quantity) {
  return [quantity](const StudyPoint& point) { return point.of(quantity).deviation; };
}

}  // namespace

bool is_complete(const StudyPoint& point) { return point.status == "converged" || point.status == "complete"; }

std::vector<Column<StudyPoint>> study_columns(const std::optional<SiScales>& si) {
  using Point = StudyPoint;
  using numbers::column;
  std::vector<Column<Point>> columns{
      {"cells", "-", "cells along x of the finest grid", part(&Point::variant, &StudyCase::cells)},
      {"wedge", "", "scheme of the wedge term", part(&Point::variant, &StudyCase::wedge)},
      {"evaluator", "", "evaluation of the deformation", part(&Point::variant, &StudyCase::evaluator)},
      {id::cycles, "", "number and shape of the cycles, or run", part(&Point::variant, &StudyCase::cycles)},
      {id::status, "", "how the solution ended", &Point::status},
      column<Point>(id::nx, &Point::nx),
      column<Point>(id::ny, &Point::ny),
      column<Point>(id::Hc, &Point::Hc),
      column<Point>(id::Hm, &Point::Hm),
      {"deviation_Hc", "-", "relative deviation from the reference", deviation(of_Hc)},
      {"deviation_Hm", "-", "relative deviation from the reference", deviation(of_Hm)},
      {"estimate_Hc", "-", "relative discretization error as estimated by the run", &Point::estimate_Hc},
      {"estimate_Hm", "-", "relative discretization error as estimated by the run", &Point::estimate_Hm},
      column<Point>(id::residual, &Point::residual),
      {"cycles_by_level", "", "values from the first grid to the finest", &Point::cycles_by_level},
      {"attempts", "-", "number of strategies tried", &Point::attempts},
      {id::work_units, "-", "work of the whole solution, in evaluations of the finest grid", &Point::work_units},
      {id::seconds, "s", "shortest time of the repetitions", &Point::seconds},
      {"seconds_most", "s", "longest time of the repetitions", &Point::seconds_most},
      column<Point>(id::peak_memory, &Point::peak_memory),
      {"at_reference_Hc", "-", at_reference, [](const Point& point) { return point.of(of_Hc).at_reference; }},
      {"at_reference_Hm", "-", at_reference, [](const Point& point) { return point.of(of_Hm).at_reference; }},
      {"front_Hc", "-", on_front, [](const Point& point) { return point.of(of_Hc).front; }},
      {"front_Hm", "-", on_front, [](const Point& point) { return point.of(of_Hm).front; }},
      {id::reason, "", "why there is no solution", &Point::reason}};
  if (!si) return columns;
  const double nm = si_unit("a^2/R", *si).factor;
  const auto in_nm = [nm](double Point::*film) { return [nm, film](const Point& point) { return nm * point.*film; }; };
  const auto film = std::ranges::find(columns, id::Hc, &Column<Point>::name);
  columns.insert(film, {{numbers::column_in_si(id::hc), "nm", numbers::number_of(id::hc).meaning, in_nm(&Point::Hc)},
                        {numbers::column_in_si(id::hm), "nm", numbers::number_of(id::hm).meaning, in_nm(&Point::Hm)}});
  return columns;
}

void add_repetition(const StudyPoint& again, StudyPoint& point) {
  if (point.status == "failed") {
    point = again;
  } else if (again.status != "failed") {
    point.seconds = std::fmin(point.seconds, again.seconds);
    point.seconds_most = std::fmax(point.seconds_most, again.seconds_most);
    point.peak_memory = std::fmax(point.peak_memory, again.peak_memory);
  }
}

std::vector<std::string> time_study_quantities(std::size_t probes) {
  std::vector<std::string> list{id::Hc, id::Hm, id::P_max};
  for (std::size_t k = 1; k <= probes; ++k) list.push_back("P_" + std::to_string(k));
  return list;
}

double cycles_per_step(const StudyPoint& point) { return static_cast<double>(point.cycles) / point.steps; }

std::vector<Column<StudyPoint>> time_study_columns(const std::vector<std::string>& quantities,
                                                   const std::optional<SiScales>& si) {
  using Point = StudyPoint;
  std::vector<Column<Point>> list{
      {"rtol", "-", "tolerance of the time integration", part(&Point::variant, &StudyCase::rtol)},
      {"longest_step", "a/u_m", "longest allowed step", part(&Point::variant, &StudyCase::longest_step)},
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
                    deviation(k)});
  list.push_back({id::reason, "", "why it is not complete", &Point::reason});
  return list;
}

namespace {

std::vector<Column<StudyPoint>> columns_of(const StudyPoint& point) {
  return point.variant.in_time() ? time_study_columns({}) : study_columns();
}

}  // namespace

std::string text_of(const StudyPoint& point) {
  std::string text = csv_text(columns_of(point), point);
  for (const TimeSample& sample : point.samples) {
    text += "\n" + csv_cell(sample.T);
    for (const double value : sample.values) text += "," + csv_cell(value);
  }
  return text;
}

void read_text(const std::string& text, StudyPoint& point) {
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  point = csv_read(columns_of(point), line);
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

}  // namespace ehl::program
