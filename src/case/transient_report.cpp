// The printed summary of a run in time.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/text_format.hpp"
#include "case/course_of_run.hpp"
#include "case/numbers/number.hpp"
#include "case/transient_input.hpp"
#include "case/transient_run.hpp"
#include "deck/text.hpp"

namespace ehl::program {
namespace {

using transient::StepRow;

// How a number of the rows is printed: its dimensionless name, its name in SI, and its SI unit.
struct Printed {
  std::string own{};
  std::string in_SI{};
  SiUnit unit{};
};

// One line with the smallest and largest value over time. in: value: the number of a row.
template <class Value>
std::string range_line(const Case& input, const Printed& number, const std::vector<StepRow>& rows, Value value) {
  const auto known = [&](const StepRow& row) { return !std::isnan(std::invoke(value, row)); };
  const auto of_known = [&](double unknown) {
    return [&, unknown](const StepRow& row) {
      return known(row) ? static_cast<double>(std::invoke(value, row)) : unknown;
    };
  };
  const StepRow& low = *std::ranges::min_element(rows, {}, of_known(HUGE_VAL));
  const StepRow& high = *std::ranges::max_element(rows, {}, of_known(-HUGE_VAL));
  const double least = std::invoke(value, low), most = std::invoke(value, high), last = std::invoke(value, rows.back());
  const SiUnit time = time_unit(input);
  if (!input.physics.si)
    return fmt::format("  {:<10} {:.5f} to {:.5f}, at times {:.4g} and {:.4g}; at the end {:.5f}\n", number.own, least,
                       most, low.T, high.T, last);
  const double factor = number.unit.factor;
  return fmt::format(
      "  {:<10} {:.5g} to {:.5g} {}, at times {:.4g} and {:.4g} {}; at the end {:.5g} {}; {} {:.5f} to {:.5f}\n",
      number.in_SI, factor * least, factor * most, number.unit.name, time.factor * low.T, time.factor * high.T,
      time.name, factor * last, number.unit.name, number.own, least, most);
}

std::string range_lines(const Case& input, const std::vector<StepRow>& rows) {
  const SiScales scales = si_scales(input.physics).value_or(SiScales{});
  const SiUnit nm = si_unit("a^2/R", scales), GPa = si_unit("p_h", scales);
  const auto line = [&](const Printed& number, auto value) { return range_line(input, number, rows, value); };
  std::string text = line({id::Hc, numbers::symbol_of(id::hc), nm}, &StepRow::Hc) +
                     line({id::Hm, numbers::symbol_of(id::hm), nm}, &StepRow::Hm) +
                     line({id::P_max, numbers::symbol_of(id::p_max), GPa}, &StepRow::P_max);
  if (input.transient->conditions.body) {
    const double load = input.physics.si ? input.physics.si->contact.load : 1.0;
    text +=
        line({"velocity", "velocity", si_unit("a u_m/R", scales)}, &StepRow::velocity) +
        line({"carried", "carried", {contact::line(input.scene.contact.shape) ? "N/m" : "N", load}}, &StepRow::carried);
  }
  const std::vector<transient::Place>& places = input.transient->parameters.probes;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const std::string P = name_of_probe("P", places[k]), H = name_of_probe("H", places[k]);
    text += line({P, P, GPa}, [k](const StepRow& row) { return row.probed[k].P; }) +
            line({H, H, nm}, [k](const StepRow& row) { return row.probed[k].H; });
  }
  return text;
}

// The line about the conservation of oil mass.
std::string oil_line(const TransientResult& result, bool line) {
  const transient::OilInTime &first = result.rows.front().oil, &last = result.rows.back().oil;
  return fmt::format(
      "  oil        {:.5f} to {:.5f} rho0 {}/R between the bodies; at the end in {:.5f}, out {:.5f}, through the sides "
      "{:.2g} per a/u_m; mass error {:.1e} of the first inflow in a/u_m in the worst step, {:.1e} since the start\n",
      first.stored, last.stored, line ? "a^3" : "a^4", last.in, last.out, last.aside, result.report.worst_oil_error,
      last.lost);
}

// "time 0 to 0.5 a/u_m (0.1345 ms)", with the deck's own unit first.
std::string time_text(const Case& input, double T) {
  const std::optional<SiScales> si = si_scales(input.physics);
  const std::string own = fmt::format("{:.6g} a/u_m", T);
  if (!si) return "time 0 to " + own;
  const std::string ms = fmt::format("{:.4g} ms", 1e3 * si->time * T);
  return "time 0 to " + (input.transient->in_seconds ? ms + " (" + own + ")" : own + " (" + ms + ")");
}

constexpr double rounding_of_course = 1e-9;

// The lines about a cycle: its scales, its periods, and its quasi-steady states.
std::string cycle_lines(const Case& input, const TransientResult& result) {
  const transient::Input& march = *input.transient;
  if (!deck::given(input.deck, "transient", "cycle")) return "";
  std::string text =
      fmt::format("  scales     a, p_h and u_m of the state of [contact] and [motion], M = {:.4g}, L = {:.4g}\n",
                  input.physics.groups.M, input.physics.groups.L);
  const SiUnit time = time_unit(input);
  if (!std::isnan(march.parameters.period) && march.mode != transient::Mode::quasi_steady)
    text += fmt::format(
        "  period     {:.5g} {}; {} whole period{}{}\n", march.parameters.period * time.factor, time.name,
        result.report.periods, result.report.periods == 1 ? "" : "s",
        std::isnan(result.report.change_of_period)
            ? ""
            : fmt::format("; Hc and Hm of the last two differ by at most {:.1e}", result.report.change_of_period));
  const double course = input.machine && input.machine->course ? input.machine->course->rows.back().values[0] : 0.0;
  const double covered = result.report.T / march.second;
  if (deck::word(input.deck, "transient", "cycle") == "machine" && completed(result) &&
      covered < course * (1.0 - rounding_of_course))
    text += fmt::format("  course     ends here at {:.4g} of {:.4g} ms: a longer end_time computes the rest\n",
                        1e3 * covered, 1e3 * course);
  if (!result.states) return text;
  const transient::MarchReport& states = *result.states;
  return text + fmt::format(
                    "  states     {} quasi-steady states; {} without entrainment and so without a film, {} not "
                    "found{}; {:.3f} s\n",
                    states.steps, states.at_rest, states.not_found,
                    states.reason.empty() ? "" : " (the first: " + states.reason + ")", states.seconds);
}

// The error bars of the numbers that are usually asked for.
std::string error_line(const TimeErrors& errors) {
  if (!errors.missing.empty()) return "  errors     not known: " + errors.missing + "\n";
  std::string text;
  for (const char* name : {id::least_Hc, id::least_Hm, id::largest_P_max, id::mean_mu}) {
    const auto found = errors.of.find(name);
    if (found == errors.of.end()) continue;
    std::string words = name;
    std::ranges::replace(words, '_', ' ');
    text += (text.empty() ? "" : ", ") + words + " " + percent(found->second);
  }
  return "  errors     " + text +
         fmt::format("; of mesh and time steps, from two more runs in {:.3f} s\n", errors.seconds);
}

// The means of a part of the run.
std::string mean_line(const Case& input, const TransientResult& result) {
  const Window window = window_of_means(input, result);
  if (window.from == 0.0 && window.to == result.rows.back().T) return "";
  const SiUnit time = time_unit(input);
  const auto mean = [&](const char* name) { return extremes_of(input, result, name).mean; };
  return fmt::format("  means      Hc {:.5f}, Hm {:.5f}, P_max {:.5f} over times {:.4g} to {:.4g} {}\n", mean(id::Hc),
                     mean(id::Hm), mean(id::P_max), window.from * time.factor, window.to * time.factor, time.name);
}

}  // namespace

