#include "effects/friction/friction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/slopes.hpp"
#include "core/timer.hpp"
#include "effects/friction/beyond.hpp"

namespace ehl::friction {
namespace {

/// Share of the load from which stresses that no lubricant carries cause a warning.
constexpr double worth_a_warning = 0.01;

// Weight of a node in the trapezoidal rule, without hx hy.
double weight(const core::Grid& grid, int i, int j) {
  return (i == 0 || i == grid.nx ? 0.5 : 1.0) * (j == 0 || j == grid.ny ? 0.5 : 1.0);
}

// Share of a node's cell that is filled with oil: 1/2 if the contour of the meniscus passes through the node.
double share_of_oil(const Film& film, double meniscus, double X, double Y) {
  if (std::isinf(meniscus)) return 1.0;
  const auto& [XX, XY, YY] = film.gap;
  const double gap = film.gap.at(X, Y), there = XX * meniscus * meniscus;
  const double slope_X = 2.0 * XX * X + XY * Y, slope_Y = XY * X + 2.0 * YY * Y;
  const double width = std::abs(slope_X) * film.grid.hx() + std::abs(slope_Y) * film.grid.hy();
  return std::clamp(0.5 + (there - gap) / std::max(width, 1e-300), 0.0, 1.0);
}

constexpr double infinite = std::numeric_limits<double>::infinity();

// True if the whole domain lies inside the meniscus: the gap is convex.
bool oil_reaches_corners(const Film& film, double meniscus) {
  for (const double X : {film.grid.X_a, film.grid.X_b})
    for (const double Y : {film.grid.Y_a, film.grid.Y_b})
      if (share_of_oil(film, meniscus, 1.01 * X, 1.01 * Y) < 1.0) return false;
  return true;
}

// 1/eta_y, evaluated for a few columns (constant X) at once where these are short, as in a line contact.
class Fluidity {
 public:
  explicit Fluidity(const Film& film)
      : film_(film), nodes_(film.grid.nodes_y()), columns_(std::max(1, least_nodes / nodes_)) {
    for (std::vector<double>* list : {&P_, &H_, &at_rest_, &along_, &across_})
      list->resize(static_cast<std::size_t>(nodes_) * static_cast<std::size_t>(columns_));
  }
  /// Called for the columns in order, each before its values are asked for.
  void go_to_column(int i) {
    if (i % columns_ == 0) evaluate(i);
  }
  double operator()(int i, int j) const {
    const int k = (i % columns_) * nodes_ + j;
    return (film_.thinning ? across_ : at_rest_)[static_cast<std::size_t>(k)];
  }

 private:
  static constexpr int least_nodes = 64;

  void evaluate(int first) {
    for (int i = first; i < std::min(first + columns_, film_.grid.nodes_x()); ++i) {
      const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(i - first) * nodes_;
      std::ranges::copy(film_.P.station(i), P_.begin() + at);
      std::ranges::copy(film_.H.station(i), H_.begin() + at);
    }
    rheology::fluidity(film_.viscosity, P_, at_rest_);
    if (film_.I0)
      for (std::size_t k = 0; k < at_rest_.size(); ++k) {
        const int i = first + static_cast<int>(k) / nodes_;
        if (i <= film_.grid.nx) at_rest_[k] *= (*film_.I0)(i, static_cast<int>(k) % nodes_);
      }
    if (film_.thinning) rheology::film_fluidity(*film_.thinning, H_, at_rest_, along_, across_);
  }

  const Film& film_;
  int nodes_, columns_;
  std::vector<double> P_{}, H_{}, at_rest_{}, along_{}, across_{};
};

// Integral of -(h/2) dp/dy, in p_h times cells.
double side_force(const Film& film, double slope) {
  const core::Grid& grid = film.grid;
  double sum = 0.0;
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = 0; j < grid.ny; ++j)
      sum -= (i == 0 || i == grid.nx ? 0.5 : 1.0) * 0.25 * slope * (film.H(i, j) + film.H(i, j + 1)) *
             (film.P(i, j + 1) - film.P(i, j)) / grid.hy();
  return sum;
}

}  // namespace

