// The effect `elliptic`: bodies with two principal radii, and line contacts.
#include <fmt/core.h>

#include "case/effects.hpp"

namespace ehl::program {

Effect elliptic_effect() {
  return {
      .name = "elliptic",
      .meaning =
          "Contacts that are not circular: different radii along x and y, rolling at an angle to them, and line "
          "contacts.",
      .name_here =
          [](const Case& input) { return std::string(contact::line(input.scene.contact.shape) ? "line" : "elliptic"); },
      .without = "circular",
      .callers = {{"contact", "kind"}, {"contact", "radius_ratio"}, {"contact", "radius_y"}},
      .on = [](const Case& input) { return !contact::circular(input.scene.contact.shape) && !input.roller; },
      .what =
          [](const Case& input) {
            const contact::Ellipse& shape = input.scene.contact.shape;
            if (contact::line(shape)) return std::string("R_y infinite, nothing varies along y");
            return fmt::format("R_x/R_y = {:.4g}, b/a = {:.4g}, rolling at {:.4g} degrees to R_x", shape.radius_ratio,
                               shape.kappa, shape.angle);
          },
      .asymmetry =
          [](const Case& input) {
            const bool oblique = contact::gap(input.scene.contact.shape).oblique();
            return oblique ? fmt::format("rolling at {:.4g} degrees", input.scene.contact.shape.angle) : std::string();
          },
      .example = {"contact.radius_ratio=0.5"}};
}

}  // namespace ehl::program
