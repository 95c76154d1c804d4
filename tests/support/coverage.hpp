#pragma once
// Compares error bars with true errors: the contacts, a reference from finer grids, and the bars of a solution.
//
// The true film of a contact is that of the continuous problem on the same domain; it is the same for all schemes. It
// is extrapolated with order 2 from two solutions with upstream3, converged to 1e-7, on grids finer than those that are
// judged. It uses no value that is judged or that an error bar was derived from.
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

/// A contact and its lubricant. The density law is Dowson and Higginson's, except for the incompressible oil.
struct Point {
  double M, L;
  double alpha;    ///< [1/Pa]
  double z;        ///< Roelands' exponent
  bool held_back;  ///< was not used in the development of the estimates
  Oil oil = Oil::roelands;
  double radius_ratio = 1.0, angle = 0.0;
};

/// The scene on the domain that the program chooses, with n cells along X. With upstream3, epsilon is
/// evaluated at half points.
inline steady::Scene scene_of(const Point& point, reynolds::Wedge wedge, int n, bool far_field) {
  const contact::Groups groups =
      contact::from_moes(point.M, point.L, contact::ellipse(point.radius_ratio, point.angle));
  const double p_h = groups.alpha_bar / point.alpha;
  steady::Scene scene;
  scene.contact = steady::scales_of(point.M, point.L, groups.shape);
  scene.lambda = groups.lambda;
  scene.viscosity = rheology::make_roelands(point.alpha, rheology::roelands_p0, point.z, p_h);
  if (point.oil == Oil::barus) scene.viscosity = rheology::make_barus(point.alpha, p_h);
  scene.density = rheology::make_dowson_higginson(p_h);
  if (point.oil == Oil::incompressible) scene.density = rheology::Incompressible{};
  scene.wedge = wedge;
  scene.far_field = far_field;
  scene.face = reynolds::third_order(wedge) ? reynolds::Face::logmean_bounded : reynolds::Face::mean;
  const std::optional<double> error =
      scene.far_field ? std::optional(steady::Tuning{}.error_of_closed_domain) : std::optional<double>();
  const double X_b = steady::chosen_outlet({}, scene.contact, error);
  const double X_a = steady::chosen_inlet({}, scene.contact, X_b, error);
  const double half = steady::chosen_half_width({}, X_a, X_b, scene.contact.shape, scene.far_field);
  int levels = 0;
  for (int cells = n; cells % 2 == 0 && cells >= 64; cells /= 2) ++levels;
  const double pairs = std::round(std::ldexp(2.0 * half * n / (X_b - X_a), -levels - 1));
  scene.grid = {n, static_cast<int>(std::ldexp(std::max(1.0, pairs), levels + 1)), X_a, X_b, -half, half};
  return scene;
}

/// The finest grid's row, solved to a relative residual. errors: std::runtime_error if the residual is not reached.
inline steady::LevelRow solved(steady::Scene scene, double residual) {
  scene.solver.tolerance = residual;
  const steady::Solution solution = steady::solve(scene);
  if (!solution.converged) throw std::runtime_error(solution.failed_check);
  return solution.levels.back();
}

struct Film {
  double Hc = 0.0;
  double Hm = 0.0;
};

/// Second-order extrapolation from two grids with any ratio of cells; Hm is the fitted minimum.
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

/// A number with its error bar and its true error, both relative to the number.
struct Judged {
  std::string_view name;
  double estimate = 0.0;  ///< of mesh and cycles; NaN: the run gives no estimate
  double error = 0.0;
  bool within() const { return error <= estimate; }
  double ratio() const { return estimate / error; }
};

/// The error bars of a solution and the true errors.
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
