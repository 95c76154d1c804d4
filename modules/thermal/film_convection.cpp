// Convection of heat from column to column and from layer to layer.
#include <algorithm>

#include "thermal/film_columns.hpp"

namespace ehl::thermal {
namespace {

using core::broadcast;

// Decay of the temperature of oil that leaves a line contact's domain against the entrainment and returns. Heat is
// generated upstream as X^-2 and carried by a recirculating flow that grows as X^2, so the temperature decays as X^-3
// far away and as X^-1 to X^-2 near the contact. [bench: thermal_falls_upstream_as]
constexpr double falls_upstream_as = 2.0;

// v[1], v[2], .., after[0].
Lanes moved_down(Lanes v, Lanes after) {
  return core::shuffled(v, after, [](int k) { return k + 1; });
}

Lanes positive(Lanes a) { return core::max(a, Lanes{}); }

}  // namespace

// Values on the preceding lines (smaller Y).
Lanes FilmColumns::south(const std::vector<double>& f, int batch, int i, int k, Lanes outside) const {
  const Lanes own = core::load(&f[index(batch, i, k)]);
  return core::moved_up(batch > 0 ? broadcast(f[index(batch - 1, i, k) + core::lanes - 1]) : outside, own);
}

// Values on the following lines (larger Y); beyond the last one `mirrored` times the mirror image, or `outside`.
Lanes FilmColumns::north(const std::vector<double>& f, int batch, int i, int k, double mirrored, Lanes outside) const {
  const core::Patch& patch = setup_.patch;
  const Lanes own = core::load(&f[index(batch, i, k)]);
  Lanes next = moved_down(own, batch + 1 < batches_ ? broadcast(f[index(batch + 1, i, k)]) : own);
  const int last = patch.ny - batch * core::lanes;
  if (last < core::lanes)
    next[last] = patch.north == core::Edge::mirror ? mirrored * value(f, i, patch.ny - 1, k) : outside[last];
  return next;
}

// Share of the oil entering at the first node of a line contact that has the supply temperature. If oil flows back
// there, the rest is as warm as the node, less the decay over one cell, because the throughflow has mixed with
// recirculating oil for long. [bench: thermal_fresh_share]
Lanes FilmColumns::fresh_share(int batch) const {
  const core::Patch& patch = setup_.patch;
  Lanes out{};
  for (int k = 0; k <= nodes_.intervals; ++k) out += positive(-core::load(&flow_x_[index(batch, 0, k)]));
  const double falls = patch.domain.X_a < 0.0 ? falls_upstream_as * patch.hx() / -patch.domain.X_a : 1.0;
  return out > 0.0 ? broadcast(std::min(1.0, falls)) : broadcast(1.0);
}

// Upwind finite volumes around the nodes of the columns: inflow carries the temperature of its origin. The flow between
// two layers follows from continuity; the defect of the columns' own flows is spread over the film.
void FilmColumns::carry(int batch, int i, bool downstream, Worker& worker) const {
  const int j = batch * core::lanes;
  Columns& at = worker.at;
  at.carries = setup_.Pe > 0.0 || setup_.compression > 0.0;
  if (!at.carries) return;
  const core::Patch& patch = setup_.patch;
  const auto n = static_cast<std::size_t>(nodes_.intervals);
  Lanes rho_c{};
  const auto lane_span = [](const Lanes& v) { return std::span(reinterpret_cast<const double*>(&v), core::lanes); };
  rheology::heat_capacity(setup_.heat, lane_span(at.P), lane_span(at.theta[n / 2]),
                          {reinterpret_cast<double*>(&rho_c), core::lanes});
  const Lanes scale = setup_.Pe * at.H * rho_c / core::load(rho_bar_.at_x(i) + j);
  worker.capacity = setup_.Pe * at.H * at.H * rho_c * core::load(oil_.at_x(i) + j);
  const double hx = 1.0 / patch.hx(), hy = 1.0 / patch.domain.between_lines();
  const int west_i = std::max(i - 1, 0), east_i = std::min(i + 1, patch.nx);
  const std::vector<double>& from_west = downstream ? theta_ : before_;
  const std::vector<double>& from_east = downstream ? before_ : theta_;
  Convection& by = at.convection;
  const Lanes oil = broadcast(setup_.theta_oil);
  const Lanes fresh = patch.domain.line && i == 0 ? fresh_share(batch) : broadcast(1.0);
  Lanes defect{};
  for (std::size_t k = 0; k <= n; ++k) {
    const int node = static_cast<int>(k);
    const auto flow_at = [&](int station) { return core::load(&flow_x_[index(batch, station, node)]); };
    const Lanes own = flow_at(i);
    const Lanes west = (0.5 * hx) * (flow_at(west_i) + own), east = (0.5 * hx) * (own + flow_at(east_i));
    const Lanes theta_west = i > 0 ? core::load(&from_west[index(batch, west_i, node)]) : oil;
    const Lanes theta_east = i < patch.nx ? core::load(&from_east[index(batch, east_i, node)]) : oil;
    const Lanes in_west = positive(west), in_east = positive(-east);
    Lanes in = fresh * in_west + in_east, brought = fresh * in_west * theta_west + in_east * theta_east,
          leaves = east - west;
    if (hy > 0.0) {
      const Lanes own_across = core::load(&flow_y_[index(batch, i, node)]);
      const Lanes to_south = (0.5 * hy) * (south(flow_y_, batch, i, node, own_across) + own_across);
      const Lanes to_north = (0.5 * hy) * (own_across + north(flow_y_, batch, i, node, -1.0, own_across));
      const Lanes in_south = positive(to_south), in_north = positive(-to_north);
      in = in + in_south + in_north;
      brought = brought + in_south * south(before_, batch, i, node, oil) +
                in_north * north(before_, batch, i, node, 1.0, oil);
      leaves = leaves + to_north - to_south;
    }
    by.side[k] = scale * in;
    by.carried[k] = scale * brought;
    by.below[k] = leaves;  // outflow of the layer, for the flow between layers
    by.compression[k] = Lanes{};
    defect += by.below[k];
  }
  Lanes up{};
  for (std::size_t k = 0; k <= n; ++k) {
    const Lanes from_below = up;
    up += defect * (k == 0 || k == n ? 0.5 * nodes_.step : nodes_.step) - by.below[k];
    by.below[k] = scale * positive(from_below);
    by.above[k] = scale * positive(-up);
  }
  if (in_time_) add_storage(batch, i, worker);
  if (setup_.compression > 0.0) add_compression(batch, i, worker);
}

// compression e T0 H^2 (P_T + u P_X + v P_Y), with e at mid-film.
void FilmColumns::add_compression(int batch, int i, Worker& worker) const {
  const int j = batch * core::lanes;
  Columns& at = worker.at;
  const auto n = static_cast<std::size_t>(nodes_.intervals);
  const Lanes P_X = core::load(P_X_.at_x(i) + j), P_Y = core::load(P_Y_.at_x(i) + j);
  Lanes ratio{}, expansion{};
  const auto in = [](const Lanes& v) { return std::span(reinterpret_cast<const double*>(&v), core::lanes); };
  const auto out = [](Lanes& v) { return std::span(reinterpret_cast<double*>(&v), core::lanes); };
  rheology::density_change(setup_.density, in(at.P), in(at.theta[n / 2]), out(ratio), out(expansion));
  const Lanes scale = setup_.compression * expansion * at.H / core::load(rho_bar_.at_x(i) + j);
  const Lanes of_rate = in_time_ ? setup_.compression * expansion * at.H * at.H * core::load(oil_.at_x(i) + j) *
                                       core::load(in_time_->P_T.at_x(i) + j)
                                 : Lanes{};
  for (std::size_t k = 0; k <= n; ++k) {
    const double layer = k == 0 || k == n ? 0.5 * nodes_.step : nodes_.step;
    const std::size_t here = index(batch, i, static_cast<int>(k));
    at.convection.compression[k] =
        scale / layer * (core::load(&flow_x_[here]) * P_X + core::load(&flow_y_[here]) * P_Y) + of_rate;
  }
}

}  // namespace ehl::thermal
