#include "case/machine_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/constants.hpp"
#include "machines/keys.hpp"

namespace ehl::program {
namespace {

using Names = std::vector<std::string>;

bool is_among(const std::string& name, const Names& names) { return std::ranges::find(names, name) != names.end(); }

// True for the keys of the deck that describe the bodies; they are allowed with any machine.
bool of_the_bodies(const deck::Key& key) {
  static const Names names{"E1",
                           "nu1",
                           "E2",
                           "nu2",
                           "E_prime",
                           "Sq1",
                           "Sq2",
                           "coating1_E",
                           "coating1_nu",
                           "coating1_thickness",
                           "coating2_E",
                           "coating2_nu",
                           "coating2_thickness"};
  return key.section == "contact" && is_among(key.name, names);
}

// True for the keys whose values follow from the machine.
bool follows(const deck::Key& key, const std::string& kind) {
  if (kind == machines::impact)
    return (key.section == "contact" && is_among(key.name, {"load", "load_per_length"})) || key.section == "body" ||
           (key.section == "motion" && is_among(key.name, {"u1", "u2", "u_m", "srr"})) ||
           (key.section == "transient" && is_among(key.name, {"load", "load_wave", "cycle", "time_unit"}));
  if (kind == machines::reciprocating) return key.section == "motion" && is_among(key.name, {"u1", "u2", "u_m", "srr"});
  return (key.section == "contact" || key.section == "motion") && !of_the_bodies(key);
}

// A refused key is treated as absent, so that it causes no further messages.
void refuse_what_follows(deck::Deck& deck, const machines::Contact& machine) {
  const std::string kind = deck::word(deck, "case", "kind");
  for (std::size_t k = 0; k < deck.values.size(); ++k) {
    const deck::Key& key = deck.catalogue.keys[k];
    if (!follows(key, kind) || deck.values[k].origin != deck::Origin::given) continue;
    complain(deck, key.section, key.name,
             "[case] kind = " + kind + " computes it from [" + machine.section + "]: remove it");
    deck.values[k] = {};
  }
}

// NaN after an error.
double number_of(const machines::Contact& machine, const std::string& name) {
  const machines::Number* number = machines::find_number(machine, name);
  return number == nullptr ? core::unknown : number->value;
}

// Load, radii and speeds.
void compute_contact(deck::Deck& deck, const machines::Contact& machine, const std::string& kind) {
  const std::string& section = machine.section;
  const bool ball = kind == machines::ball_race;
  const bool with_ends = !ball && deck::given(deck, "roller", "profile");
  if (ball) {
    compute(deck, "motion", "angle", 0.0, section, "the ball rolls along radius_x");
    compute(deck, "contact", "kind", "point", section, "a ball in its groove");
  } else if (with_ends) {
    compute(deck, "contact", "kind", "roller", section, "[roller] gives it a profile");
    const std::string length = kind == machines::roller_race ? "length" : "face_width";
    compute(deck, "contact", "length_m", deck::number(deck, section, length), section, length);
  } else {
    compute(deck, "contact", "kind", "line", section, "straight flanks");
  }
  for (const auto& [part, name] : {std::pair{"contact", ball || with_ends ? "load" : "load_per_length"},
                                   {"contact", "radius_x"},
                                   {"contact", "radius_y"},
                                   {"motion", "u1"},
                                   {"motion", "u2"}})
    if (const machines::Number* number = machines::find_number(machine, name))
      compute(deck, part, name, number->value, section, number->formula);
}

// An impact is a body that moves in time under its inertia alone.
void compute_impact(deck::Deck& deck, const machines::Contact& machine) {
  const std::string& section = machine.section;
  const auto set = [&](const char* part, const char* name, double value, const char* why) {
    if (!deck::given(deck, part, name)) compute(deck, part, name, value, section, why);
  };
  set("contact", "load", number_of(machine, "load"), "largest load of the dry impact");
  for (const char* name : {"u1", "u2"}) {
    set("motion", name, number_of(machine, "reference_speed"), "reference_speed, for the scales");
    if (!deck::given(deck, "transient", name)) compute(deck, "transient", name, "0:0", section, "no rolling");
  }
  compute(deck, "transient", "time_unit", "seconds", section, "times in SI");
  set("transient", "end_time", number_of(machine, "end_time"), "gap/velocity + 1.5 dry_duration");
  compute(deck, "transient", "load", "0:0", section, "inertia is the only load");
  set("body", "mass_kg", deck::number(deck, section, "mass"), "mass");
  set("body", "gap_m", deck::number(deck, section, "gap"), "gap");
  set("body", "velocity_mps", -deck::number(deck, section, "velocity"), "velocity");
  const double far = number_of(machine, "reach");
  for (const auto& [name, value] : {std::pair{"x_inlet", -far}, {"x_outlet", far}, {"y_half", far}})
    set("domain", name, value, "reach, to all sides");
}

// [transient] cycle = machine: the run ends after one course.
void compute_course(deck::Deck& deck, const machines::Contact& machine) {
  const deck::Part transient{deck, "transient"};
  if (!transient.given("time_unit"))
    compute(deck, "transient", "time_unit", "seconds", machine.section, "the course is in seconds");
  if (!machine.repeats)
    transient.fill("cycle_repeats", std::string("off"), "the course of [" + machine.section + "] does not repeat");
  const double end = machine.course ? machine.course->rows.back().values[0] : core::unknown;
  if (transient.given("end_time")) {
    if (!machine.repeats && transient.word("time_unit") == "seconds" &&
        transient.number("end_time") > end * (1.0 + 1e-9))
      transient.complain("end_time", fmt::format("the course of [{}] ends at {:.5g} s: give at most this, or remove it",
                                                 machine.section, end));
    return;
  }
  compute(deck, "transient", "end_time", end, machine.section, "one course");
}

}  // namespace

std::optional<machines::Contact> machine_input(deck::Deck& deck) {
  std::optional<machines::Contact> machine = machines::read(deck);
  const std::string kind = deck::word(deck, "case", "kind");
  const bool asks_course = deck::word(deck, "transient", "cycle") == "machine";
  const bool has_course = is_among(kind, {machines::gear_mesh, machines::cam_and_tappet, machines::reciprocating});
  if (asks_course && !has_course)
    complain(
        deck, "transient", "cycle",
        "machine needs [case] kind = cam, gear_mesh or reciprocating, whose contact changes in time; or name a file",
        deck::Cause::by_itself);
  if (!machine) return std::nullopt;
  refuse_what_follows(deck, *machine);
  if (kind == machines::impact)
    compute_impact(deck, *machine);
  else if (kind == machines::reciprocating)
    for (const char* name : {"u1", "u2"})
      compute(deck, "motion", name, number_of(*machine, name), machine->section, "at the middle of the stroke");
  else
    compute_contact(deck, *machine, kind);
  if (asks_course && has_course) compute_course(deck, *machine);
  return machine;
}

}  // namespace ehl::program
