#include "transient/keys.hpp"

#include <fmt/format.h>

#include <cmath>
#include <sstream>

#include "deck/record.hpp"

namespace ehl::transient {
namespace {

deck::Records<MarchParameters> time_records() {
  using namespace deck::record;
  return {
      key("end_time", positive, example("5"),
          "Time at which the run ends, in units of time_unit. The run starts from the steady solution at time 0. "
          "Without this key the contact is steady.",
          remedy("the time at which the run ends")),
      key("time_unit", by_default("contact"), words({"contact", "seconds"}),
          "Unit of all times of this section. contact: a/u_m, the time in which the oil crosses half of the contact. "
          "seconds: needs a contact in SI."),
      key("cavitation", words({"pressure", "content"}), otherwise("content with [supply], else pressure"),
          "Model of the region with P = 0. pressure: the gap is taken as full of oil. content: the oil content of the "
          "gap is an unknown that moves with the surfaces, and mass is conserved. A steady contact with a flooded "
          "inlet has the same film with both; they differ when a rapidly rising load pressurizes the cavitated region.",
          source("modules/transient/README.md")),
      key("rtol", &MarchParameters::rtol, Range{1e-7, 1e-1}, by_default("1e-4"),
          "Relative tolerance of pressure and film in the error test of the time integration.",
          source("modules/transient/README.md")),
      key("max_step", &MarchParameters::longest_step, positive, example("0.05"),
          otherwise("follows from what varies: a quarter of the time in which a feature passes, a quarter of a ramp "
                    "(one shorter than 0.04 a/u_m counts only while it lasts), a twentieth of a period"),
          "Largest time step."),
      key("max_steps", &MarchParameters::most_steps, Range{1, 100000000}, by_default("100000"),
          "Largest number of time steps. A run that needs more fails."),
      key("output_interval", &MarchParameters::output_interval, positive, example("0.1"),
          otherwise("none: the fields of the first and the last time only"),
          "Time between two stored fields of P and H. The values of every step are always stored.",
          remedy("a longer interval keeps fewer fields")),
      key("start_of_means", &MarchParameters::start_of_means, not_negative, example("4"),
          otherwise("the start of the last whole period of a cycle, else 0"),
          "Time from which on extremes and means of a run are taken, for the report and the rows of a sweep. Without "
          "it the last whole period of a cycle counts, else the whole run."),
      key("error", words({"on", "off"}), by_default("off"),
          "on: error bars of Hc, Hm, P_max and mu at every step, and of their extremes and means, from two more runs: "
          "one on half the cells, and one that also has ten times the tolerance. They cover mesh and time steps, and "
          "not the size of the domain.",
          source("modules/transient/README.md")),
  };
}

deck::Records<MarchParameters> stop_records() {
  using namespace deck::record;
  return {
      key("stop_film", &MarchParameters::stop_film, positive, example("0.02"), otherwise("none"),
          "The run ends when the minimum film falls to this value, H = hR/a^2."),
      key("stop_steady", &MarchParameters::stop_steady, Range{1e-12, 0.1}, example("1e-6"), otherwise("none"),
          "The run ends when Hc, Hm and P_max have changed by less than this relative value during a/u_m."),
      key("stop_periodic", &MarchParameters::stop_periodic, Range{1e-8, 0.1}, example("1e-3"), otherwise("none"),
          needs("cycle"),
          "The run ends after a period in which Hc and Hm differ from those of the period before, at the same phase, "
          "by less than this relative value. The report states the difference in any case."),
  };
}

deck::Records<Input> output_records() {
  using namespace deck::record;
  return {key("checkpoint", &Input::seconds_between_checkpoints, unit("s"), positive, example("60"),
              otherwise("60 for a run in time"),
              "Wall-clock time between two checkpoints of a run in time. `ehl resume` continues from the last "
              "checkpoint in the result file."),
          key("probe", text, example("0 0, 0.7 0.2"), otherwise("none"),
              "Points 'X Y, X Y, ...' in Hertz radii at which a run in time stores P and H at every step, as the "
              "columns P_1, H_1, P_2, ... of /transient. The value is that of the node at the point, else bicubic "
              "interpolation with P >= 0.")};
}

const deck::Condition in_time{.name = "end_time", .section = "transient"};

deck::Records<MarchParameters> march_records() {
  const std::vector<deck::Key> drive = deck::together({drive_keys(), cycle_keys()});
  return deck::only_with<MarchParameters>(
      {.name = "end_time"},
      deck::together<deck::Record<MarchParameters>>({time_records(), {drive.begin(), drive.end()}, stop_records()}));
}

std::vector<Place> read_probes(const deck::Part& output, const core::Grid& grid) {
  std::vector<Place> places;
  std::istringstream parts(output.word("probe"));
  for (std::string part; std::getline(parts, part, ',');) {
    const std::vector<std::string> words = deck::split_words(part);
    const Place place = words.size() == 2 ? Place{deck::read_number(words[0]).value, deck::read_number(words[1]).value}
                                          : Place{core::unknown, core::unknown};
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

// The times of the quasi-steady states.
void read_states(const deck::Part& transient, double unit, const std::optional<Cycle>& cycle, Input& input) {
  constexpr double rounding = 1e-12;
  const std::string mode = transient.word("mode");
  if (mode != "quasi_steady" && mode != "both") return;
  input.mode = mode == "both" ? Mode::both : Mode::quasi_steady;
  if (input.conditions.body)
    transient.complain("mode", "in_time is the only mode with [body], whose motion is not steady");
  if (input.conditions.on_1 || input.conditions.on_2)
    transient.complain("mode", "in_time is the only mode with [surface1] or [surface2], whose shapes move");
  if (input.mode == Mode::quasi_steady) {
    for (const char* key :
         {"rtol", "max_step", "output_interval", "stop_film", "stop_steady", "stop_periodic", "error"})
      if (transient.given(key))
        transient.complain(key, "has no influence with mode = quasi_steady: remove it, or set mode = both");
    if (cycle && input.parameters.end > cycle->period * (1.0 + rounding))
      transient.complain("end_time", fmt::format("quasi-steady states repeat after one period: set it to {:.6g}",
                                                 cycle->times.back() * unit));
    if (input.conditions.conserves_mass && !deck::called_for(transient.deck, "supply"))
      transient.complain("mode",
                         "quasi_steady needs cavitation = pressure, because steady contacts without [supply] "
                         "have no oil content");
  }
  if (!cycle) return;
  for (const double T : cycle->times) {
    if (T > input.parameters.end * (1.0 + rounding)) break;
    if (!input.states.empty() && T == input.states.back())
      return transient.complain("mode",
                                "in_time is the only mode if the table jumps (two rows with one time), because "
                                "there are two steady states at that time");
    input.states.push_back(T);
  }
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

std::vector<deck::Key> keys() {
  return deck::together({deck::keys_of("transient", march_records()),
                         deck::keys_of("output", deck::only_with(in_time, output_records())),
                         deck::in_section("body", deck::only_with(in_time, body_keys()))});
}

FarDemands far_demands(const deck::Deck& deck, const Scales& scales, const deck::ColumnTable* of_machine) {
  deck::Deck read_ahead = deck;
  const deck::Part transient{read_ahead, "transient"};
  const double unit = unit_of_time(transient, scales);
  Conditions conditions;
  read_drive(transient, unit, scales, of_machine, conditions);
  const double end = transient.number("end_time") / unit;
  FarDemands demands{.steepest_load = steepest(conditions.load, end)};
  if (!conditions.radius.points.empty())
    demands.why_zero = "radius_x varies in time";
  else if (std::isfinite(end) && reversal(conditions, end) <= end)
    demands.why_zero = "the direction of the entrainment reverses";
  return demands;
}

Input read(deck::Deck& deck, const Scales& scales, const Conditions& carried, const core::Grid& grid,
           const deck::ColumnTable* of_machine) {
  const deck::Part transient{deck, "transient"}, output{deck, "output"};
  Input input{.conditions = carried, .second = 1.0 / scales.time};
  const bool seconds = transient.word("time_unit") == "seconds";
  const bool reported = scales.in_SI && !deck.errors.empty();  // why the scales are not known
  if (seconds && std::isnan(scales.time) && !reported)
    transient.complain("time_unit", "seconds need a contact and a motion in SI: set time_unit = contact");
  input.in_seconds = seconds;
  const double unit = unit_of_time(transient, scales);
  const std::optional<Cycle> cycle = read_drive(transient, unit, scales, of_machine, input.conditions);
  input.conditions.body = read_body(deck, scales);
  MarchParameters& march = input.parameters = deck::read(transient, march_records());
  input.conditions.conserves_mass = transient.word("cavitation") == "content";
  march.end = transient.number("end_time") / unit;
  if (cycle) march.period = cycle->period;
  march.longest_step /= unit;
  march.output_interval /= unit;
  march.start_of_means /= unit;
  if (march.start_of_means >= march.end)
    transient.complain("start_of_means", fmt::format("must be less than end_time = {:g}", march.end * unit));
  input.error_bars = transient.word("error") == "on";
  march.probes = read_probes(output, grid);
  deck::read(output, output_records(), input);
  if (std::isfinite(march.end)) check_drive(transient, unit, input.conditions, march.end, grid);
  read_states(transient, unit, cycle, input);
  if (cycle && std::isnan(cycle->period))
    transient.refuse({"stop_periodic"}, "a cycle with cycle_repeats = off has no periods: remove one of them");
  if (deck.errors.empty() && input.mode != Mode::quasi_steady)
    check_steps(transient, march, longest_step(input.conditions, march.end));
  return input;
}

}  // namespace ehl::transient
