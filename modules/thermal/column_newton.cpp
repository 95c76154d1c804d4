// Newton's method for a batch of columns.
#include <algorithm>

#include "rheology/elementary.hpp"
#include "thermal/column_equation.hpp"

namespace ehl::thermal {
namespace {

using core::broadcast;
using core::LaneMask;

// Numerov's mean of a source over three nodes, times the step.
Lanes mean(const Nodes& nodes, const Profile& f, std::size_t k) {
  return (nodes.step / 12.0) * (f[k - 1] + 10.0 * f[k] + f[k + 1]);
}
Lanes wall_mean(const Nodes& nodes, const Profile& f, std::size_t wall, std::size_t one, std::size_t two) {
  return (nodes.step / 24.0) * (7.0 * f[wall] + 6.0 * f[one] - f[two]);
}

// Row of a surface, theta - given - (self/H) H q = 0; `one` is its neighbour.
void wall_row(const Nodes& nodes, Columns& at, std::size_t wall, std::size_t one, std::size_t two, Lanes given,
              Lanes self, Profile& off_diagonal) {
  const Lanes share = self / at.H;
  const Convection& by = at.convection;
  const Lanes side = at.carries ? by.side[wall] : Lanes{};
  const Lanes inner = at.carries ? (wall == 0 ? by.above[wall] : by.below[wall]) : Lanes{};
  at.diagonal[wall] = 1.0 + share * (at.k_bar / nodes.step - (7.0 * nodes.step / 24.0) * at.df[wall] + side + inner);
  // The derivative with respect to the third node is neglected, so that the row stays tridiagonal.
  off_diagonal[wall] = -share * (at.k_bar / nodes.step + (6.0 * nodes.step / 24.0) * at.df[one] + inner);
  at.right[wall] = given + share * wall_flux(nodes, at, wall, one, two) - at.theta[wall];
  at.by_I0[wall] = -share * wall_mean(nodes, at.f_I0, wall, one, two);
  at.by_M2[wall] = -share * wall_mean(nodes, at.f_M2, wall, one, two);
  at.by_z[wall] = -share * wall_mean(nodes, at.f_z, wall, one, two);
}

void linearise(const Nodes& nodes, const ColumnLaws& laws, Columns& at) {
  const auto n = static_cast<std::size_t>(nodes.intervals);
  const Lanes scale = (laws.Br * at.heated) * (at.H * at.H) * at.fluidity;
  const Lanes by_I0 = scale / at.I0, by_M2 = -scale / at.M2;
  for (std::size_t k = 0; k <= n; ++k) {
    const Lanes s = nodes.zeta[k] - at.z_bar;
    at.f_I0[k] = by_I0 * at.phi[k] * (at.a_slope + s * (at.b_slope + s * at.c_slope));
    at.f_M2[k] = by_M2 * at.phi[k] * s * (at.b + 2.0 * s * at.c);
    at.f_z[k] = -scale * at.phi[k] * (at.b + 2.0 * s * at.c);
  }
  const Lanes conduction = at.k_bar / nodes.step;
  for (std::size_t k = 1; k < n; ++k) {
    const double twelfth = nodes.step / 12.0;
    at.lower[k] = conduction + twelfth * at.df[k - 1];
    at.upper[k] = conduction + twelfth * at.df[k + 1];
    at.diagonal[k] = -2.0 * conduction + 10.0 * twelfth * at.df[k];
    at.right[k] = conduction * (2.0 * at.theta[k] - at.theta[k - 1] - at.theta[k + 1]) - mean(nodes, at.f, k);
    at.by_I0[k] = mean(nodes, at.f_I0, k);
    at.by_M2[k] = mean(nodes, at.f_M2, k);
    at.by_z[k] = mean(nodes, at.f_z, k);
    if (!at.carries) continue;
    const Convection& by = at.convection;
    at.lower[k] += by.below[k];
    at.upper[k] += by.above[k];
    at.diagonal[k] -= by.below[k] + by.above[k] + by.side[k];
    at.right[k] -= carried_into(nodes, at, k);
  }
  wall_row(nodes, at, 0, 1, 2, at.given_2, at.self_2, at.upper);
  wall_row(nodes, at, n, n - 1, n - 2, at.given_1, at.self_1, at.lower);
}

// Gaussian elimination without pivoting, for four right-hand sides.
void eliminate(const Nodes& nodes, Columns& at) {
  const auto n = static_cast<std::size_t>(nodes.intervals);
  const std::array sides{&at.right, &at.by_I0, &at.by_M2, &at.by_z};
  for (std::size_t k = 1; k <= n; ++k) {
    const Lanes factor = at.lower[k] / at.diagonal[k - 1];
    at.diagonal[k] -= factor * at.upper[k - 1];
    for (Profile* side : sides) (*side)[k] -= factor * (*side)[k - 1];
  }
  for (std::size_t k = n + 1; k-- > 0;) {
    const Lanes inverse = 1.0 / at.diagonal[k];
    for (Profile* side : sides) {
      if (k < n) (*side)[k] -= at.upper[k] * (*side)[k + 1];
      (*side)[k] *= inverse;
    }
  }
}

// Solves a 3 x 3 system by Cramer's rule.
std::array<Lanes, 3> solve_three(const std::array<std::array<Lanes, 3>, 3>& m, const std::array<Lanes, 3>& r) {
  const auto det = [](const auto& p, const auto& q, const auto& s) {
    return p[0] * (q[1] * s[2] - q[2] * s[1]) - p[1] * (q[0] * s[2] - q[2] * s[0]) + p[2] * (q[0] * s[1] - q[1] * s[0]);
  };
  const auto column = [&](std::size_t n) { return std::array<Lanes, 3>{m[0][n], m[1][n], m[2][n]}; };
  const std::array<Lanes, 3> one = column(0), two = column(1), three = column(2);
  const Lanes inverse = 1.0 / det(one, two, three);
  return {det(r, two, three) * inverse, det(one, r, three) * inverse, det(one, two, r) * inverse};
}

// Writes the Newton change of theta to at.right: the tridiagonal solution, corrected for the changes of I0, M2 and
// z_bar (Sherman, Morrison, Woodbury).
void newton_step(const Nodes& nodes, Columns& at) {
  eliminate(nodes, at);
  std::array<std::array<Lanes, 3>, 3> matrix{};
  std::array<Lanes, 3> right{};
  for (std::size_t n = 0; n < 3; ++n) matrix[n][n] = broadcast(1.0);
  for (std::size_t k = 0; k <= static_cast<std::size_t>(nodes.intervals); ++k) {
    const Lanes s = nodes.zeta[k] - at.z_bar;
    const Lanes dI0 = -nodes.simpson[k] * at.dD[k] * at.phi[k];
    const std::array<Lanes, 3> slope{dI0, 12.0 * s * s * dI0, s * dI0 / at.I0};
    for (std::size_t n = 0; n < 3; ++n) {
      right[n] += slope[n] * at.right[k];
      matrix[n][0] += slope[n] * at.by_I0[k];
      matrix[n][1] += slope[n] * at.by_M2[k];
      matrix[n][2] += slope[n] * at.by_z[k];
    }
  }
  const std::array<Lanes, 3> change = solve_three(matrix, right);
  for (std::size_t k = 0; k <= static_cast<std::size_t>(nodes.intervals); ++k)
    at.right[k] -= change[0] * at.by_I0[k] + change[1] * at.by_M2[k] + change[2] * at.by_z[k];
}

// Limits the change of theta in at.right where the viscosity would change too much. returns the columns that have
// converged. theta takes the change of the other columns, and after the last step of the batch that of all. A converged
// column waits at the temperatures before its last step and gets the same change again, so its result does not depend
// on the other columns of the batch or on the number of lanes.
LaneMask apply_step(const Nodes& nodes, const ColumnLaws& laws, Columns& at, LaneMask done, const Steps& steps,
                    int step) {
  constexpr double most_change = 2.0;  // of ln eta [bench: thermal_newton_most_change]
  Lanes largest_D{}, largest{};
  for (std::size_t k = 0; k <= static_cast<std::size_t>(nodes.intervals); ++k) {
    largest = core::max(largest, core::abs(at.right[k]));
    largest_D = core::max(largest_D, core::abs(at.right[k] * at.dD[k]));
  }
  const Lanes cut = largest_D > most_change ? most_change / largest_D : broadcast(1.0);
  done |= largest <= steps.tolerance;
  const LaneMask waits = step == steps.most || core::all(done) ? LaneMask{} : done;
  LaneMask clipped{};
  for (std::size_t k = 0; k <= static_cast<std::size_t>(nodes.intervals); ++k) {
    const Lanes changed = at.theta[k] + cut * at.right[k];
    const Lanes kept = core::max(broadcast(laws.theta_least), core::min(broadcast(laws.theta_most), changed));
    clipped |= kept != changed;
    at.right[k] = kept - at.theta[k];
    at.theta[k] += waits ? Lanes{} : at.right[k];
  }
  at.clipped = clipped;
  return done;
}

}  // namespace

int solve(const Nodes& nodes, const ColumnLaws& laws, Columns& at, const Steps& steps) {
  spread(nodes, at);
  LaneMask done{};
  int step = 0;
  while (step < steps.most && !core::all(done)) {
    ++step;
    sources(nodes, laws, at);
    linearise(nodes, laws, at);
    newton_step(nodes, at);
    done = apply_step(nodes, laws, at, done, steps, step);
  }
  follow(nodes, laws, at.right, done, at);
  heat_flow(nodes, at);
  return core::all(done) ? step : steps.most + 1;
}

}  // namespace ehl::thermal
