#include "reynolds/residual.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/simd.hpp"
#include "reynolds/row.hpp"

namespace ehl::reynolds {
namespace {

// plain: epsilon at the nodes and no third-order flux, known at compile time. Number: the lines that are taken
// together.
template <bool plain, class Number>
void residual_by(const core::Patch& grid, const Fields& state, const Transport& transport, int threads,
                 core::Field& r) {
  const HalfInverseSquares half(grid);
  const Face face = plain ? Face::mean : state.face;
  const WedgeWeights first = transport_weights(transport, 1, grid.hx()),
                     inner = transport_weights(transport, 2, grid.hx());
  std::ranges::fill(r.station(0), 0.0);
  std::ranges::fill(r.station(grid.nx), 0.0);
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
  for (int i = 1; i < grid.nx; ++i) {
    const WedgeWeights& c = i == 1 ? first : inner;
    const auto columns = [i](const core::Field& f) { return columns_at(i, [&f](int k) { return f.at_x(k); }); };
    const auto P = columns(state.P), H = columns(state.H), rho_bar = columns(state.rho_bar), eps = columns(state.eps);
    const double* eps_across = state.eps_across.at_x(i);
    const double* theta_west = plain ? nullptr : state.third_order.at_x(i - 1);
    const double* theta_east = plain ? nullptr : state.third_order.at_x(i);
    const double* f = state.f.nodes_x() > 0 ? state.f.at_x(i) : nullptr;
    double* out = r.at_x(i);
    for (int j = 1; j <= grid.last_line(); j += static_cast<int>(sizeof(Number) / sizeof(double))) {
      const auto at = [j](const double* column) { return core::load<Number>(column + j); };
      const auto Q = [&](const double* rho, const double* film) { return at(rho) * at(film); };
      const Columns<Number> around{Q(rho_bar.own, H.own), Q(rho_bar.west, H.west), Q(rho_bar.far_west, H.far_west),
                                   Q(rho_bar.east, H.east)};
      const Faces<Number> e =
          faces<Number>(face, {at(eps.west), at(eps.east), at(eps_across - 1), at(eps_across + 1), at(eps.own)},
                        at(eps_across), half);
      const Cross<Number> pressures{at(P.west), at(P.east), at(P.own - 1), at(P.own + 1), at(P.own)};
      const auto w = wedge_weights<!plain, Number>(c, transport, grid.hx(), [&] {
        return ThirdOrder<Number>{at(theta_west), at(theta_east)};
      });
      Number own = residual(w, e, around, pressures);
      if (f != nullptr) own += at(f);
      core::store(out + j, own);
    }
    out[0] = 0.0;
    out[grid.last_line() + 1] = 0.0;
    core::fill_ghosts(grid, out);
  }
}

template <bool plain>
void residual_of(const core::Patch& grid, const Fields& state, const Transport& transport, int threads,
                 core::Field& r) {
  if (grid.last_line() == 1)  // a vector would have one line in it
    residual_by<plain, double>(grid, state, transport, threads, r);
  else
    residual_by<plain, core::Lanes>(grid, state, transport, threads, r);
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
  const NodeRows rows(grid, state, transport);
  for (int i = 1; i < grid.nx; ++i) {
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
      const double w = transported(rows.wedge(i), rows.Q(i, j));
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
