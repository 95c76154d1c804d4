#include "tables/study_measure.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/machine.hpp"
#include "core/constants.hpp"
#include "core/errors.hpp"
#include "core/norms.hpp"
#include "core/timer.hpp"
#include "judgement/measures.hpp"
#include "run/pipeline.hpp"
#include "tables/children.hpp"

namespace ehl::program {
namespace {

// The work of all levels in units of the finest grid.
double whole_work(const steady::Solution& solution) {
  const auto nodes = [](const steady::LevelRow& row) { return (row.nx + 1.0) * (row.ny + 1.0); };
  double work = 0.0;
  for (const steady::LevelRow& row : solution.levels) work += row.work_units * nodes(row);
  return work / nodes(solution.levels.back());
}

void take(const steady::Solution& solution, StudyPoint& point) {
  point.reason = solution.failed_check;
  point.attempts = static_cast<int>(solution.attempts.size());
  if (solution.levels.empty()) return;
  const steady::LevelRow& finest = solution.levels.back();
  if (solution.converged) point.status = "converged";
  // A fixed number of cycles was asked for and is done, and the film is positive: the point counts
  // although it is not converged.
  else if (point.variant.cycles != "run" && solution.end == steady::CyclesEnd::limit && finest.Hm > 0.0)
    point.status = "stopped";
  point.nx = finest.nx;
  point.ny = finest.ny;
  point.Hc = finest.Hc;
  point.Hm = finest.Hm;
  point.estimate_Hc = finest.mesh_error_Hc;
  point.estimate_Hm = finest.mesh_error_Hm;
  point.residual = finest.residual;
  for (const steady::LevelRow& row : solution.levels)
    point.cycles_by_level += (point.cycles_by_level.empty() ? "" : ";") + std::to_string(row.cycles);
  point.work_units = whole_work(solution);
}

/// Tolerance for the comparison of two times.
constexpr double rounding = 1e-9;

TimeSample sample_of(const Case& input, const transient::Frame& frame) {
  const core::Grid& grid = input.scene.grid;
  TimeSample sample{frame.T, {}};
  sample.values = {judgement::value_at(grid, frame.H, 0.0, 0.0), core::minimum(frame.H).value,
                   core::maximum(frame.P).value};
  for (const transient::Probed& probed :
       transient::probed_at(grid, frame.P, frame.H, input.transient->parameters.probes))
    sample.values.push_back(probed.P);
  return sample;
}

void take(const transient::MarchReport& report, StudyPoint& point) {
  using transient::MarchEnd;
  const bool complete = report.end != MarchEnd::failed && report.end != MarchEnd::interrupted;
  point.status = complete ? "complete" : "not-complete";
  if (!complete) point.reason = how_it_ended(report);
  point.T = report.T;
  point.steps = report.steps;
  point.cycles = report.cycles;
  point.rejected = report.rejected;
  point.not_solved = report.not_solved;
  point.jumps = report.restarts;
  point.seconds = point.seconds_most = report.seconds;
}

}  // namespace

StudyPoint measure(Case input, const StudyCase& variant) {
  use_way(variant, input.scene);
  StudyPoint point;
  point.variant = variant;
  point.status = "not-converged";
  point.nx = input.scene.grid.nx;
  point.ny = input.scene.grid.ny;
  Progress silent(true);
  RunSettings settings{.progress = silent, .extent = Extent::film};
  Computed computed;
  const double began = core::now();
  solve_case(input, settings, computed);
  take(computed.solution, point);
  point.seconds = point.seconds_most = core::now() - began;
  point.peak_memory = peak_memory();
  return point;
}

StudyPoint measure_in_time(Case input, const StudyCase& variant, int samples) {
  StudyPoint point;
  point.variant = variant;
  point.status = "not-complete";
  transient::MarchParameters& march = input.transient->parameters;
  march.rtol = variant.rtol;
  march.longest_step = variant.longest_step;
  march.output_interval = samples > 0 ? march.end / samples : core::unknown;
  Progress silent(true);
  RunSettings settings{.progress = silent};
  settings.frame = [&](transient::Frame&& frame) {
    // If the run ends early, its last frame may lie between two times of comparison; that frame is ignored.
    const double parts = frame.T / march.output_interval;
    if (std::abs(parts - std::round(parts)) < rounding * samples) point.samples.push_back(sample_of(input, frame));
  };
  Computed computed;
  solve_case(input, settings, computed);
  if (computed.in_time)
    take(computed.in_time->report, point);
  else
    point.reason =
        (computed.unsolved.empty() ? "the steady start did not converge: " : "") + computed.solution.failed_check;
  point.peak_memory = peak_memory();
  return point;
}

std::vector<StudyPoint> measured(const std::vector<StudyCase>& variants, int times, int at_once, bool quiet,
                                 const std::function<StudyPoint(const StudyCase&)>& compute, const std::string& note) {
  const std::size_t count = variants.size();
  std::vector<StudyPoint> all(count * static_cast<std::size_t>(times));
  std::vector<std::size_t> tasks(all.size());
  std::iota(tasks.begin(), tasks.end(), std::size_t{0});
  for (const std::size_t k : tasks) all[k].variant = variants[k % count];
  const auto name = [&](std::size_t k) {
    const std::string cells =
        variants[k % count].in_time() ? "" : std::to_string(variants[k % count].cells) + " cells, ";
    return cells + name_of_variant(variants[k % count]) + note;
  };
  const auto ended = [&](const ChildEnd& end) {
    StudyPoint& row = all[end.task];
    if (end.complete) {
      read_text(end.text, row);
    } else {
      row.status = "failed";
      row.reason = end.reason;
    }
    return row.status;
  };
  const auto task = [&](std::size_t k, const Say&) { return text_of(compute(variants[k % count])); };
  if (!run_watched({tasks, at_once, quiet, name, task, ended})) throw core::Interrupted();
  for (std::size_t k = count; k < all.size(); ++k) add_repetition(all[k], all[k % count]);
  all.resize(count);
  return all;
}

}  // namespace ehl::program
