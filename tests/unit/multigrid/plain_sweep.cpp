#include "unit/multigrid/plain_sweep.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "reynolds/flux.hpp"

namespace ehl::tests {
namespace {

using core::Field;
using core::Patch;

/// epsilon/h^2 at the half points around a node.
struct Around {
  double west, east, south, north;
};

class Sweep {
 public:
  Sweep(const multigrid::Problem& problem, const multigrid::RelaxationParameters& parameters,
        const multigrid::Level& level)
      : problem_(problem),
        parameters_(parameters),
        level_(level),
        grid_(level.grid),
        delta_(level.grid),
        distributed_(level.grid) {
    result_.P = level.P;
  }

  PlainSweep run() {
    for (const int first : {1, 2}) {
      delta_.fill(0.0);
      distributed_.fill(0.0);
      for (int j = first; j < grid_.ny; j += 2) solve_line(j);
      apply();
    }
    return result_;
  }

 private:
  Around around(int i, int j) const {
    const Field& eps = level_.eps;
    const double x = 2.0 * grid_.hx() * grid_.hx();
    const double y = 2.0 * grid_.hy() * grid_.hy();
    return {(eps(i - 1, j) + eps(i, j)) / x, (eps(i + 1, j) + eps(i, j)) / x, (eps(i, j - 1) + eps(i, j)) / y,
            (eps(i, j + 1) + eps(i, j)) / y};
  }

  bool beside_cavitation(int i, int j) const {
    const Field& P = result_.P;
    return P(i, j) <= 0.0 || P(i - 1, j) <= 0.0 || P(i + 1, j) <= 0.0 || P(i, j - 1) <= 0.0 || P(i, j + 1) <= 0.0;
  }

  bool is_distributive(int i, int j) const {
    return !(ehl::reynolds::ruptures(problem_.cavitation) && beside_cavitation(i, j)) && !single_by_epsilon(i, j);
  }

  /// hx/hy for cells at least sqrt(2) times as long as wide, else 1.
  double stretch() const {
    const double ratio = grid_.hx() / grid_.hy();
    return ratio > 1.41 ? ratio : 1.0;
  }
  /// The shares that a distributed change takes from a neighbour along X and from one along Y, in proportion to 1/h^2.
  double along() const { return 0.5 / (1.0 + stretch() * stretch()); }
  double across() const { return 0.5 - along(); }
  /// epsilon/(hx hy) on stretched cells.
  Around scaled(const Around& e) const {
    const double s = stretch();
    return {e.west * s, e.east * s, e.south / s, e.north / s};
  }

  bool single_by_epsilon(int i, int j) const {
    const Around e = scaled(around(i, j));
    const double most = std::max({e.west, e.east, e.south, e.north});
    const double least = std::min({e.west, e.east, e.south, e.north});
    const double jump = most / least;
    return most * (stretch() > 1.0 ? jump : std::sqrt(jump)) >
           parameters_.crossover * ehl::reynolds::relative_strength(problem_.transport, grid_.hx());
  }

  /// U dg/dX + c g at i, from g at i, i-1, i-2.
  template <class Function>
  double transported(Function g, int i) const {
    const ehl::reynolds::Transport& transport = problem_.transport;
    const bool second = transport.wedge == ehl::reynolds::Wedge::upstream2 && i >= 2;
    const double slope = second ? 1.5 * g(i) - 2.0 * g(i - 1) + 0.5 * g(i - 2) : g(i) - g(i - 1);
    return transport.speed * slope / grid_.hx() + transport.squeeze * g(i);
  }

  double residual(int i, int j) const {
    const Field& P = result_.P;
    const Around e = around(i, j);
    const double poiseuille = e.west * (P(i - 1, j) - P(i, j)) + e.east * (P(i + 1, j) - P(i, j)) +
                              e.south * (P(i, j - 1) - P(i, j)) + e.north * (P(i, j + 1) - P(i, j));
    const double wedge = transported([&](int k) { return level_.rho_bar(k, j) * level_.H(k, j); }, i);
    const double f = level_.f.nodes_x() > 0 ? level_.f(i, j) : 0.0;  // the finest level has no right-hand side
    return f - poiseuille + wedge;
  }

