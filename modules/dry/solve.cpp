#include "dry/solve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "core/errors.hpp"
#include "core/norms.hpp"
#include "core/timer.hpp"
#include "dry/conjugate_gradients.hpp"
#include "transfer/transfer.hpp"

namespace ehl::dry {
namespace {

// Least number of cells of the coarsest grid. [bench: dry_fewest_cells]
constexpr int fewest_cells = 32;

// Grids from the finest to the coarsest.
std::vector<core::Patch> grids_of(const Problem& problem) {
  const int coarsest = problem.parameters.coarsest_cells;
  std::vector<core::Patch> grids{problem.grid};
  const auto goes_on = [&](const core::Patch& grid) {
    return coarsest > 0 ? grid.nx > coarsest : grid.nx / 2 >= fewest_cells;
  };
  while (grids.back().nx % 2 == 0 && grids.back().ny % 2 == 0 && goes_on(grids.back()))
    grids.push_back(core::coarsened(grids.back()));
  return grids;
}

// Hertz' pressure; scaling to the load corrects it for other shapes.
core::Field first_guess(const core::Patch& grid, const core::QuadraticForm& outline) {
  core::Field P(grid);
  for (int i = 0; i < grid.nodes_x(); ++i)
    for (int j = 0; j < grid.nodes_y(); ++j) P(i, j) = std::sqrt(std::max(0.0, 1.0 - outline.at(grid.X(i), grid.Y(j))));
  return P;
}

bool touches_edge(const core::Field& P) {
  const int nx = P.nodes_x() - 1, ny = P.nodes_y() - 1;
  for (int i = 0; i <= nx; ++i)
    if (P(i, 0) > 0.0 || P(i, ny) > 0.0) return true;
  for (int j = 0; j <= ny; ++j)
    if (P(0, j) > 0.0 || P(nx, j) > 0.0) return true;
  return false;
}

void check(const Problem& problem, Solution& solution) {
  const GridRow& last = solution.rows.back();
  if (!(last.error <= problem.parameters.tolerance))
    solution.failed_check = fmt::format(
        "dry contact: after {} iterations on {} x {} cells the gap error is {:.1e} a^2/R, above the tolerance {:.1e}: "
        "allow more iterations",
        last.iterations, last.nx, last.ny, last.error, problem.parameters.tolerance);
  else if (touches_edge(solution.P))
    solution.failed_check = "dry contact: the contact reaches the edge of the domain: use a larger domain";
  solution.converged = solution.failed_check.empty();
}

}  // namespace

core::Field smooth_gap(const core::Patch& grid) {
  core::Field gap(grid);
  for (int i = 0; i < grid.nodes_x(); ++i)
    for (int j = 0; j < grid.nodes_y(); ++j) gap(i, j) = 0.5 * (grid.X(i) * grid.X(i) + grid.Y(j) * grid.Y(j));
  return gap;
}

Problem ball_on_flat(const core::Patch& grid, const std::function<void(const core::Patch&, core::Field& S)>& surface) {
  constexpr double hertz_load = 2.0 * core::pi / 3.0;  // integral of P = sqrt(1 - r^2) over the contact
  Problem problem{.grid = grid, .gap = smooth_gap(grid), .load = hertz_load};
  if (!surface) return problem;
  core::Field S(grid);
  surface(grid, S);
  for (int i = 0; i < grid.nodes_x(); ++i)
    for (int j = 0; j < grid.nodes_y(); ++j) problem.gap(i, j) += S(i, j);
  return problem;
}

Solution solve(const Problem& problem, const Observer& observe) {
  const double start = core::now();
  const std::vector<core::Patch> grids = grids_of(problem);
  std::vector<core::Field> gaps{problem.gap};
  for (std::size_t k = 1; k < grids.size(); ++k) {
    gaps.emplace_back(grids[k]);
    transfer::restrict_injection(gaps[k - 1], gaps[k]);
  }
  Solution solution;
  core::Field P = first_guess(grids.back(), problem.outline), H;
  for (std::size_t k = grids.size(); k-- > 0;) {
    const double begun = core::now();
    const core::Patch& grid = grids[k];
    if (k + 1 < grids.size()) {
      core::Field finer(grid);
      transfer::prolong_bilinear(P, finer, 1);
      P = std::move(finer);
    }
    mlmi::Deformation deformation(grid, problem.deformation, problem.threads, problem.kernel);
    ConjugateGradients iteration(grid, gaps[k], problem.load, deformation, P);
    int count = 0;
    while (iteration.error() > problem.parameters.tolerance && count < problem.parameters.max_iterations) {
      iteration.step();
      ++count;
      if (observe && !observe({grid.domain, static_cast<int>(k), count, iteration.error()})) throw core::Interrupted();
    }
    if (!std::isfinite(iteration.error()))
      throw core::SolverError("dry contact: a value is not finite on " + std::to_string(grid.nx) + " x " +
                              std::to_string(grid.domain.ny) + " cells, iteration " + std::to_string(count));
    P = iteration.P();
    H = iteration.H();
    solution.H00 = iteration.H00();
    solution.rows.push_back({grid.nx, grid.domain.ny, core::maximum(P).value, iteration.H00(), iteration.area(),
                             iteration.error(), count, core::now() - begun});
    solution.deformation = deformation.description();
  }
  solution.grid = problem.grid.domain;
  solution.P = core::on_domain(problem.grid, P);
  solution.H = core::on_domain(problem.grid, H);
  double sum = 0.0;
  for (int i = 0; i < solution.grid.nodes_x(); ++i)
    for (const double p : solution.P.station(i)) sum += p;
  solution.load_error = std::abs(sum * solution.grid.hx() * solution.grid.hy() / problem.load - 1.0);
  check(problem, solution);
  solution.seconds = core::now() - start;
  return solution;
}

}  // namespace ehl::dry
