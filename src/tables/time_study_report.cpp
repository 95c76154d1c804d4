#include "tables/time_study_report.hpp"

#include <fmt/core.h>

#include "base/text_format.hpp"
#include "case/transient_input.hpp"
#include "tables/csv.hpp"

namespace ehl::program {
namespace {

// A deviation, "1.4e-03"; "< ..." if it is below the error of the reference.
std::string deviation_text(const Judged& judged, double known_to) {
  return judged.at_reference ? "< " + known("{:.1e}", known_to) : known("{:.1e}", judged.deviation);
}

std::string known_text(const TimeReference& reference) {
  const std::vector<std::string> names = time_study_quantities(reference.probes.size());
  std::string text;
  for (std::size_t k = 0; k < names.size(); ++k)
    text += (k > 0 ? ", " : "") + names[k] + " " + known("{:.1e}", reference.errors[k]);
  return text;
}

std::string columns_of_tolerances(std::size_t probes) {
  std::string text = "    rtol   steps  cycles/step  rejected  not solved   seconds";
  for (const std::string& name : time_study_quantities(probes)) text += fmt::format("  {:>15}", "deviation_" + name);
  return text + "\n";
}

// One line of the report; a run that is not complete gets a mark instead of errors.
std::string point_line(const StudyPoint& point, const TimeReference& reference) {
  std::string text = fmt::format("{:8g}  {:6}  {:>11}  {:8}  {:10}  {:>8}", point.variant.rtol, point.steps,
                                 known("{:.2f}", cycles_per_step(point)), point.rejected, point.not_solved,
                                 known("{:.2f}", point.seconds));
  if (!is_complete(point)) return text + "  NOT COMPLETE: " + point.reason + "\n";
  for (std::size_t k = 0; k < point.judged.size(); ++k)
    text += fmt::format("  {:>15}", deviation_text(point.judged[k], reference.errors[k]));
  return text + "\n";
}

std::string time_text(double T, const std::optional<SiScales>& si) {
  const std::string own = fmt::format("{:g} a/u_m", T);
  return si ? fmt::format("{:.4g} ms (", 1e3 * si->time * T) + own + ")" : own;
}

std::string times_text(const StudyHeader& header) {
  return times_of(header) + "; the run in time without its steady start";
}

}  // namespace

std::string time_study_csv(const StudyHeader& header, const TimeReference& reference,
                           const std::vector<StudyPoint>& points) {
  const std::vector<std::string> names = time_study_quantities(reference.probes.size());
  std::string text = time_study_mark + origin_lines(header, times_text(header));
  text += "# reference: " + name_of_variant(reference.run.variant) + "; its error is its difference from " +
          name_of_variant(reference.coarser.variant) + "\n# reference steps: " + std::to_string(reference.run.steps) +
          "\n";
  for (std::size_t k = 0; k < names.size(); ++k)
    text += "# reference error " + names[k] + ": " + csv_cell(reference.errors[k]) + "\n";
  for (std::size_t k = 0; k < reference.probes.size(); ++k)
    text += "# probe " + std::to_string(k + 1) + ": " + name_of_probe("P", reference.probes[k]) + "\n";
  text += "# compared at: " + std::to_string(reference.run.samples.size()) +
          " equidistant times, by the dense output of the integration\n"
          "# deviations: from the reference, largest over the run; Hc, Hm, P_max relative at every time, P_1, ... "
          "relative to the largest P there\n"
          "# status: complete, not-complete (deviations are not given), failed (the program)\n";
  return csv_table(text, time_study_columns(names, header.si), points);
}

std::string time_study_report(const StudyHeader& header, const TimeReference& reference,
                              const std::vector<StudyPoint>& points) {
  const StudyPoint& run = reference.run;
  std::string text = "case         " + header.title + "\n";
  text += "reference    " + name_of_variant(run.variant) + fmt::format(": {} steps to time ", run.steps) +
          time_text(run.T, header.si) + "\n";
  text += "             known to " + known_text(reference) + "\n             (its difference from " +
          name_of_variant(reference.coarser.variant) + ")\n";
  text += fmt::format(
      "compared     at {} equidistant times, by the dense output of the integration; largest over the run\n",
      run.samples.size());
  for (std::size_t k = 0; k < reference.probes.size(); ++k)
    text += fmt::format("P_{}          ", k + 1) + name_of_probe("P", reference.probes[k]) +
            ", relative to the largest there\n";
  text += "times        " + times_text(header) + "\n\n" + columns_of_tolerances(reference.probes.size());
  for (const StudyPoint& point : points) text += point_line(point, reference);
  return text + "(< below the error of the reference)\n";
}

}  // namespace ehl::program
