#pragma once
// Error bars against errors: scenes, a truth from finer grids, and what a solution says of itself.
//
// The truth of a contact is the film of the continuous problem on the same domain, for all schemes the same. It is made
// of two solutions with upstream3, solved to 1e-7, on grids finer than any that is judged, extrapolated with the order
// 2: no value that is judged, nor any that its error bar was made of, enters it.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "contact/groups.hpp"
#include "steady/domain_error.hpp"
#include "steady/solve.hpp"

namespace ehl::test {

enum class Oil { roelands, barus, incompressible };

/// A contact and its lubricant. Density of Dowson and Higginson, but for the oil that is incompressible.
struct Point {
  double M, L;
  double alpha;    ///< [1/Pa]
  double z;        ///< Roelands' exponent
  bool held_back;  ///< played no part where the estimates were made
  Oil oil = Oil::roelands;
  double radius_ratio = 1.0, angle = 0.0;
};

/// On the domain that the program chooses, n cells along x. With the third-order wedge epsilon is made at half points.
inline steady::Scene scene_of(const Point& point, reynolds::Wedge wedge, int n, bool far_field) {
  const contact::Groups groups =
      contact::from_moes(point.M, point.L, contact::ellipse(point.radius_ratio, point.angle));
  const double p_h = groups.alpha_bar / point.alpha;
  steady::Scene scene;
  scene.M = point.M;
  scene.L = point.L;
  scene.lambda = groups.lambda;
  scene.shape = groups.shape;
  scene.viscosity = rheology::make_roelands(point.alpha, rheology::roelands_p0, point.z, p_h);
  if (point.oil == Oil::barus) scene.viscosity = rheology::make_barus(point.alpha, p_h);
  scene.density = rheology::make_dowson_higginson(p_h);
  if (point.oil == Oil::incompressible) scene.density = rheology::Incompressible{};
  scene.wedge = wedge;
  scene.far_field = far_field;
  scene.face = reynolds::third_order(wedge) ? reynolds::Face::logmean_bounded : reynolds::Face::mean;
  const std::optional<double> error =
      scene.far_field ? std::optional(steady::error_of_closed_domain) : std::optional<double>();
  const double X_b = steady::chosen_outlet(point.M, point.L, scene.shape, error);
  const double X_a = steady::chosen_inlet(point.M, point.L, X_b, scene.shape, error);
  const double half = steady::chosen_half_width(X_a, X_b, scene.shape, scene.far_field);
  int levels = 0;
  for (int cells = n; cells % 2 == 0 && cells >= 64; cells /= 2) ++levels;
  const double pairs = std::round(std::ldexp(2.0 * half * n / (X_b - X_a), -levels - 1));
  scene.grid = {n, static_cast<int>(std::ldexp(std::max(1.0, pairs), levels + 1)), X_a, X_b, -half, half};
  return scene;
}

/// The row of the finest grid, solved to a relative residual. errors: std::runtime_error where that is not reached.
inline steady::LevelRow solved(steady::Scene scene, double residual) {
  scene.multigrid.tolerance = residual;
  const steady::Solution solution = steady::solve(scene);
  if (!solution.converged) throw std::runtime_error(solution.failed_check);
  return solution.levels.back();
}

struct Film {
  double Hc = 0.0;
  double Hm = 0.0;
};

/// Second-order extrapolation from two grids, fine over coarse the ratio of their cells; Hm the fitted minimum.
inline Film extrapolated(const steady::LevelRow& coarse, const steady::LevelRow& fine) {
  const double ratio = static_cast<double>(fine.nx) / coarse.nx;
  const double share = 1.0 / (ratio * ratio - 1.0);
  return {fine.Hc + share * (fine.Hc - coarse.Hc), fine.Hm_fitted + share * (fine.Hm_fitted - coarse.Hm_fitted)};
}

constexpr double residual_of_truth = 1e-7;

/// in: cells of the two grids. errors: std::runtime_error, core::SolverError.
inline Film truth_of(const Point& point, int coarse, int fine, bool far_field) {
  const auto row = [&](int n) {
    return solved(scene_of(point, reynolds::Wedge::upstream3, n, far_field), residual_of_truth);
  };
  return extrapolated(row(coarse), row(fine));
}

/// One number with its error bar, and the error that it has; both relative to the number.
struct Judged {
  std::string_view name;
  double estimate = 0.0;  ///< of mesh and cycles; NaN: the run tells none
  double error = 0.0;
  bool within() const { return error <= estimate; }
  double ratio() const { return estimate / error; }
};

/// What the error bars of a solution claim, and what is true.
inline std::array<Judged, 5> judged(const steady::Solution& solution, const Film& truth) {
  const steady::ErrorBars& bars = solution.error_bars;
  const steady::LevelRow& row = solution.levels.back();
  const auto one = [](std::string_view name, double estimate, double value, double right) {
    return Judged{name, estimate, std::abs((value - right) / value)};
  };
  return {one("Hc", bars.Hc.total(), row.Hc, truth.Hc), one("Hm, node", bars.Hm.total(), row.Hm, truth.Hm),
          one("Hm, fitted", bars.Hm_fitted.total(), bars.Hm_fitted_value, truth.Hm),
          one("Hc, extrapolated", bars.Hc_extrapolated.error, bars.Hc_extrapolated.value, truth.Hc),
          one("Hm, extrapolated", bars.Hm_extrapolated.error, bars.Hm_extrapolated.value, truth.Hm)};
}

inline std::string name_of(const Point& point, reynolds::Wedge wedge, int n) {
  std::string name = "(";
  name += std::to_string(static_cast<int>(point.M)) + ", " + std::to_string(static_cast<int>(point.L)) + ")";
  name += " upstream" + std::to_string(static_cast<int>(wedge) + 1) + " ";
  return name + std::to_string(n);
}

}  // namespace ehl::test