  /// The change of the left-hand side at (i,j) for delta = 1 at (k,j). The line ignores the boundary: a distributed
  /// change counts as applied there, too.
  double influence(int i, int k, int j, bool distributive) const {
    const auto pressure = [&](int m) { return m == k ? 1.0 : distributive && std::abs(m - k) == 1 ? -along() : 0.0; };
    const double beside = distributive && i == k ? -across() : 0.0;  // on the lines j-1 and j+1
    const auto film = [&](int m) {
      const auto distance = static_cast<std::size_t>(std::abs(m - k));
      if (std::abs(m - k) > parameters_.reach) return 0.0;
      return distributive ? level_.film_terms.delta_K[distance] : level_.film_terms.K[distance];
    };
    const auto flow = [&](int m) {  // change of rho_bar H
      return level_.rho_bar(m, j) * film(m) + level_.drho_bar(m, j) * pressure(m) * level_.H(m, j);
    };
    const Around e = around(i, j);
    return e.west * (pressure(i - 1) - pressure(i)) + e.east * (pressure(i + 1) - pressure(i)) +
           (e.south + e.north) * (beside - pressure(i)) - transported(flow, i);
  }

  /// The film that the Gauss-Seidel changes around a point displace, per change of the point itself.
  double far_squeeze(int i, int j) const {
    if (is_distributive(i, j)) return 0.0;
    const double film = single_by_epsilon(i, j) ? parameters_.far_squeeze * multigrid::film_response(level_, 0)
                                                : parameters_.far_squeeze_beside;
    return film * problem_.transport.squeeze * level_.rho_bar(i, j);
  }

  double weight(int i, int j, bool distributive) const {
    if (distributive) return parameters_.weight_distributed;
    const Around e = scaled(around(i, j));
    const double low = std::min({e.west, e.east, e.south, e.north});
    const double high = std::max({e.west, e.east, e.south, e.north});
    const double smooth = high > 0.0 ? std::min(1.0, 2.0 * low / high) : 1.0;
    return parameters_.weight_single_steep + (parameters_.weight_single - parameters_.weight_single_steep) * smooth;
  }

  void solve_line(int j) {
    const int points = grid_.nx - 1;
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(points, points);
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(points);
    std::vector<int> held;
    std::vector<bool> distributive(static_cast<std::size_t>(grid_.nx));
    for (int i = 1; i <= points; ++i) distributive[static_cast<std::size_t>(i)] = is_distributive(i, j);
    for (int i = 1; i <= points; ++i) {
      const double r = residual(i, j);
      if (ehl::reynolds::ruptures(problem_.cavitation) && result_.P(i, j) <= 0.0 && r >= 0.0) {
        A(i - 1, i - 1) = 1.0;
        held.push_back(i);
        continue;
      }
      ++(distributive[static_cast<std::size_t>(i)] ? result_.distributive : result_.single);
      for (int k = 1; k <= points; ++k) A(i - 1, k - 1) = influence(i, k, j, distributive[static_cast<std::size_t>(k)]);
      A(i - 1, i - 1) -= far_squeeze(i, j);
      rhs(i - 1) = r;
    }
    result_.held += static_cast<int>(held.size());
    Eigen::VectorXd x = A.partialPivLu().solve(rhs);
    for (const int i : held) x(i - 1) = 0.0;  // exactly, so that rounding does not turn them into points with pressure
    for (int i = 1; i <= points; ++i) {
      const bool distributes = distributive[static_cast<std::size_t>(i)];
      const double change = weight(i, j, distributes) * x(i - 1);
      delta_(i, j) = std::clamp(change, -parameters_.most_change, parameters_.most_change);
      result_.bounded += delta_(i, j) != change ? 1 : 0;
      if (distributes && ehl::reynolds::ruptures(problem_.cavitation) && problem_.transport.squeeze > 0.0 &&
          delta_(i, j) < -result_.P(i, j)) {
        delta_(i, j) = -result_.P(i, j);  // no more than the present pressure
        ++result_.withheld;
      }
      distributed_(i, j) = distributes ? delta_(i, j) : 0.0;
    }
  }

  /// Eq. (15), for all nodes at once.
  void apply() {
    for (int i = 1; i < grid_.nx; ++i)
      for (int j = 1; j < grid_.ny; ++j) {
        double P = result_.P(i, j) + delta_(i, j) - along() * (distributed_(i - 1, j) + distributed_(i + 1, j)) -
                   across() * (distributed_(i, j - 1) + distributed_(i, j + 1));
        if (ehl::reynolds::ruptures(problem_.cavitation) && P < 0.0) {
          P = 0.0;
          ++result_.clipped;
        }
        result_.P(i, j) = P;
      }
  }

  const multigrid::Problem& problem_;
  const multigrid::RelaxationParameters& parameters_;
  const multigrid::Level& level_;
  const Patch& grid_;
  Field delta_;
  Field distributed_;
  PlainSweep result_;
};

}  // namespace

PlainSweep plain_sweep(const multigrid::Problem& problem, const multigrid::RelaxationParameters& parameters,
                       const multigrid::Level& level) {
  return Sweep(problem, parameters, level).run();
}

}  // namespace ehl::tests
