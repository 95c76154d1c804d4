#include "support/model_problem.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "core/norms.hpp"
#include "multigrid/cycle.hpp"

namespace ehl::tests {
namespace {

constexpr double X_a = -4.5, X_b = 1.5, Y_b = 3.0;

core::Grid grid_of(int cells, double stretch = 1.0) { return {cells, cells, X_a, X_b, -Y_b / stretch, Y_b / stretch}; }

}  // namespace

multigrid::RelaxationParameters ModelProblem::linear_relaxation() {
  multigrid::RelaxationParameters relaxation;
  relaxation.weight_single = 1.0;
  relaxation.weight_single_steep = 1.0;
  return relaxation;
}

ModelProblem constant_epsilon(double e, int cells, reynolds::Wedge wedge, multigrid::Cycle cycle) {
  const double h = grid_of(cells).hx();
  return {.cells = cells, .epsilon = [=](double, double) { return e * h * h; }, .wedge = wedge, .cycle = cycle};
}

ModelProblem constant_epsilon_on_stretched_cells(double e, double stretch, int cells, reynolds::Wedge wedge,
                                                 multigrid::Cycle cycle) {
  const double h = grid_of(cells).hx();
  return {.cells = cells,
          .stretch = stretch,
          .epsilon = [=](double, double) { return e * h * h / stretch; },
          .wedge = wedge,
          .cycle = cycle};
}

ModelProblem papers_epsilon(int cells, reynolds::Wedge wedge, multigrid::Cycle cycle) {
  const auto epsilon = [](double X, double Y) {
    const double r2 = X * X + Y * Y;
    return r2 > 1.0 ? r2 * r2 * r2 / 8.0 : 0.0;
  };
  return {.cells = cells, .epsilon = epsilon, .wedge = wedge, .cycle = cycle};
}

multigrid::Hierarchy make_error_hierarchy(const ModelProblem& problem) {
  const multigrid::Problem equations{.film = {.viscosity = rheology::Isoviscous{},
                                              .density = rheology::Incompressible{},
                                              .given_epsilon = problem.epsilon},
                                     .transport = problem.wedge,
                                     .load = std::nullopt,
                                     .cavitation = reynolds::Cavitation::none};
  multigrid::Parameters parameters{};
  parameters.cycle = problem.cycle;
  parameters.post = 1;
  parameters.coarsest_cells = problem.coarsest;
  parameters.relaxation = problem.relaxation;
  multigrid::Hierarchy hierarchy = multigrid::make_hierarchy(equations, parameters, {.method = mlmi::Method::fft},
                                                             grid_of(problem.cells, problem.stretch), 1);
  multigrid::Level& level = hierarchy.finest();
  level.F = core::Field(level.grid);
  for (int i = 0; i <= level.grid.nx; ++i)
    for (int j = 0; j <= level.grid.ny; ++j) {
      const double X = level.grid.X(i);
      const double Y = level.grid.Y(j);
      level.F(i, j) = -(0.5 * X * X + 0.5 * Y * Y);
    }
  return hierarchy;
}

std::vector<double> error_factors(const ModelProblem& problem, int cycles) {
  multigrid::Hierarchy hierarchy = make_error_hierarchy(problem);
  multigrid::Level& level = hierarchy.finest();
  std::mt19937 numbers(1992);
  for (int i = 1; i < level.grid.nx; ++i)
    for (int j = 1; j < level.grid.ny; ++j) level.P(i, j) = static_cast<double>(numbers()) / numbers.max() - 0.5;

  std::vector<double> factors;
  for (int k = 0; k < cycles; ++k) {
    // The problem is linear, so the error is normalised after each cycle; rounding then never dominates.
    const double size = core::root_mean_square(level.P);
    for (int i = 1; i < level.grid.nx; ++i)
      for (int j = 1; j < level.grid.ny; ++j) level.P(i, j) /= size;
    multigrid::update_film(hierarchy, level);
    multigrid::fas_cycle(hierarchy, hierarchy.levels.size() - 1);
    factors.push_back(core::root_mean_square(level.P));
  }
  return factors;
}

double late_factor(const std::vector<double>& factors, int count) {
  const auto used = std::min(factors.size(), static_cast<std::size_t>(count));
  double sum = 0.0;
  for (std::size_t k = factors.size() - used; k < factors.size(); ++k) sum += std::log(factors[k]);
  return std::exp(sum / static_cast<double>(used));
}

}  // namespace ehl::tests
