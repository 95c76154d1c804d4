// Oil balance of a contact in time, where mass is conserved.
#include <algorithm>
#include <cmath>

#include "core/norms.hpp"
#include "multigrid/mass_balance.hpp"
#include "transient/contact_dae.hpp"
#include "transient/nodes.hpp"

namespace ehl::transient {

double ContactDae::content(int i, int j) const {
  const multigrid::Level& level = hierarchy_.levels.back();
  const double Q = conserves_mass() ? level.content->Q(i, j) : level.rho_bar(i, j) * level.H(i, j);
  return stored_share(i, j) * Q;
}

// True for cavitated nodes of y and for nodes so close that the film edge may reach them within a step. When the edge
// passes a node, Q of that node has a kink that no step size resolves. The error is conservative and leaves with the
// oil.
bool ContactDae::at_edge(std::span<const double> y, int i, int j) const {
  if (!conserves_mass()) return false;
  const core::Patch& grid = hierarchy_.levels.back().grid;
  const auto dry = [&](int k, int l) {
    const bool inside = k > 0 && k < grid.nx && l > 0 && l <= grid.last_line();
    return inside && y[static_cast<std::size_t>(k * grid.nodes_y() + l)] <= 0.0;
  };
  for (int d = 0; d <= control_.tuning.edge_reach; ++d)
    if (dry(i - d, j) || dry(i + d, j) || dry(i, j - d) || dry(i, j + d)) return true;
  return false;
}

// IDA interpolates Q between two steps, and the result may exceed the full gap.
void ContactDae::set_content(std::span<const double> y) {
  if (!conserves_mass()) return;
  multigrid::Level& level = hierarchy_.finest();
  for_nodes(level.grid, reversed_, [&](int i, int j, std::size_t k) {
    const double full = level.rho_bar(i, j) * level.H(i, j);
    level.content->Q(i, j) = level.P(i, j) > 0.0 ? full : std::clamp(y[nodes_ + k], 0.0, full);
  });
  core::fill_ghosts(level.grid, level.content->Q);
  oil_by_flows_ = y.back();
}

void ContactDae::begin_oil() {
  if (!conserves_mass()) return;
  if (!released()) correct_mass();
}

void ContactDae::count_from_here(std::span<double> y) {
  if (!conserves_mass()) return;
  y.back() = oil_by_flows_ = multigrid::stored_oil(hierarchy_.levels.back());
}

// Oil at rest below a body that approaches: the supplied layer.
void ContactDae::spread_oil() {
  if (!conserves_mass()) return;
  multigrid::Level& level = hierarchy_.finest();
  for_nodes(level.grid, [&](int i, int j, std::size_t) {
    level.content->Q(i, j) =
        std::min(level.content->supply[static_cast<std::size_t>(j)], level.rho_bar(i, j) * level.H(i, j));
  });
  core::fill_ghosts(level.grid, level.content->Q);
}

// Without this correction the algebraic errors in the rows of full nodes would add up from step to step. The excess is
// a flow; times the length of the implicit step, about 1/squeeze, it is an amount of oil.
bool ContactDae::correct_mass() {
  multigrid::Level& level = hierarchy_.finest();
  multigrid::balance_mass(hierarchy_, level, inlet_);
  const double squeeze = hierarchy_.transport.squeeze;
  const double excess = std::abs(multigrid::mass_defect(hierarchy_, level));
  from_nowhere_ = excess / (squeeze > 0.0 ? squeeze : 1.0) / inlet_;
  constexpr double closed = 1e-10;
  return from_nowhere_ <= closed;
}

void ContactDae::count_oil(const Stage& stage) {
  if (!conserves_mass()) return;
  const double gain = multigrid::oil_of(hierarchy_, hierarchy_.finest()).stored();
  oil_by_flows_ = stage.y_predicted.back() + (gain - stage.yp_predicted.back()) / stage.cj;
}

OilInTime ContactDae::oil() const {
  if (!conserves_mass()) return {};
  const reynolds::OilBalance flow = multigrid::oil_of(hierarchy_, hierarchy_.levels.back());
  const double stored = multigrid::stored_oil(hierarchy_.levels.back());
  return {stored, flow.in, flow.out, flow.aside, from_nowhere_, (oil_by_flows_ - stored) / inlet_};
}

core::Field ContactDae::theta() const {
  if (!conserves_mass()) return {};
  const multigrid::Level& level = hierarchy_.levels.back();
  core::Field theta = multigrid::theta_of(level);
  if (reversed_) mirror_in_X(level.grid, theta);
  return core::on_domain(level.grid, theta);
}

}  // namespace ehl::transient
