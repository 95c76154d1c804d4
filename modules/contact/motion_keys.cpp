// Keys of [motion].
#include <cmath>

#include "contact/keys.hpp"
#include "deck/record.hpp"

namespace ehl::contact {

std::vector<deck::Key> motion_keys() {
  using namespace deck::record;
  constexpr Range speed{-1e6, 1e6};
  return {
      key("angle", unit("degrees"), Range{-90.0, 90.0}, example("45"), otherwise("0: along radius_x"),
          "Angle from the direction of radius_x to the rolling direction, for an elliptic contact; 90: rolling along "
          "radius_y. For other angles than 0 and 90 the contact is oblique and the whole domain is computed. x is "
          "always the rolling direction."),
      key("u1", unit("m/s"), speed, example("0.09"),
          "Surface speed of body 1. Give u1 and u2, or u_m and srr. The oil enters at negative x."),
      key("u2", unit("m/s"), speed, example("0.09"), "Surface speed of body 2."),
      key("u_m", unit("m/s"), up_to(1e6), example("0.09"), "Entrainment speed (u1 + u2)/2, instead of u1 and u2.",
          remedy("without entrainment there is no film")),
      key("srr", Range{-1e6, 1e6}, example("0.1"), otherwise("0"),
          "Slide-roll ratio (u1 - u2)/u_m. The film of a steady, smooth, isothermal, Newtonian contact does not depend "
          "on it. [shear] and [friction] use it, also when the contact is given by M and L or by W, U and G."),
  };
}

namespace {

void check_motion(const deck::Part& motion, Language language, bool slides) {
  if (language != Language::si) {
    const std::string why = "has no influence: a dimensionless contact already contains the speed; remove it";
    motion.refuse({"u1", "u2", "u_m"}, why, deck::Cause::idle);
    if (!slides) motion.refuse({"srr"}, why, deck::Cause::idle);
    return;
  }
  if (motion.given("u_m")) {
    motion.refuse({"u1", "u2"}, "u_m is given as well: keep either u1 and u2, or u_m and srr");
    return;
  }
  motion.refuse({"srr"}, "has no influence: it is used only with u_m; give u_m instead of u1 and u2, or remove it",
                deck::Cause::idle);
  if (motion.given_of({"u1", "u2"}).empty()) {
    motion.complain("u_m", "is missing: give the entrainment speed, or u1 and u2", deck::Cause::missing);
    return;
  }
  motion.demand({"u1", "u2"}, "u1 and u2 belong together (or give u_m)");
  const double sum = motion.number("u1") + motion.number("u2");
  if (!(sum > 0.0) && !std::isnan(sum))
    motion.complain(
        "u2", "u1 + u2 = " + deck::shortest(sum) + " m/s: the sum must be > 0, because the oil enters at negative x");
}

}  // namespace

void read_motion(const deck::Part& motion, bool slides, Input& input) {
  if (input.language != Language::none) check_motion(motion, input.language, slides);
  const double u_m = motion.number("u_m"), srr = motion.number("srr");
  if (motion.given("srr")) input.srr = srr;
  const bool mean = motion.given("u_m");
  input.u1 = mean ? u_m * (1.0 + 0.5 * input.srr) : motion.number("u1");
  input.u2 = mean ? u_m * (1.0 - 0.5 * input.srr) : motion.number("u2");
  input.u_s = mean ? 2.0 * u_m : input.u1 + input.u2;
}

}  // namespace ehl::contact
