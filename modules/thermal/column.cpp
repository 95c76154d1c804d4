#include "thermal/column.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "core/errors.hpp"
#include "rheology/elementary.hpp"
#include "thermal/column_equation.hpp"

namespace ehl::thermal {
namespace {

using core::broadcast;
using core::LaneMask;

std::span<double> flat(Profile& profile, int nodes) {
  return {reinterpret_cast<double*>(profile.data()), static_cast<std::size_t>(nodes * core::lanes)};
}
std::span<double> flat(Lanes& lanes) { return {reinterpret_cast<double*>(&lanes), core::lanes}; }
std::span<const double> flat(const Lanes& lanes) { return {reinterpret_cast<const double*>(&lanes), core::lanes}; }

// Sliding of a shear-thinning oil at the present I0, and its derivatives with respect to ln I0.
void shear(const ColumnLaws& laws, Columns& at) {
  const Lanes I0 = at.I0 * at.fluidity, M2 = at.M2 * at.fluidity;
  Lanes along{}, across{};
  rheology::film_fluidity_slopes(laws.thinning, flat(std::as_const(at.H)), flat(I0), flat(along), flat(across));
  const Lanes x_slope = along - 1.0, y_slope = across - 1.0;  // d ln F'/d ln I0, d ln (F/tau)/d ln I0
  rheology::film_fluidity(laws.thinning, flat(std::as_const(at.H)), flat(I0), flat(along), flat(across));
  const Lanes t_N = std::abs(laws.sliding) / (at.H * I0);
  const Lanes tau = at.less_tau * t_N / (across / I0);
  at.mobility_x = at.more_x * along / I0;
  at.mobility_y = at.more_y * across / I0;
  const LaneMask limited = tau > at.limit;
  at.tau_m = limited ? at.limit : tau;
  at.unlimited = tau;
  const Lanes tau_slope = limited ? Lanes{} : -1.0 - y_slope;
  // tau_m and t_N are magnitudes, so the flow is taken in the direction of sliding.
  const double direction = laws.sliding < 0.0 ? 12.0 : -12.0;
  const Lanes g_x = direction * at.flow_x / (at.H * M2 * at.mobility_x);
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

// D, its slope, and phi at the present temperatures.
void fluidities(const ColumnLaws& laws, int count, Columns& at) {
  rheology::log_viscosity_change(laws.viscosity, flat(at.P_of_node, count), flat(at.log_eta_of_node, count),
                                 flat(at.theta, count), flat(at.D, count), flat(at.dD, count));
  for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) at.phi[k] = rheology::exp(-at.D[k]);
}

// Moments, stresses, source f and its slope, at given phi.
void sheared(const Nodes& nodes, const ColumnLaws& laws, Columns& at) {
  const int count = nodes.intervals + 1;
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

}  // namespace

void spread(const Nodes& nodes, Columns& at) {
  for (std::size_t k = 0; k <= static_cast<std::size_t>(nodes.intervals); ++k) {
    at.P_of_node[k] = at.P;
    at.log_eta_of_node[k] = at.log_eta;
  }
}

void sources(const Nodes& nodes, const ColumnLaws& laws, Columns& at) {
  fluidities(laws, nodes.intervals + 1, at);
  sheared(nodes, laws, at);
}

void follow(const Nodes& nodes, const ColumnLaws& laws, const Profile& change, LaneMask done, Columns& at) {
  const int count = nodes.intervals + 1;
  for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
    const Lanes d = -at.dD[k] * change[k];
    at.phi[k] *= 1.0 + d * (1.0 + d * (0.5 + d * (1.0 / 6.0)));
  }
  if (!core::all(done)) {
    Profile &followed = at.by_I0, &slope = at.by_M2;
    for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
      followed[k] = at.phi[k];
      slope[k] = at.dD[k];
    }
    fluidities(laws, count, at);
    for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
      at.phi[k] = done ? followed[k] : at.phi[k];
      at.dD[k] = done ? slope[k] : at.dD[k];
    }
  }
  sheared(nodes, laws, at);
}

Lanes carried_into(const Nodes& nodes, const Columns& at, std::size_t k) {
  const Convection& by = at.convection;
  Lanes sum = by.carried[k] - by.side[k] * at.theta[k];
  if (k > 0) sum += by.below[k] * (at.theta[k - 1] - at.theta[k]);
  if (k < static_cast<std::size_t>(nodes.intervals)) sum += by.above[k] * (at.theta[k + 1] - at.theta[k]);
  return sum;
}

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

Nodes make_nodes(int intervals) {
  if (intervals < 4 || intervals >= most_nodes || intervals % 2 != 0)
    throw core::InputError("nodes across the film: " + std::to_string(intervals + 1) + " must be odd, from 5 to " +
                           std::to_string(most_nodes));
  Nodes nodes{.intervals = intervals, .step = 1.0 / intervals};
  // Numerov's mean over three nodes and the flux at the surface add up to Gregory's weights.
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
      nodes.heat[n] += nodes.step * (ends[k] - 1.0);  // with five nodes both ends contribute to the middle
  return nodes;
}

void evaluate(const Nodes& nodes, const ColumnLaws& laws, Columns& at) {
  spread(nodes, at);
  sources(nodes, laws, at);
  heat_flow(nodes, at);
}

}  // namespace ehl::thermal
