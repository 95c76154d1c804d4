#include "thermal/column.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <utility>

#include "core/errors.hpp"
#include "rheology/elementary.hpp"

namespace ehl::thermal {
namespace {

using core::broadcast;
using core::LaneMask;

std::span<double> flat(Profile& profile, int nodes) {
  return {reinterpret_cast<double*>(profile.data()), static_cast<std::size_t>(nodes * core::lanes)};
}
std::span<double> flat(Lanes& lanes) { return {reinterpret_cast<double*>(&lanes), core::lanes}; }
std::span<const double> flat(const Lanes& lanes) { return {reinterpret_cast<const double*>(&lanes), core::lanes}; }

// What a thinning law makes of the sliding at this I0, and how that changes with ln I0.
void shear(const ColumnLaws& laws, Columns& at) {
  const Lanes I0 = at.I0 * at.fluidity, M2 = at.M2 * at.fluidity;
  Lanes along{}, across{};
  rheology::film_fluidity_slopes(laws.thinning, flat(std::as_const(at.H)), flat(I0), flat(along), flat(across));
  const Lanes x_slope = along - 1.0, y_slope = across - 1.0;  // d ln F'/d ln I0, d ln (F/tau)/d ln I0
  rheology::film_fluidity(laws.thinning, flat(std::as_const(at.H)), flat(I0), flat(along), flat(across));
  at.mobility_x = along / I0;
  at.mobility_y = across / I0;
  const Lanes t_N = laws.sliding / (at.H * I0);
  const Lanes tau = t_N / at.mobility_y;
  const LaneMask limited = tau > at.limit;
  at.tau_m = limited ? at.limit : tau;
  const Lanes tau_slope = limited ? Lanes{} : -1.0 - y_slope;
  const Lanes g_x = -12.0 * at.flow_x / (at.H * M2 * at.mobility_x);
  const Lanes g_y = -12.0 * at.flow_y / (at.H * M2 * at.mobility_y);
  const Lanes both = at.tau_m * at.mobility_x, x_heat = at.mobility_x * g_x * g_x, y_heat = at.mobility_y * g_y * g_y;
  at.a = at.tau_m * t_N;
  at.b = g_x * (t_N + both);
  at.c = x_heat + y_heat;
  at.a_slope = at.a * (tau_slope - 1.0);
  at.b_slope = -x_slope * at.b + g_x * (both * (tau_slope + x_slope) - t_N);
  at.c_slope = -x_slope * x_heat - y_slope * y_heat;
}

void moments(const Nodes& nodes, Columns& at) {
  Lanes zero{}, one{}, two{};
  for (int k = 0; k <= nodes.intervals; ++k) {
    const auto n = static_cast<std::size_t>(k);
    const Lanes part = nodes.simpson[n] * at.phi[n];
    zero += part;
    one += nodes.zeta[n] * part;
    two += (nodes.zeta[n] * nodes.zeta[n]) * part;
  }
  at.I0 = zero;
  at.z_bar = one / zero;
  at.M2 = 12.0 * (two - at.z_bar * one);
}

// phi, moments, stresses, source f and its slope at the node's own temperature.
void sources(const Nodes& nodes, const ColumnLaws& laws, Columns& at) {
  const int count = nodes.intervals + 1;
  rheology::log_viscosity_change(laws.viscosity, flat(at.P_of_node, count), flat(at.log_eta_of_node, count),
                                 flat(at.theta, count), flat(at.D, count), flat(at.dD, count));
  for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) at.phi[k] = rheology::exp(-at.D[k]);
  moments(nodes, at);
  shear(laws, at);
  const Lanes scale = (laws.Br * at.heated) * (at.H * at.H) * at.fluidity;
  for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
    const Lanes s = nodes.zeta[k] - at.z_bar;
    at.f[k] = scale * at.phi[k] * (at.a + s * (at.b + s * at.c));
    at.df[k] = -at.dD[k] * at.f[k];
    if (!at.carries) continue;
    at.f[k] += at.convection.compression[k] * (1.0 + at.theta[k]);
    at.df[k] += at.convection.compression[k];
  }
}

