#include "tables/study_report.hpp"

#include <algorithm>
#include <cmath>

#include "deck/text.hpp"
#include "report/text_format.hpp"
#include "tables/csv.hpp"

namespace ehl::program {
namespace {

std::string nodes_of(const StudyPoint& point) { return formatted("%d x %d", point.nx + 1, point.ny + 1); }

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
  std::string line = formatted(
      "%11s  %-9s  %-9s  %6s  %8s  %8s  %9s  %9s  %10s  %8s  %-13s  %s", nodes_of(point).c_str(),
      point.way.wedge.c_str(), point.way.evaluator.c_str(), point.way.cycles.c_str(), known("%.5f", point.Hc).c_str(),
      known("%.5f", point.Hm).c_str(), error_text(point.error_Hc, point.at_reference_Hc, reference.Hc).c_str(),
      error_text(point.error_Hm, point.at_reference_Hm, reference.Hm).c_str(), known("%.1f", point.work_units).c_str(),
      known("%.3f", point.seconds).c_str(), status.c_str(), fronts_of(point).c_str());
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
      text += formatted("  %s to %-6s", wanted.name, formatted("%g %%", 100.0 * error).c_str());
      text += found == points.size()
                  ? "  not reached\n"
                  : formatted("  %.3f s: %s, ", points[found].seconds, nodes_of(points[found]).c_str()) +
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
      line += formatted("  %12s", (known("%.5f", value) + (point ? mark(*point) : " ")).c_str());
  }
  return formatted("%11s", nodes.c_str()) + line + "\n";
}

std::string header_lines(const StudyHeader& header, const Reference& reference) {
  std::string text = std::string(study_mark) + "\n# program: " + header.program + "\n# deck: " + header.deck + "\n" +
                     deck_text_line(header.deck_text) + "\n# title: " + header.title + "\n";
  for (const std::string& set : header.set) text += "# set: " + set + "\n";
  text += "# machine: " + header.machine + "\n# date: " + header.date + "\n# times: " + times_of(header) + "\n";
  text += "# reference cells: " + cells_of(reference) + "\n# reference Hc: " + csv_number(reference.Hc.value) +
          "\n# reference Hm: " + csv_number(reference.Hm.value) +
          "\n# reference error Hc: " + csv_number(reference.Hc.error) +
          "\n# reference error Hm: " + csv_number(reference.Hm.error) + "\n";
  return text +
         "# reference: extrapolated from second-order solutions with FFT and a residual of 1e-10; its error relative\n"
         "# cycles: 2W are two W(2,1) cycles on every level (the first grid has its own); run: what ehl run does\n"
         "# status: converged, stopped (after the cycles of its way, not converged), not-converged, failed (the "
         "program); errors of what did not converge are those of what was left\n"
         "# units: seconds [s] (least and most of the repetitions), peak_memory [bytes]; work_units: whole solution, "
         "in "
         "evaluations of the finest grid; H = h R/a^2; errors and estimates relative\n"
         "# error: against the reference; estimate: of the discretization, by the run itself; at_reference: the error "
         "is below the reference's own; front: nothing cheaper [s] is as accurate\n" +
         study_columns() + "\n";
}

}  // namespace

std::string times_of(const StudyHeader& header) {
  std::string text =
      formatted("least of %d, %d thread%s each, ", header.repeats, header.threads, header.threads == 1 ? "" : "s");
  return text + (header.jobs == 1 ? std::string("one solution after another")
                                  : formatted("%d solutions at a time: SHARED, not to be compared", header.jobs));
}

std::string study_csv(const StudyHeader& header, const Reference& reference, const std::vector<StudyPoint>& points) {
  std::string text = header_lines(header, reference);
  for (const StudyPoint& point : points) text += study_text(point) + "\n";
  return text;
}

std::string film_by_level(const std::vector<StudyPoint>& points) {
  const std::vector<std::string> cycles = distinct(points, &StudyCase::cycles);
  StudyCase way{0, "", one_of(distinct(points, &StudyCase::evaluator), "mlmi8"), one_of(cycles, "2W")};
  std::string text = "\nTable 1: the film by level, " + way.evaluator + ", " + way.cycles +
                     " (* not converged: what these cycles leave)\n      nodes";
  for (const std::string& wedge : distinct(points, &StudyCase::wedge))
    text += formatted("  %12s  %12s", ("Hm " + wedge).c_str(), ("Hc " + wedge).c_str());
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
  for (const std::string& cycles : all) text += formatted("  %8s", cycles.c_str());
  text += "\n";
  for (const int cells : levels_of(points)) {
    std::string nodes = "-";
    std::string line;
    way.cells = cells;
    for (const std::string& cycles : all) {
      way.cycles = cycles;
      const StudyPoint* point = find(points, way);
      if (point != nullptr) nodes = nodes_of(*point);
      line += formatted("  %8s", known("%.3f", point ? point->seconds : StudyPoint::unknown).c_str());
    }
    text += formatted("%11s", nodes.c_str()) + line + "\n";
  }
  return text;
}

std::string study_report(const StudyHeader& header, const Reference& reference, const std::vector<StudyPoint>& points) {
  std::string text = "case         " + header.title + "\n";
  text += formatted("reference    Hc = %.7f to %s, Hm = %.7f to %s\n", reference.Hc.value,
                    percent(reference.Hc.error).c_str(), reference.Hm.value, percent(reference.Hm.error).c_str());
  text += formatted("             second order, FFT, %s cells, extrapolated; residual %.0e\n",
                    cells_of(reference).c_str(), reference.residual);
  text += "times        " + times_of(header) + "\n\n" + column_line();
  for (const StudyPoint& point : points) text += point_line(point, reference);
  text += "(< below the reference's own error; stopped: after the cycles of its way, not converged)\n";
  text += front_lines(points, reference, &StudyPoint::front_Hc, "Hc");
  text += front_lines(points, reference, &StudyPoint::front_Hm, "Hm");
  return text + accuracy_lines(points) + film_by_level(points) + seconds_by_level(points);
}

}  // namespace ehl::program
