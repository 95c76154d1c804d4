// The effect `body`: a body that moves under the load and the film's pressure.
#include <fmt/core.h>

#include <numbers>

#include "case/effects.hpp"

namespace ehl::program {

Effect body_effect() {
  return {.name = "body",
          .meaning = "A body with mass that moves under the load and the film: impact, rebound, vibration.",
          .sections = {{.name = "body",
                        .meaning =
                            "Equation of motion of a body, instead of a prescribed load. Used only with [transient].",
                        .called_by = {"mass", "mass_kg"}}},
          .on = [](const Case& input) { return input.transient && input.transient->conditions.body; },
          .what =
              [](const Case& input) {
                const transient::Body& body = *input.transient->conditions.body;
                const std::string start = body.gap ? fmt::format("a gap of {:.4g}", *body.gap) : "the steady film";
                return fmt::format(
                    "mass {:.4g}, damping {:.4g}, starts from {} with velocity {:.4g}; {:.4g} vibrations per a/u_m on "
                    "the dry contact",
                    body.mass, body.damping, start, body.velocity,
                    transient::natural_frequency(body) / (2.0 * std::numbers::pi));
              },
          .example = {"body.mass=2"},
          .upon = "transient"};
}

}  // namespace ehl::program
