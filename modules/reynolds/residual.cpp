#include "reynolds/residual.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "reynolds/flux.hpp"

namespace ehl::reynolds {

namespace {

// plain: epsilon at the nodes and no third-order flux, known at compile time.
template <bool plain>
void residual_by(const core::Patch& grid, const Fields& state, const Transport& transport, int threads,
                 core::Field& r) {
  const HalfInverseSquares half(grid.hx(), grid.hy());
  const int last = grid.last_line();
  const Face face = plain ? Face::mean : state.face;
  std::ranges::fill(r.station(0), 0.0);
  std::ranges::fill(r.station(grid.nx), 0.0);
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
  for (int i = 1; i < grid.nx; ++i) {
    const auto c = transport_weights(transport, i, grid.hx());
    const int upstream = std::max(i - 2, 0);
    const double* __restrict P = state.P.at_x(i);
    const double* __restrict P_west = state.P.at_x(i - 1);
    const double* __restrict P_east = state.P.at_x(i + 1);
    const double* __restrict eps = state.eps.at_x(i);
    const double* __restrict eps_west = state.eps.at_x(i - 1);
    const double* __restrict eps_east = state.eps.at_x(i + 1);
    const double* __restrict eps_across = state.eps_across.at_x(i);
    const double* __restrict H0 = state.H.at_x(i);
    const double* __restrict H1 = state.H.at_x(i - 1);
    const double* __restrict H2 = state.H.at_x(upstream);
    const double* __restrict rho0 = state.rho_bar.at_x(i);
    const double* __restrict rho1 = state.rho_bar.at_x(i - 1);
    const double* __restrict rho2 = state.rho_bar.at_x(upstream);
    const double* __restrict H_east = state.H.at_x(i + 1);
    const double* __restrict rho_east = state.rho_bar.at_x(i + 1);
    const double* __restrict theta_west = plain ? nullptr : state.third_order.at_x(i - 1);
    const double* __restrict theta_east = plain ? nullptr : state.third_order.at_x(i);
    double* __restrict out = r.at_x(i);
    for (int j = 1; j <= last; ++j) {
      const Faces<double> e{conductance(face, eps_west[j], eps[j], half.X),
                            conductance(face, eps[j], eps_east[j], half.X),
                            conductance(face, eps_across[j - 1], eps_across[j], half.Y),
                            conductance(face, eps_across[j], eps_across[j + 1], half.Y)};
      double net;
      if constexpr (plain)
        net = transported(c, rho0[j] * H0[j], rho1[j] * H1[j], rho2[j] * H2[j]);
      else
        net = transported(third_order_weights<double>(c, transport, grid.hx(), {theta_west[j], theta_east[j]}),
                          rho0[j] * H0[j], rho1[j] * H1[j], rho2[j] * H2[j], rho_east[j] * H_east[j]);
      out[j] = net - poiseuille(e, P_west[j], P_east[j], P[j - 1], P[j + 1], P[j]);
    }
    if (state.f.nodes_x() > 0) {
      const double* __restrict f = state.f.at_x(i);
      for (int j = 1; j <= last; ++j) out[j] += f[j];
    }
    out[0] = 0.0;
    out[last + 1] = 0.0;
    core::fill_ghosts(grid, out);
  }
}

// The residual of a line contact, from node to node along its one line.
template <bool plain>
void residual_along_line(const core::Patch& grid, const Fields& state, const Transport& transport, core::Field& r) {
  const HalfInverseSquares half(grid.hx(), grid.hy());
  const Face face = plain ? Face::mean : state.face;
  const bool with_f = state.f.nodes_x() > 0;
  const auto Q = [&](int i) { return state.rho_bar(i, 1) * state.H(i, 1); };
  const auto coupling = [&](int i) { return conductance(face, state.eps(i, 1), state.eps(i + 1, 1), half.X); };
  double west = coupling(0);
  double Q2 = Q(0), Q1 = Q(0), Q0 = Q(1);  // the first node has no node i-2
  std::array<double, 3> c{};
  for (int i = 1; i < grid.nx; ++i) {
    if (i <= 2) c = transport_weights(transport, i, grid.hx());
    const Faces<double> e{west, coupling(i), 0.0, 0.0};
    const double Q_east = Q(i + 1);
    double net;
    if constexpr (plain)
      net = transported(c, Q0, Q1, Q2);
    else
      net = transported(
          third_order_weights<double>(c, transport, grid.hx(), {state.third_order(i - 1, 1), state.third_order(i, 1)}),
          Q0, Q1, Q2, Q_east);
    const double P = state.P(i, 1);
    double own = net - poiseuille(e, state.P(i - 1, 1), state.P(i + 1, 1), P, P, P);
    if (with_f) own += state.f(i, 1);
    core::fill_lines(r.at_x(i), own);
    west = e.east;
    Q2 = Q1;
    Q1 = Q0;
    Q0 = Q_east;
  }
  std::ranges::fill(r.station(0), 0.0);
  std::ranges::fill(r.station(grid.nx), 0.0);
}

template <bool plain>
void residual_of(const core::Patch& grid, const Fields& state, const Transport& transport, int threads,
                 core::Field& r) {
  if (grid.domain.line)
    residual_along_line<plain>(grid, state, transport, r);
  else
    residual_by<plain>(grid, state, transport, threads, r);
}

}  // namespace

void residual(const core::Patch& grid, const Fields& state, const Transport& transport, int threads, core::Field& r) {
  if (state.face == Face::mean && !third_order(transport.wedge))
    residual_of<true>(grid, state, transport, threads, r);
  else
    residual_of<false>(grid, state, transport, threads, r);
}

ResidualNorms residual_norms(const core::Patch& grid, const Fields& state, const Transport& transport,
                             Cavitation cavitation, const core::Field& r) {
  ResidualNorms norms;
  double total = 0.0;
  double wedge_total = 0.0;
  double wedge_points = 0.0;
  const auto Q = [&](int i, int j) { return state.rho_bar(i, j) * state.H(i, j); };
  std::array<double, 3> c{};
  for (int i = 1; i < grid.nx; ++i) {
    if (i <= 2) c = transport_weights(transport, i, grid.hx());  // the same from i = 2 on
    const int upstream = std::max(i - 2, 0);
    double sum = 0.0;
    double wedge_sum = 0.0;
    for (int j = 1; j <= grid.last_line(); ++j) {
      const double lines = grid.lines(j);
      const bool cavitated = dry(cavitation, state.P(i, j));
      // In a cavitated point L(P) <= f is allowed: only r < 0 violates. Written so that NaN goes through.
      const double violation = stays_dry(cavitation, state.P(i, j), r(i, j)) ? 0.0 : r(i, j);
      sum += lines * (violation * violation);
      if (!(std::abs(violation) <= norms.largest) && !std::isnan(norms.largest))  // keeps the first NaN
        norms = {0.0, 0.0, std::abs(violation), i, j, norms.largest_dry, norms.least_P};
      if (cavitated) {
        norms.largest_dry = std::max(norms.largest_dry, std::abs(violation));
        norms.least_P = std::min(norms.least_P, state.P(i, j));
        continue;
      }
      const double w = transported(c, Q(i, j), Q(i - 1, j), Q(upstream, j));
      wedge_sum += lines * (w * w);
      wedge_points += lines;
    }
    total += sum;
    wedge_total += wedge_sum;
  }
  const double points = static_cast<double>(grid.nx - 1) * (grid.domain.ny - 1);
  norms.root_mean_square = std::sqrt(total / points);
  norms.wedge = std::sqrt(wedge_total / std::max(wedge_points, 1.0));
  return norms;
}

}  // namespace ehl::reynolds
