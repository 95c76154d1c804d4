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
    const auto at_columns = columns_at(i, [&](int k) { return k * state.P.stride(); });
    double* out = r.at_x(i);
    for (int j = 1; j <= grid.last_line(); j += static_cast<int>(sizeof(Number) / sizeof(double))) {
      // All fields of a grid have the same stride.
      const auto at = [j](const core::Field& f, std::ptrdiff_t column) {
        return core::load<Number>(f.at_x(0) + column + j);
      };
      const auto columns = [&](auto value) {
        return Columns<Number>{value(at_columns.own), value(at_columns.west), value(at_columns.far_west),
                               value(at_columns.east)};
      };
      const auto cross = [&](const core::Field& along, const core::Field& across) {
        const std::ptrdiff_t own = at_columns.own;
        return Cross<Number>{at(along, at_columns.west), at(along, at_columns.east), at(across, own - 1),
                             at(across, own + 1), at(along, own)};
      };
      const Faces<Number> e =
          faces<Number>(face, cross(state.eps, state.eps_across), at(state.eps_across, at_columns.own), half);
      const auto w = wedge_weights<!plain, Number>(c, transport, grid.hx(), [&] {
        return ThirdOrder<Number>{at(state.third_order, at_columns.west), at(state.third_order, at_columns.own)};
      });
      const Columns<Number> Q = columns([&](std::ptrdiff_t k) { return at(state.rho_bar, k) * at(state.H, k); });
      Number own = residual(w, e, Q, cross(state.P, state.P));
      if (state.f.nodes_x() > 0) own += at(state.f, at_columns.own);
      core::store(out + j, own);
    }
    out[0] = 0.0;
    out[grid.last_line() + 1] = 0.0;
    core::fill_ghosts(grid, out);
  }
}

}  // namespace

void residual(const core::Patch& grid, const Fields& state, const Transport& transport, int threads, core::Field& r) {
  const bool plain = state.face == Face::mean && !third_order(transport.wedge);
  const bool one_line = grid.last_line() == 1;  // a vector would have one line in it
  const auto by = one_line ? (plain ? residual_by<true, double> : residual_by<false, double>)
                           : (plain ? residual_by<true, core::Lanes> : residual_by<false, core::Lanes>);
  by(grid, state, transport, threads, r);
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
