// Keys of [gear], and the numbers that follow from them.
#include <fmt/format.h>

#include <cmath>

#include "core/constants.hpp"
#include "machines/gear.hpp"
#include "machines/keys.hpp"

namespace ehl::machines {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr deck::Range positive{0.0, infinity, true, true};

std::vector<deck::Key> wheel_keys() {
  const auto teeth = [](const char* name, const char* meaning, const char* example) {
    return deck::Key{
        .name = name, .type = deck::Type::integer, .range = {3, 10000}, .meaning = meaning, .example = example};
  };
  const auto shift = [](const char* name, const char* meaning) {
    return deck::Key{.name = name, .default_text = "0", .range = {-2.0, 2.0}, .meaning = meaning};
  };
  return {
      {.name = "module", .unit = "m", .range = positive, .meaning = "Module m of both wheels.", .example = "4e-3"},
      teeth("teeth1", "Number of teeth z1 of wheel 1, the driving wheel. Contact begins at the root of its teeth.",
            "24"),
      teeth("teeth2", "Number of teeth z2 of wheel 2.", "48"),
      {.name = "pressure_angle",
       .default_text = "20",
       .unit = "degrees",
       .range = {5.0, 45.0},
       .meaning = "Pressure angle alpha of the basic rack.",
       .source = "ISO 53"},
      shift("shift1", "Profile shift coefficient x1. The tips are shortened so that the tip clearance stays the same."),
      shift("shift2", "Profile shift coefficient x2."),
      {.name = "addendum",
       .default_text = "1",
       .range = {0.0, 3.0, true, false},
       .meaning = "Addendum over the module, before the change by profile shift.",
       .source = "ISO 53"}};
}

std::vector<deck::Key> mesh_keys() {
  return {{.name = "face_width",
           .unit = "m",
           .range = positive,
           .meaning = "Face width b over which the teeth touch.",
           .example = "20e-3"},
          {.name = "power", .unit = "W", .range = positive, .meaning = "Power, instead of torque1.", .example = "10e3"},
          {.name = "torque1",
           .unit = "N m",
           .range = positive,
           .meaning = "Torque on wheel 1, instead of power.",
           .example = "64"},
          {.name = "rpm1",
           .unit = "1/min",
           .range = {0.0, 1e6, true, false},
           .meaning = "Speed of rotation of wheel 1.",
           .example = "1500"},
          {.name = "position",
           .default_note = "the pitch point, if it lies on the path of contact",
           .range = {0.0, 1.0},
           .meaning = "Point of contact on the path of contact. 0: contact begins, at the tip of wheel 2. 1: contact "
                      "ends, at the tip of wheel 1.",
           .example = "0.5"},
          {.name = "sharing",
           .default_text = "linear",
           .words = {"none", "linear"},
           .meaning = "How two pairs of teeth share the load. linear: equal stiffness and no tip relief: the share "
                      "rises from 1/3 at the beginning of contact to 2/3, is 1 while one pair is alone, and falls from "
                      "2/3 to 1/3 at the end; for a contact ratio below 2. none: every pair carries the whole load.",
           .source = "AGMA 925-A03; ISO/TS 6336-20"}};
}

void demand_all(const deck::Part& gear) {
  gear.demand({"module", "teeth1", "teeth2", "face_width", "rpm1"}, "the contact is computed from it");
  if (gear.given("power") && gear.given("torque1"))
    gear.complain("torque1", "power is given as well: keep one of them");
  if (!gear.given("power") && !gear.given("torque1"))
    gear.complain("power", "is missing: give it, or torque1", deck::Cause::missing);
}

// in: wheel, "1" or "2".
void check_tip(const deck::Part& gear, const std::string& wheel, double thickness) {
  if (thickness > 0.0) return;
  const std::string shift = "shift" + wheel;
  const bool shifted = gear.number(shift) > 0.0;
  gear.complain(shifted ? shift : "teeth" + wheel,
                fmt::format("the teeth of wheel {} would be pointed: their flanks meet below the tip circle, where the "
                            "tooth would be {:.4g} m thick; use {}less addendum, or more teeth",
                            wheel, thickness, shifted ? "less profile shift, " : ""));
}

void check_path(const deck::Part& gear, const PathOfContact& path, bool shared) {
  const auto interferes = [&](const char* wheel, const char* other) {
    gear.complain(std::string("teeth") + other,
                  std::string("the tip of wheel ") + wheel + " would touch wheel " + other +
                      " below its base circle (interference): use more teeth, more profile shift, or less addendum");
  };
  if (std::isnan(path.working_angle) || !(path.working_angle < 90.0))
    gear.complain(gear.given("shift1") ? "shift1" : "shift2",
                  "with this shift the wheels cannot mesh without backlash");
  else if (std::isnan(path.A) || std::isnan(path.E))
    gear.complain("addendum", "is too small: a tip does not reach the base circle of its wheel");
  else if (!(path.A > 0.0))
    interferes("2", "1");
  else if (!(path.E < path.length_T1T2))
    interferes("1", "2");
  else if (!(path.tip_thickness1 > 0.0 && path.tip_thickness2 > 0.0)) {
    check_tip(gear, "1", path.tip_thickness1);
    check_tip(gear, "2", path.tip_thickness2);
  } else if (!(path.contact_ratio >= 1.0))
    gear.complain(
        "addendum",
        fmt::format("the contact ratio is {:.4g}: below 1 a pair of teeth separates before the next one meets",
                    path.contact_ratio));
  else if (shared && path.contact_ratio >= 2.0)
    gear.complain("sharing", fmt::format("the contact ratio is {:.4g}, and this rule holds below 2: set sharing = none",
                                         path.contact_ratio));
}

// Checks the pitch point, which is the position if the deck gives none.
void check_pitch_point(const deck::Part& gear, const PathOfContact& path) {
  if (path.C >= path.A && path.C <= path.E) return;
  gear.complain("position",
                fmt::format("is missing: its default, the pitch point, is not on the path of contact but "
                            "at {:.4g} of it, where the teeth do not touch; give a position of 0 to 1",
                            (path.C - path.A) / (path.E - path.A)),
                deck::Cause::missing);
}

std::vector<Number> path_numbers(const PathOfContact& path) {
  const auto position = [&](double s) { return (s - path.A) / (path.E - path.A); };
  const bool alone = path.contact_ratio < 2.0;  // otherwise at least two pairs are always in contact
  return {
      {"working_angle", path.working_angle, "degrees",
       "inv(alpha_w) = inv(alpha) + 2 tan(alpha) (x1 + x2)/(z1 + z2), ISO 21771"},
      {"centre_distance", path.centre_distance, "m", "m (z1 + z2)/2 cos(alpha)/cos(alpha_w)"},
      {"base_radius1", path.base_radius1, "m", "m z1 cos(alpha)/2"},
      {"base_radius2", path.base_radius2, "m", "m z2 cos(alpha)/2"},
      {"tip_alteration", path.tip_alteration, "-",
       "k = centre_distance/m - (z1 + z2)/2 - (x1 + x2): the tip clearance stays the same"},
      {"tip_radius1", path.tip_radius1, "m", "m (z1/2 + addendum + x1 + k)"},
      {"tip_radius2", path.tip_radius2, "m", "m (z2/2 + addendum + x2 + k)"},
      {"tip_thickness1", path.tip_thickness1, "m",
       "2 tip_radius1 [(pi/2 + 2 x1 tan(alpha))/z1 + inv(alpha) - inv(alpha_a1)], cos(alpha_a1) = "
       "base_radius1/tip_radius1"},
      {"tip_thickness2", path.tip_thickness2, "m", "thickness of a tooth of wheel 2 at its tip, as for wheel 1"},
      {"base_pitch", path.base_pitch, "m", "pi m cos(alpha)"},
      {"length_T1T2", path.length_T1T2, "m", "centre_distance sin(alpha_w), between the base circles"},
      {"s_begin", path.A, "m", "from T1: length_T1T2 - sqrt(tip_radius2^2 - base_radius2^2)"},
      {"s_end", path.E, "m", "from T1: sqrt(tip_radius1^2 - base_radius1^2)"},
      {"contact_ratio", path.contact_ratio, "-", "(s_end - s_begin)/base_pitch"},
      {"position_alone_from", alone ? position(path.B) : core::unknown, "-",
       alone ? "one pair carries the whole load from s_end - base_pitch on" : "nowhere: two pairs touch everywhere"},
      {"position_alone_to", alone ? position(path.D) : core::unknown, "-",
       alone ? "one pair carries the whole load up to s_begin + base_pitch" : "nowhere: two pairs touch everywhere"},
      {"position_pitch_point", position(path.C), "-", "s = base_radius1 tan(alpha_w)"}};
}

// in: s, the contact point, from T1.
std::vector<Number> mesh_numbers(const deck::Part& gear, const Gears& gears, const PathOfContact& path, double s) {
  const double omega1 = gear.number("rpm1") * core::pi / 30.0;
  const Mesh mesh = mesh_at(gears, path, s, omega1);
  const bool by_power = gear.given("power");
  const double power = gear.number("power"), given_torque = gear.number("torque1");
  const double torque = by_power ? power / omega1 : given_torque;
  const double normal_force = torque / path.base_radius1;
  const Sharing sharing = gear.choice("sharing", {Sharing::none, Sharing::linear});
  const double of_pair = share(path, s, sharing);
  return {{"rho1", mesh.rho1, "m", "radius of curvature of tooth 1, s_begin + position (s_end - s_begin)"},
          {"rho2", mesh.rho2, "m", "radius of curvature of tooth 2, length_T1T2 - rho1"},
          {"radius_x", mesh.R, "m", "rho1 rho2/(rho1 + rho2)"},
          {"u1", mesh.u1, "m/s", "rho1 pi rpm1/30"},
          {"u2", mesh.u2, "m/s", "rho2 (z1/z2) pi rpm1/30"},
          {"sliding_speed", mesh.u1 - mesh.u2, "m/s", "u1 - u2, zero at the pitch point"},
          {"torque1", torque, "N m", by_power ? "power/(pi rpm1/30)" : "as given"},
          {"normal_force", normal_force, "N", "torque1/base_radius1, of all pairs together"},
          {"share", of_pair, "-",
           sharing == Sharing::linear ? "share of this pair of teeth, by AGMA 925-A03 with sharing = linear"
                                      : "1: with sharing = none every pair carries the whole load"},
          {"load", of_pair * normal_force, "N", "share times normal_force"},
          {"load_per_length", of_pair * normal_force / gear.number("face_width"), "N/m", "load/face_width"}};
}

}  // namespace

std::vector<deck::Key> gear_keys() {
  const deck::Condition gear{.name = "kind", .words = {gear_mesh}, .section = "case"};
  return deck::in_section("gear", deck::only_with(gear, deck::together({wheel_keys(), mesh_keys()})));
}

std::vector<Number> read_gear(const deck::Part& gear) {
  const Gears gears{gear.number("module"),         gear.integer("teeth1", 0), gear.integer("teeth2", 0),
                    gear.number("pressure_angle"), gear.number("shift1"),     gear.number("shift2"),
                    gear.number("addendum")};
  demand_all(gear);
  if (!gear.deck.errors.empty()) return {};
  const PathOfContact path = path_of_contact(gears);
  check_path(gear, path, gear.word("sharing") == "linear");
  if (!gear.deck.errors.empty()) return {};
  if (!gear.given("position")) check_pitch_point(gear, path);
  if (!gear.deck.errors.empty()) return {};
  std::vector<Number> numbers = path_numbers(path);
  gear.follow("position", numbers.back().value, "the pitch point");
  const double s = path.A + gear.number("position") * (path.E - path.A);
  for (Number& one : mesh_numbers(gear, gears, path, s)) numbers.push_back(std::move(one));
  return numbers;
}

}  // namespace ehl::machines
