// Keys of [bearing], and the numbers that follow from them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "deck/record.hpp"
#include "machines/bearing.hpp"
#include "machines/keys.hpp"

namespace ehl::machines {
namespace {

deck::Records<Bearing> geometry_records() {
  using namespace deck::record;
  const deck::Condition ball{.name = "kind", .words = {ball_race}, .section = "case"};
  const deck::Condition roller{.name = "kind", .words = {roller_race}, .section = "case"};
  return {key("diameter", &Bearing::diameter, required("the contact is computed from it"), unit("m"), positive,
              example("9.525e-3"), "Diameter D of the ball or roller."),
          key("pitch_diameter", &Bearing::pitch_diameter, required("the contact is computed from it"), unit("m"),
              positive, example("46e-3"),
              "Pitch diameter d_m: the diameter of the circle through the centres of the balls or rollers, nearly the "
              "mean of bore and outside diameter."),
          key("race", &Bearing::race, {{"inner", Race::inner}, {"outer", Race::outer}}, own_default,
              "Race whose contact is computed."),
          key("conformity", Range{0.5, 1.0, true, false}, by_default("0.52"), ball,
              "Groove conformity f: radius of the groove over the diameter of the ball.",
              remedy("the groove is wider than the ball: usually 0.515 to 0.53"),
              source("ISO 281: at most 0.52 for the ratings of ball bearings")),
          key("contact_angle", &Bearing::contact_angle, unit("degrees"), Range{0.0, 90.0, false, true}, by_default("0"),
              ball, "Contact angle alpha between the load on the ball and the radial plane, equal at both races."),
          key("length", unit("m"), positive, roller, required("the length of the roller that carries its load"),
              example("10e-3"), "Length of a cylindrical roller that touches the race.")};
}

deck::Records<Bearing> load_records() {
  using namespace deck::record;
  const deck::Condition radial{.name = "radial_load"};
  return {
      key("load", required("give it, or radial_load and elements"), unit("N"), positive, example("500"),
          "Load Q on the ball or roller, instead of radial_load."),
      key("radial_load", instead_of({"load"}), unit("N"), positive, example("1000"),
          "Radial load F_r on the bearing, instead of load. The loads Q of the balls or rollers follow from static "
          "equilibrium with rigid rings and no clearance; Q grows with the power 3/2 of the deflection for balls and "
          "10/9 for rollers.",
          source("Stribeck 1901; Palmgren 1959")),
      key("elements", integer, Range{3, 1000}, radial,
          required("the number of balls or rollers that carry the radial load"), example("9"),
          "Number Z of balls or rollers."),
      key("azimuth", unit("degrees"), Range{-180.0, 180.0}, by_default("0"), radial,
          "Angle between the ball or roller and the direction of the radial load. At 0 it carries the largest load.")};
}

deck::Records<Bearing> speed_records() {
  using namespace deck::record;
  constexpr Range rpm{-1e6, 1e6};
  return {key("rpm_inner", unit("1/min"), rpm, example("3000"),
              "Speed of the inner ring. If one ring speed is given, the other ring stands still; otherwise give two of "
              "rpm_inner, rpm_outer and rpm_cage."),
          key("rpm_outer", unit("1/min"), rpm, example("0"),
              "Speed of the outer ring, positive in the same sense of rotation as the inner ring."),
          key("rpm_cage", unit("1/min"), rpm, example("1200"),
              "Speed of the cage. It follows from the speeds of both rings, or replaces one of them.")};
}

deck::Records<Bearing> records() {
  return deck::only_with<Bearing>(
      {.name = "kind", .words = {ball_race, roller_race}, .section = "case"},
      deck::together<deck::Record<Bearing>>({geometry_records(), load_records(), speed_records()}));
}

Turning read_turning(const deck::Part& bearing) {
  const std::vector<std::string> given = bearing.given_of({"rpm_inner", "rpm_outer", "rpm_cage"});
  if (given.empty()) bearing.complain("rpm_inner", "is missing: give the speed of a ring", deck::Cause::missing);
  if (given.size() == 3) bearing.complain("rpm_cage", "follows from rpm_inner and rpm_outer: keep two of the three");
  if (given == std::vector<std::string>{"rpm_cage"})
    bearing.complain(
        "rpm_cage",
        "does not determine which ring turns: give rpm_inner or rpm_outer as well, 0 for a ring that stands");
  if (given == std::vector<std::string>{"rpm_inner"}) bearing.follow("rpm_outer", 0.0, "the ring stands still");
  if (given == std::vector<std::string>{"rpm_outer"}) bearing.follow("rpm_inner", 0.0, "the ring stands still");
  return {bearing.number("rpm_inner"), bearing.number("rpm_outer"), bearing.number("rpm_cage")};
}

void check_space(const deck::Part& bearing, const Bearing& given) {
  const int elements = bearing.integer("elements", 0);
  // The pitch diameter must leave room for the inner race, which every bearing has, and for more than one element.
  if (!(given.diameter < given.pitch_diameter))
    bearing.complain("diameter", "leaves no room for a race within the circle of diameter pitch_diameter");
  else if (elements > 1 && given.diameter > given.pitch_diameter * std::sin(core::pi / elements))
    bearing.complain(
        "elements",
        fmt::format("this number of elements of diameter {:g} m does not fit on a circle of diameter {:g} m",
                    given.diameter, given.pitch_diameter));
}

// True if both rings turn at the same speed, up to rounding, because one speed may have been computed from the cage's.
bool turn_alike(const Turning& turning) {
  constexpr double rounding = 1e-12;
  return std::abs(turning.inner - turning.outer) <=
         rounding * std::max(std::abs(turning.inner), std::abs(turning.outer));
}

void add_shape(const deck::Part& bearing, const Bearing& given, bool ball, std::vector<Number>& numbers) {
  const bool inner = given.race == Race::inner;
  numbers.push_back({"gamma", gamma(given), "-", "D cos(alpha)/d_m"});
  numbers.push_back(
      {"race_radius", race_radius(given), "m",
       inner ? "(d_m/cos(alpha) - D)/2, in the plane of rolling" : "(d_m/cos(alpha) + D)/2, in the plane of rolling"});
  numbers.push_back(
      {"radius_x", radius_along(given), "m",
       inner ? "1/R_x = 2/D + 1/race_radius, so D (1 - gamma)/2" : "1/R_x = 2/D - 1/race_radius, so D (1 + gamma)/2"});
  if (!ball) return;
  const double conformity = bearing.number("conformity");
  numbers.push_back({"groove_radius", conformity * given.diameter, "m", "f D"});
  numbers.push_back(
      {"radius_y", radius_across(given.diameter, conformity), "m", "1/R_y = 2/D - 1/groove_radius, so D f/(2 f - 1)"});
}

void add_speeds(const Bearing& given, const Turning& turning, std::vector<Number>& numbers) {
  numbers.push_back({"rpm_inner", turning.inner, "1/min", "speed of the inner ring"});
  numbers.push_back({"rpm_outer", turning.outer, "1/min", "speed of the outer ring"});
  numbers.push_back(
      {"rpm_cage", turning.cage, "1/min", "[rpm_inner (1 - gamma) + rpm_outer (1 + gamma)]/2, rolling without slip"});
  const double speed = rolling_speed(given, turning);
  numbers.push_back({"u1", speed, "m/s", "(pi/120) d_m (1 - gamma^2) |rpm_inner - rpm_outer|, past the cage"});
  numbers.push_back({"u2", speed, "m/s", "u1, rolling without slip"});
}

// Load of the element: its part of a radial load, or as given.
double add_load(const deck::Part& bearing, bool ball, std::vector<Number>& numbers) {
  if (!bearing.given("radial_load")) return bearing.number("load");
  const RadialLoad radial{bearing.number("radial_load"), bearing.integer("elements", 0), bearing.number("azimuth"),
                          ball ? exponent_of_balls : exponent_of_rollers};
  const std::vector<double> loads = element_loads(radial);
  numbers.push_back({"loaded_elements",
                     static_cast<double>(std::ranges::count_if(loads, [](double Q) { return Q > 0.0; })), "-",
                     "number of balls or rollers that the ring approaches"});
  numbers.push_back({"load_factor", loads.front() * radial.elements / radial.load, "-",
                     std::string("Z Q/F_r by sum Q_j cos(psi_j) = F_r, sum Q_j sin(psi_j) = 0, Q_j = K delta_j^") +
                         (ball ? "(3/2)" : "(10/9)") + ", no clearance (Stribeck)"});
  if (!(loads.front() > 0.0)) bearing.complain("azimuth", "at this angle the ball or roller carries no load");
  return loads.front();
}

}  // namespace

std::vector<deck::Key> bearing_keys() { return deck::keys_of("bearing", records()); }

Contact read_bearing(const deck::Part& bearing, bool ball) {
  Contact contact{.section = "bearing",
                  .what = (ball ? "ball on the " : "roller on the ") + bearing.word("race") + " race"};
  const Bearing given = deck::read(bearing, records());
  const Turning turning_given = read_turning(bearing);
  if (ball && bearing.given("radial_load") && given.contact_angle > 0.0)
    bearing.complain("radial_load",
                     "implies an axial load if there is a contact angle: give load, that on the ball, instead");
  if (bearing.deck.errors.empty()) check_space(bearing, given);
  if (!bearing.deck.errors.empty()) return contact;

  std::vector<Number>& numbers = contact.numbers;
  add_shape(bearing, given, ball, numbers);
  const Turning turning = complete(turning_given, gamma(given));
  add_speeds(given, turning, numbers);
  if (turn_alike(turning)) bearing.complain("rpm_inner", "and rpm_outer are equal: nothing rolls");
  const double load = add_load(bearing, ball, numbers);
  numbers.push_back({"load", load, "N", bearing.given("load") ? "as given" : "load_factor F_r/Z"});
  if (!ball) numbers.push_back({"load_per_length", load / bearing.number("length"), "N/m", "load/length"});
  return contact;
}

}  // namespace ehl::machines
