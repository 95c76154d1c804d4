#include "case/starvation_report.hpp"

#include <fmt/core.h>

#include <cmath>

#include "base/text_format.hpp"
#include "case/numbers/number.hpp"
#include "contact/ellipse.hpp"
#include "core/constants.hpp"
#include "deck/text.hpp"
#include "effects/starvation/formulas.hpp"
#include "reynolds/flux.hpp"

namespace ehl::program {
namespace {

using core::unknown;
using steady::Pass;
using steady::Starvation;

/// Exponent gamma of starvation::by_supply near r = 1; modules/effects/starvation/README.md.
constexpr double usual_gamma = 3.0;

/// Formulas for passes over a track on which the layer returns unchanged; otherwise NaN.
class PassFormulas {
 public:
  PassFormulas(const steady::Scene& scene, const Pass& first)
      : holds_(scene.passes.returning == 1.0 && scene.passes.renewed == 0.0 && scene.passes.levelled == 0.0),
        first_(first),
        lost_(starvation::lost_by_pass(scene.contact.shape, scene.lambda, scene.viscosity, scene.density)) {}

  /// The oil content Q on y = 0 after a pass, by van Zoelen's formula.
  double thin_layer(const Pass& pass) const {
    return holds_ ? 1.0 / std::sqrt(1.0 / (first_.supply * first_.supply) + pass.number * lost_) : unknown;
  }
  double factor(const Pass& pass) const {
    return holds_ ? starvation::by_passes(first_.supply_ratio, usual_gamma, pass.number) : unknown;
  }

