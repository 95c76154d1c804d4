// The effect `shear`: an oil that thins under shear.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text_format.hpp"
#include "case/coupled_film.hpp"
#include "case/effects.hpp"
#include "case/numbers/records.hpp"
#include "case/sliding_input.hpp"
#include "rheology/shear_keys.hpp"

namespace ehl::program {
namespace numbers {
namespace {

const HeatResult& thinned(Of s) { return *s.computed.flow; }

Group shear_numbers() {
  Group group{.name = "shear"};
  group.on = [](Of s) { return s.computed.flow.has_value(); };
  group.asked = [](const deck::Deck&) { return false; };
  group.numbers = {
      number("Hc_without", "a^2/R", "film at (0,0), thinned by the sliding alone",
             [](Of s) { return thinned(s).Hc_isothermal; }),
      number("Hm_without", "a^2/R", "minimum film, thinned by the sliding alone",
             [](Of s) { return thinned(s).Hm_isothermal; }),
      number("mu_without", "-", "sliding friction over the load, thinned by the sliding alone",
             [](Of s) { return thinned(s).mu_isothermal; }),
      number(id::mu, "-", "sliding friction over the load", bar(id::error_mu), [](Of s) { return thinned(s).mu; }),
      number(id::error_mu, "-", "estimated relative discretization error of mu",
             [](Of s) { return thinned(s).error_mu; })};
  return group;
}

}  // namespace
}  // namespace numbers

namespace {

void enter(Case& input) {
  if (deck::called_for(input.deck, "shear")) settle_sliding_at_start(input);
  const std::optional<ShearInput> shear = shear_input(input.deck, input.physics);
  if (!shear) return;
  input.scene.thinning = shear->sliding;
  input.flow_thinning = shear->flow;
  if (input.transient) input.transient->conditions.thinning_k = shear->k_of_u_m;
  observe_friction(input);
}

// A film with heat takes the thinning by the flow into its own iteration.
FilmSolver film(const Case& input) {
  if (!input.flow_thinning || input.heat) return nullptr;
  return [](const Case& one, const steady::ProgressCallback& progress, Computed& computed) {
    thermal::Setup setup = thermal::cold_setup(one.scene.viscosity, one.scene.density);
    setup.lambda = one.scene.lambda;
    setup.srr = one.physics.srr;
    setup.stress_of_P = 1.0 / stress_of_speed(one.physics);
    setup.thinning = one.scene.thinning;
    setup.flow_thinning = one.flow_thinning;
    if (one.friction) setup.limit = one.friction->limit;
    computed.flow = solve_coupled(one, setup, progress, computed.solution);
  };
}

std::string what(const Case& input) {
  const bool eyring = std::holds_alternative<rheology::Eyring>(input.scene.thinning->law);
  const double stress = deck::number(input.deck, "shear", eyring ? "tau_0" : "G");
  return (eyring ? "Eyring, tau_0 = " : "Carreau, G = ") + pressure(stress) +
         (eyring ? "" : fmt::format(", n = {:.4g}", std::get<rheology::Carreau>(input.scene.thinning->law).n)) +
         fmt::format(
             ", slide-roll ratio {:.4g}; at H = 1 and ambient pressure the Newtonian shear stress is {:.3g} times this "
             "stress",
             input.physics.srr, input.scene.thinning->k) +
         (input.flow_thinning ? "; the flow driven by the pressure gradient thins too" : "");
}

std::string idle(const Case& input) {
  // A traction curve may contain the point srr = 0, and the speeds may vary in time.
  const bool one_of_a_curve = input.friction || input.heat || input.flow_thinning;
  const auto varies = [&](const char* speed) { return deck::given(input.deck, "transient", speed); };
  const bool one_of_many_times = std::ranges::any_of(std::array{"u1", "u1_wave", "u2", "u2_wave", "cycle"}, varies);
  if (input.scene.thinning->k == 0.0 && !one_of_a_curve && !one_of_many_times)
    return "the surfaces do not slide (srr = 0), and the oil thins by sliding: remove [shear], or give [motion] srr, "
           "or different u1 and u2, or flow = on";
  const auto* carreau = std::get_if<rheology::Carreau>(&input.scene.thinning->law);
  return carreau && carreau->n == 1.0 ? "n = 1 is a Newtonian oil" : "";
}

std::string summary(const Case&, const Computed& computed) {
  if (!computed.flow) return "";
  const HeatResult& flow = *computed.flow;
  const heat::Row& row = flow.found.rows.back();
  return fmt::format(
      "shear        with thinning by the pressure gradient: Hc {:+.2g} %, Hm {:+.2g} % in {} iterations{}\n",
      100.0 * (row.Hc / flow.Hc_isothermal - 1.0), 100.0 * (row.Hm / flow.Hm_isothermal - 1.0), row.passes,
      convergence_mark(computed.solution.converged));
}

// Warnings about the friction, which [friction] gives itself.
core::Warnings warnings(const Case& input, const Computed& computed) {
  return input.friction || !computed.flow ? core::Warnings{} : computed.flow->friction_warnings;
}

// The cost: a second epsilon on every level, the roots and logarithms of the law in every sweep, and the
// iterations for flow thinning.
Needs expense(const Case& input) {
  const core::Grid& grid = input.scene.grid;
  constexpr double fields = 4.0 / 3.0;
  const double share = input.flow_thinning && !input.heat ? 4.0 : 0.15;  // share of the time of the basic model
  return {.bytes = fields * sizeof(double) * grid.nodes_x() * grid.nodes_y(),
          .seconds = share * basic_needs(input.scene).seconds};
}

}  // namespace

Effect shear_effect() {
  return {.name = "shear",
          .meaning = "Shear-thinning of the oil by sliding, in the film and in the friction.",
          .without = "Newtonian",
          .sections = {{.name = "shear", .called_by = {"law"}}},
          .keys = rheology::shear_keys,
          .numbers = numbers::shear_numbers,
          .stages = {.scene = enter, .film = film},
          .on = [](const Case& input) { return input.scene.thinning.has_value(); },
          .what = what,
          .idle = idle,
          .expense = expense,
          .summary = summary,
          .warnings = warnings,
          // Thinning by sliding is part of every evaluation of the film and has no time of its own.
          .seconds = [](const Computed& computed) { return computed.flow ? computed.flow->found.seconds : NAN; },
          .example = {"motion.srr=0.5", "contact.a_over_R=0.01", "shear.law=eyring", "shear.tau_0=5e6"}};
}

}  // namespace ehl::program
