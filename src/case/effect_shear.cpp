// Oil that thins where it is sheared.
#include <fmt/core.h>

#include "base/text_format.hpp"
#include "case/effects.hpp"
#include "case/sliding_input.hpp"
#include "rheology/shear_keys.hpp"

namespace ehl::program {
namespace {

std::string what(const Case& input) {
  const bool eyring = std::holds_alternative<rheology::Eyring>(input.scene.thinning->law);
  const double stress = deck::number(input.deck, "shear", eyring ? "tau_0" : "G");
  return (eyring ? "Eyring, tau_0 = " : "Carreau, G = ") + pressure(stress) +
         (eyring ? "" : fmt::format(", n = {:.4g}", std::get<rheology::Carreau>(input.scene.thinning->law).n)) +
         fmt::format(", slide-roll ratio {:.4g}: eta rate is {:.3g} of that stress at ambient pressure where H = 1",
                     input.physics.srr, input.scene.thinning->k);
}

std::string idle(const Case& input) {
  const bool one_of_a_curve = input.friction || input.heat;  // srr = 0 is a point of a traction curve
  if (input.scene.thinning->k == 0.0 && !one_of_a_curve)
    return "the surfaces do not slide (srr = 0), and the laws thin an oil that sliding shears: remove [shear], or give "
           "[motion] srr, or u1 and u2 that differ";
  const auto* carreau = std::get_if<rheology::Carreau>(&input.scene.thinning->law);
  return carreau && carreau->n == 1.0 ? "n = 1 is a Newtonian oil" : "";
}

// A second epsilon on every level, and the laws' roots and logarithms in every sweep.
Needs expense(const Case& input) {
  const core::Grid& grid = input.scene.grid;
  constexpr double fields = 4.0 / 3.0;
  constexpr double share = 0.15;  // of the time of the basic model
  return {.bytes = fields * sizeof(double) * grid.nodes_x() * grid.nodes_y(),
          .seconds = share * basic_needs(input.scene).seconds};
}

}  // namespace

Effect shear_effect() {
  return {.name = "shear",
          .meaning = "Oil that thins where sliding shears it: in the film, and in the friction.",
          .stage = Stage::coefficients,
          .without = "Newtonian",
          .sections = {{.name = "shear", .called_by = {"law"}}},
          .keys = rheology::shear_keys,
          .read = [](Case& input) { input.scene.thinning = shear_input(input.deck, input.physics); },
          .on = [](const Case& input) { return input.scene.thinning.has_value(); },
          .what = what,
          .idle = idle,
          .expense = expense,
          // Part of every evaluation of the film: it has no clock of its own.
          .seconds = nullptr,
          .example = {"motion.srr=0.5", "contact.a_over_R=0.01", "shear.law=eyring", "shear.tau_0=5e6"}};
}

}  // namespace ehl::program