 private:
  bool holds_;
  Pass first_;
  double lost_;
};

std::string length_text(const Case& input, double X) {
  return input.physics.si ? fmt::format("{:.1f} um ({:.3f} a)", 1e6 * X * input.physics.si->hertz.a, X)
                          : fmt::format("{:.3f} a", X);
}

// All passes if they are few; otherwise those at even intervals on a logarithmic axis.
bool shown(int pass, int passes) {
  constexpr int few = 12;
  if (passes <= few || pass == passes || pass <= 3) return true;
  int step = 1;
  while (10 * step <= pass) step *= 10;
  return pass == step || pass == 2 * step || pass == 5 * step;
}

std::string pass_table(const Case& input, const steady::Solution& solution) {
  const bool in_SI = input.physics.si.has_value();
  std::string text = fmt::format(
      "passes            r  factor  {:>9}  {:>9}  {:>7}  meniscus       left  thin layers  steps\n",
      in_SI ? numbers::heading_in_si(id::hc) : id::Hc, in_SI ? numbers::heading_in_si(id::hm) : id::Hm, id::P_max);
  const auto film = [&](double H) {
    return in_SI ? fmt::format("{:9.2f}", 1e9 * input.physics.si->hertz.h_scale * H) : fmt::format("{:9.5f}", H);
  };
  const int passes = static_cast<int>(solution.passes.size());
  const PassFormulas formulas(input.scene, solution.passes.front());
  for (const Pass& pass : solution.passes) {
    if (!shown(pass.number, passes)) continue;
    const double formula = formulas.thin_layer(pass);
    text += fmt::format("  {:<11} {:6.4f}  {:6.4f}  {}  {}  {:7.4f}  {:6.3f} a  {}  {:>11}  {:5}{}\n", pass.number,
                        pass.supply_ratio, pass.factor, film(pass.Hc), film(pass.Hm), pass.P_max, pass.meniscus_X,
                        film(pass.left), std::isfinite(formula) ? film(formula) : "-", pass.steps,
                        pass.chatters ? "  chatters" : "");
  }
  if (const double error = solution.passes.back().supply_error; passes > 1 && std::isfinite(error))
    text += fmt::format(
        "             the mesh leaves {} in the layer of the last pass, by the passes on half as many cells; the error "
        "bars of the film contain it\n",
        percent(error));
  return text;
}

// The line about the oil of a line contact, where no oil flows around the contact.
std::string line_of_oil(const Case& input, const Starvation& found) {
  std::string text = fmt::format("             oil through the contact {:.6f} rho0 u_m a^2/R", found.through);
  if (input.physics.si) {
    const SiUnit unit = si_unit(numbers::unit_of(id::oil_in, input), *si_scales(input.physics));
    text += fmt::format(" = {:.4g} {}", unit.factor * found.through, unit.name);
  }
  text += fmt::format("; imbalance {:.1e}\n", found.imbalance);
  if (!found.flooded_converged) return text;
  return text + fmt::format("             nothing flows aside: {:.4f} by the supply, the lesser of r and 1\n",
                            factor_by_supply(input, found));
}

}  // namespace

double factor_by_meniscus(const Case& input, const Starvation& found) {
  return contact::circular(input.scene.contact.shape) ? starvation::by_meniscus(-found.meniscus_X, found.Hc_flooded)
                                                      : unknown;
}

double factor_by_supply(const Case& input, const Starvation& found) {
  const double r = found.supply_ratio;
  return reynolds::flows_aside(input.scene.grid) ? starvation::by_supply(r, usual_gamma) : std::fmin(r, 1.0);
}

std::vector<Column<Pass>> pass_columns(const Case& input, const steady::Solution& solution) {
  const PassFormulas formulas(input.scene, solution.passes.front());
  using numbers::column;
  std::vector<Column<Pass>> columns{
      {"pass", "-", "contacts on the track so far", &Pass::number},
      column<Pass>(id::supply_ratio, &Pass::supply_ratio),
      {"supply_error", "-", "estimated relative error of what is brought, of the mesh of all passes before",
       &Pass::supply_error},
      {"factor", "-", "rho H at the centre over that of the flooded contact", &Pass::factor},
      column<Pass>(id::Hc, &Pass::Hc),
      column<Pass>(id::Hm, &Pass::Hm),
      column<Pass>(id::P_max, &Pass::P_max),
      column<Pass>(id::meniscus_x, &Pass::meniscus_X),
      {"left", "a^2/R", "oil left behind on y = 0", &Pass::left},
      {"thin_layers", "a^2/R", "the same of thin layers: van Zoelen, Venner, Lugt 2012",
       [formulas](const Pass& pass) { return formulas.thin_layer(pass); }},
      {"factor_by_passes", "-", "factor by r_n^-3 = r^-3 + n: layers that stay even",
       [formulas](const Pass& pass) { return formulas.factor(pass); }},
      column<Pass>(id::oil_in, &Pass::in),
      column<Pass>(id::oil_aside, &Pass::aside),
      column<Pass>(id::mass_imbalance, &Pass::imbalance),
      {"steps", "-", "cycles, or steps of Newton's method", &Pass::steps},
      column<Pass>(id::residual, &Pass::residual),
      {"first_order", "-", "nodes at the edge of the film behind which the flux is of first order", &Pass::first_order},
      {"chatters", "-", "1: a node at the edge of the film chatters", &Pass::chatters}};
  if (const double between = deck::number(input.deck, "supply", "pass_time"); std::isfinite(between))
    columns.insert(columns.begin() + 1,
                   {id::time, "s", "at the pass", [between](const Pass& pass) { return (pass.number - 1) * between; }});
  return columns;
}

results::Table table_of_tracks(const steady::Solution& solution) {
  results::Table table{"tracks", "what every pass left behind across the track", {}};
  table.columns = {{"pass", "-", "contacts on the track so far", true, {}},
                   {"y", "a", "across the track", false, {}},
                   {"layer", "a^2/R", "oil of both surfaces together, as mass over rho0", false, {}}};
  for (std::size_t n = 0; n < solution.tracks.size(); ++n)
    for (std::size_t j = 0; j < solution.tracks[n].size(); ++j) {
      table.columns[0].values.push_back(static_cast<double>(n + 1));
      table.columns[1].values.push_back(solution.grid.Y(static_cast<int>(j)));
      table.columns[2].values.push_back(solution.tracks[n][j]);
    }
  return table;
}

std::string starvation_summary(const Case& input, const Computed& computed) {
  const steady::Solution& solution = computed.solution;
  const Starvation& found = *solution.starvation;
  const char* mark = convergence_mark(solution.converged);
  std::string text =
      found.flooded_converged
          ? fmt::format("starvation   factor {:.4f} of the flooded film (Hc = {:.5f}) at a supply of {:.4f} of it{}\n",
                        found.factor, found.Hc_flooded, found.supply_ratio, mark)
          : fmt::format("starvation   no factor: the flooded contact beside it did not converge{}\n", mark);
  text += "             meniscus on y = 0 at x = " + length_text(input, found.meniscus_X) +
          fmt::format(", {} cells from the inlet boundary where it is nearest\n", found.cells_to_inlet);
  if (!reynolds::flows_aside(input.scene.grid)) return text + line_of_oil(input, found);
  text += fmt::format(
      "             oil in {:.5f} rho0 u_m a^3/R: through the contact {:.5f}, beside it {:.5f}, aside {:.2g}; "
      "imbalance {:.1e}\n",
      found.in, found.through, found.around(), found.aside, found.imbalance);
  if (!found.flooded_converged) return text;
  text += fmt::format("             formulas: {:.4f} by the supply (Chevalier 1998, gamma = {:g}",
                      starvation::by_supply(found.supply_ratio, usual_gamma), usual_gamma);
  const double gamma = starvation::gamma_of(found.supply_ratio, found.factor);
  text += std::isfinite(gamma) ? fmt::format("; here {:.2f})", gamma) : ")";
  if (contact::circular(input.scene.contact.shape))
    text +=
        fmt::format(", {:.4f} by the meniscus (Hamrock, Dowson 1977; flooded from x = {} on)",
                    factor_by_meniscus(input, found), length_text(input, -starvation::flooded_inlet(found.Hc_flooded)));
  text += "\n";
  return solution.passes.empty() ? text : text + pass_table(input, solution);
}

}  // namespace ehl::program
