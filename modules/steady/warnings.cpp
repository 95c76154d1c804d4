#include "steady/warnings.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/norms.hpp"
#include "reynolds/flux.hpp"

namespace ehl::steady {
namespace {

/// An estimated error above this only shows that the film is far from resolved.
constexpr double hardly_an_error = 1.0;
/// Pressure at a boundary over the maximum from which the domain is too short.
constexpr double cut_off_pressure = 1e-3;
/// A meniscus within this many cells of the inlet is too close to it.
constexpr int cells_to_meniscus = 3;
/// The mesh cannot explain a starvation factor above this.
constexpr double starvation_above_one = 1.01;
/// The end of a roller cuts where the film is negative beyond this share of the half length.
constexpr double roller_end = 0.8;

std::string percent(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, value < 1.0 ? "%.2g %%" : "%.0f %%", 100.0 * value);
  return buffer;
}

double largest_along_outlet(const Solution& solution) {
  double largest = 0.0;
  for (int j = 0; j <= solution.grid.ny; ++j) largest = std::max(largest, solution.P(solution.grid.nx - 1, j));
  return largest;
}

double largest_along_sides(const Solution& solution) {
  double largest = 0.0;
  if (!reynolds::flows_aside(solution.grid)) return largest;
  for (int i = 0; i <= solution.grid.nx; ++i)
    largest = std::max({largest, solution.P(i, 1), solution.P(i, solution.grid.ny - 1)});
  return largest;
}

void warn_of_supply(const Starvation& found, core::Warnings& warnings) {
  if (found.line && found.filled > 0.0)
    warnings.push_back({"supply-left",
                        "the supply exceeds what passes through the contact, and a line contact has no side flow: the "
                        "rest stays upstream, and the film is the flooded one"});
  else if (found.filled > 0.0)
    warnings.push_back(
        {"supply-left", "the supply exceeds what the domain can hold: at " + percent(found.filled) +
                            " of the inlet boundary the gap is full, and this oil is lost; move x_inlet upstream"});
  else if (found.cells_to_inlet <= cells_to_meniscus)
    warnings.push_back(
        {"meniscus-at-inlet", "the meniscus is only " + std::to_string(found.cells_to_inlet) +
                                  " cells from the inlet boundary, which may displace it; move x_inlet upstream"});
  if (!found.flooded_converged)
    warnings.push_back({"no-flooded-film",
                        "the flooded contact, solved for comparison, did not converge: there is no starvation factor"});
  if (found.factor > starvation_above_one)
    warnings.push_back(
        {"starvation-above-1",
         "the starvation factor is above 1, which is not physical: the mesh resolves neither film; use more cells"});
}

void warn_of_passes(const std::vector<Pass>& passes, core::Warnings& warnings) {
  if (!passes.empty() && std::isnan(passes.back().supply_error)) {
    const auto known = std::ranges::count_if(passes, [](const Pass& pass) { return !std::isnan(pass.supply_error); });
    warnings.push_back({"passes-unknown", "the error in the layer after " + std::to_string(passes.size() - 1) +
                                              " passes is not known, and the film has no error bar: the comparison on "
                                              "half as many cells reached pass number " +
                                              std::to_string(known) + " only; use more cells"});
  }
  const auto chattering = std::ranges::count_if(passes, &Pass::chatters);
  if (chattering == 0) return;
  const double residual = std::ranges::max_element(passes, {}, [](const Pass& pass) {
                            return pass.chatters ? pass.residual : 0.0;
                          })->residual;
  char largest[16];
  std::snprintf(largest, sizeof largest, "%.1e", residual);
  warnings.push_back(
      {"edge-of-film", "in " + std::to_string(chattering) + " of " + std::to_string(passes.size()) +
                           " passes a node at the edge of the film alternates between wet and dry: residual " +
                           largest + " at most, oil is conserved; try another number of cells"});
}

}  // namespace

int cells_that_resolve(int cells, double error, reynolds::Wedge wedge) {
  const double per_doubling = wedge != reynolds::Wedge::upstream1 ? 4.0 : 2.0;
  for (error = std::min(error, hardly_an_error); error > unresolved_film; error /= per_doubling) cells *= 2;
  return cells;
}

