#include "reynolds/content.hpp"

#include <algorithm>

#include "core/store_lines.hpp"

namespace ehl::reynolds {
namespace {

using core::Lanes;

// The lines j, j+1, .. of a batch.
template <bool held>
void march_batch(const core::Patch& grid, const Fields& state, const Content& content, const Transport& transport,
                 const std::array<double, core::lanes>& supply, int j, core::Field& r) {
  const HalfInverseSquares half(grid);
  const auto at = [j](const core::Field& field, int i) { return core::load(field.at_x(i) + j); };
  const auto full_at = [&](int i) { return at(state.rho_bar, i) * at(state.H, i); };
  const auto theta_at = [&](int i) {
    return third_order(transport.wedge) && i > 0 ? at(state.third_order, i) : Lanes{};
  };
  Lanes full = full_at(0);
  const Lanes first = core::min(full, core::load(supply.data()));
  core::store_lines(grid, content.Q, 0, j, first);
  March<Lanes> march(transport, grid.hx(), first, full);
  full = full_at(1);
  Lanes P_west = at(state.P, 0);
  Lanes P = at(state.P, 1);
  for (int i = 1; i < grid.nx; ++i) {
    const Lanes P_east = at(state.P, i + 1);
    const Lanes east = full_at(i + 1);
    const auto beside = [&](const core::Field& field, int line) { return core::load(field.at_x(i) + line); };
    const Faces<Lanes> e = faces<Lanes>(state.face,
                                        {at(state.eps, i - 1), at(state.eps, i + 1), beside(state.eps_across, j - 1),
                                         beside(state.eps_across, j + 1), at(state.eps, i)},
                                        at(state.eps_across, i), half);
    Lanes inflow = poiseuille(e, {P_west, P_east, beside(state.P, j - 1), beside(state.P, j + 1), P});
    if (state.f.nodes_x() > 0) inflow -= at(state.f, i);
    Lanes out = march.residual(full, east, {theta_at(i - 1), theta_at(i)}, inflow);
    const auto chatters = (state.chatters != nullptr ? at(*state.chatters, i) : Lanes{}) > 0.0;
    if constexpr (held)
      out = march.go_on_with(full, at(content.Q, i), out, chatters);
    else
      march.go_on(full, P <= 0.0, out, chatters);
    core::store_lines(grid, r, i, j, out);
    core::store_lines(grid, content.Q, i, j, march.Q());
    P_west = P;
    P = P_east;
    full = east;
  }
  core::store_lines(grid, content.Q, grid.nx, j, core::min(march.Q(), full));
}

template <bool held>
void march_all(const core::Patch& grid, const Fields& state, const Content& content, const Transport& transport,
               int threads, core::Field& r) {
  const int last = grid.last_line();
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
  for (int j = 1; j <= last; j += core::lanes) {
    std::array<double, core::lanes> supply{};
    for (int k = 0; k < core::lanes; ++k)
      supply[static_cast<std::size_t>(k)] = content.supply[static_cast<std::size_t>(std::min(j + k, grid.ny))];
    march_batch<held>(grid, state, content, transport, supply, j, r);
  }
  std::ranges::fill(r.station(0), 0.0);
  std::ranges::fill(r.station(grid.nx), 0.0);
  const auto edge_line = [&](int i, int j, double supply) {
    r(i, j) = 0.0;
    content.Q(i, j) = std::min(state.rho_bar(i, j) * state.H(i, j), supply);
  };
  for (int i = 0; i <= grid.nx; ++i) {
    edge_line(i, 0, content.supply.front());
    if (last < grid.ny) edge_line(i, grid.ny, content.supply.back());
    core::fill_ghosts(grid, r.at_x(i));
    core::fill_ghosts(grid, content.Q.at_x(i));
  }
}

}  // namespace

void residual(const core::Patch& grid, const Fields& state, const Content& content, const Transport& transport,
              int threads, core::Field& r) {
  march_all<false>(grid, state, content, transport, threads, r);
}

void residual_of_content(const core::Patch& grid, const Fields& state, const Content& content,
                         const Transport& transport, int threads, core::Field& r) {
  march_all<true>(grid, state, content, transport, threads, r);
}

}  // namespace ehl::reynolds