Friction friction_of(const Film& film, const Parameters& parameters) {
  const double began = core::now();
  const core::Grid& grid = film.grid;
  const double meniscus = oil_reaches_corners(film, parameters.meniscus) ? infinite : parameters.meniscus;
  Friction result{.parameters = parameters,
                  .thinned = film.thinning.has_value(),
                  .line = grid.line,
                  .counts_outside = film.outside != nullptr};
  if (parameters.keep_tau1) result.tau1 = core::Field(grid);
  if (parameters.keep_tau2) result.tau2 = core::Field(grid);
  const auto nodes = static_cast<std::size_t>(grid.nodes_y());
  Fluidity fluidity(film);
  std::vector<double> film_at_end(nodes, 0.0);
  double load_inside = 0.0, limited_load = 0.0, unlikely_load = 0.0;
  for (int i = 0; i <= grid.nx; ++i) {
    fluidity.go_to_column(i);
    for (int j = 0; j <= grid.ny; ++j) {
      const double P = film.P(i, j), H = film.H(i, j), w = weight(grid, i, j);
      const bool wet = P > 0.0;
      double& end = film_at_end[static_cast<std::size_t>(j)];
      if (wet) end = H;
      const double oil = share_of_oil(film, meniscus, grid.X(i), grid.Y(j));
      const bool only_layers = film.starved && end == 0.0 && parameters.cavitated != Cavitated::full;
      const double share = wet ? 1.0 : only_layers ? 0.0 : filled(parameters.cavitated, H, end);
      double tau = share > 0.0 && parameters.stress != 0.0 ? parameters.stress / (H * fluidity(i, j)) : 0.0;
      if (wet && film.less_tau) tau *= (*film.less_tau)(i, j);
      if (wet) {
        load_inside += w * P;
        if (std::abs(tau) > largest_limit * P) unlikely_load += w * P;
        if (std::abs(tau) > parameters.limit * P) limited_load += w * P;
        tau = rheology::limited(tau, parameters.limit * P);
        result.largest_stress = std::max(result.largest_stress, std::abs(tau));
      } else {
        tau *= share;
        result.cavitated += w * oil * tau;
      }
      tau *= oil;
      if (film.P_c && parameters.stress != 0.0) {
        const double rubbed = std::copysign(parameters.boundary, parameters.stress) * (*film.P_c)(i, j);
        result.boundary += w * rubbed;
        tau += rubbed;
      }
      result.sliding += w * tau;
      const double rolling =
          oil * 0.5 * parameters.slope * H * core::slope_X(film.P, film.grid.nx, film.grid.hx(), i, j);
      if (parameters.keep_tau1) result.tau1(i, j) = -tau - rolling;
      if (parameters.keep_tau2) result.tau2(i, j) = tau - rolling;
      if (i < grid.nx) {
        const double part = share_of_oil(film, meniscus, grid.X(i) + 0.5 * grid.hx(), grid.Y(j)) * w /
                            (i == 0 ? 0.5 : 1.0) * 0.25 * parameters.slope * (H + film.H(i + 1, j)) *
                            (film.P(i + 1, j) - P) / grid.hx();
        result.rolling += part;
        if (grid.X(i) < parameters.outer_X) result.outer += part;
      }
    }
  }
  if (parameters.oblique) result.side = side_force(film, parameters.slope);
  // For a line contact each of the grid's lines counts as the whole contact, so the sums are divided by ny.
  const double nodes_per_area = grid.line ? grid.ny / grid.hx() : 1.0 / (grid.hx() * grid.hy());
  if (film.outside) {
    const Beyond outside = beyond(film, parameters, film_at_end);
    result.beyond = outside.sliding * nodes_per_area;
    result.rolling_beyond = outside.rolling * nodes_per_area;
    result.sliding += result.beyond;
    result.rolling += result.rolling_beyond;
    result.cavitated += outside.cavitated * nodes_per_area;
  }
  const double load = std::isnan(film.load) ? load_inside : film.load * nodes_per_area;
  for (double* part : {&result.sliding, &result.rolling, &result.boundary, &result.cavitated, &result.beyond,
                       &result.rolling_beyond, &result.outer, &result.side, &limited_load, &unlikely_load})
    *part /= load;
  result.limited_share = limited_load;
  result.unlikely_share = unlikely_load;
  result.on_1 = -(result.sliding + result.rolling);
  result.on_2 = result.sliding - result.rolling;
  result.seconds = core::now() - began;
  return result;
}

bool exceeds_any_oil(const Friction& friction) { return friction.unlikely_share >= worth_a_warning; }

bool unlikely(const Friction& friction) {
  return exceeds_any_oil(friction) && friction.parameters.limit > largest_limit;
}

core::Warnings warnings(const Friction& friction) {
  if (!unlikely(friction)) return {};
  return {{"shear-stress",
           fmt::format(
               "friction: on {:.0f} % of the load the shear stress exceeds {:.2f} p, which no lubricant carries: {}",
               100.0 * friction.unlikely_share, largest_limit,
               friction.thinned
                   ? "check the shear law, or give [friction] limit"
                   : "a Newtonian oil does not describe this friction; give [shear] law, or [friction] limit")}};
}

}  // namespace ehl::friction
