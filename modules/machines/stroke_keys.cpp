// Keys of [stroke]: a body that moves to and fro, the motion of reciprocating rigs.
#include <fmt/format.h>

#include <cmath>

#include "core/constants.hpp"
#include "deck/record.hpp"
#include "machines/course.hpp"
#include "machines/keys.hpp"

namespace ehl::machines {
namespace {

struct Stroke {
  double length = 0.0;     // [m]
  double frequency = 0.0;  // [1/s]
  bool rolls = false;      // surface 2 moves as surface 1 does
};

deck::Records<Stroke> records() {
  using namespace deck::record;
  const char* const computed_from_it = "the speeds are computed from it";
  return deck::only_with<Stroke>(
      {.name = "kind", .words = {reciprocating}, .section = "case"},
      {key("length", &Stroke::length, required(computed_from_it), unit("m"), positive, example("4e-3"),
           "Stroke of body 1 between its turning points, twice the amplitude of its sine."),
       key("frequency", &Stroke::frequency, required(computed_from_it), unit("1/s"), up_to(1e6), example("10"),
           "Number of double strokes in a second."),
       key("second_body", &Stroke::rolls, {{"rests", false}, {"rolls", true}}, own_default,
           "rests: body 2 stands still in the contact, which slides (a clamped ball on a moving plate). rolls: body 2 "
           "turns freely about a fixed axis, with the speed of body 1."),
       key("states", integer, Range{12, 3600}, by_default("100"), in_time,
           "Number of states in one double stroke, between which a course in time is linear.")});
}

}  // namespace

std::vector<deck::Key> stroke_keys() { return deck::keys_of("stroke", records()); }

Contact read_stroke(const deck::Part& part) {
  const Stroke stroke = deck::read(part, records());
  const int count = part.integer("states", 0);
  Contact contact{
      .section = "stroke",
      .what = stroke.rolls ? "a body that rolls on a reciprocating one" : "a body at rest on a reciprocating one",
      .only_moves = true};
  if (!part.deck.errors.empty()) return contact;
  const double period = 1.0 / stroke.frequency, fastest = core::pi * stroke.frequency * stroke.length;
  std::vector<CourseState> states;
  for (int k = 0; k <= count; ++k) {
    const double share = static_cast<double>(k) / count;
    // Exactly zero at the turning points, and exactly periodic.
    const double quarters = 4.0 * share;
    const bool turns = quarters == 1.0 || quarters == 3.0;
    const double u = turns ? 0.0 : fastest * std::cos(2.0 * core::pi * (k < count ? share : 0.0));
    states.push_back({fmt::format("{:.4g} of the period after the middle of the stroke", share), share * period,
                      core::unknown, core::unknown, u, stroke.rolls ? u : 0.0});
  }
  contact.course = course_of(states);
  contact.numbers = {{"period", period, "s", "1/frequency"},
                     {"u1", fastest, "m/s", "pi frequency length, at the middle of the stroke"},
                     {"u2", stroke.rolls ? fastest : 0.0, "m/s", stroke.rolls ? "u1, rolling" : "body 2 rests"},
                     {"largest_acceleration", 2.0 * core::pi * stroke.frequency * fastest, "m/s^2",
                      "2 pi^2 frequency^2 length, at the turning points"}};
  return contact;
}

}  // namespace ehl::machines
