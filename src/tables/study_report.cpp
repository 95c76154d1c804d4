#include "tables/study_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/text_format.hpp"
#include "deck/text.hpp"
#include "tables/csv.hpp"

namespace ehl::program {
namespace {

std::string nodes_of(const StudyPoint& point) { return fmt::format("{} x {}", point.nx + 1, point.ny + 1); }

std::string cells_of(const Reference& reference) {
  std::vector<std::string> cells;
  for (const int one : reference.cells) cells.push_back(std::to_string(one));
  return deck::joined(cells, ", ");
}

// The error, or the one below which nothing can be told.
std::string error_text(double error, bool at_reference, const Extrapolated& reference) {
  return at_reference ? "< " + percent(reference.error) : percent(error);
}

std::string fronts_of(const StudyPoint& point) {
  return std::string(point.front_Hc ? "Hc" : "") + (point.front_Hc && point.front_Hm ? " " : "") +
         (point.front_Hm ? "Hm" : "");
}

std::string point_line(const StudyPoint& point, const Reference& reference) {
  const std::string status = point.status == "converged" ? "" : point.status;
  std::string line =
      fmt::format("{:>11}  {:<9}  {:<9}  {:>6}  {:>8}  {:>8}  {:>9}  {:>9}  {:>10}  {:>8}  {:<13}  {}", nodes_of(point),
                  point.way.wedge, point.way.evaluator, point.way.cycles, known("{:.5f}", point.Hc),
                  known("{:.5f}", point.Hm), error_text(point.error_Hc, point.at_reference_Hc, reference.Hc),
                  error_text(point.error_Hm, point.at_reference_Hm, reference.Hm), known("{:.1f}", point.work_units),
                  known("{:.3f}", point.seconds), status, fronts_of(point));
  return line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
}

std::string column_line() {
  return "      nodes  wedge      evaluator  cycles        Hc        Hm  error(Hc)  error(Hm)  work units   seconds  "
         "status         front\n";
}

std::string front_lines(const std::vector<StudyPoint>& points, const Reference& reference, bool StudyPoint::*on_front,
                        const std::string& name) {
  std::vector<StudyPoint> front;
  for (const StudyPoint& point : points)
    if (point.*on_front) front.push_back(point);
  std::sort(front.begin(), front.end(), [](const StudyPoint& a, const StudyPoint& b) { return a.seconds < b.seconds; });
  std::string text = "\nPareto front of " + name + ": nothing cheaper is as accurate\n" + column_line();
  for (const StudyPoint& point : front) text += point_line(point, reference);
  return text;
}

std::string accuracy_lines(const std::vector<StudyPoint>& points) {
  std::string text = "\nseconds to an accuracy that holds on all finer grids too\n";
  struct Wanted {
    const char* name;
    double StudyPoint::*error;
  };
  for (const Wanted& wanted : {Wanted{"Hc", &StudyPoint::error_Hc}, Wanted{"Hm", &StudyPoint::error_Hm}})
    for (const double error : {1e-2, 1e-3, 1e-4}) {
      const std::size_t found = cheapest(points, wanted.error, error);
      text += fmt::format("  {} to {:<6}", wanted.name, fmt::format("{:g} %", 100.0 * error));
      text += found == points.size() ? "  not reached\n"
                                     : fmt::format("  {:.3f} s: {}, ", points[found].seconds, nodes_of(points[found])) +
                                           name_of_way(points[found].way) + "\n";
    }
  return text;
}

std::vector<std::string> distinct(const std::vector<StudyPoint>& points, std::string StudyCase::*part) {
  std::vector<std::string> found;
  for (const StudyPoint& point : points)
    if (std::find(found.begin(), found.end(), point.way.*part) == found.end()) found.push_back(point.way.*part);
  return found;
}

// The program's own choice where it is among them.
std::string one_of(const std::vector<std::string>& words, const std::string& preferred) {
  return std::find(words.begin(), words.end(), preferred) != words.end() ? preferred : words.front();
}

std::vector<int> levels_of(const std::vector<StudyPoint>& points) {
  std::vector<int> cells;
  for (const StudyPoint& point : points)
    if (cells.empty() || cells.back() != point.way.cells) cells.push_back(point.way.cells);
  return cells;
}

const StudyPoint* find(const std::vector<StudyPoint>& points, const StudyCase& way) {
  const auto found = std::find_if(points.begin(), points.end(), [&](const StudyPoint& point) {
    return point.way.cells == way.cells && name_of_way(point.way) == name_of_way(way);
  });
  return found == points.end() ? nullptr : &*found;
}

// What a film without convergence must carry.
std::string mark(const StudyPoint& point) { return point.status == "converged" ? " " : "*"; }

std::string line_of_films(const std::vector<StudyPoint>& points, StudyCase way) {
  std::string nodes = "-";
  std::string line;
  for (const std::string& wedge : distinct(points, &StudyCase::wedge)) {
    way.wedge = wedge;
    const StudyPoint* point = find(points, way);
    if (point != nullptr) nodes = nodes_of(*point);
    for (const double value : {point ? point->Hm : StudyPoint::unknown, point ? point->Hc : StudyPoint::unknown})
      line += fmt::format("  {:>12}", (known("{:.5f}", value) + (point ? mark(*point) : " ")));
  }
  return fmt::format("{:>11}", nodes) + line + "\n";
}

std::string reference_lines(const Reference& reference) {
  return fmt::format(
      "# reference cells: {}\n# reference Hc: {}\n# reference Hm: {}\n# reference error Hc: {}\n"
      "# reference error Hm: {}\n",
      cells_of(reference), csv_cell(reference.Hc.value), csv_cell(reference.Hm.value), csv_cell(reference.Hc.error),
      csv_cell(reference.Hm.error));
}

constexpr char how_to_read[] =
    "# reference: extrapolated from second-order solutions with FFT and a residual of 1e-10; its error relative\n"
    "# cycles: 2W are two W(2,1) cycles on every level (the first grid has its own); run: what ehl run does\n"
    "# status: converged, stopped (after the cycles of its way, not converged), not-converged, failed (the program); "
    "errors of what did not converge are those of what was left\n"
    "# work_units: whole solution, in evaluations of the finest grid; H = h R/a^2; errors and estimates relative\n"
    "# error: against the reference; estimate: of the discretization, by the run itself; at_reference: the error is "
    "below the reference's own; front: nothing cheaper [s] is as accurate\n";

}  // namespace

std::string times_of(const StudyHeader& header) {
  return fmt::format("least of {}, {} each, ", header.repeats, threads_text(header.threads)) +
         (header.jobs == 1 ? "one solution after another"
                           : fmt::format("{} solutions at a time: SHARED, not to be compared", header.jobs));
}

std::string origin_lines(const StudyHeader& header, const std::string& times) {
  std::string text = fmt::format("\n# program: {}\n# deck: {}\n{}\n# title: {}\n", header.program, header.deck,
                                 deck_text_line(header.deck_text), header.title);
  for (const std::string& set : header.set) text += "# set: " + set + "\n";
  return text + fmt::format("# machine: {}\n# date: {}\n# times: {}\n", header.machine, header.date, times);
}

std::string study_csv(const StudyHeader& header, const Reference& reference, const std::vector<StudyPoint>& points) {
  std::string text = study_mark + origin_lines(header, times_of(header)) + reference_lines(reference) + how_to_read +
                     study_units() + "\n" + study_columns() + "\n";
  for (const StudyPoint& point : points) text += study_text(point) + "\n";
  return text;
}

std::string film_by_level(const std::vector<StudyPoint>& points) {
  const std::vector<std::string> cycles = distinct(points, &StudyCase::cycles);
  StudyCase way{0, "", one_of(distinct(points, &StudyCase::evaluator), "mlmi8"), one_of(cycles, "2W")};
  std::string text = "\nTable 1: the film by level, " + way.evaluator + ", " + way.cycles +
                     " (* not converged: what these cycles leave)\n      nodes";
  for (const std::string& wedge : distinct(points, &StudyCase::wedge))
    text += fmt::format("  {:>12}  {:>12}", ("Hm " + wedge), ("Hc " + wedge));
  text += "\n";
  for (const int cells : levels_of(points)) {
    way.cells = cells;
    text += line_of_films(points, way);
  }
  return text;
}

std::string seconds_by_level(const std::vector<StudyPoint>& points) {
  StudyCase way{0, distinct(points, &StudyCase::wedge).front(),
                one_of(distinct(points, &StudyCase::evaluator), "mlmi8"), ""};
  std::string text =
      "\nTable 2: seconds by level and cycles per level, " + way.wedge + ", " + way.evaluator + "\n      nodes";
  const std::vector<std::string> all = distinct(points, &StudyCase::cycles);
  for (const std::string& cycles : all) text += fmt::format("  {:>8}", cycles);
  text += "\n";
  for (const int cells : levels_of(points)) {
    std::string nodes = "-";
    std::string line;
    way.cells = cells;
    for (const std::string& cycles : all) {
      way.cycles = cycles;
      const StudyPoint* point = find(points, way);
      if (point != nullptr) nodes = nodes_of(*point);
      line += fmt::format("  {:>8}", known("{:.3f}", point ? point->seconds : StudyPoint::unknown));
    }
    text += fmt::format("{:>11}", nodes) + line + "\n";
  }
  return text;
}

std::string study_report(const StudyHeader& header, const Reference& reference, const std::vector<StudyPoint>& points) {
  std::string text = "case         " + header.title + "\n";
  text += fmt::format("reference    Hc = {:.7f} to {}, Hm = {:.7f} to {}\n", reference.Hc.value,
                      percent(reference.Hc.error), reference.Hm.value, percent(reference.Hm.error));
  text += fmt::format("             second order, FFT, {} cells, extrapolated; residual {:.0e}\n", cells_of(reference),
                      reference.residual);
  text += "times        " + times_of(header) + "\n\n" + column_line();
  for (const StudyPoint& point : points) text += point_line(point, reference);
  text += "(< below the reference's own error; stopped: after the cycles of its way, not converged)\n";
  text += front_lines(points, reference, &StudyPoint::front_Hc, "Hc");
  text += front_lines(points, reference, &StudyPoint::front_Hm, "Hm");
  return text + accuracy_lines(points) + film_by_level(points) + seconds_by_level(points);
}

}  // namespace ehl::program
