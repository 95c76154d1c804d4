#include "case/transient_run.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/signals.hpp"
#include "case/effects.hpp"
#include "case/numbers/number.hpp"
#include "case/transient_input.hpp"
#include "core/constants.hpp"
#include "core/errors.hpp"
#include "core/timer.hpp"
#include "transient/quasi_steady.hpp"

namespace ehl::program {
namespace {

using transient::MarchEnd;
using transient::StepRow;

// The unit of printed times: ms if the deck gives times in seconds.
SiUnit time_unit(const Case& input) {
  const std::optional<SiScales> si = si_scales(input.physics);
  return si && input.transient->in_seconds ? si_unit("a/u_m", *si) : SiUnit{"a/u_m", 1.0};
}

std::string text_of(const Case& input, const StepRow& row) {
  const SiUnit time = time_unit(input);
  return fmt::format("time {:.4g} of {:.4g} {}  step {:.1e}  order {}  Hc {:.4f}  Hm {:.4f}", row.T * time.factor,
                     input.transient->parameters.end * time.factor, time.name, row.length * time.factor, row.order,
                     row.Hc, row.Hm);
}

// Sums the counters over all rows, including those before a checkpoint.
void total(TransientResult& result) {
  transient::MarchReport& report = result.report;
  report.T = result.rows.back().T;
  report.steps = static_cast<int>(result.rows.size()) - 1;
  report.cycles = report.newton_steps = report.rejected = report.not_solved = 0;
  report.worst_load_error = report.worst_oil_error = 0.0;
  for (const StepRow& row : result.rows) {
    report.cycles += row.cycles;
    report.newton_steps += row.newton_steps;
    report.rejected += row.rejected;
    report.not_solved += row.not_solved;
    report.worst_load_error = std::max(report.worst_load_error, row.load_error);
    report.worst_oil_error = std::max(report.worst_oil_error, row.oil.from_nowhere);
  }
}

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

}  // namespace

std::string how_it_ended(const transient::MarchReport& report) {
  switch (report.end) {
    case MarchEnd::end_time: return "at the end time";
    case MarchEnd::film: return "because the film fell to stop_film";
    case MarchEnd::steady: return "because it was steady to stop_steady";
    case MarchEnd::periodic: return "because it was periodic to stop_periodic";
    case MarchEnd::interrupted: return "interrupted";
    case MarchEnd::failed: return "FAILED: " + report.reason;
  }
  return "";
}

namespace {

// The value of a quasi-steady state at T, linear between the states; NaN if one of both is not known.
double between(const std::vector<StepRow>& states, double T, double StepRow::*value) {
  const auto after = std::ranges::lower_bound(states, T, {}, &StepRow::T);
  if (after == states.end()) return T > states.back().T ? core::unknown : states.back().*value;
  if (after == states.begin() || after->T == T) return *after.*value;
  const StepRow& before = after[-1];
  if (before.speed * after->speed < 0.0) return core::unknown;  // the film vanishes between them
  const double share = (T - before.T) / (after->T - before.T);
  return before.*value + share * (*after.*value - before.*value);
}

// Adds the quasi-steady film to a row of the run in time. in: the states of the first period.
void add_state(const std::vector<StepRow>& states, double period, StepRow& row) {
  if (states.empty()) return;
  const double phase = std::isnan(period) ? std::min(row.T, states.back().T) : std::fmod(row.T, period);
  row.Hc_quasi = between(states, phase, &StepRow::Hc);
  row.Hm_quasi = between(states, phase, &StepRow::Hm);
  row.P_max_quasi = between(states, phase, &StepRow::P_max);
}

}  // namespace

TransientResult run_transient(const Case& input, const steady::Solution& start, RunSettings& settings) {
  TransientResult result = std::move(settings.before);
  const std::optional<transient::Checkpoint> from = std::move(result.checkpoint);
  result.checkpoint.reset();
  result.report.end = MarchEnd::interrupted;  // until the run has ended
  const transient::Input& march = *input.transient;
  if (!result.rows.empty() && result.rows.front().probed.size() != march.parameters.probes.size())
    throw core::FileError("the file is damaged: its rows have other probes than its deck");
  double saved = core::now();
  const InSteps added = in_steps_of(input, &result.seconds);
  result.measured = added.numbers;
  std::vector<StepRow> states;
  double share = 0.0;  // of the last state that was shown, and its text
  std::string shown = "quasi-steady states";
  const auto going_on = [&] { return settings.progress.show(share, shown); };
  const auto show_state = [&](const StepRow& row) {
    states.push_back(row);
    share = row.T / march.parameters.end;
    shown = text_of(input, row);
    return going_on();
  };
  if (march.mode == transient::Mode::both)
    result.states = transient::quasi_steady(input.scene, march.conditions, march.parameters, march.states,
                                            {.row = show_state}, going_on);
  const transient::Observer observer{
      .row =
          [&](const StepRow& row) {
            result.rows.push_back(row);
            result.rows.back().measured.resize(added.numbers.size(), core::unknown);  // a row may have no state
            add_state(states, march.parameters.period, result.rows.back());
            return settings.progress.show(row.T / march.parameters.end, text_of(input, row));
          },
      .frame =
          [&](transient::Frame&& frame) {
            if (settings.frame) return settings.frame(std::move(frame));
            result.frames.push_back(std::move(frame));
          },
      .measure = added.measure,
      .measure_fields = added.measure_fields,
      .wants_checkpoint =
          [&, kept = !added.coupling] {
            return kept && settings.save && core::now() - saved > march.seconds_between_checkpoints;
          },
      .checkpoint =
          [&](transient::Checkpoint&& checkpoint) {
            if (added.coupling) return;  // the state of the effect is not kept
            result.checkpoint = std::move(checkpoint);
            total(result);
            if (settings.save && !stop_requested())
              settings.save([&](results::Content& content) { add_transient(input, result, content); });
            saved = core::now();
          }};
  if (march.mode == transient::Mode::quasi_steady) {
    const auto keep_state = [&](const StepRow& row) {
      share = row.T / march.parameters.end;
      shown = text_of(input, row);
      return observer.row(row);
    };
    result.report = transient::quasi_steady(input.scene, march.conditions, march.parameters, march.states,
                                            {.row = keep_state, .frame = observer.frame}, going_on);
    result.states = result.report;
    total(result);
    return result;
  }
  result.report = transient::march(input.scene, start, march.conditions, march.parameters, observer,
                                   from ? &*from : nullptr, added.coupling ? &*added.coupling : nullptr);
  if (result.report.end != MarchEnd::interrupted) result.checkpoint.reset();
  total(result);
  return result;
}

bool completed(const TransientResult& result) {
  return result.report.end != MarchEnd::failed && result.report.end != MarchEnd::interrupted;
}

std::string why_incomplete(const std::optional<TransientResult>& result) {
  if (!result || completed(*result)) return {};
  const transient::MarchReport& report = result->report;
  return report.end == MarchEnd::interrupted
             ? fmt::format("the transient was interrupted at time {:g} a/u_m", report.T)
             : fmt::format("the transient ended at time {:g} a/u_m: {}", report.T, report.reason);
}

namespace {

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
  if (!result.states) return text;
  const transient::MarchReport& states = *result.states;
  return text + fmt::format(
                    "  states     {} quasi-steady states; {} without entrainment and so without a film, {} not "
                    "found{}; {:.3f} s\n",
                    states.steps, states.at_rest, states.not_found,
                    states.reason.empty() ? "" : " (the first: " + states.reason + ")", states.seconds);
}

}  // namespace

std::string transient_summary(const Case& input, const TransientResult& result) {
  const transient::MarchReport& report = result.report;
  std::string text = "transient    " + time_text(input, report.T) + ", ended " + how_it_ended(report) + "\n";
  text += range_lines(input, result.rows);
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
