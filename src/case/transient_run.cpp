#include "case/transient_run.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/signals.hpp"
#include "case/effects.hpp"
#include "case/numbers/number.hpp"
#include "case/transient_input.hpp"
#include "core/constants.hpp"
#include "core/errors.hpp"
#include "core/timer.hpp"
#include "transient/quasi_steady.hpp"

namespace ehl::program {

SiUnit time_unit(const Case& input) {
  const std::optional<SiScales> si = si_scales(input.physics);
  return si && input.transient->in_seconds ? si_unit("a/u_m", *si) : SiUnit{"a/u_m", 1.0};
}

namespace {

using transient::MarchEnd;
using transient::StepRow;

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

}  // namespace ehl::program
