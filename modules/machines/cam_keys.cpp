// Keys of [cam], and the numbers and the course that follow from them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "deck/file.hpp"
#include "deck/record.hpp"
#include "machines/cam.hpp"
#include "machines/course.hpp"
#include "machines/keys.hpp"

namespace ehl::machines {
namespace {

constexpr double revolution = 2.0 * core::pi;
constexpr double rounding = 1e-6;  // of angles and lifts in a table

deck::Records<Cam> records() {
  using namespace deck::record;
  const char* const computed_from_it = "the contact is computed from it";
  return deck::only_with<Cam>(
      {.name = "kind", .words = {cam_and_tappet}, .section = "case"},
      {key("base_radius", &Cam::base_radius, required(computed_from_it), unit("m"), positive, example("17e-3"),
           "Radius of the base circle, on which the lift is 0."),
       key("lift", file, required(computed_from_it), example("lift.csv"),
           "Text file with the columns angle [degrees] and lift [m], with other units if the heading names them: one "
           "revolution, whose last row repeats the first; or the part of it in which the tappet moves, with lift 0 at "
           "both ends. A third column load [N] replaces the spring. A cubic spline gives the curvature of the cam, so "
           "the lift needs enough digits: the report estimates the error.",
           source("Dyson and Naylor 1960")),
       key("face_width", required(computed_from_it), unit("m"), positive, example("12e-3"),
           "Width over which cam and tappet touch."),
       key("rpm", required(computed_from_it), unit("1/min"), up_to(1e6), example("1000"),
           "Speed of the camshaft. The angle of the table rises with time."),
       key("spring_force", &Cam::spring_force, unit("N"), not_negative, example("200"), otherwise("0"),
           "Force of the spring where the lift is 0."),
       key("spring_stiffness", &Cam::spring_stiffness, unit("N/m"), not_negative, example("30e3"), otherwise("0"),
           "Stiffness of the spring: the load is spring_force + spring_stiffness lift + mass (acceleration of the "
           "lift)."),
       key("mass", &Cam::mass, unit("kg"), not_negative, example("0.15"), otherwise("0"),
           "Mass that moves with the tappet."),
       key("angle", unit("degrees"), Range{-360.0, 720.0}, otherwise("the first of the table"), example("0"),
           "Angle of the cam whose contact is computed; in time, the state whose scales the results have and at which "
           "the course begins. The mean speed must be positive there."),
       key("states", integer, Range{12, 3600}, by_default("180"), in_time,
           "Number of states in one revolution, between which a course in time is linear.")});
}

// The rows of the lift table; without rows after an error.
deck::ColumnTable read_rows(const deck::Part& cam) {
  const deck::ReadColumns read = deck::read_columns(
      deck::found_beside(cam.deck, cam.section, "lift"),
      {{{"angle", "phi"}, "degrees"}, {{"lift", "s"}, "m"}, {{"load"}, "N", false}}, " ([cam] lift)");
  if (const auto* wrong = std::get_if<std::string>(&read)) {
    cam.complain("lift", *wrong);
    return {};
  }
  const auto& table = std::get<deck::ColumnTable>(read);
  const auto& rows = table.rows;
  const auto refuse = [&](const std::string& what) {
    cam.complain("lift", what);
    return deck::ColumnTable{};
  };
  constexpr std::size_t fewest = 8;
  if (rows.size() < fewest) return refuse(fmt::format("has {} rows; at least {} are needed", rows.size(), fewest));
  for (std::size_t k = 1; k < rows.size(); ++k)
    if (!(rows[k].values[0] > rows[k - 1].values[0])) return refuse(rows[k].place + ": the angle does not rise");
  const double span = rows.back().values[0] - rows.front().values[0];
  if (span > 360.0 + rounding) return refuse(fmt::format("has {:g} degrees, more than one revolution", span));
  return table;
}

// The cam with its lift; the spline is empty after an error.
Cam with_lift(const deck::Part& part, Cam cam) {
  const deck::ColumnTable table = read_rows(part);
  if (table.rows.empty()) return cam;
  std::vector<double> angles, lifts, loads;
  for (const deck::ColumnRow& row : table.rows) {
    angles.push_back(row.values[0] * degree);
    lifts.push_back(row.values[1]);
    loads.push_back(row.values[2]);
  }
  const double size = rounding * std::abs(std::ranges::max(lifts, {}, [](double s) { return std::abs(s); }));
  const bool whole = angles.back() - angles.front() > (360.0 - rounding) * degree;
  if (whole && std::abs(lifts.back() - lifts.front()) > size)
    part.complain("lift",
                  fmt::format("the last row must repeat the first after one revolution, but their lifts are {:g} "
                              "and {:g} m",
                              lifts.back(), lifts.front()));
  else if (!whole && std::max(std::abs(lifts.front()), std::abs(lifts.back())) > size)
    part.complain("lift",
                  "the lift must be 0 in the first and in the last row, because the table is shorter than a "
                  "revolution; or let the last row repeat the first after 360 degrees");
  if (whole) angles.back() = angles.front() + revolution;
  cam.lift = whole ? periodic_spline(angles, lifts) : clamped_spline(angles, lifts);
  if (!table.present[2]) {
    part.demand({"spring_force"}, "the lift table has no column load: give the spring");
    return cam;
  }
  part.refuse({"spring_force", "spring_stiffness", "mass"}, "the lift table has a column load: remove one of them");
  if (loads.back() != loads.front())
    part.complain("lift", fmt::format("the loads of the first and the last row must be equal, but are {:g} and {:g} N",
                                      loads.front(), loads.back()));
  cam.load = Spline{angles, loads, std::vector<double>(loads.size(), 0.0)};
  return cam;
}

CourseState course_state(const Cam& cam, double angle, double omega, double face_width, double t) {
  const CamState state = state_at(cam, angle, omega);
  return {fmt::format("the cam at {:.6g} degrees", angle / degree),
          t,
          state.R,
          state.load / face_width,
          state.u1,
          state.u2};
}

// Reports a state in which cam and tappet cannot touch, and a lift whose radius of curvature is not known.
void check_states(const deck::Part& cam, const std::vector<CourseState>& states, double error_of_curvature) {
  constexpr double most_error = 0.2;
  const CourseState& sharpest = std::ranges::min(states, {}, &CourseState::radius_x);
  const CourseState& lightest = std::ranges::min(states, {}, &CourseState::load);
  if (!(sharpest.radius_x > 0.0))
    cam.complain("lift", fmt::format("{}: the radius of curvature is {:.4g} m, and a flat tappet touches convex flanks "
                                     "only; the base circle is too small, or the lifts have too few digits",
                                     sharpest.place, sharpest.radius_x));
  else if (error_of_curvature > most_error * sharpest.radius_x)
    cam.complain("lift",
                 fmt::format("the second derivative of the lift is uncertain by {:.2g} m, where the least radius of "
                             "curvature is {:.2g} m: give more digits, or rows closer to each other",
                             error_of_curvature, sharpest.radius_x));
  if (!(lightest.load > 0.0))
    cam.complain(cam.given("spring_force") ? "spring_force" : "lift",
                 fmt::format("{}: the load is {:.4g} N, so the tappet lifts off: use a stronger spring, less mass or a "
                             "lower speed",
                             lightest.place, lightest.load * cam.number("face_width")));
}

// Reports a state of [contact] and [motion] that draws the oil in from the other side, as near the nose.
void check_entrainment(const deck::Part& cam, const std::vector<CourseState>& states, const CamState& at_angle) {
  if (at_angle.u1 + at_angle.u2 > 0.0) return;
  const CourseState& fastest = std::ranges::max(states, {}, [](const CourseState& one) { return one.u1 + one.u2; });
  cam.complain("angle",
               fmt::format("there the entrainment is u1 + u2 = {:.4g} m/s, and the oil must enter at negative x: give "
                           "another angle, as of {}; [transient] cycle = machine with mode = both computes the states "
                           "of all angles",
                           at_angle.u1 + at_angle.u2, fastest.place));
}

// The largest error of a course that is linear between the states, at their middles: of the radius and of u1 + u2, over
// the range of each.
double error_of_states(const Cam& cam, const std::vector<CourseState>& states, double start, double omega) {
  const auto sum = [](const CourseState& one) { return one.u1 + one.u2; };
  const auto [sharp, flat] = std::ranges::minmax(states, {}, &CourseState::radius_x);
  const auto [slow, fast] = std::ranges::minmax(states, {}, sum);
  double worst = 0.0;
  for (std::size_t k = 1; k < states.size(); ++k) {
    const CourseState &before = states[k - 1], &after = states[k];
    const double share = (static_cast<double>(k) - 0.5) / static_cast<double>(states.size() - 1);
    const CamState middle = state_at(cam, start + share * revolution, omega);
    const double of_radius = middle.R - 0.5 * (before.radius_x + after.radius_x);
    const double of_speed = middle.u1 + middle.u2 - 0.5 * (sum(before) + sum(after));
    worst = std::max(
        {worst, std::abs(of_radius) / (flat.radius_x - sharp.radius_x), std::abs(of_speed) / (sum(fast) - sum(slow))});
  }
  return worst;
}

}  // namespace

std::vector<deck::Key> cam_keys() { return deck::keys_of("cam", records()); }

Contact read_cam(const deck::Part& part) {
  Contact contact{.section = "cam", .what = "cam and flat tappet"};
  const Cam given = deck::read(part, records());
  const double rpm = part.number("rpm"), width = part.number("face_width"), asked = part.number("angle");
  const int count = part.integer("states", 0);
  if (!part.deck.errors.empty()) return contact;
  const Cam cam = with_lift(part, given);
  if (!part.deck.errors.empty()) return contact;

  const double omega = rpm * core::pi / 30.0, period = 60.0 / rpm;
  part.follow("angle", cam.lift.x.front() / degree, "the first angle of the table");
  const double start = part.given("angle") ? asked * degree : cam.lift.x.front();
  std::vector<CourseState> states;
  for (int k = 0; k <= count; ++k) {
    const double share = static_cast<double>(k) / count;
    states.push_back(course_state(cam, start + (k < count ? share : 0.0) * revolution, omega, width, share * period));
  }
  check_states(part, states, error_of_second(cam));
  check_entrainment(part, states, state_at(cam, start, omega));
  if (!part.deck.errors.empty()) return contact;
  contact.course = course_of(states);

  const CamState at_angle = state_at(cam, start, omega);
  contact.numbers = {{"period", period, "s", "60/rpm"},
                     {"largest_lift", std::ranges::max(cam.lift.y), "m", "of the table"},
                     {"error_of_curvature", error_of_second(cam), "m",
                      "of s\" = d2s/dphi2, from a spline through every second row of the table"},
                     {error_of_course, error_of_states(cam, states, start, omega), "-",
                      "of radius_x and u1 + u2 in the middle between two states, over their ranges"},
                     {"lift_here", at_angle.lift, "m", "s at the angle"},
                     {"radius_x", at_angle.R, "m", "base_radius + s + s\" (Dyson and Naylor 1960)"},
                     {"u1", at_angle.u1, "m/s", "(pi rpm/30) radius_x, of the cam past the contact"},
                     {"u2", at_angle.u2, "m/s", "(pi rpm/30) s\", of the tappet past the contact"},
                     {"load", at_angle.load, "N",
                      cam.load ? "of the table" : "spring_force + spring_stiffness s + mass (pi rpm/30)^2 s\""},
                     {"load_per_length", at_angle.load / width, "N/m", "load/face_width"}};
  for (Number& one : extremes_of(states, true)) contact.numbers.push_back(std::move(one));
  return contact;
}

}  // namespace ehl::machines
