#include "case/transient_run.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/json.hpp"
#include "base/signals.hpp"
#include "case/transient_input.hpp"
#include "core/errors.hpp"
#include "core/timer.hpp"

namespace ehl::program {
namespace {

using transient::MarchEnd;
using transient::StepRow;

std::string text_of(const StepRow& row, double end) {
  return fmt::format("time {:.4g} of {:.4g} a/u_m  step {:.1e}  order {}  Hc {:.4f}  Hm {:.4f}", row.T, end, row.length,
                     row.order, row.Hc, row.Hm);
}

// The counts of all rows, those before a checkpoint included.
void total(TransientResult& result) {
  transient::MarchReport& report = result.report;
  report.T = result.rows.back().T;
  report.steps = static_cast<int>(result.rows.size()) - 1;
  report.cycles = report.rejected = report.not_solved = 0;
  report.worst_load_error = 0.0;
  for (const StepRow& row : result.rows) {
    report.cycles += row.cycles;
    report.rejected += row.rejected;
    report.not_solved += row.not_solved;
    report.worst_load_error = std::max(report.worst_load_error, row.load_error);
  }
}

// in: value, of a row.
template <class Value>
std::string range_line(const std::string& name, const std::vector<StepRow>& rows, Value value) {
  const StepRow& low = *std::ranges::min_element(rows, {}, value);
  const StepRow& high = *std::ranges::max_element(rows, {}, value);
  return fmt::format("  {:<10} {:.5f} to {:.5f}, at times {:.4g} and {:.4g}; at the end {:.5f}\n", name,
                     std::invoke(value, low), std::invoke(value, high), low.T, high.T, std::invoke(value, rows.back()));
}

std::string probe_lines(const Case& input, const std::vector<StepRow>& rows) {
  std::string text;
  const std::vector<transient::Place>& places = input.transient->parameters.probes;
  for (std::size_t k = 0; k < places.size(); ++k)
    text += range_line(name_of_probe("P", places[k]), rows, [k](const StepRow& row) { return row.probed[k].P; }) +
            range_line(name_of_probe("H", places[k]), rows, [k](const StepRow& row) { return row.probed[k].H; });
  return text;
}

}  // namespace

std::string how_it_ended(const transient::MarchReport& report) {
  switch (report.end) {
    case MarchEnd::end_time: return "at the end time";
    case MarchEnd::film: return "where the film fell to stop_film";
    case MarchEnd::steady: return "steady to stop_steady";
    case MarchEnd::interrupted: return "interrupted";
    case MarchEnd::failed: return "FAILED: " + report.reason;
  }
  return "";
}

TransientResult run_transient(const Case& input, const steady::Solution& start, Progress& progress,
                              TransientResult before, const std::function<void(const TransientResult& so_far)>& save) {
  TransientResult result = std::move(before);
  const std::optional<transient::Checkpoint> from = std::move(result.checkpoint);
  result.checkpoint.reset();
  result.report.end = MarchEnd::interrupted;  // so far
  const transient::Input& march = *input.transient;
  if (!result.rows.empty() && result.rows.front().probed.size() != march.parameters.probes.size())
    throw core::FileError("the file is damaged: its rows have other probes than its deck");
  double saved = core::now();
  const transient::Observer observer{
      .row =
          [&](const StepRow& row) {
            result.rows.push_back(row);
            return progress.show(row.T / march.parameters.end, text_of(row, march.parameters.end));
          },
      .frame = [&](transient::Frame&& frame) { result.frames.push_back(std::move(frame)); },
      .wants_checkpoint = [&] { return core::now() - saved > march.seconds_between_checkpoints; },
      .checkpoint =
          [&](transient::Checkpoint&& checkpoint) {
            result.checkpoint = std::move(checkpoint);
            total(result);
            if (!stop_requested()) save(result);
            saved = core::now();
          }};
  result.report =
      transient::march(input.scene, start, march.conditions, march.parameters, observer, from ? &*from : nullptr);
  if (result.report.end != MarchEnd::interrupted) result.checkpoint.reset();
  total(result);
  return result;
}

bool completed(const TransientResult& result) {
  return result.report.end != MarchEnd::failed && result.report.end != MarchEnd::interrupted;
}

std::string transient_summary(const Case& input, const TransientResult& result) {
  const transient::MarchReport& report = result.report;
  std::string text = fmt::format("transient    time 0 to {:.6g} a/u_m", report.T);
  if (std::isfinite(input.transient->second)) text += fmt::format(" ({:.4g} s)", report.T / input.transient->second);
  text += ", ended " + how_it_ended(report) + "\n";
  text += range_line("Hc", result.rows, &StepRow::Hc) + range_line("Hm", result.rows, &StepRow::Hm) +
          range_line("P_max", result.rows, &StepRow::P_max);
  if (input.transient->conditions.body)
    text +=
        range_line("velocity", result.rows, &StepRow::velocity) + range_line("carried", result.rows, &StepRow::carried);
  text += probe_lines(input, result.rows);
  const int attempts = report.steps + report.rejected + report.not_solved;
  text += fmt::format(
      "  steps      {}, {:.2f} cycles each; {} of {} attempts rejected for their error, {} not solved; {} jumps; "
      "longest "
      "allowed {:.3g}\n",
      report.steps, static_cast<double>(report.cycles) / std::max(1, report.steps), report.rejected, attempts,
      report.not_solved, report.restarts, report.longest_step);
  text += fmt::format("  load       worst error {:.1e}\n  time       {:.3f} s, {:.2f} ms per step; {} fields kept\n",
                      report.worst_load_error, report.seconds, 1e3 * report.seconds / std::max(1, report.steps),
                      result.frames.size());
  return text;
}

Json transient_json(const TransientResult& result) {
  const transient::MarchReport& report = result.report;
  return {{"completed", completed(result)},
          {"ended", how_it_ended(report)},
          {"end_time", report.T},
          {"Hc", result.rows.back().Hc},
          {"Hm", result.rows.back().Hm},
          {"least_Hm", std::ranges::min(result.rows, {}, &StepRow::Hm).Hm},
          {"largest_P_max", std::ranges::max(result.rows, {}, &StepRow::P_max).P_max},
          {"steps", report.steps},
          {"cycles", report.cycles},
          {"rejected", report.rejected},
          {"not_solved", report.not_solved},
          {"jumps", report.restarts},
          {"worst_load_error", report.worst_load_error},
          {"seconds", report.seconds}};
}

}  // namespace ehl::program
