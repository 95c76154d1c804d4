#include "transient/keys.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "deck/text.hpp"

namespace ehl::transient {
namespace {

using deck::Key;
using deck::Type;

constexpr deck::Range positive{0.0, std::numeric_limits<double>::infinity(), true, true};

std::vector<Key> time_keys() {
  return {
      {.name = "end_time",
       .range = positive,
       .remedy = "the time at which the run ends",
       .meaning = "How long, from the steady state at time 0, in the unit that time_unit says. Without it the contact "
                  "is steady.",
       .example = "5"},
      {.name = "time_unit",
       .default_text = "contact",
       .words = {"contact", "seconds"},
       .meaning = "Unit of all times of this section: contact is a/u_m, in which the oil crosses half of the contact; "
                  "seconds need a contact in SI."},
      {.name = "cavitation",
       .default_note = "content with a [supply], else pressure",
       .words = {"pressure", "content"},
       .meaning =
           "Behind the contact, and wherever P = 0: pressure, the gap is taken to be full; content, the oil there "
           "is an unknown that moves with the surfaces, and mass is conserved. A full inlet has no other film "
           "while it is steady; a load that rises fast presses on what is there.",
       .source = "modules/transient/README.md"},
      {.name = "rtol",
       .default_text = "1e-4",
       .range = {1e-7, 1e-1},
       .meaning = "Relative tolerance of the time integration's error test for pressure and film.",
       .source = "modules/transient/README.md"},
      {.name = "max_step",
       .default_note = "from what varies: a quarter of a feature's width at its speed, a quarter of a ramp (of one "
                       "shorter than 0.04 a/u_m only within it), a twentieth "
                       "of a period",
       .range = positive,
       .meaning = "Longest step of time.",
       .example = "0.05"},
      {.name = "max_steps",
       .type = Type::integer,
       .default_text = "100000",
       .range = {1, 100000000},
       .meaning = "Steps after which the run ends as failed."},
      {.name = "output_interval",
       .default_note = "none: the fields of the first and the last time",
       .range = positive,
       .remedy = "a longer time between two fields keeps fewer of them",
       .meaning = "Time between two fields of P and H in the result. The numbers of every step are always kept.",
       .example = "0.1"},
  };
}

std::vector<Key> stop_keys() {
  return {
      {.name = "stop_film",
       .default_note = "none",
       .range = positive,
       .meaning = "End where the smallest film falls to this, H = hR/a^2.",
       .example = "0.02"},
      {.name = "stop_steady",
       .default_note = "none",
       .range = {1e-12, 0.1},
       .meaning = "End where Hc, Hm and P_max have changed by less than this, relative, for a time of a/u_m.",
       .example = "1e-6"},
  };
}

std::vector<Key> output_keys() {
  return {
      {.name = "checkpoint",
       .default_note = "60 in a run in time",
       .unit = "s",
       .range = positive,
       .meaning = "Time by the clock between the moments at which a run in time writes its result so far, from "
                  "which `ehl resume` goes on.",
       .example = "60"},
      {.name = "probe",
       .type = Type::text,
       .default_note = "none",
       .meaning = "Points 'X Y, X Y, ...' in Hertz radii at which a run in time keeps P and H at every step, as the "
                  "columns P_1, H_1, P_2, ... of /transient: of a node where there is one, else by bicubic "
                  "interpolation, P no less than 0.",
       .example = "0 0, 0.7 0.2"}};
}

std::vector<Place> read_probes(const deck::Part& output, const core::Grid& grid) {
  std::vector<Place> places;
  std::istringstream parts(output.word("probe"));
  for (std::string part; std::getline(parts, part, ',');) {
    const std::vector<std::string> words = deck::split_words(part);
    const Place place = words.size() == 2 ? Place{deck::read_number(words[0]).value, deck::read_number(words[1]).value}
                                          : Place{Scales::unset, Scales::unset};
    if (std::isnan(place.X + place.Y)) {
      output.complain("probe",
                      deck::quoted(deck::trimmed(part)) + " is no point: write X Y, X Y, ... as in 0 0, 0.7 0.2");
      return {};
    }
    if (grid.line && place.Y != 0.0)
      output.complain(
          "probe", fmt::format("({:g}, {:g}) is beside the one line of a line contact: write Y = 0", place.X, place.Y));
    const bool inside = place.X >= grid.X_a && place.X <= grid.X_b && place.Y >= grid.Y_a && place.Y <= grid.Y_b;
    if (grid.ny > 0 && !inside)
      output.complain("probe", fmt::format("({:g}, {:g}) is outside of the domain, {:g} <= X <= {:g} and |Y| <= {:g}",
                                           place.X, place.Y, grid.X_a, grid.X_b, grid.Y_b));
    places.push_back(place);
  }
  return places;
}

// in: otherwise, the longest step if the deck gives none.
void check_steps(const deck::Part& transient, const MarchParameters& march, double otherwise) {
  const double longest = std::isnan(march.longest_step) ? otherwise : march.longest_step;
  const double steps = std::ceil(march.end / longest);
  if (!transient.given_of({"max_steps", "stop_film", "stop_steady"}).empty() || !(steps > march.most_steps)) return;
  transient.complain("end_time",
                     fmt::format("takes at least {:.3g} steps of at most {:.3g} a/u_m, and max_steps is {}: "
                                 "a shorter time, or more steps",
                                 steps, longest, march.most_steps));
}

double unit_of_time(const deck::Part& transient, const Scales& scales) {
  return transient.word("time_unit") == "seconds" && std::isfinite(scales.time) ? scales.time : 1.0;
}

}  // namespace

std::vector<Key> keys() {
  const deck::Condition in_time{.name = "end_time", .section = "transient"};
  const std::vector<Key> of_transient = deck::together({time_keys(), drive_keys(), stop_keys()});
  return deck::together({deck::in_section("transient", deck::only_with({.name = "end_time"}, of_transient)),
                         deck::in_section("output", deck::only_with(in_time, output_keys())),
                         deck::in_section("body", deck::only_with(in_time, body_keys()))});
}

double steepest_load(const deck::Deck& deck, const Scales& scales) {
  deck::Deck read_ahead = deck;
  const deck::Part transient{read_ahead, "transient"};
  const double unit = unit_of_time(transient, scales);
  Conditions conditions;
  read_drive(transient, unit, scales, conditions);
  return steepest(conditions.load, transient.number("end_time") / unit);
}

Input read(deck::Deck& deck, const Scales& scales, const Conditions& carried, const core::Grid& grid) {
  const deck::Part transient{deck, "transient"}, output{deck, "output"};
  Input input{.conditions = carried, .second = 1.0 / scales.time};
  const bool seconds = transient.word("time_unit") == "seconds";
  if (seconds && std::isnan(scales.time))
    transient.complain("time_unit", "seconds need a contact and a motion in SI: use contact");
  input.in_seconds = seconds;
  const double unit = unit_of_time(transient, scales);
  const auto time = [&](const char* key) { return transient.number(key) / unit; };
  read_drive(transient, unit, scales, input.conditions);
  input.conditions.body = read_body(deck, scales);
  MarchParameters& march = input.parameters;
  input.conditions.conserves_mass = transient.word("cavitation") == "content";
  march.end = time("end_time");
  march.rtol = transient.number("rtol");
  march.longest_step = time("max_step");
  march.most_steps = transient.integer("max_steps", march.most_steps);
  march.output_interval = time("output_interval");
  march.stop_film = transient.number("stop_film");
  march.stop_steady = transient.number("stop_steady");
  march.probes = read_probes(output, grid);
  const double checkpoint = output.number("checkpoint");
  if (output.given("checkpoint")) input.seconds_between_checkpoints = checkpoint;
  if (std::isfinite(march.end)) check_drive(transient, input.conditions, march.end);
  if (deck.errors.empty()) check_steps(transient, march, longest_step(input.conditions, march.end));
  return input;
}

}  // namespace ehl::transient