std::string transient_summary(const Case& input, const TransientResult& result) {
  const transient::MarchReport& report = result.report;
  std::string text = "transient    " + time_text(input, report.T) + ", ended " + how_it_ended(report) + "\n";
  text += range_lines(input, result.rows);
  text += mean_line(input, result);
  if (result.errors) text += error_line(*result.errors);
  text += cycle_lines(input, result);
  if (input.transient->mode == transient::Mode::quasi_steady) return text;
  const int attempts = report.steps + report.rejected + report.not_solved;
  const std::string newton =
      report.newton_steps > 0 ? fmt::format(", {} steps of Newton's method", report.newton_steps) : "";
  text += fmt::format(
      "  steps      {}, {:.2f} cycles each{}; {} of {} attempts rejected by the error test, {} not solved; {} jumps; "
      "longest allowed {:.3g}\n",
      report.steps, static_cast<double>(report.cycles) / std::max(1, report.steps), newton, report.rejected, attempts,
      report.not_solved, report.restarts, report.longest_step);
  if (input.transient->conditions.conserves_mass) text += oil_line(result, numbers::per_length(input));
  text += fmt::format(
      "  load       largest error {:.1e}\n  time       {:.3f} s, {:.2f} ms per step; {} fields stored\n",
      report.worst_load_error, report.seconds, 1e3 * report.seconds / std::max(1, report.steps), result.frames.size());
  return text;
}

}  // namespace ehl::program
