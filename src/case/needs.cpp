#include "case/needs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/machine.hpp"
#include "case/effects.hpp"
#include "case/touching.hpp"
#include "deck/text.hpp"
#include "steady/accuracy.hpp"
#include "steady/domain_error.hpp"
#include "steady/larger_domain.hpp"
#include "steady/multigrid_solve.hpp"
#include "steady/resolution.hpp"

namespace ehl::program {
namespace {

using deck::complain;
using deck::given;

constexpr double giga = 1e9;

// Seconds on the coarsest grid if that grid is still large. Relaxation alone converges slowly there, and all strategies
// are tried. [bench: needs_of_coarsest]
double seconds_of_coarsest(const steady::Scene& scene) {
  constexpr double usual = 1e4;  // nodes; below this the estimate of the cycles includes the coarsest grid
  constexpr double sweeps = 2500.0;
  constexpr double seconds_per_node_and_sweep = 1e-7;
  const int wanted =
      scene.solver.coarsest_cells > 0 ? scene.solver.coarsest_cells : 2 * scene.solver.least_coarsest_cells - 1;
  core::Grid grid = scene.grid;
  while (grid.nx > wanted && grid.nx % 2 == 0 && grid.ny % 2 == 0) grid = core::coarsened(grid);
  const double nodes = static_cast<double>(grid.nodes_x()) * grid.nodes_y();
  return nodes > usual ? nodes * sweeps * seconds_per_node_and_sweep : 0.0;
}

Needs with_effects(const Case& input, Needs needs) {
  for (const Effect& effect : effects_of(input)) {
    const Needs more = effect.expense ? effect.expense(input) : Needs{};
    needs.bytes += more.bytes;
    needs.seconds += more.seconds;
  }
  return needs;
}

}  // namespace

Needs basic_needs(const steady::Scene& scene) {
  const double nodes = static_cast<double>(scene.grid.nodes_x()) * scene.grid.nodes_y();
  // For one thread of a machine of the 2020s. [bench: needs_of_basic_model]
  const double doubles_per_node = steady::on_one_half(scene) ? 15.0 : 25.0;
  constexpr double program_itself = 1.5e7;  // bytes
  const double seconds_per_node_and_cycle = steady::on_one_half(scene) ? 2e-7 : 4e-7;
  constexpr double more_cycles = 2.0;  // more than planned, because the checks on the finest grid may need them
  const double direct_pairs_per_second = steady::on_one_half(scene) ? 8e9 : 2e9;
  constexpr double evaluations_per_cycle = 8.0;
  constexpr double newton_bytes_per_node = 2400.0;  // the sparse factors of the Jacobian
  constexpr double newton_seconds_per_node = 4e-5;
  const multigrid::Parameters& multigrid = scene.solver;
  const double cycles = std::isnan(multigrid.tolerance) ? more_cycles * multigrid.cycles : 10.0;
  Needs needs;
  needs.bytes = nodes * doubles_per_node * sizeof(double) + program_itself;
  constexpr double seconds_of_coarse_grids = 0.03;
  needs.seconds = seconds_of_coarse_grids + seconds_of_coarsest(scene) +
                  cycles * nodes * seconds_per_node_and_cycle / std::sqrt(scene.threads);
  if (scene.polish == steady::Polish::always) {
    needs.bytes += nodes * newton_bytes_per_node;
    needs.seconds += nodes * newton_seconds_per_node;
  }
  if (scene.deformation.method == mlmi::Method::direct)
    needs.seconds += cycles * evaluations_per_cycle * nodes * nodes / direct_pairs_per_second / scene.threads;
  return needs;
}

core::Grid predicted_grid(const steady::Scene& scene) {
  core::Grid grid = scene.grid;
  double allowed = scene.accuracy.error;
  if (std::isnan(allowed)) return grid;
  if (scene.accuracy.domain_is_free) {
    allowed *= 0.5;  // the same share as in solve_to_accuracy()
    const double size = std::sqrt(steady::rough_domain_error(scene) / allowed);
    if (size > 1.0) grid = steady::on_larger_domain(grid, size, steady::sides_of(scene));
  }
  const double zone = scene.contact.film_zone;
  const auto error = [&] {
    const double h = grid.hx() / zone;
    // as in resolving_step()
    return scene.wedge == reynolds::Wedge::upstream1 ? 0.2 * h : 0.4 * h * h;
  };
  while (error() > allowed && 2 * grid.nx <= scene.accuracy.most_cells) grid = core::refined(grid);
  return grid;
}

namespace {

/// Lambda ratio from which on measured roughness costs no time, and from which on a first start finds the film. Between
/// them the time grows with this power of the ratio of the first to the lambda ratio.
/// [bench: lambda_of_smooth_surfaces]
constexpr double lambda_of_smooth_surfaces = 5.0, lambda_of_one_start = 1.5, growth_of_time = 1.3;

// Lambda ratio of what was measured of the surfaces of a steady contact; infinite if they are smooth.
double measured_lambda(const Case& input) {
  if (input.dry || input.transient || !(measured_roughness(input) > 0.0)) return INFINITY;
  return smallest_smooth_film(input.physics.groups) / measured_roughness(input);
}

// Time over that of smooth surfaces, for the first start.
double time_of_roughness(const Case& input) {
  const double lambda = measured_lambda(input);
  if (!(lambda < lambda_of_smooth_surfaces) || !input.scene.one_start_only.empty()) return 1.0;
  return std::pow(lambda_of_smooth_surfaces / std::max(lambda, lambda_of_one_start), growth_of_time);
}

}  // namespace

Needs expected_needs(const Case& input) {
  steady::Scene scene = input.scene;
  scene.grid = predicted_grid(scene);
  Needs basic = basic_needs(scene);
  basic.seconds *= time_of_roughness(input);
  Needs needs = with_effects(input, basic);
  if (!std::isnan(scene.accuracy.error) && scene.accuracy.domain_is_free)
    for (const steady::Scene& coarse : steady::domain_series(input.scene)) needs.seconds += basic_needs(coarse).seconds;
  return needs;
}

namespace {

// The key of the deck that determines the memory of an effect.
KeyName key_of_memory(const deck::Deck& deck, const Effect& effect) {
  const KeyName& costly = effect.costly;
  if (!costly.name.empty() && given(deck, costly.section, costly.name)) return costly;
  return effect.callers.front();
}

}  // namespace

void bound_accuracy(Case& input) {
  steady::AccuracyTarget& target = input.scene.accuracy;
  if (std::isnan(target.error)) return;
  const auto nodes = [](const core::Grid& grid) { return static_cast<double>(grid.nodes_x()) * grid.nodes_y(); };
  Case finer = input;
  finer.scene.grid = core::refined(input.scene.grid);
  const double more =
      with_effects(finer, basic_needs(finer.scene)).bytes - with_effects(input, basic_needs(input.scene)).bytes;
  target.bytes_per_node = more / (nodes(finer.scene.grid) - nodes(input.scene.grid));
  target.most_nodes = share_of_memory * free_memory() / target.bytes_per_node;
}

void check_memory(Case& input) {
  deck::Deck& deck = input.deck;
  const double needed = with_effects(input, basic_needs(input.scene)).bytes;
  const double available = usable_memory();
  if (!(needed > available)) return;
  const std::string has = "the machine has " + deck::shortest(std::round(available / giga)) + " GB";
  const double basic = basic_needs(input.scene).bytes;
  for (const Effect& effect : effects_of(input)) {
    const double more = effect.expense ? effect.expense(input).bytes : 0.0;
    if (basic > 0.5 * available || more <= 0.5 * needed) continue;
    const KeyName key = key_of_memory(deck, effect);
    const deck::Key* record = deck::find_key(deck.catalogue, key.section, key.name);
    complain(deck, key.section, key.name,
             "needs about " + deck::shortest(std::round(more / giga)) + " GB of memory for the effect " + effect.name +
                 ", but " + has + (record->remedy.empty() ? "" : ": " + record->remedy));
    return;
  }
  const double ratio = std::sqrt(needed / available);
  const double fitting = std::exp2(std::floor(std::log2(input.scene.grid.nx / ratio)));
  complain(deck, "grid", "cells",
           "needs about " + deck::shortest(std::round(needed / giga)) + " GB of memory, but " + has + ": use at most " +
               deck::shortest(fitting));
}

std::string what_needs_leave_out(const Case& input) {
  const double lambda = measured_lambda(input);
  if (std::isnan(lambda)) return ", as if the surfaces were smooth: rough ones take longer";
  if (lambda >= lambda_of_smooth_surfaces) return {};
  if (!input.scene.one_start_only.empty()) return "; the surfaces touch, and the run gives up after one start";
  const std::string of = fmt::format(" (lambda ratio {:.2g})", lambda);
  if (lambda >= lambda_of_one_start)
    return fmt::format(", {:.2g} times as long as for smooth surfaces", time_of_roughness(input)) + of;
  return ", if the first start finds the film" + of + ": others may follow and take a hundred times as long";
}

}  // namespace ehl::program
