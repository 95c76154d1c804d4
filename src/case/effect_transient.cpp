// The effect `transient`: contacts in time.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/json.hpp"
#include "case/effects.hpp"
#include "case/numbers/records.hpp"
#include "core/constants.hpp"
#include "deck/text.hpp"
#include "transient/keys.hpp"

namespace ehl::program {
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
  constexpr double doubles_of_frame = 5.0;  // P, H and their copies in the file
  constexpr double seconds_per_node_and_step = 2.5e-7;
  constexpr double seconds_of_coarse_grids = 1.5e-3;     // in each step
  constexpr double seconds_per_node_and_frame = 5.5e-7;  // computes a film and writes both fields
  const core::Grid& grid = input.scene.grid;
  const double nodes = static_cast<double>(grid.nodes_x()) * grid.nodes_y();
  const transient::MarchParameters& march = input.transient->parameters;
  const double steps = expected_steps(input);
  const double frames = std::isnan(march.output_interval) ? 2.0 : march.end / march.output_interval + 2.0;
  const double of_error_bars = 1.8;  // with the runs on half the cells [bench: needs_in_time]
  return {.bytes = nodes * sizeof(double) * (doubles_of_history + frames * doubles_of_frame),
          .seconds = (input.transient->error_bars ? of_error_bars : 1.0) * steps *
                         (seconds_of_coarse_grids + nodes * seconds_per_node_and_step) +
                     frames * nodes * seconds_per_node_and_frame};
}

namespace {

// For bodies that start separated the steady contact gives the scales only, so it need not be found.
void compute(const Case& input, RunSettings& settings, Computed& computed) {
  const std::optional<transient::Body>& body = input.transient->conditions.body;
  if (!computed.solution.converged && !(body && body->gap)) return;
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
          .more_numbers = numbers::errors_of_transient,
          .stages = {.in_time = compute},
          .on = [](const Case& input) { return input.transient.has_value(); },
          .what = what,
          .expense = expense_in_time,
          .summary =
              [](const Case& input, const Computed& computed) {
                return computed.in_time ? transient_summary(input, *computed.in_time) : "";
              },
          .json =
              [](const Case& input, const Computed& computed, Json& report) {
                add(numbers::quantities("errors in time", {input, computed}), report);
              },
          .add_content =
              [](const Case& input, const Computed& computed, results::Content& content) {
                if (computed.in_time) add_transient(input, *computed.in_time, content);
              },
          .seconds =
              [](const Computed& computed) {
                if (!computed.in_time) return 0.0;
                double own = computed.in_time->report.seconds - computed.in_time->report.seconds_of_surfaces;
                if (computed.in_time->errors) own += computed.in_time->errors->seconds;
                for (const auto& [effect, seconds] : computed.in_time->seconds) own -= seconds;
                return own;
              },
          .example = {"transient.end_time=0.5", "transient.load=0.1:1 0.4:1.1"}};
}

}  // namespace ehl::program
