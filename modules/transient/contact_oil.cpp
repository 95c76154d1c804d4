// The oil of a contact in time, where mass is conserved.
#include <algorithm>
#include <cmath>

#include "core/norms.hpp"
#include "fmg/oil.hpp"
#include "transient/contact_dae.hpp"
#include "transient/nodes.hpp"

namespace ehl::transient {

double ContactDae::content(int i, int j) const {
  const fmg::Level& level = hierarchy_.levels.back();
  return conserves_mass() ? level.content(i, j) : level.rho_bar(i, j) * level.H(i, j);
}

// Q of a node that the edge of the film passes bends there, and no step is short enough for it; what it errs is
// conserved, and leaves with the node. Where y is dry, or the edge is near enough to come in a step.
bool ContactDae::at_edge(std::span<const double> y, int i, int j) const {
  if (!conserves_mass()) return false;
  const core::Patch& grid = hierarchy_.levels.back().grid;
  constexpr int near = 2;
  const auto dry = [&](int k, int l) {
    const bool inside = k > 0 && k < grid.nx && l > 0 && l <= grid.last_line();
    return inside && y[static_cast<std::size_t>(k * grid.nodes_y() + l)] <= 0.0;
  };
  for (int d = 0; d <= near; ++d)
    if (dry(i - d, j) || dry(i + d, j) || dry(i, j - d) || dry(i, j + d)) return true;
  return false;
}

// Between two steps Q of y is interpolated, and may pass what the gap takes.
void ContactDae::set_content(std::span<const double> y) {
  if (!conserves_mass()) return;
  fmg::Level& level = hierarchy_.finest();
  for_nodes(level.grid, [&](int i, int j, std::size_t k) {
    const double full = level.rho_bar(i, j) * level.H(i, j);
    level.content(i, j) = level.P(i, j) > 0.0 ? full : std::clamp(y[nodes_ + k], 0.0, full);
  });
  core::fill_ghosts(level.grid, level.content);
  oil_by_flows_ = y.back();
}

double ContactDae::stored_oil() const {
  const core::Patch& grid = hierarchy_.levels.back().grid;
  return grid.hx() * grid.hy() * core::interior_sum(grid, hierarchy_.levels.back().content);
}

void ContactDae::begin_oil() {
  if (!conserves_mass()) return;
  close_oil();
  oil_by_flows_ = stored_oil();
}

// What the cycles have left in the rows of full nodes would add up from step to step.
void ContactDae::close_oil() {
  fmg::Level& level = hierarchy_.finest();
  fmg::balance_oil(hierarchy_, level, inlet_);
  from_nowhere_ = std::abs(fmg::oil_from_nowhere(hierarchy_, level)) / inlet_;
}

void ContactDae::count_oil(const Stage& stage) {
  if (!conserves_mass()) return;
  close_oil();
  const double gain = fmg::oil_of(hierarchy_, hierarchy_.finest()).stored();
  oil_by_flows_ = stage.y_predicted.back() + (gain - stage.yp_predicted.back()) / stage.cj;
}

OilInTime ContactDae::oil() const {
  if (!conserves_mass()) return {};
  const reynolds::OilBalance flow = fmg::oil_of(hierarchy_, hierarchy_.levels.back());
  const double stored = stored_oil();
  return {stored, flow.in, flow.out, flow.aside, from_nowhere_, (oil_by_flows_ - stored) / inlet_};
}

core::Field ContactDae::theta() const {
  const fmg::Level& level = hierarchy_.levels.back();
  return conserves_mass() ? core::on_domain(level.grid, fmg::theta_of(level)) : core::Field();
}

}  // namespace ehl::transient
