// The effect `transient`: contacts in time.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "case/effects.hpp"
#include "case/numbers/records.hpp"
#include "core/constants.hpp"
#include "deck/text.hpp"
#include "transient/keys.hpp"

namespace ehl::program {
namespace numbers {
namespace {

// The extreme of the rows whose value is known.
double extreme(const TransientResult& run, double transient::StepRow::*value, double (*of_two)(double, double)) {
  double found = core::unknown;
  for (const transient::StepRow& row : run.rows) found = of_two(found, row.*value);
  return found;
}
const TransientResult& in_time(Of s) { return *s.computed.in_time; }
const transient::MarchReport& march(Of s) { return in_time(s).report; }
bool repeats(Of s) { return !std::isnan(s.input.transient->parameters.period); }
bool has_states(Of s) { return in_time(s).states.has_value(); }
bool counts_oil_in_time(Of s) { return s.input.transient->conditions.conserves_mass; }

Group transient_numbers() {
  Group group{.name = "transient", .prefix = "transient_"};
  group.on = [](Of s) { return s.computed.in_time.has_value(); };
  const auto count = [](int transient::MarchReport::*part) { return [part](Of s) { return march(s).*part; }; };
  const auto of_states = [](int transient::MarchReport::*part) {
    return [part](Of s) { return (*in_time(s).states).*part; };
  };
  using R = transient::MarchReport;
  using transient::StepRow;
  std::vector<Number>& list = group.numbers;
  list = {number(id::completed, "-", "1: the run in time is complete, 0: it is not",
                 [](Of s) { return completed(in_time(s)); }),
          number(id::ended, "", "how the run in time ended", [](Of s) { return how_it_ended(march(s)); }),
          number("start_converged", "-", "only a converged start is followed in time", [](Of) { return true; }),
          number("end_time", "a/u_m", "time reached", [](Of s) { return march(s).T; }),
          number(id::Hc, "a^2/R", "film at (0,0) at the end", [](Of s) { return in_time(s).rows.back().Hc; }),
          number(id::Hm, "a^2/R", "minimum film at the end", [](Of s) { return in_time(s).rows.back().Hm; }),
          number("least_Hm", "a^2/R", "minimum film of all times",
                 [](Of s) { return extreme(in_time(s), &StepRow::Hm, std::fmin); }),
          number("largest_P_max", "p_h", "highest pressure of all times",
                 [](Of s) { return extreme(in_time(s), &StepRow::P_max, std::fmax); }),
          number("steps", "-", "number of time steps", count(&R::steps)),
          number(id::cycles, "-", "cycles of all steps", count(&R::cycles)),
          number("newton_steps", "-", "Newton steps of all attempts", count(&R::newton_steps)),
          number("rejected", "-", "attempts that failed the error test", count(&R::rejected)),
          number("not_solved", "-", "attempts that were not solved", count(&R::not_solved)),
          number("jumps", "-", "jumps of load or speed", count(&R::restarts)),
          number("worst_load_error", "-", "largest relative error of the load",
                 [](Of s) { return march(s).worst_load_error; }),
          number(id::seconds, "s", "time of the run in time", [](Of s) { return march(s).seconds; }),
          number("worst_oil_error", "-", "largest share of oil from nowhere in a step", only_if(counts_oil_in_time),
                 [](Of s) { return march(s).worst_oil_error; }),
          number("oil_lost", "-", "since the start, over what the inlet brings then in a/u_m",
                 only_if(counts_oil_in_time), [](Of s) { return in_time(s).rows.back().oil.lost; }),
          number("periods", "-", "whole periods of the cycle", only_if(repeats), count(&R::periods)),
          number("change_of_period", "-", "largest relative change of Hc and Hm between the last two periods",
                 only_if(repeats), [](Of s) { return march(s).change_of_period; }),
          number("states_at_rest", "-", "quasi-steady states without entrainment, which have no film",
                 only_if(has_states), of_states(&R::at_rest)),
          number("states_not_found", "-", "quasi-steady states that were not found", only_if(has_states),
                 of_states(&R::not_found))};
  // The file contains how the run ended; the other numbers follow from its table of steps.
  for (Number& one : list) one.in_file = one.name == id::completed || one.name == id::ended;
  return group;
}

}  // namespace
}  // namespace numbers

namespace {

double step_of(const transient::Input& transient) {
  const transient::MarchParameters& march = transient.parameters;
  return std::isnan(march.longest_step) ? transient::longest_step(transient.conditions, march.end) : march.longest_step;
}

// "; radius_x 4.5 to 31.3 mm, ...": the extremes of the columns of a cycle, and of the mean speed.
std::string extremes_of_cycle(const Case& input) {
  if (!deck::given(input.deck, "transient", "cycle")) return "";
  const transient::Conditions& conditions = input.transient->conditions;
  const std::optional<SiInput>& si = input.physics.si;
  const double u_m = si ? 0.5 * si->contact.u_s : 1.0;
  const auto range = [](const char* name, const std::vector<double>& values, double factor, const char* unit) {
    if (values.empty()) return std::string();
    const auto [least, most] = std::ranges::minmax(values);
    if (least == most) return std::string();
    return fmt::format(", {} {:.5g} to {:.5g}{}", name, factor * least, factor * most, unit);
  };
  const auto values_of = [](const transient::Schedule& schedule) {
    std::vector<double> values;
    for (const transient::Schedule::Point& point : schedule.points) values.push_back(point.value);
    return values;
  };
  std::vector<double> speeds;
  for (const transient::Schedule* one : {&conditions.u1, &conditions.u2})
    for (const transient::Schedule::Point& point : one->points)
      speeds.push_back(transient::drive_at(conditions, point.T).speed);
  const char* newton = contact::line(input.scene.contact.shape) ? " N/m" : " N";
  const std::string text =
      range("radius_x", values_of(conditions.radius), si ? 1e3 * si->contact.radius : 1.0, si ? " mm" : "") +
      range("load", values_of(conditions.load), si ? si->contact.load : 1.0, si ? newton : "") +
      range("u1", values_of(conditions.u1), u_m, si ? " m/s" : "") +
      range("u2", values_of(conditions.u2), u_m, si ? " m/s" : "") + range("mean speed", speeds, u_m, si ? " m/s" : "");
  return text.empty() ? "" : ";" + text.substr(1);
}

std::string what(const Case& input) {
  std::vector<std::string> varying;
  for (const char* key : {"load", "load_wave", "u1", "u1_wave", "u2", "u2_wave", "supply", "supply_wave", "cycle"})
    if (deck::given(input.deck, "transient", key)) varying.push_back(key);
  if (!input.transient->states.empty() && input.transient->mode == transient::Mode::quasi_steady)
    return fmt::format("{} quasi-steady states of the cycle", input.transient->states.size()) +
           extremes_of_cycle(input);
  return fmt::format("in time to {:.4g} a/u_m, steps of at most {:.3g}; varying: ", input.transient->parameters.end,
                     step_of(*input.transient)) +
         (varying.empty() ? "neither load nor speed" : deck::joined(varying, ", ")) + extremes_of_cycle(input) +
         (input.transient->conditions.conserves_mass ? "; mass is conserved where P = 0" : "");
}

// True if measured heights reach the contact before the end.
bool is_rough(const Case& input) {
  const auto comes = [&](const CarriedSurface* one) {
    const auto* map = std::get_if<surface::HeightMap>(&one->relief);
    return map && travel_of(*one, *input.transient).farthest + 0.5 * map->length_x() >
                      -contact::extent(input.scene.contact.shape).X;
  };
  return std::ranges::any_of(carried(input.surfaces), comes);
}

}  // namespace

double expected_steps(const Case& input) {
  constexpr double shorter_steps = 3.0;  // if load, speed or supply varies: steps over longest steps
  constexpr double more_of_rough = 5.0;  // for measured heights, with more cycles per step
  const transient::Conditions& conditions = input.transient->conditions;
  const auto varies = [](const transient::Schedule& schedule) { return schedule.wave || schedule.points.size() > 1; };
  const bool driven = conditions.body || std::ranges::any_of(transient::schedules_of(conditions),
                                                             [&](const auto* schedule) { return varies(*schedule); });
  return input.transient->parameters.end / step_of(*input.transient) *
         (is_rough(input) ? more_of_rough
          : driven        ? shorter_steps
                          : 1.0);
}

Needs expense_in_time(const Case& input) {
  // Per node of the whole domain, for a contact that is symmetric in Y. [bench: needs_in_time]
  constexpr double doubles_of_history = 30.0;  // IDA's history of P and Q
  constexpr double doubles_of_frame = 5.0;     // P, H and their copies in the file
  constexpr double seconds_per_node_and_step = 2.5e-7;
  constexpr double seconds_of_coarse_grids = 1.5e-3;     // in each step
  constexpr double seconds_per_node_and_frame = 5.5e-7;  // computes a film and writes both fields
  const core::Grid& grid = input.scene.grid;
  const double nodes = static_cast<double>(grid.nodes_x()) * grid.nodes_y();
  const transient::MarchParameters& march = input.transient->parameters;
  const double steps = expected_steps(input);
  const double frames = std::isnan(march.output_interval) ? 2.0 : march.end / march.output_interval + 2.0;
  return {.bytes = nodes * sizeof(double) * (doubles_of_history + frames * doubles_of_frame),
          .seconds = steps * (seconds_of_coarse_grids + nodes * seconds_per_node_and_step) +
                     frames * nodes * seconds_per_node_and_frame};
}

namespace {

void compute(const Case& input, RunSettings& settings, Computed& computed) {
  if (!computed.solution.converged) return;
  computed.in_time = run_transient(input, computed.solution, settings);
}

}  // namespace

Effect transient_effect() {
  return {.name = "transient",
          .meaning = "Time-dependent contact, from the steady solution at time 0.",
          .without = "steady",
          .sections = {{.name = "transient", .called_by = {"end_time"}}},
          .costly = {"transient", "output_interval"},
          .keys = transient::keys,
          .numbers = numbers::transient_numbers,
          .stages = {.in_time = compute},
          .on = [](const Case& input) { return input.transient.has_value(); },
          .what = what,
          .expense = expense_in_time,
          .summary =
              [](const Case& input, const Computed& computed) {
                return computed.in_time ? transient_summary(input, *computed.in_time) : "";
              },
          .add_content =
              [](const Case& input, const Computed& computed, results::Content& content) {
                if (computed.in_time) add_transient(input, *computed.in_time, content);
              },
          .seconds =
              [](const Computed& computed) {
                if (!computed.in_time) return 0.0;
                double own = computed.in_time->report.seconds - computed.in_time->report.seconds_of_surfaces;
                for (const auto& [effect, seconds] : computed.in_time->seconds) own -= seconds;
                return own;
              },
          .example = {"transient.end_time=0.5", "transient.load=0.1:1 0.4:1.1"}};
}

}  // namespace ehl::program