std::string advice_for_cutting_ends(const Scene& scene, const Solution& solution) {
  if (!contact::roller(scene.contact.shape) || solution.H.nodes_x() == 0) return {};
  const core::Location least = core::minimum(solution.H);
  const double Y = solution.grid.Y(least.j);
  if (!(least.value < 0.0) || std::abs(Y) < roller_end * 0.5 * scene.contact.shape.length) return {};
  char place[64];
  std::snprintf(place, sizeof place, "H = %.3g at y = %.4g a", least.value, Y);
  return std::string("the film is negative at the end of the roller, ") + place +
         ", and finer meshes do not help: let the profile fall further at the ends, or reduce the load or the tilt";
}

core::Warnings warnings_of(const Scene& scene, const Solution& solution) {
  core::Warnings warnings;
  const LevelRow& last = solution.levels.back();
  const double of_Hc = solution.error_bars.Hc.discretization, of_Hm = solution.error_bars.Hm.discretization;
  const std::string cutting = advice_for_cutting_ends(scene, solution);
  if (!cutting.empty())
    warnings.push_back({"roller-cuts", cutting});
  else if (last.Hm_fitted < 0.0)
    warnings.push_back({"film-negative",
                        "the minimum of the film lies between the nodes and is negative there: the mesh does not "
                        "resolve it; use at least " +
                            std::to_string(2 * last.nx) + " cells"});
  else if (std::isnan(last.mesh_error_Hc))
    warnings.push_back(
        {"one-level", "the error estimate is rough, because the film was computed on a single level; use at least " +
                          std::to_string(2 * last.nx) + " cells"});
  else if (const double error = std::max(of_Hc, of_Hm); error > unresolved_film)
    warnings.push_back({"mesh", "the mesh does not resolve the film: estimated error of Hc " + percent(of_Hc) +
                                    ", of Hm " + percent(of_Hm) + " on " + std::to_string(last.nx) + " cells; " +
                                    (error > hardly_an_error ? "at least " : "") +
                                    std::to_string(cells_that_resolve(last.nx, error, scene.wedge)) +
                                    " would bring both below 10 %"});
  if (std::abs(solution.domain_error_Hc) > scene.tuning.domain_worth_a_look)
    warnings.push_back(
        {"domain",
         "the domain is too short: on a domain twice as long and wide Hc differs by about " +
             percent(std::abs(solution.domain_error_Hc)) +
             " (an estimate), and larger domains may add as much again; move x_inlet upstream and widen y_half"});
  if (solution.starvation) warn_of_supply(*solution.starvation, warnings);
  if (solution.chattering_nodes > 0)
    warnings.push_back(
        {"edge-of-film", "at " + std::to_string(solution.chattering_nodes) +
                             " nodes at the edge of the film the flux is of first order, because they chatter between "
                             "wet and dry with the second order; try another number of cells"});
  warn_of_passes(solution.passes, warnings);
  if (!solution.polish_failure.empty())
    warnings.push_back(
        {"polish", "the Newton refinement did not reach rounding errors; the solution of the cycles is kept: " +
                       solution.polish_failure});
  if (const double lost = solution.error_bars.relief_unresolved; lost > 0.0)
    warnings.push_back({"surfaces-unresolved", "the mesh of " + std::to_string(last.nx) +
                                                   " cells does not resolve the surfaces: half as many lose " +
                                                   percent(lost) +
                                                   " of the variance of their heights; the maximum pressure depends on "
                                                   "the mesh and has no error bar; use more cells"});
  const double P_max = core::maximum(solution.P).value;
  const double outlet = largest_along_outlet(solution);
  if (!scene.far_field && outlet > cut_off_pressure * P_max)
    warnings.push_back({"outlet", "the outlet is too short: the pressure next to the boundary is still " +
                                      percent(outlet / P_max) + " of its maximum; move x_outlet downstream"});
  const double sides = largest_along_sides(solution);
  if (!scene.far_field && !contact::roller(scene.contact.shape) && sides > cut_off_pressure * P_max)
    warnings.push_back({"sides", "the domain is too narrow: the pressure next to its sides is still " +
                                     percent(sides / P_max) + " of its maximum; widen y_half"});
  return warnings;
}

}  // namespace ehl::steady
