#include "run/error_bars_in_time.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "case/course_of_run.hpp"
#include "case/numbers/names.hpp"
#include "core/errors.hpp"
#include "core/timer.hpp"
#include "mlmi/deformation.hpp"
#include "run/solver.hpp"

namespace ehl::program {
namespace {

using transient::StepRow;

/// Share of the difference of two tolerances that bounds the error of the smaller one. [bench: bars_in_time]
constexpr double share_of_steps = 0.3;
/// A difference that changes its sign is taken as large as at the times around it, in a/u_m.
constexpr double half_window = 0.25;
constexpr double looser = 10.0, longer = 2.0;  ///< tolerance and longest step of the second run
constexpr double largest_rtol = 0.1;

/// A column with error bars: the share of the difference of two meshes that bounds the error of the finer one. Hc
/// converges with the third order, the others more slowly. The difference of Hm, a value at single nodes, may vanish by
/// chance: a share of the relative difference of Hc is added. [bench: bars_in_time]
struct Barred {
  const char* name;
  double StepRow::*error;
  double share_of_mesh;
  double share_of_Hc;
};
constexpr Barred columns[] = {{id::Hc, &StepRow::error_Hc, 0.27, 0.0},
                              {id::Hm, &StepRow::error_Hm, 0.35, 0.4},
                              {id::P_max, &StepRow::error_P_max, 0.65, 0.0},
                              {id::mu, &StepRow::error_mu, 0.65, 0.0}};

Case on_half_the_cells(const Case& input) {
  Case half = input;
  steady::Scene& scene = half.scene;
  scene.grid = core::coarsened(scene.grid);
  scene.deformation = mlmi::fitting(scene.deformation, scene.grid);
  scene.adjoint_errors = scene.error_maps = false;
  transient::MarchParameters& march = half.transient->parameters;
  march.output_interval = core::unknown;
  march.probes.clear();
  half.transient->mode = transient::Mode::in_time;
  half.transient->error_bars = false;
  return half;
}

void loosen(Case& half) {
  transient::MarchParameters& march = half.transient->parameters;
  const double longest =
      std::isnan(march.longest_step) ? longest_step(half.transient->conditions, march.end) : march.longest_step;
  march.rtol = std::min(largest_rtol, looser * march.rtol);
  march.longest_step = longer * longest;
}

// The value of a run at T, linear between its steps.
double value_at(const TransientResult& run, const std::vector<double>& values, double T) {
  const auto after = std::ranges::lower_bound(run.rows, T, {}, &StepRow::T);
  const auto k = static_cast<std::size_t>(after - run.rows.begin());
  if (k == run.rows.size()) return values.back();
  if (k == 0 || after->T == T) return values[k];
  const double share = (T - run.rows[k - 1].T) / (after->T - run.rows[k - 1].T);
  return values[k - 1] + share * (values[k] - values[k - 1]);
}

/// The run of the case, that on half the cells, and that with the larger tolerance.
struct Runs {
  const TransientResult& own;
  TransientResult half{}, looser{};
};

// The largest of the values around each time.
std::vector<double> largest_around(const std::vector<StepRow>& rows, const std::vector<double>& values) {
  std::vector<double> largest(values.size());
  std::size_t from = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    while (rows[from].T < rows[k].T - half_window) ++from;
    for (std::size_t n = from; n < rows.size() && rows[n].T <= rows[k].T + half_window; ++n)
      largest[k] = std::fmax(largest[k], values[n]);
  }
  return largest;
}

// The relative differences of the meshes and of the tolerances at every row of the case, the largest around each time.
// A value of zero has none.
struct Differences {
  std::vector<double> mesh{}, steps{};
};
Differences differences_of(const Runs& runs, const char* name) {
  const std::vector<double> of_half = values_of(runs.half, name), of_looser = values_of(runs.looser, name);
  const std::vector<double> own = values_of(runs.own, name);
  Differences found;
  for (std::size_t k = 0; k < own.size(); ++k) {
    const double T = runs.own.rows[k].T, half = value_at(runs.half, of_half, T);
    found.mesh.push_back(std::abs(half - own[k]));
    found.steps.push_back(std::abs(value_at(runs.looser, of_looser, T) - half));
  }
  for (std::vector<double>* list : {&found.mesh, &found.steps}) {
    *list = largest_around(runs.own.rows, *list);
    for (std::size_t k = 0; k < own.size(); ++k)
      (*list)[k] = own[k] == 0.0 ? core::unknown : (*list)[k] / std::abs(own[k]);
  }
  return found;
}

// The bar of an extreme is that at its time, that of a mean the mean of the bars.
void add_bars(const Case& input, const Runs& runs, TransientResult& result, TimeErrors& errors) {
  const Window window = window_of_means(input, result);
  const std::vector<double> of_Hc = differences_of(runs, id::Hc).mesh;
  for (const Barred& column : columns) {
    const std::vector<double> own = values_of(result, column.name);
    if (own.empty()) continue;
    const Differences found = differences_of(runs, column.name);
    std::vector<double> bars;
    for (std::size_t k = 0; k < own.size(); ++k) {
      const double bar =
          column.share_of_mesh * found.mesh[k] + share_of_steps * found.steps[k] + column.share_of_Hc * of_Hc[k];
      result.rows[k].*column.error = bar;
      bars.push_back(bar * std::abs(own[k]));
    }
    const Extremes of_own = extremes_of(result, window, own);
    const auto at = [&](double T) { return value_at(result, bars, T); };
    const std::string name = column.name;
    errors.of["least_" + name] = at(of_own.time_of_least) / std::abs(of_own.least);
    errors.of["largest_" + name] = at(of_own.time_of_largest) / std::abs(of_own.largest);
    errors.of["mean_" + name] = extremes_of(result, window, bars).mean / std::abs(of_own.mean);
  }
}

// Follows a run in time from its own steady state. out: why it is not complete; empty if it is.
std::string follow(const Case& half, RunSettings& settings, Computed& start, TransientResult& run) {
  RunSettings own{.progress = settings.progress};
  own.frame = [](transient::Frame&&) {};
  run = run_transient(half, start.solution, own);
  return why_incomplete(run);
}

std::string run_both(const Case& input, RunSettings& settings, Runs& runs) try {
  Case half = on_half_the_cells(input);
  Computed start;
  film_solver().solve(half, settings.progress, start);
  if (!start.solution.converged)
    return "the contact on half the cells did not converge: " + start.solution.failed_check;
  if (const std::string why = follow(half, settings, start, runs.half); !why.empty()) return "on half the cells " + why;
  loosen(half);
  const std::string why = follow(half, settings, start, runs.looser);
  return why.empty() ? "" : "with a larger tolerance " + why;
} catch (const core::SolverError& error) {
  return std::string("the contact on half the cells was not solved: ") + error.what();
}

}  // namespace

void add_error_bars_in_time(const Case& input, RunSettings& settings, Computed& computed) {
  if (!input.transient || !input.transient->error_bars || !computed.in_time || !completed(*computed.in_time)) return;
  const double began = core::now();
  TransientResult& result = *computed.in_time;
  TimeErrors& errors = result.errors.emplace();
  Runs runs{.own = result};
  errors.missing = run_both(input, settings, runs);
  if (errors.missing.empty()) add_bars(input, runs, result, errors);
  errors.seconds = core::now() - began;
}

}  // namespace ehl::program
