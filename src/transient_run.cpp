#include "transient_run.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "core/timer.hpp"
#include "json.hpp"
#include "signals.hpp"
#include "text_format.hpp"

namespace ehl::program {
namespace {

using transient::MarchEnd;
using transient::StepRow;

constexpr double bar_interval = 0.05;  // s
constexpr double line_interval = 5.0;
constexpr int bar_width = 30;

/// A bar in model time, with the present step.
class MarchProgress {
 public:
  MarchProgress(double end, bool quiet) : end_(end), quiet_(quiet), terminal_(::isatty(STDERR_FILENO) != 0) {}
  ~MarchProgress() {
    if (line_open_) std::fputs("\r\x1b[K", stderr);
  }
  MarchProgress(const MarchProgress&) = delete;
  MarchProgress& operator=(const MarchProgress&) = delete;

  void show(const StepRow& row) {
    const double now = core::now();
    if (quiet_ || now - last_time_ < (terminal_ ? bar_interval : line_interval)) return;
    last_time_ = now;
    const double share = std::clamp(row.T / end_, 0.0, 1.0);
    const std::string words = formatted("time %.4g of %.4g a/u_m  step %.1e  order %d  Hc %.4f  Hm %.4f", row.T, end_,
                                        row.length, row.order, row.Hc, row.Hm);
    if (terminal_) {
      const auto filled = static_cast<std::size_t>(share * bar_width);
      const std::string bar = std::string(filled, '#') + std::string(bar_width - filled, '.');
      std::fprintf(stderr, "\r[%s] %3.0f %%  %s\x1b[K", bar.c_str(), 100.0 * share, words.c_str());
      std::fflush(stderr);
      line_open_ = true;
    } else {
      std::fprintf(stderr, "ehl: %3.0f %%  %s\n", 100.0 * share, words.c_str());
    }
  }

