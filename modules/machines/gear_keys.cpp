// Keys of [gear], and the numbers that follow from them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "deck/record.hpp"
#include "machines/course.hpp"
#include "machines/gear.hpp"
#include "machines/keys.hpp"

namespace ehl::machines {
namespace {

const char* const computed_from_it = "the contact is computed from it";

deck::Records<Gears> wheel_records() {
  using namespace deck::record;
  return {key("module", &Gears::module, required(computed_from_it), unit("m"), positive, example("4e-3"),
              "Module m of both wheels."),
          key("teeth1", &Gears::teeth1, required(computed_from_it), Range{3, 10000}, example("24"),
              "Number of teeth z1 of wheel 1, the driving wheel. Contact begins at the root of its teeth."),
          key("teeth2", &Gears::teeth2, required(computed_from_it), Range{3, 10000}, example("48"),
              "Number of teeth z2 of wheel 2."),
          key("pressure_angle", &Gears::pressure_angle, unit("degrees"), Range{5.0, 45.0}, by_default("20"),
              "Pressure angle alpha of the basic rack.", source("ISO 53")),
          key("shift1", &Gears::shift1, Range{-2.0, 2.0}, own_default,
              "Profile shift coefficient x1. The tips are shortened so that the tip clearance stays the same."),
          key("shift2", &Gears::shift2, Range{-2.0, 2.0}, own_default, "Profile shift coefficient x2."),
          key("addendum", &Gears::addendum, up_to(3.0), by_default("1"),
              "Addendum over the module, before the change by profile shift.", source("ISO 53"))};
}

deck::Records<Gears> mesh_records() {
  using namespace deck::record;
  return {
      key("face_width", required(computed_from_it), unit("m"), positive, example("20e-3"),
          "Face width b over which the teeth touch."),
      key("power", required("give it, or torque1"), unit("W"), positive, example("10e3"), "Power, instead of torque1."),
      key("torque1", instead_of({"power"}), unit("N m"), positive, example("64"),
          "Torque on wheel 1, instead of power."),
      key("rpm1", required(computed_from_it), unit("1/min"), up_to(1e6), example("1500"),
          "Speed of rotation of wheel 1."),
      key("position", Range{0.0, 1.0}, example("0.5"), otherwise("the pitch point, if it lies on the path of contact"),
          "Point of contact on the path of contact. 0: contact begins, at the tip of wheel 2. 1: contact ends, at the "
          "tip of wheel 1. In time, the state whose scales the results have; the course is the whole path."),
      key("sharing", by_default("linear"), words({"none", "linear"}),
          "How two pairs of teeth share the load. linear: equal stiffness and no tip relief: the share rises from 1/3 "
          "at the beginning of contact to 2/3, is 1 while one pair is alone, and falls from 2/3 to 1/3 at the end; for "
          "a contact ratio below 2. none: every pair carries the whole load.",
          source("AGMA 925-A03; ISO/TS 6336-20")),
      key("transition", Range{1e-4, 0.1}, by_default("0.01"), in_time,
          "Part of the path on which the load changes, in a course in time, where the next pair of teeth begins to "
          "carry and where the last one ceases to: 2/3 to 1 and 1 to 2/3 of the load."),
      key("states", integer, Range{12, 3600}, by_default("100"), in_time,
          "Number of states along the path, between which a course in time is linear.")};
}

deck::Records<Gears> records() {
  return deck::only_with<Gears>({.name = "kind", .words = {gear_mesh}, .section = "case"},
                                deck::together<deck::Record<Gears>>({wheel_records(), mesh_records()}));
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
                fmt::format("is missing: its default, the pitch point, is not on the path of contact but at {:.4g} of "
                            "it, where the teeth do not touch; give a position of 0 to 1",
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

// What follows from the keys of the load.
struct Drive {
  double omega1, torque, normal_force, face_width;
  Sharing sharing;
  bool by_power;
};

Drive drive_of(const deck::Part& gear, const PathOfContact& path) {
  const double omega1 = gear.number("rpm1") * core::pi / 30.0;
  const bool by_power = gear.given("power");
  const double power = gear.number("power"), given_torque = gear.number("torque1");
  const double torque = by_power ? power / omega1 : given_torque;
  return {omega1,
          torque,
          torque / path.base_radius1,
          gear.number("face_width"),
          gear.choice("sharing", {Sharing::none, Sharing::linear}),
          by_power};
}

// in: s, the contact point, from T1.
std::vector<Number> mesh_numbers(const Gears& gears, const PathOfContact& path, const Drive& drive, double s) {
  const Mesh mesh = mesh_at(gears, path, s, drive.omega1);
  const double of_pair = share(path, s, drive.sharing), load = of_pair * drive.normal_force;
  return {{"rho1", mesh.rho1, "m", "radius of curvature of tooth 1, s_begin + position (s_end - s_begin)"},
          {"rho2", mesh.rho2, "m", "radius of curvature of tooth 2, length_T1T2 - rho1"},
          {"radius_x", mesh.R, "m", "rho1 rho2/(rho1 + rho2)"},
          {"u1", mesh.u1, "m/s", "rho1 pi rpm1/30"},
          {"u2", mesh.u2, "m/s", "rho2 (z1/z2) pi rpm1/30"},
          {"sliding_speed", mesh.u1 - mesh.u2, "m/s", "u1 - u2, zero at the pitch point"},
          {"torque1", drive.torque, "N m", drive.by_power ? "power/(pi rpm1/30)" : "as given"},
          {"normal_force", drive.normal_force, "N", "torque1/base_radius1, of all pairs together"},
          {"share", of_pair, "-",
           drive.sharing == Sharing::linear ? "share of this pair of teeth, by AGMA 925-A03 with sharing = linear"
                                            : "1: with sharing = none every pair carries the whole load"},
          {"load", load, "N", "share times normal_force"},
          {"load_per_length", load / drive.face_width, "N/m", "load/face_width"}};
}

// The share of the load along the path, with ramps of the given length instead of the steps at B and D.
double share_in_time(const PathOfContact& path, double s, Sharing sharing, double ramp) {
  if (sharing == Sharing::none) return 1.0;
  for (const auto& [step, outwards] : {std::pair{path.B, -0.5 * ramp}, {path.D, 0.5 * ramp}}) {
    if (std::abs(s - step) >= 0.5 * ramp) continue;
    const double outside = share(path, step + outwards, sharing);
    return outside + (1.0 - outside) * std::abs(s - step - outwards) / ramp;
  }
  return share(path, s, sharing);
}

// The states of one pair of teeth from the beginning of its contact to the end.
std::vector<CourseState> path_states(const deck::Part& gear, const Gears& gears, const PathOfContact& path,
                                     const Drive& drive) {
  const double length = path.E - path.A, ramp = gear.number("transition") * length;
  const int count = gear.integer("states", 0);
  if (drive.sharing == Sharing::none)
    gear.refuse({"transition"}, "has no influence with sharing = none: remove it", deck::Cause::idle);
  std::vector<double> places;
  for (int k = 0; k <= count; ++k) places.push_back(path.A + length * k / count);
  if (drive.sharing == Sharing::linear) {
    if (!(ramp < std::min(path.D - path.B, path.B - path.A)))
      gear.complain("transition",
                    fmt::format("is longer than the part of the path with one pair of teeth, {:.4g}, or than that with "
                                "two, {:.4g}",
                                (path.D - path.B) / length, (path.B - path.A) / length));
    const auto near = [&](double s) {
      return std::abs(s - path.B) <= 0.5 * ramp || std::abs(s - path.D) <= 0.5 * ramp;
    };
    std::erase_if(places, near);
    for (const double step : {path.B, path.D})
      for (const double side : {-0.5, 0.5}) places.push_back(step + side * ramp);
    std::ranges::sort(places);
  }
  std::vector<CourseState> states;
  for (const double s : places) {
    const Mesh mesh = mesh_at(gears, path, s, drive.omega1);
    const double load = share_in_time(path, s, drive.sharing, ramp) * drive.normal_force / drive.face_width;
    states.push_back({fmt::format("{:.4g} of the path of contact", (s - path.A) / length),
                      (s - path.A) / (drive.omega1 * path.base_radius1), mesh.R, load, mesh.u1, mesh.u2});
  }
  return states;
}

}  // namespace

std::vector<deck::Key> gear_keys() { return deck::keys_of("gear", records()); }

Contact read_gear(const deck::Part& gear) {
  Contact contact{.section = "gear", .what = "teeth of two spur gears", .repeats = false};
  const Gears gears = deck::read(gear, records());
  if (!gear.deck.errors.empty()) return contact;
  const PathOfContact path = path_of_contact(gears);
  check_path(gear, path, gear.word("sharing") == "linear");
  if (!gear.deck.errors.empty()) return contact;
  if (!gear.given("position")) check_pitch_point(gear, path);
  if (!gear.deck.errors.empty()) return contact;
  std::vector<Number>& numbers = contact.numbers;
  numbers = path_numbers(path);
  gear.follow("position", numbers.back().value, "the pitch point");
  const double s = path.A + gear.number("position") * (path.E - path.A);
  const Drive drive = drive_of(gear, path);
  for (Number& one : mesh_numbers(gears, path, drive, s)) numbers.push_back(std::move(one));
  if (deck::has_influence(gear.deck, gear.key("states")))
    contact.course = course_of(path_states(gear, gears, path, drive));
  return contact;
}

}  // namespace ehl::machines
