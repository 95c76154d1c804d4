// The lubricated contact: from the case to the printed report and the result file.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/errors.hpp"
#include "report/outcome.hpp"
#include "report/report.hpp"
#include "report/result_content.hpp"
#include "run/solver.hpp"
#include "steady/solve.hpp"

namespace ehl::program {
namespace {

std::string text_of(const steady::Progress& now) {
  // A load continuation solves for other loads first.
  const std::string load = now.load_ratio == 1.0 ? "" : fmt::format("  load {:.3g} %", 100.0 * now.load_ratio);
  return fmt::format("{} x {}{}  cycle {}/{}  residual {:.1e}  Hc {:.4f}", now.nx + 1, now.ny + 1, load, now.cycle,
                     std::max(now.cycle, now.cycles), now.residual, now.Hc);
}

// The solver of the effect that has equations to be solved with the film, or that of the film alone.
FilmSolver solver_of_film(const Case& input) {
  FilmSolver solver = [](const Case& one, const steady::ProgressCallback& progress, Computed& computed) {
    computed.solution = steady::solve(one.scene, progress);
  };
  for (const Effect& effect : effects_of(input))
    if (effect.stages.film)
      if (const FilmSolver own = effect.stages.film(input)) solver = own;
  return solver;
}

void solve(const Case& input, Progress& progress, Computed& computed) {
  int level = -1;
  const auto show = [&](const steady::Progress& now) {
    const bool new_level = now.level != level;
    level = now.level;
    return progress.show(now.fraction, text_of(now), new_level);
  };
  solver_of_film(input)(input, show, computed);
  if (!has_film(computed.solution)) throw core::SolverError(computed.solution.failed_check);
  computed.outcome = outcome_of(input, computed.solution);
  if (!is_finite(computed.outcome)) throw core::SolverError("the film or the pressure is not finite");
}

std::string profile(const Case& input, const Computed& computed) {
  return tuning_lines(input.tuning) +
         (computed.in_time ? profile_table(computed.in_time->report.times, computed.in_time->report.seconds)
                           : profile_table(computed.solution.times, computed.solution.seconds));
}

}  // namespace

Solver film_solver() {
  return {.solve = solve,
          .derived = derived,
          .summary = summary,
          .json = json_report,
          .profile = profile,
          .content = result_content};
}

}  // namespace ehl::program