 private:
  double end_;
  bool quiet_;
  bool terminal_;
  bool line_open_ = false;
  double last_time_ = 0.0;
};

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

const StepRow& extreme(const std::vector<StepRow>& rows, double StepRow::*value, bool largest) {
  const auto found = largest ? std::ranges::max_element(rows, {}, value) : std::ranges::min_element(rows, {}, value);
  return *found;
}

std::string range_line(const char* name, const std::vector<StepRow>& rows, double StepRow::*value) {
  const StepRow& low = extreme(rows, value, false);
  const StepRow& high = extreme(rows, value, true);
  return formatted("  %-11s%.5f to %.5f, at times %.4g and %.4g; at the end %.5f\n", name, low.*value, high.*value,
                   low.T, high.T, rows.back().*value);
}

}  // namespace

TransientResult run_transient(const Case& input, const steady::Solution& start, bool quiet) {
  TransientResult result;
  const TransientInput& march = *input.transient;
  MarchProgress progress(march.parameters.end, quiet);
  const transient::Observer observer{[&](const StepRow& row) {
                                       result.rows.push_back(row);
                                       progress.show(row);
                                       return !stop_requested();
                                     },
                                     [&](transient::Frame&& frame) { result.frames.push_back(std::move(frame)); }};
  result.report = transient::march(input.scene, start, march.conditions, march.parameters, observer);
  return result;
}

bool completed(const TransientResult& result) {
  return result.report.end != MarchEnd::failed && result.report.end != MarchEnd::interrupted;
}

std::string transient_summary(const Case& input, const TransientResult& result) {
  const transient::MarchReport& report = result.report;
  std::string text = formatted("transient    time 0 to %.6g a/u_m", report.T);
  if (std::isfinite(input.transient->second)) text += formatted(" (%.4g s)", report.T / input.transient->second);
  text += ", ended " + how_it_ended(report) + "\n";
  text += range_line("Hc", result.rows, &StepRow::Hc) + range_line("Hm", result.rows, &StepRow::Hm) +
          range_line("P_max", result.rows, &StepRow::P_max);
  const int attempts = report.steps + report.rejected + report.not_solved;
  text += formatted(
      "  steps      %d, %.2f cycles each; %d of %d attempts rejected for their error, %d not solved; %d jumps; longest "
      "allowed %.3g\n",
      report.steps, static_cast<double>(report.cycles) / std::max(1, report.steps), report.rejected, attempts,
      report.not_solved, report.restarts, report.longest_step);
  text += formatted("  load       worst error %.1e\n  time       %.3f s, %.2f ms per step; %zu fields kept\n",
                    report.worst_load_error, report.seconds, 1e3 * report.seconds / std::max(1, report.steps),
                    result.frames.size());
  return text;
}

std::string transient_json(const TransientResult& result) {
  const transient::MarchReport& report = result.report;
  using json::number;
  return json::object({{"completed", json::boolean(completed(result))},
                       {"ended", json::text(how_it_ended(report))},
                       {"end_time", number(report.T)},
                       {"Hc", number(result.rows.back().Hc)},
                       {"Hm", number(result.rows.back().Hm)},
                       {"least_Hm", number(extreme(result.rows, &StepRow::Hm, false).Hm)},
                       {"largest_P_max", number(extreme(result.rows, &StepRow::P_max, true).P_max)},
                       {"steps", number(report.steps)},
                       {"cycles", number(report.cycles)},
                       {"rejected", number(report.rejected)},
                       {"not_solved", number(report.not_solved)},
                       {"jumps", number(report.restarts)},
                       {"worst_load_error", number(report.worst_load_error)},
                       {"seconds", number(report.seconds)}});
}

void add_transient(const Case& input, const TransientResult& result, results::Content& content) {
  using results::Column;
  const auto column = [&](const char* name, const char* unit, const char* meaning, bool whole,
                          const std::function<double(const StepRow&)>& value) {
    Column made{name, unit, meaning, whole, {}};
    for (const StepRow& row : result.rows) made.values.push_back(value(row));
    return made;
  };
  const auto number = [&](const char* name, const char* unit, const char* meaning, double StepRow::*member) {
    return column(name, unit, meaning, false, [member](const StepRow& row) { return row.*member; });
  };
  const auto count = [&](const char* name, const char* meaning, int StepRow::*member) {
    return column(name, "-", meaning, true, [member](const StepRow& row) { return row.*member; });
  };
  results::Table table{
      "transient",
      "every accepted step of time; ended " + how_it_ended(result.report),
      {number("time", "a/u_m", "time reached", &StepRow::T), number("Hc", "a^2/R", "film at (0,0)", &StepRow::Hc),
       number("Hm", "a^2/R", "smallest film of all nodes", &StepRow::Hm),
       number("Hm_x", "a", "where it is", &StepRow::Hm_X), number("Hm_y", "a", "where it is", &StepRow::Hm_Y),
       number("P_max", "p_h", "highest pressure of all nodes", &StepRow::P_max),
       number("H00", "a^2/R", "mutual approach", &StepRow::H00),
       number("load", "-", "wanted, over that of the contact", &StepRow::load),
       number("speed", "-", "entrainment speed (u1 + u2)/2 over u_m", &StepRow::speed),
       number("load_error", "-", "relative error of the load", &StepRow::load_error),
       number("step", "a/u_m", "length of the step; 0 for the start", &StepRow::length),
       count("order", "of the time integration", &StepRow::order),
       count("cycles", "of all attempts at the step", &StepRow::cycles),
       count("rejected", "attempts that failed the error test", &StepRow::rejected),
       count("not_solved", "attempts that the cycles did not solve", &StepRow::not_solved)}};
  if (std::isfinite(input.transient->second))
    content.scales.push_back({"time", 1.0 / input.transient->second, "s", "a/u_m, the scale of time"});
  content.tables.push_back(std::move(table));
  content.frames.group = "/transient/frames";
  for (const transient::Frame& frame : result.frames) content.frames.times.push_back(frame.T);
  const auto series = [&](const char* name, const char* unit, const char* meaning,
                          core::Field transient::Frame::*member) {
    if (std::ranges::find(input.fields, name) == input.fields.end()) return;
    results::Series made{name, unit, meaning, {}};
    for (const transient::Frame& frame : result.frames) made.fields.push_back(&(frame.*member));
    content.frames.series.push_back(std::move(made));
  };
  series("P", "p_h", "pressure p/p_h", &transient::Frame::P);
  series("H", "a^2/R", "film thickness h R/a^2", &transient::Frame::H);
}

}  // namespace ehl::program
