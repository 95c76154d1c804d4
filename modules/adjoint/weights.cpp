#include "adjoint/weights.hpp"

#include <algorithm>
#include <utility>

#include "newton/gmres.hpp"

namespace ehl::adjoint {
double value_of(const Number& number, const core::Field& film) {
  double value = 0.0;
  for (const auto& [i, j, weight] : number) value += weight * film(i, j);
  return value;
}

Adjoint::Adjoint(multigrid::Hierarchy& hierarchy, std::size_t l)
    : hierarchy_(hierarchy),
      level_(hierarchy.levels[l]),
      equations_(hierarchy, l),
      preconditioner_(equations_, newton::Preconditioner::Precision::single),
      on_P_(level_.grid),
      on_H_(level_.grid),
      deformed_(level_.grid) {
  std::vector<double> u(equations_.size());
  equations_.unknowns(u);
  // Each node counts as wet or cavitated according to its residual: the edge of cavitation is a cell off if the state
  // is not the solution.
  const core::Patch& grid = level_.grid;
  for (int i = 1; i < grid.nx; ++i)
    for (int j = 1; j <= grid.last_line(); ++j) {
      const std::size_t k = equations_.index(i, j);
      u[k] = level_.P(i, j) - equations_.scale(k) * level_.r(i, j);
    }
  equations_.linearize(u);
  by_P_ = newton::slopes(equations_, newton::By::pressure);
  by_H_ = newton::slopes(equations_, newton::By::film);
  if (hierarchy.problem.far_field) {
    boundary_ = multigrid::nodes_of_boundary(level_.grid);
    far_ = multigrid::far_slopes(hierarchy, level_);
  }
  factored_ = preconditioner_.factor(by_P_, by_H_);
}

void Adjoint::scatter(const newton::Slopes& slopes, std::span<const double> x, core::Field& y) const {
  const core::Patch& grid = level_.grid;
  y.fill(0.0);
  for (int i = 1; i < grid.nx; ++i)
    for (int j = 1; j <= grid.last_line(); ++j) {
      const std::size_t row = equations_.index(i, j);
      if (!equations_.wet(row)) continue;
      for (std::size_t k = 0; k < newton::stencil.size(); ++k) {
        const auto [di, dj] = newton::stencil[k];
        if (slopes[row][k] != 0.0) y(i + di, j + dj) += slopes[row][k] * x[row];
      }
    }
}

// K^T v. A node that stands for its mirror image too has that weight in the inner product in which K is symmetric. The
// copies of the line of a line contact, which stand for none, have no part in it.
void Adjoint::deform(core::Field& v) {
  const core::Patch& grid = level_.grid;
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j) v(i, j) /= std::max(1.0, grid.lines(j));
  {
    const core::ScopedTimer timer(hierarchy_.times, core::Part::deformation);
    level_.deformation.evaluate(v, deformed_);
  }
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j) deformed_(i, j) *= std::max(1.0, grid.lines(j));
}

// Unknowns: one for the equation of each interior node, one for the load, and those of the boundary. Rows
// correspondingly: derivatives by P inside, by H00, by P on the boundary.
void Adjoint::product(std::span<const double> x, std::span<double> y) {
  const core::Patch& grid = level_.grid;
  const std::size_t last = equations_.size() - 1;
  const double cell = grid.hx() * grid.hy() / level_.load;
  const std::span<const double> beside = x.subspan(last + 1);
  scatter(by_P_, x, on_P_);
  scatter(by_H_, x, on_H_);
  double by_H00 = 0.0;
  for (std::size_t k = 0; k < boundary_.size(); ++k) {
    on_H_(boundary_[k].i, boundary_[k].j) -= far_.P_by_H[k] * beside[k];
    by_H00 -= far_.P_by_H00[k] * beside[k];
  }
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j) by_H00 += on_H_(i, j);
  y[last] = by_H00 + far_.load_by_H00 / level_.load * x[last];
  deform(on_H_);
  const auto by_P = [&](int i, int j, double share) {
    return on_P_(i, j) + deformed_(i, j) + cell * share * grid.lines(j) * x[last];
  };
  for (int i = 1; i < grid.nx; ++i)
    for (int j = 1; j <= grid.last_line(); ++j) y[equations_.index(i, j)] = by_P(i, j, 1.0);
  for (std::size_t k = 0; k < boundary_.size(); ++k)
    y[last + 1 + k] = beside[k] + by_P(boundary_[k].i, boundary_[k].j, boundary_[k].share);
}

std::optional<Weights> Adjoint::weights(const Number& number, double tolerance) {
  if (!factored_) return std::nullopt;
  const core::Patch& grid = level_.grid;
  const std::size_t last = equations_.size() - 1;
  std::vector<double> slope(last + 1 + boundary_.size(), 0.0), x(slope.size());
  on_H_.fill(0.0);
  for (const auto& [i, j, weight] : number) {
    on_H_(i, j) += weight;
    slope[last] += weight;
  }
  deform(on_H_);
  for (int i = 1; i < grid.nx; ++i)
    for (int j = 1; j <= grid.last_line(); ++j) slope[equations_.index(i, j)] = deformed_(i, j);
  for (std::size_t k = 0; k < boundary_.size(); ++k) slope[last + 1 + k] = deformed_(boundary_[k].i, boundary_[k].j);
  std::vector<double> of_wet = slope;
  for (std::size_t k = 0; k < last; ++k)
    if (!equations_.wet(k)) of_wet[k] = 0.0;
  const newton::LinearSystem system{[this, last](auto v, auto Av) {
                                      product(v, Av);
                                      for (std::size_t k = 0; k < last; ++k)
                                        if (!equations_.wet(k)) Av[k] = v[k];
                                    },
                                    [this, last](auto v) { preconditioner_.solve_transposed(v.first(last + 1)); }};
  const newton::GmresResult solved = newton::gmres(system, of_wet, tolerance, x);
  iterations_ = solved.iterations;
  if (!solved.reached) return std::nullopt;
  std::vector<double> by_P(x.size());
  product(x, by_P);
  Weights weights{core::Field(grid),
                  core::Field(grid),
                  x[last] / level_.load,
                  {x.begin() + static_cast<std::ptrdiff_t>(last) + 1, x.end()}};
  for (int i = 1; i < grid.nx; ++i)
    for (int j = 1; j <= grid.last_line(); ++j) {
      const std::size_t k = equations_.index(i, j);
      if (equations_.wet(k))
        weights.residual(i, j) = equations_.scale(k) * x[k];
      else
        weights.pressure(i, j) = slope[k] - by_P[k];
    }
  return weights;
}

double left_over(const Weights& weights, const core::Field& r, const core::Field& P, double load) {
  double sum = weights.load * load;
  for (int i = 0; i < r.nodes_x(); ++i)
    for (int j = 0; j < r.nodes_y(); ++j) sum += weights.residual(i, j) * r(i, j) + weights.pressure(i, j) * P(i, j);
  return sum;
}

}  // namespace ehl::adjoint
