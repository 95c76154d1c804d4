#include "tables/study_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/text_format.hpp"
#include "case/numbers/number.hpp"
#include "deck/text.hpp"
#include "tables/csv.hpp"

namespace ehl::program {
namespace {

std::string nodes_of(const StudyPoint& point) { return fmt::format("{} x {}", point.nx + 1, point.ny + 1); }

std::string cells_of(const Reference& reference) { return fmt::format("{}", fmt::join(reference.cells, ", ")); }

// A deviation; "< ..." if it is below the error of the reference.
std::string deviation_text(const Judged& judged, const Extrapolated& reference) {
  return judged.at_reference ? "< " + percent(reference.error) : percent(judged.deviation);
}

// The films in nm, followed by the space between columns; empty without scales.
std::string in_nm(const StudyPoint& point, const std::optional<SiScales>& si) {
  if (!si) return {};
  const double to_nm = si_unit("a^2/R", *si).factor;
  return fmt::format("{:>8}  {:>8}  ", known("{:.2f}", to_nm * point.Hc), known("{:.2f}", to_nm * point.Hm));
}

std::string point_line(const StudyPoint& point, const Reference& reference, const std::optional<SiScales>& si) {
  const std::string status = point.status == "converged" ? "" : point.status;
  const Judged Hc = point.of(of_Hc), Hm = point.of(of_Hm);
  const std::string fronts = fmt::format("{} {}", Hc.front ? id::Hc : "", Hm.front ? id::Hm : "");
  std::string line = fmt::format(
      "{:>11}  {:<9}  {:<9}  {:>6}  {}{:>8}  {:>8}  {:>12}  {:>12}  {:>10}  {:>8}  {:<13}  {}", nodes_of(point),
      point.variant.wedge, point.variant.evaluator, point.variant.cycles, in_nm(point, si), known("{:.5f}", point.Hc),
      known("{:.5f}", point.Hm), deviation_text(Hc, reference.Hc), deviation_text(Hm, reference.Hm),
      known("{:.1f}", point.work_units), known("{:.3f}", point.seconds), status, deck::trimmed(fronts));
  return line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
}

std::string columns_of_points(const std::optional<SiScales>& si) {
  const std::string in_nm = si ? numbers::heading_in_si(id::hc) + "  " + numbers::heading_in_si(id::hm) + "  " : "";
  return fmt::format(
      "      nodes  wedge      evaluator  cycles  {}{:>8}  {:>8}  deviation_Hc  deviation_Hm  {}  {:>8}  "
      "status         front\n",
      in_nm, id::Hc, id::Hm, id::work_units, id::seconds);
}

std::string front_lines(const std::vector<StudyPoint>& points, const Reference& reference, std::size_t quantity,
                        const std::string& name, const std::optional<SiScales>& si) {
  std::vector<StudyPoint> front;
  std::ranges::copy_if(points, std::back_inserter(front),
                       [&](const StudyPoint& point) { return point.of(quantity).front; });
  std::ranges::sort(front, {}, &StudyPoint::seconds);
  std::string text = "\nPareto front of " + name + ": no cheaper variant is as accurate\n" + columns_of_points(si);
  for (const StudyPoint& point : front) text += point_line(point, reference, si);
  return text;
}

std::string accuracy_lines(const std::vector<StudyPoint>& points) {
  std::string text = "\nseconds to an accuracy that holds on all finer grids too\n";
  for (const auto& [name, quantity] : {std::pair(id::Hc, of_Hc), std::pair(id::Hm, of_Hm)})
    for (const double error : {1e-2, 1e-3, 1e-4}) {
      const std::size_t found = cheapest(points, quantity, error);
      text += fmt::format("  {} to {:<6}", name, fmt::format("{:g} %", 100.0 * error));
      text += found == points.size() ? "  not reached\n"
                                     : fmt::format("  {:.3f} s: {}, ", points[found].seconds, nodes_of(points[found])) +
                                           name_of_variant(points[found].variant) + "\n";
    }
  return text;
}

// The distinct values of one part of the methods, in order of appearance.
template <class Part>
std::vector<Part> distinct(const std::vector<StudyPoint>& points, Part StudyCase::*part) {
  std::vector<Part> found;
  for (const StudyPoint& point : points)
    if (std::ranges::find(found, point.variant.*part) == found.end()) found.push_back(point.variant.*part);
  return found;
}

// `preferred`, the default of the program, if it is in the list; else the first word.
std::string one_of(const std::vector<std::string>& words, const std::string& preferred) {
  return std::ranges::find(words, preferred) != words.end() ? preferred : words.front();
}

// One line per level. in: the method; the part of it that varies along a line; the function that prints a cell, also
// for a point without data.
std::string by_level(const std::vector<StudyPoint>& points, StudyCase variant, std::string StudyCase::*varied,
                     std::string (*cell)(const StudyPoint&)) {
  std::string text;
  for (const int cells : distinct(points, &StudyCase::cells)) {
    variant.cells = cells;
    std::string nodes = "-", line;
    for (const std::string& word : distinct(points, varied)) {
      variant.*varied = word;
      const auto found = std::ranges::find(points, variant, &StudyPoint::variant);
      if (found != points.end()) nodes = nodes_of(*found);
      line += cell(found != points.end() ? *found : StudyPoint{});
    }
    text += fmt::format("{:>11}", nodes) + line + "\n";
  }
  return text;
}

// The cells of the films; a film that did not converge is marked.
std::string film_cells(const StudyPoint& point) {
  const char* mark = point.status.empty() || point.status == "converged" ? " " : "*";
  return fmt::format("  {:>12}  {:>12}", known("{:.5f}", point.Hm) + mark, known("{:.5f}", point.Hc) + mark);
}

// Arranged as Table 1 of the paper, for the largest number of cycles and the default evaluator.
std::string film_by_level(const std::vector<StudyPoint>& points) {
  const StudyCase variant{.evaluator = one_of(distinct(points, &StudyCase::evaluator), "mlmi8"),
                          .cycles = one_of(distinct(points, &StudyCase::cycles), "2W")};
  std::string text = "\nTable 1: the film by level, " + variant.evaluator + ", " + variant.cycles +
                     " (* not converged after these cycles)\n      nodes";
  for (const std::string& wedge : distinct(points, &StudyCase::wedge))
    text += fmt::format("  {:>12}  {:>12}", "Hm " + wedge, "Hc " + wedge);
  return text + "\n" + by_level(points, variant, &StudyCase::wedge, film_cells);
}

// Arranged as Table 2 of the paper, for the first wedge and the default evaluator.
std::string seconds_by_level(const std::vector<StudyPoint>& points) {
  const StudyCase variant{.wedge = points.front().variant.wedge,
                          .evaluator = one_of(distinct(points, &StudyCase::evaluator), "mlmi8")};
  std::string text =
      "\nTable 2: seconds by level and cycles per level, " + variant.wedge + ", " + variant.evaluator + "\n      nodes";
  for (const std::string& cycles : distinct(points, &StudyCase::cycles)) text += fmt::format("  {:>8}", cycles);
  return text + "\n" + by_level(points, variant, &StudyCase::cycles, [](const StudyPoint& point) {
           return fmt::format("  {:>8}", known("{:.3f}", point.seconds));
         });
}

std::string reference_lines(const Reference& reference) {
  return fmt::format(
      "# reference cells: {}\n"
      "# reference Hc: {}\n"
      "# reference Hm: {}\n"
      "# reference error Hc: {}\n"
      "# reference error Hm: {}\n",
      cells_of(reference), csv_cell(reference.Hc.value), csv_cell(reference.Hm.value), csv_cell(reference.Hc.error),
      csv_cell(reference.Hm.error));
}

constexpr char how_to_read[] =
    "# reference: extrapolated from second-order solutions with FFT and a residual of 1e-10; its error is relative\n"
    "# cycles: 2W are two W(2,1) cycles on every level (the first grid has its own); run: as ehl run\n"
    "# status: converged, stopped (not converged after its cycles), not-converged, failed (the program); without "
    "convergence the deviations are those of the last film\n"
    "# work_units: whole solution, in evaluations of the finest grid; H = h R/a^2; deviations and estimates are "
    "relative\n"
    "# deviation: from the reference; estimate: discretization error as estimated by the run; at_reference: the "
    "deviation is below the error of the reference; front: no cheaper variant [s] is as accurate\n";

}  // namespace

std::string times_of(const StudyHeader& header) {
  return fmt::format("least of {}, {} each, ", header.repeats, threads_text(header.threads)) +
         (header.jobs == 1 ? "one solution after another"
                           : fmt::format("{} solutions at a time: SHARED, not to be compared", header.jobs));
}

std::string origin_lines(const StudyHeader& header, const std::string& times) {
  std::string text = fmt::format("\n# program: {}\n# deck: {}\n{}\n# title: {}\n", header.program, header.deck,
                                 deck_text_line(header.deck_text), header.title);
  for (const deck::NamedFile& file : header.files) text += file_line(file) + "\n";
  for (const std::string& set : header.set) text += "# set: " + set + "\n";
  return text + fmt::format("# machine: {}\n# date: {}\n# times: {}\n", header.machine, header.date, times);
}

std::string study_csv(const StudyHeader& header, const Reference& reference, const std::vector<StudyPoint>& points) {
  return csv_table(study_mark + origin_lines(header, times_of(header)) + reference_lines(reference) + how_to_read,
                   study_columns(header.si), points);
}

std::string study_report(const StudyHeader& header, const Reference& reference, const std::vector<StudyPoint>& points) {
  std::string text = "case         " + header.title + "\n";
  text += "reference    ";
  if (header.si)
    text += numbers::symbol_of(id::hc) + " = " + film_text(reference.Hc.value, *header.si) + ", " +
            numbers::symbol_of(id::hm) + " = " + film_text(reference.Hm.value, *header.si) + "; ";
  text += fmt::format("Hc = {:.7f} to {}, Hm = {:.7f} to {}\n", reference.Hc.value, percent(reference.Hc.error),
                      reference.Hm.value, percent(reference.Hm.error));
  text += fmt::format("             second order, FFT, {} cells, extrapolated; residual {:.0e}\n", cells_of(reference),
                      reference.residual);
  text += "times        " + times_of(header) + "\n\n" + columns_of_points(header.si);
  for (const StudyPoint& point : points) text += point_line(point, reference, header.si);
  text += "(< below the error of the reference; stopped: not converged after its cycles)\n";
  text += front_lines(points, reference, of_Hc, id::Hc, header.si);
  text += front_lines(points, reference, of_Hm, id::Hm, header.si);
  return text + accuracy_lines(points) + film_by_level(points) + seconds_by_level(points);
}

}  // namespace ehl::program
