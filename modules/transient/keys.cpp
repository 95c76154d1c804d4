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
       .meaning = "Time at which the run ends, in units of time_unit. The run starts from the steady solution at time "
                  "0. Without this key the contact is steady.",
       .example = "5"},
      {.name = "time_unit",
       .default_text = "contact",
       .words = {"contact", "seconds"},
       .meaning = "Unit of all times of this section. contact: a/u_m, the time in which the oil crosses half of the "
                  "contact. seconds: needs a contact in SI."},
      {.name = "cavitation",
       .default_note = "content with [supply], else pressure",
       .words = {"pressure", "content"},
       .meaning = "Model of the region with P = 0. pressure: the gap is taken as full of oil. content: the oil content "
                  "of the gap is an unknown that moves with the surfaces, and mass is conserved. A steady contact with "
                  "a flooded inlet has the same film with both; they differ when a rapidly rising load pressurizes the "
                  "cavitated region.",
       .source = "modules/transient/README.md"},
      {.name = "rtol",
       .default_text = "1e-4",
       .range = {1e-7, 1e-1},
       .meaning = "Relative tolerance of pressure and film in the error test of the time integration.",
       .source = "modules/transient/README.md"},
      {.name = "max_step",
       .default_note = "follows from what varies: a quarter of the time in which a feature passes, a quarter of a ramp "
                       "(one shorter than 0.04 a/u_m counts only while it lasts), a twentieth of a period",
       .range = positive,
       .meaning = "Largest time step.",
       .example = "0.05"},
      {.name = "max_steps",
       .type = Type::integer,
       .default_text = "100000",
       .range = {1, 100000000},
       .meaning = "Largest number of time steps. A run that needs more fails."},
      {.name = "output_interval",
       .default_note = "none: the fields of the first and the last time only",
       .range = positive,
       .remedy = "a longer interval keeps fewer fields",
       .meaning = "Time between two stored fields of P and H. The values of every step are always stored.",
       .example = "0.1"},
  };
}

std::vector<Key> stop_keys() {
  return {
      {.name = "stop_film",
       .default_note = "none",
       .range = positive,
       .meaning = "The run ends when the minimum film falls to this value, H = hR/a^2.",
       .example = "0.02"},
      {.name = "stop_steady",
       .default_note = "none",
       .range = {1e-12, 0.1},
       .meaning = "The run ends when Hc, Hm and P_max have changed by less than this relative value during a/u_m.",
       .example = "1e-6"},
  };
}

std::vector<Key> output_keys() {
  return {{.name = "checkpoint",
           .default_note = "60 for a run in time",
           .unit = "s",
           .range = positive,
           .meaning = "Wall-clock time between two checkpoints of a run in time. `ehl resume` continues from the last "
                      "checkpoint in the result file.",
           .example = "60"},
          {.name = "probe",
           .type = Type::text,
           .default_note = "none",
           .meaning = "Points 'X Y, X Y, ...' in Hertz radii at which a run in time stores P and H at every step, as "
                      "the columns P_1, H_1, P_2, ... of /transient. The value is that of the node at the point, else "
                      "bicubic interpolation with P >= 0.",
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
                      deck::quoted(deck::trimmed(part)) + " is not a point: write X Y, X Y, ... as in 0 0, 0.7 0.2");
      return {};
    }
    if (grid.line && place.Y != 0.0)
      output.complain("probe", fmt::format("({:g}, {:g}) does not lie on the line Y = 0 of a line contact: set Y = 0",
                                           place.X, place.Y));
    const bool inside = place.X >= grid.X_a && place.X <= grid.X_b && place.Y >= grid.Y_a && place.Y <= grid.Y_b;
    if (grid.ny > 0 && !inside)
      output.complain("probe", fmt::format("({:g}, {:g}) lies outside the domain, {:g} <= X <= {:g} and |Y| <= {:g}",
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
  transient.complain("end_time", fmt::format("takes at least {:.3g} steps of at most {:.3g} a/u_m, but max_steps is "
                                             "{}: use a shorter time, or raise max_steps",
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
    transient.complain("time_unit", "seconds need a contact and a motion in SI: set time_unit = contact");
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
  if (std::isfinite(march.end)) check_drive(transient, unit, input.conditions, march.end);
  if (deck.errors.empty()) check_steps(transient, march, longest_step(input.conditions, march.end));
  return input;
}

}  // namespace ehl::transient
