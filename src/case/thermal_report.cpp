#include "case/thermal_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/text_format.hpp"
#include "case/numbers/number.hpp"
#include "rheology/temperature.hpp"

namespace ehl::program {
namespace {

std::string hottest_text(const Case& input, const char* name, const heat::Hottest& at) {
  const std::string bar = std::isfinite(at.error) ? " +- " + percent(at.error) : "";
  return fmt::format("{} {:.2f} K{} at {}", name, input.heat->T0 * at.theta, bar,
                     place_text(at.X, at.Y, *si_scales(input.physics)));
}

// Below these Peclet numbers, Carslaw and Jaeger's moving line source overestimates the surface temperature by more
// than a tenth. The limit of point contacts is higher, because heat also flows sideways.
constexpr double low_peclet = 10.0, low_peclet_of_line = 3.0;
// Limit of beta tau du h/k per interval across the film, above which the nodes no longer resolve the temperature.
// [bench: thermal_most_per_interval]
constexpr double most_per_interval = 34.0 / 16.0;

}  // namespace

thermal::InletGroups inlet_groups(const Case& input) {
  const contact::SiContact& contact = input.physics.si->contact;
  const double u_m = 0.5 * contact.u_s;
  return {.L = contact.eta0 * input.heat->beta * u_m * u_m / input.heat->k,
          .srr = input.physics.srr,
          .p_h_over_E = input.physics.p_h / contact.E_prime};
}

double film_reduction(const HeatResult& heat) { return heat.found.rows.back().Hc / heat.Hc_isothermal; }

std::vector<Column<heat::Row>> thermal_columns(const HeatInput& input) {
  using Row = heat::Row;
  const double T0 = input.T0;
  const auto kelvin = [T0](double Row::*theta) { return [T0, theta](const Row& row) { return T0 * row.*theta; }; };
  using numbers::column;
  return {column<Row>(id::nx, &Row::nx),
          column<Row>(id::ny, &Row::ny),
          {"passes", "-", "of a sweep of the temperature and a cycle", &Row::passes},
          column<Row>(id::Hc, &Row::Hc),
          column<Row>(id::Hm, &Row::Hm),
          {id::mu, "-", "sliding friction of the pressurised film over the load", &Row::mu},
          column<Row>(id::T_film_max, kelvin(&Row::film)),
          column<Row>(id::T1_max, kelvin(&Row::surface_1)),
          column<Row>(id::T2_max, kelvin(&Row::surface_2)),
          column<Row>(id::heat_imbalance, &Row::defect),
          {id::seconds, "s", "time on the grid", &Row::seconds}};
}

core::Warnings thermal_warnings(const Case& input, const HeatResult& heat) {
  const HeatInput& in = *input.heat;
  const heat::Solution& found = heat.found;
  core::Warnings list;
  if (!input.friction) list = heat.friction_warnings;  // [friction], if present, prints these warnings
  if (heat.unlikely_isothermal)
    list.push_back(
        {"isothermal-friction",
         fmt::format("thermal: mu_isothermal = {:.4g} belongs to shear stresses that no lubricant carries: it says "
                     "nothing of friction without heat; {}",
                     heat.mu_isothermal,
                     input.scene.thinning ? "check the shear law, or give [friction] limit"
                                          : "give [shear] law, or [friction] limit")});
  const double hottest = in.T0 * (1.0 + found.in_film.theta) - rheology::zero_celsius;
  if (hottest > rheology::hottest_oil)
    list.push_back({"hot-film", fmt::format("thermal: the film reaches {:.0f} C, but the viscosity laws hold up to "
                                            "{:.0f} C: above this, oil evaporates and cracks",
                                            hottest, rheology::hottest_oil)});
  if (found.spike_unresolved)
    list.push_back(
        {"spike", fmt::format("thermal: the mesh of {} cells does not resolve the pressure spike, below which the film "
                              "is hotter on finer meshes: T_film_max has no error bar; use more cells",
                              found.rows.back().nx)});
  if (found.nahme > most_per_interval * in.setup.intervals)
    list.push_back({"thermal-nodes", fmt::format("thermal: beta tau_m du h/k reaches {:.0f}, which {} nodes across the "
                                                 "film do not resolve to 1e-3: raise [thermal] nodes",
                                                 found.nahme, in.setup.intervals + 1)});
  const struct {
    const char* name;
    const thermal::Body& body;
  } bodies[] = {{"1", in.setup.body_1}, {"2", in.setup.body_2}};
  for (const auto& [name, body] : bodies)
    if (body.Pe == 0.0)
      list.push_back({"at-rest", fmt::format("thermal: surface {} stands still: the temperature is that after a long "
                                             "time, for a body as large as a half-space",
                                             name)});
    else if (in.setup.lines && body.Pe < (input.scene.grid.line ? low_peclet_of_line : low_peclet))
      list.push_back({"slow-surface",
                      fmt::format("thermal: surface {} is slow, u a over the diffusivity = {:.2g}: solids = lines "
                                  "overestimates its temperature by more than a tenth; set [thermal] solids = full",
                                  name, body.Pe)});
  return list;
}

std::string thermal_summary(const Case& input, const Computed& computed) {
  if (!computed.heat) return "thermal      not computed: there is no isothermal film to begin with\n";
  const HeatResult& heat = *computed.heat;
  const heat::Solution& found = heat.found;
  const HeatInput& in = *input.heat;
  const thermal::InletGroups inlet = inlet_groups(input);
  const char* mark = convergence_mark(computed.solution.converged);
  constexpr const char* no_oil = " (no oil carries it)";
  std::string text =
      fmt::format("thermal      mu = {:.5g}{}{}, isothermal {:.5g}{}{}\n", heat.mu,
                  std::isfinite(heat.error_mu) && heat.mu != 0.0 ? " +- " + percent(heat.error_mu) : "",
                  heat.unlikely ? no_oil : "", heat.mu_isothermal, heat.unlikely_isothermal ? no_oil : "", mark);
  text += "             above T_oil: " + hottest_text(input, "film", found.in_film) +
          fmt::format(", mean {:.2f} K, inlet {:.2f} K{}\n", in.T0 * found.mean, in.T0 * found.inlet, mark);
  text += "             above T_oil: " + hottest_text(input, "surface 1", found.on_1) + "; " +
          hottest_text(input, "surface 2", found.on_2) + mark + "\n";
  text += fmt::format(
      "             heat {0:.4g} {5} made, {1:.4g} {5} into body 1, {2:.4g} {5} into body 2, {3:.3g} {5} with the oil; "
      "imbalance {4:.0e}{6}\n",
      in.power * found.balance.heat, in.power * found.balance.into_1, in.power * found.balance.into_2,
      in.power * found.balance.carried, std::abs(found.balance.defect), numbers::unit_of(id::heat_1, input), mark);
  text += fmt::format(
      "             film {:.3f} of the isothermal one; inlet heating by Wilson, Sheu 1983 {:.3f}, Gupta et "
      "al. 1992 {:.3f}{}{}\n",
      film_reduction(heat), thermal::wilson_sheu(inlet), thermal::gupta(inlet),
      input.physics.srr == 0.0 ? fmt::format(", Murch, Wilson 1975 {:.3f}", thermal::murch_wilson(inlet)) : "", mark);
  text += fmt::format("             Nahme's number {:.3g}; passes per grid", found.nahme);
  for (const heat::Row& row : found.rows) text += fmt::format(" {}", row.passes);
  text += "\n";
  return text;
}

}  // namespace ehl::program
