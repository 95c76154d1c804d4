#include "adjoint/errors.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "adjoint/truncation.hpp"
#include "adjoint/weights.hpp"
#include "core/norms.hpp"
#include "core/timer.hpp"
#include "judgement/measures.hpp"
#include "transfer/transfer.hpp"

namespace ehl::adjoint {
namespace {

/// Nodes above which the adjoint solution is made on a still coarser grid. [bench: many_nodes]
constexpr double many_nodes = 6000.0;
/// Relative tolerance of the adjoint systems: a coarse grid's solution needs no more.
constexpr double tolerance = 1e-2;

struct Values {
  double Hc, Hm;
};
Values values_of(const multigrid::Level& level) {
  const core::Location least = core::minimum(level.H);
  return {judgement::value_at(level.grid, level.H, 0.0, 0.0),
          judgement::fitted_minimum(level.grid, level.H, least.i, least.j).value};
}

/// Two grids below the finest, or three; the coarsest if there are few grids.
std::size_t level_of_weights(const multigrid::Hierarchy& hierarchy) {
  const std::size_t finest = hierarchy.levels.size() - 1;
  if (finest < 3) return 0;
  const core::Patch& grid = hierarchy.levels[finest - 2].grid;
  return static_cast<double>(grid.nx) * grid.ny > many_nodes ? finest - 3 : finest - 2;
}

/// Transfers the adjoint solution to a finer grid by bilinear interpolation of its values per unit area.
core::Field on_finer(const multigrid::Hierarchy& hierarchy, std::size_t from, std::size_t to,
                     const core::Field& weights) {
  const auto scaled = [&](std::size_t l, double power, core::Field field) {
    const core::Patch& grid = hierarchy.levels[l].grid;
    for (int i = 0; i <= grid.nx; ++i)
      for (int j = 0; j <= grid.ny; ++j)
        if (grid.lines(j) > 0.0) field(i, j) *= std::pow(grid.hx() * grid.hy() * grid.lines(j), power);
    return field;
  };
  core::Field now = scaled(from, -1.0, weights);
  for (std::size_t l = from; l < to; ++l) {
    core::Field next(hierarchy.levels[l + 1].grid);
    transfer::prolong_bilinear(now, next, 1);
    now = std::move(next);
  }
  return scaled(to, 1.0, std::move(now));
}

/// -(poiseuille/3 + wedge/7) per area, relative to the value: positive where the number is too large.
core::Field density(const multigrid::Hierarchy& hierarchy, const core::Field& P, const core::Field& weights,
                    const Truncation& parts, double value) {
  const std::size_t finest = hierarchy.levels.size() - 1;
  const core::Patch& grid = hierarchy.levels[finest - 1].grid;
  core::Field here(grid);
  for (int i = 1; i < grid.nx; ++i)
    for (int j = 1; j <= grid.last_line(); ++j)
      if (P(i, j) > 0.0)
        here(i, j) = -weights(i, j) * (parts.poiseuille(i, j) / 3.0 + parts.wedge(i, j) / 7.0) /
                     (value * grid.hx() * grid.hy() * grid.lines(j));
  core::Field on_fine(hierarchy.levels[finest].grid);
  transfer::prolong_bilinear(here, on_fine, 1);
  return core::on_domain(hierarchy.levels[finest].grid, on_fine);
}

/// Bound on the error from the closed far field. The closed form treats the deformation as that of a point load, and
/// the lines of rupture as straight, although H00 bends them. The relative error of the pressure is the size of these
/// two terms relative to the rigid gap, taken as round. [bench: share_of_H00]
constexpr double share_of_H00 = 0.125;
double domain_error(const multigrid::Hierarchy& hierarchy, const multigrid::Level& level, const Weights& weights) {
  const multigrid::Problem& problem = hierarchy.problem;
  if (!problem.far_field) return 0.0;
  const core::QuadraticForm& gap = problem.geometry.gap;
  const double round = gap.closed() ? 0.5 * (gap.XX + gap.YY) : gap.XX;
  const double deformation = problem.geometry.kernel.factor * problem.load.value_or(0.0);
  const std::vector<multigrid::BoundaryNode> nodes = multigrid::nodes_of_boundary(level.grid);
  double sum = 0.0;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const auto [i, j, share] = nodes[k];
    const double r = std::hypot(level.grid.X(i), level.grid.Y(j));
    const double wrong = (deformation / r + share_of_H00 * std::abs(hierarchy.H00)) / (round * r * r);
    sum += std::abs(weights.boundary[k] * level.P(i, j)) * wrong;
  }
  return sum;
}

struct Sum {
  double plain = 0.0, absolute = 0.0;
};
Sum sum_over_wet(const core::Patch& grid, const core::Field& P, const core::Field& weights, const core::Field& r) {
  Sum sum;
  for (int i = 1; i < grid.nx; ++i)
    for (int j = 1; j <= grid.last_line(); ++j)
      if (P(i, j) > 0.0) {
        sum.plain += weights(i, j) * r(i, j);
        sum.absolute += std::abs(weights(i, j) * r(i, j));
      }
  return sum;
}

}  // namespace