// What the neighbours bring into the layer of node k.
Lanes carried_into(const Nodes& nodes, const Columns& at, std::size_t k) {
  const Convection& by = at.convection;
  Lanes sum = by.carried[k] - by.side[k] * at.theta[k];
  if (k > 0) sum += by.below[k] * (at.theta[k - 1] - at.theta[k]);
  if (k < static_cast<std::size_t>(nodes.intervals)) sum += by.above[k] * (at.theta[k + 1] - at.theta[k]);
  return sum;
}

// H q at a surface: k_bar times the slope of theta there, by the two nodes next to it. f = -k_bar theta''.
Lanes wall_flux(const Nodes& nodes, const Columns& at, std::size_t wall, std::size_t one, std::size_t two) {
  Lanes flux = at.k_bar * (at.theta[one] - at.theta[wall]) / nodes.step +
               (nodes.step / 24.0) * (7.0 * at.f[wall] + 6.0 * at.f[one] - at.f[two]);
  if (at.carries) flux += carried_into(nodes, at, wall);
  return flux;
}

void heat_flow(const Nodes& nodes, Columns& at) {
  const auto n = static_cast<std::size_t>(nodes.intervals);
  at.q_2 = wall_flux(nodes, at, 0, 1, 2) / at.H;
  at.q_1 = wall_flux(nodes, at, n, n - 1, n - 2) / at.H;
  Lanes made{}, brought{};
  for (std::size_t k = 0; k <= n; ++k) {
    made += nodes.heat[k] * at.f[k];
    if (at.carries) brought += carried_into(nodes, at, k);
  }
  at.heat = made / at.H;
  at.carried_off = -brought / at.H;
}

// Numerov's mean of a source over three nodes, times the step.
Lanes mean(const Nodes& nodes, const Profile& f, std::size_t k) {
  return (nodes.step / 12.0) * (f[k - 1] + 10.0 * f[k] + f[k + 1]);
}
Lanes wall_mean(const Nodes& nodes, const Profile& f, std::size_t wall, std::size_t one, std::size_t two) {
  return (nodes.step / 24.0) * (7.0 * f[wall] + 6.0 * f[one] - f[two]);
}

