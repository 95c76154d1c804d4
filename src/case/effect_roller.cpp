// Rollers of finite length.
#include <fmt/core.h>

#include "case/effects.hpp"
#include "case/roller_input.hpp"
#include "effects/roller/keys.hpp"

namespace ehl::program {
namespace {

std::string what(const Case& input) {
  const roller::Profile& profile = *input.roller;
  const std::string tilt = profile.tilt != 0.0 ? fmt::format(", tilt dH/dY = {:.4g}", profile.tilt) : "";
  return fmt::format("{:.4g} half widths long, profile {}, {:.4g} a^2/R below the middle at the ends{}", profile.length,
                     deck::word(input.deck, "roller", "profile"), roller::drop(profile, 0.5 * profile.length), tilt);
}

std::string asymmetry(const Case& input) {
  if (input.roller->tilt != 0.0) return "it is tilted";
  return roller::symmetric(*input.roller) ? "" : "the table of its profile";
}

}  // namespace

Effect roller_effect() {
  return {.name = "roller",
          .meaning = "A roller of finite length: its profile along the axis, and its tilt.",
          .stage = Stage::coefficients,
          .sections = {{.name = "roller", .called_by = {"profile"}}},
          .keys = roller::keys,
          .read = roller_input,
          .on = [](const Case& input) { return input.roller.has_value(); },
          .what = what,
          .asymmetry = asymmetry,
          .example = {"contact.kind=roller", "contact.length=20", "roller.profile=logarithmic"}};
}

}  // namespace ehl::program
