// The rows of touching surfaces in the equations of Newton's method.
#include <algorithm>

#include "newton/equations.hpp"

namespace ehl::newton {

// A gap below H_b closes in the next step, without waiting for a pressure.
void Equations::find_touching() {
  const double H_b = multigrid::boundary_film(hierarchy_);
  const multigrid::Touching& surfaces = *level_.touching;
  const bool may_yield = surfaces.yielded.nodes_x() > 0;
  for (int i = 1; i < grid().nx; ++i)
    for (int j = 1; j <= grid().last_line(); ++j)
      touch_[index(i, j)] = may_yield && surfaces.yielded(i, j) > 0.0          ? Touch::yields
                            : surfaces.P_c(i, j) > 0.0 || level_.H(i, j) < H_b ? Touch::touches
                                                                               : Touch::none;
}

void Equations::touching_unknowns(std::span<double> u) const {
  const double s = touching_scale(), H_b = multigrid::boundary_film(hierarchy_);
  const multigrid::Touching& surfaces = *level_.touching;
  const bool yields = surfaces.yielded.nodes_x() > 0;
  for (int i = 1; i < grid().nx; ++i)
    for (int j = 1; j <= grid().last_line(); ++j) {
      double& w = u[nodes_ + index(i, j)];
      w = surfaces.P_c(i, j);
      if (yields) w += s * surfaces.yielded(i, j);
      if (w == 0.0) w = std::min(0.0, -s * (level_.H(i, j) - H_b));
    }
}

void Equations::set_touching(std::span<const double> u) {
  multigrid::Touching& surfaces = *level_.touching;
  const bool yields = surfaces.yielded.nodes_x() > 0;
  for (int i = 1; i < grid().nx; ++i)
    for (int j = 1; j <= grid().last_line(); ++j) {
      const double w = u[nodes_ + index(i, j)];
      surfaces.P_c(i, j) = std::clamp(w, 0.0, hardness());
      if (yields) surfaces.yielded(i, j) = std::max(0.0, w - hardness()) / touching_scale();
    }
}

void Equations::touching_residual(std::span<const double> u, std::span<double> F) const {
  const double H_b = multigrid::boundary_film(hierarchy_);
  for (int i = 1; i < grid().nx; ++i)
    for (int j = 1; j <= grid().last_line(); ++j) {
      const std::size_t k = nodes_ + index(i, j);
      F[k] = touching_scale() * (level_.H(i, j) - H_b) + std::min(u[k], 0.0);
    }
}

void Equations::make_moved() {
  const auto masked = [this](const core::Field& field, core::Field& moved) {
    if (field.nodes_x() == 0) return;
    if (moved.nodes_x() == 0) moved = core::Field(grid());
    for (int i = 0; i <= grid().nx; ++i)
      for (int j = 0; j <= grid().ny; ++j) moved(i, j) = moves(i, j) * field(i, j);
    core::fill_ghosts(grid(), moved);
  };
  masked(along_.dH, moved_.eps);
  masked(across_.dH, moved_.eps_across);
  masked(level_.rho_bar, moved_.q);
}

double Equations::add_touching(std::span<const double> v, const core::Field& dP) {
  dtotal_ = dP;
  double load = 0.0;
  for (int i = 1; i < grid().nx; ++i)
    for (int j = 1; j <= grid().last_line(); ++j) {
      const std::size_t node = index(i, j);
      if (touch_[node] != Touch::touches) continue;
      dtotal_(i, j) += v[nodes_ + node];
      load += grid().lines(j) * v[nodes_ + node];
    }
  core::fill_ghosts(grid(), dtotal_);
  return load;
}

void Equations::touching_rows(std::span<const double> v, core::Field& dH, std::span<double> Jv) const {
  const double s = touching_scale();
  for (int i = 1; i < grid().nx; ++i)
    for (int j = 1; j <= grid().last_line(); ++j) {
      const std::size_t node = index(i, j), k = nodes_ + node;
      if (touch_[node] == Touch::yields) dH(i, j) += v[k] / s;
      Jv[k] = touch_[node] == Touch::none ? v[k] : s * dH(i, j);
    }
  if (grid().domain.line)
    for (int i = 1; i < grid().nx; ++i) dH(i, 0) = dH(i, 2) = dH(i, 1);
}

void Equations::complete(std::span<const double> minus_F, std::span<double> d) {
  if (!touching()) return;
  for (int i = 1; i < grid().nx; ++i)
    for (int j = 1; j <= grid().last_line(); ++j) {
      const std::size_t node = index(i, j);
      dP_(i, j) = wet_[node] ? d[node] : 0.0;
    }
  core::fill_ghosts(grid(), dP_);
  add_touching(d, dP_);
  deform(dtotal_, dH_);
  for (int i = 1; i < grid().nx; ++i)
    for (int j = 1; j <= grid().last_line(); ++j) {
      const std::size_t node = index(i, j), k = nodes_ + node;
      if (touch_[node] == Touch::none) d[k] = minus_F[k] - touching_scale() * (dH_(i, j) + d.back());
    }
}

}  // namespace ehl::newton