// The row of a surface, theta - given - (self/H) H q = 0; `one` is its neighbour.
void wall_row(const Nodes& nodes, Columns& at, std::size_t wall, std::size_t one, std::size_t two, Lanes given,
              Lanes self, Profile& off_diagonal) {
  const Lanes share = self / at.H;
  const Convection& by = at.convection;
  const Lanes side = at.carries ? by.side[wall] : Lanes{};
  const Lanes inner = at.carries ? (wall == 0 ? by.above[wall] : by.below[wall]) : Lanes{};
  at.diagonal[wall] = 1.0 + share * (at.k_bar / nodes.step - (7.0 * nodes.step / 24.0) * at.df[wall] + side + inner);
  // That of the third node is left to the next step: the row stays tridiagonal.
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

// Gauss without pivoting, four right-hand sides at once.
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

// Solves a system of three by Cramer's rule.
std::array<Lanes, 3> solve_three(const std::array<std::array<Lanes, 3>, 3>& m, const std::array<Lanes, 3>& r) {
  const auto det = [](const auto& p, const auto& q, const auto& s) {
    return p[0] * (q[1] * s[2] - q[2] * s[1]) - p[1] * (q[0] * s[2] - q[2] * s[0]) + p[2] * (q[0] * s[1] - q[1] * s[0]);
  };
  const auto column = [&](std::size_t n) { return std::array<Lanes, 3>{m[0][n], m[1][n], m[2][n]}; };
  const std::array<Lanes, 3> one = column(0), two = column(1), three = column(2);
  const Lanes inverse = 1.0 / det(one, two, three);
  return {det(r, two, three) * inverse, det(one, r, three) * inverse, det(one, two, r) * inverse};
}

// The change of theta into at.right: the tridiagonal solution, and what the changes of I0, M2 and z_bar make of it
// (Sherman, Morrison, Woodbury).
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

// theta += change, cut where the viscosity would change too much at once. out: which columns are done.
LaneMask apply_step(const Nodes& nodes, const ColumnLaws& laws, Columns& at, LaneMask done, double tolerance) {
  constexpr double most_change = 2.0;  // of ln eta: half an order of magnitude per step keeps Nahme = 1e4 on its way
  Lanes largest_D{}, largest{};
  for (std::size_t k = 0; k <= static_cast<std::size_t>(nodes.intervals); ++k) {
    largest = core::max(largest, core::abs(at.right[k]));
    largest_D = core::max(largest_D, core::abs(at.right[k] * at.dD[k]));
  }
  const Lanes cut = largest_D > most_change ? most_change / largest_D : broadcast(1.0);
  LaneMask clipped{};
  for (std::size_t k = 0; k <= static_cast<std::size_t>(nodes.intervals); ++k) {
    const Lanes changed = at.theta[k] + cut * at.right[k];
    const Lanes kept = core::max(broadcast(laws.theta_least), core::min(broadcast(laws.theta_most), changed));
    clipped |= kept != changed;
    at.theta[k] = done ? at.theta[k] : kept;
  }
  at.clipped = done ? at.clipped : clipped;
  return done | (largest <= tolerance);
}

void spread(const Nodes& nodes, Columns& at) {
  for (std::size_t k = 0; k <= static_cast<std::size_t>(nodes.intervals); ++k) {
    at.P_of_node[k] = at.P;
    at.log_eta_of_node[k] = at.log_eta;
  }
}

}  // namespace

Nodes make_nodes(int intervals) {
  if (intervals < 4 || intervals >= most_nodes || intervals % 2 != 0)
    throw core::InputError("nodes across the film: " + std::to_string(intervals + 1) + " must be odd, from 5 to " +
                           std::to_string(most_nodes));
  Nodes nodes{.intervals = intervals, .step = 1.0 / intervals};
  // Numerov's mean over three nodes and the flux at the surface add up to these weights of Gregory.
  constexpr std::array<double, 3> ends{3.0 / 8.0, 7.0 / 6.0, 23.0 / 24.0};
  for (int k = 0; k <= intervals; ++k) {
    const auto n = static_cast<std::size_t>(k);
    const int from_end = std::min(k, intervals - k);
    nodes.zeta[n] = nodes.step * k;
    nodes.simpson[n] = nodes.step / 3.0 * (from_end == 0 ? 1.0 : (k % 2 == 1 ? 4.0 : 2.0));
    nodes.heat[n] = nodes.step;
  }
  for (std::size_t k = 0; k < ends.size(); ++k)
    for (const std::size_t n : {k, static_cast<std::size_t>(intervals) - k})
      nodes.heat[n] += nodes.step * (ends[k] - 1.0);  // five nodes: both ends act on the middle
  return nodes;
}

int solve(const Nodes& nodes, const ColumnLaws& laws, Columns& at, const Steps& steps) {
  spread(nodes, at);
  LaneMask done{};
  int step = 0;
  while (step < steps.most && !core::all(done)) {
    ++step;
    sources(nodes, laws, at);
    linearise(nodes, laws, at);
    newton_step(nodes, at);
    done = apply_step(nodes, laws, at, done, steps.tolerance);
  }
  sources(nodes, laws, at);
  heat_flow(nodes, at);
  return core::all(done) ? step : steps.most + 1;
}

void evaluate(const Nodes& nodes, const ColumnLaws& laws, Columns& at) {
  spread(nodes, at);
  sources(nodes, laws, at);
  heat_flow(nodes, at);
}

}  // namespace ehl::thermal