std::optional<Errors> errors(multigrid::Hierarchy& hierarchy, bool maps) {
  const double began = core::now();
  const std::size_t finest = hierarchy.levels.size() - 1;
  if (finest == 0) return std::nullopt;
  const core::EnclosingTimer timer(hierarchy.times, core::Part::errors);
  const std::size_t coarse = level_of_weights(hierarchy);
  const multigrid::Level& fine = hierarchy.levels[finest];
  const multigrid::Level& beside = hierarchy.levels[finest - 1];
  const multigrid::Level& level = hierarchy.levels[coarse];
  const Values values = values_of(fine);
  const double load_left = multigrid::carried_load(fine) - fine.load;
  const Truncation parts = truncation(hierarchy, finest - 1, finest);
  const Values beside_values = values_of(beside);
  const core::Field beside_P = beside.P;
  if (coarse != finest - 1) truncation(hierarchy, coarse, finest);
  Adjoint adjoint(hierarchy, coarse);
  Errors result;
  result.cells = level.grid.nx;
  const auto predicted = [&](const Number& number, double value, double there,
                             core::Field& map) -> std::optional<PredictedChange> {
    const std::optional<Weights> weights = adjoint.weights(number, tolerance);
    if (!weights) return std::nullopt;
    const core::Field on_beside = on_finer(hierarchy, coarse, finest - 1, weights->residual);
    const core::Field on_fine = on_finer(hierarchy, finest - 1, finest, on_beside);
    const auto of = [&](const core::Field& r) { return sum_over_wet(beside.grid, beside_P, on_beside, r).plain; };
    if (maps) map = density(hierarchy, beside_P, on_beside, parts, value);
    const Sum left = sum_over_wet(fine.grid, fine.P, on_fine, fine.r);
    return PredictedChange{.poiseuille = of(parts.poiseuille) / value,
                           .wedge = of(parts.wedge) / value,
                           .film = (of(parts.film) + weights->load * parts.load + value - there) / value,
                           .left = (left.plain + weights->load * load_left) / value,
                           .scattered = left.absolute / value,
                           .domain = domain_error(hierarchy, level, *weights) / value};
  };
  const core::Location least = core::minimum(level.H);
  const auto Hc = predicted(judgement::weights_at(level.grid, 0.0, 0.0), values.Hc, beside_values.Hc, result.map_Hc);
  const auto Hm = predicted(judgement::weights_of_fitted_minimum(level.grid, level.H, least.i, least.j), values.Hm,
                            beside_values.Hm, result.map_Hm);
  if (!Hc || !Hm) return std::nullopt;
  result.Hc = *Hc;
  result.Hm = *Hm;
  result.seconds = core::now() - began;
  return result;
}

}  // namespace ehl::adjoint
