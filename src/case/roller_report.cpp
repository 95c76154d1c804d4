#include "case/roller_report.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/text_format.hpp"
#include "case/numbers/names.hpp"
#include "core/constants.hpp"

namespace ehl::program {
namespace {

using roller::Distribution;
using roller::End;
using roller::Slice;

// Relative errors from the values on half as many cells. `of_nodes` accounts for maxima between the
// nodes. [bench: roller_bars]
double bar_of_highest(double value, double coarser) {
  constexpr double of_nodes = 5e-4;
  return std::abs(value - coarser) / std::abs(value) + of_nodes;
}
double bar_of_least(double value, double coarser) {
  constexpr double safety = 4.0;
  return safety * std::abs(value - coarser) / std::abs(value);
}

std::string with_bar(double error) { return std::isfinite(error) ? fmt::format(" +- {:.2g} %", 100.0 * error) : ""; }

std::string pressure_text(double P, const Physics& physics) {
  return std::isfinite(physics.p_h) ? fmt::format("{:.4f} ({})", P, pressure(P * physics.p_h))
                                    : fmt::format("{:.4f}", P);
}

std::string film_text(double H, const Physics& physics) {
  const std::optional<SiScales> si = si_scales(physics);
  return si ? film_text(H, *si) : fmt::format("{:.5f}", H);
}

std::string place_text(double Y, const Physics& physics) {
  const std::optional<SiScales> si = si_scales(physics);
  return si ? fmt::format("{:.3f} mm", 1e3 * si->a * Y) : fmt::format("{:.3f} a", Y);
}

}  // namespace

// The end with the higher pressure.
const End& harder(const Distribution& found) { return found.upper.P > found.lower.P ? found.upper : found.lower; }
double least_at_ends(const Distribution& found) { return std::min(found.lower.H, found.upper.H); }

RollerBars bars_of(const roller::Analysis& result) {
  if (!result.coarser) return {};
  const Distribution& found = result.found;
  const Distribution& coarser = *result.coarser;
  RollerBars bars{.H_end = bar_of_least(least_at_ends(found), least_at_ends(coarser))};
  if (!result.pressures_settle) return bars;
  bars.P_middle = bar_of_highest(found.middle.P_max, coarser.middle.P_max);
  bars.P_end = bar_of_highest(harder(found).P, harder(coarser).P);
  bars.mises_middle = bar_of_highest(result.mises.middle, result.mises_coarser.middle);
  bars.mises_end = bar_of_highest(result.mises.end, result.mises_coarser.end);
  return bars;
}

double moment_Nm(const Case& input, const Distribution& found) {
  return input.physics.si ? whole_load(*input.physics.si) * found.load_centre * input.physics.si->hertz.a
                          : core::unknown;
}

std::vector<Column<Slice>> slice_columns() {
  return {{"y", "a", "along the roller", &Slice::Y},
          {id::load, "-", "load per length over the mean", &Slice::load},
          {id::P_max, "p_h", "highest pressure of the line", &Slice::P_max},
          {"H_min", "a^2/R", "least film of the line", &Slice::H_min},
          {"H_c", "a^2/R", "film at x = 0", &Slice::H_c}};
}

core::Warnings edge_warnings(const Distribution& found) {
  constexpr double bears = 0.1;  // share of the pressure in the middle
  const double at_ends = found.P_at_ends / found.middle.P_max;
  if (!(at_ends > bears)) return {};
  return {{"roller-edge", fmt::format("edge loading: at the ends of the roller the pressure is {:.0f} % of that in the "
                                      "middle, and bodies that end there are not half-spaces; let the profile fall "
                                      "further (a logarithmic one with [roller] design_load above 1)",
                                      100.0 * at_ends)}};
}

core::Warnings roller_warnings(const roller::Analysis& result) {
  core::Warnings warnings = edge_warnings(result.found);
  if (!result.coarser)
    warnings.push_back(
        {"roller-no-bar",
         result.solved
             ? "half as many cells gave no solution: the values at the ends have no error bar"
             : "the contact was not solved: half as many cells are not tried, and the ends have no error bar"});
  return warnings;
}

std::string roller_summary(const Case& input, const Computed& computed) {
  const roller::Analysis& result = *computed.roller;
  const Distribution& found = result.found;
  const Physics& physics = input.physics;
  const End& end = harder(found);
  const RollerBars bars = bars_of(result);
  const char* mark = convergence_mark(computed.solution.converged);
  std::string text = fmt::format("roller       middle: p = {}{}, dry {}; load per length {:.4f} of the mean{}\n",
                                 pressure_text(found.middle.P_max, physics), with_bar(bars.P_middle),
                                 known("{:.4f}", result.dry.middle.P_max), found.middle.load, mark);
  text += fmt::format("             ends: p = {}{} at y = {}, dry {}; film {}{}\n", pressure_text(end.P, physics),
                      with_bar(bars.P_end), place_text(end.P_Y, physics), known("{:.4f}", harder(result.dry).P),
                      film_text(least_at_ends(found), physics), with_bar(bars.H_end));
  if (!result.pressures_settle)
    text +=
        "             these pressures belong to this mesh: a spike may grow from grid to grid, or hide between nodes\n";
  if (!roller::symmetric(*input.roller)) {
    text += "             resultant of the pressure at y = " + place_text(found.load_centre, physics);
    if (physics.si) text += fmt::format(", moment {:.4g} N m", moment_Nm(input, found));
    text += "\n";
  }
  if (std::isfinite(result.mises.end))
    text += fmt::format("             von Mises below the middle {}{}, below the ends {}{}\n",
                        pressure_text(result.mises.middle, physics), with_bar(bars.mises_middle),
                        pressure_text(result.mises.end, physics), with_bar(bars.mises_end));
  return text;
}

}  // namespace ehl::program
