#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "base/text_format.hpp"
#include "case/course_of_run.hpp"
#include "case/friction_in_time.hpp"
#include "case/numbers/records.hpp"
#include "case/sliding_input.hpp"
#include "effects/friction/of_scene.hpp"
#include "steady/multigrid_solve.hpp"

namespace ehl::program {

namespace {

numbers::Unit of_power() { return {"F_0 u_m", "F_0' u_m"}; }

/// A column whose extremes and mean the reports show.
struct Summarized {
  const char* name;
  const char* words;
  numbers::Unit unit;
};
const std::vector<Summarized>& summarized() {
  static const std::vector<Summarized> columns{
      {id::mu, "mu sliding", "-"}, {id::mu_rolling, "rolling", "-"}, {id::friction_power, "power", of_power()}};
  return columns;
}

}  // namespace

namespace numbers {
namespace {

Group friction_step_numbers() {
  Group group{.name = "friction in time", .home = "/transient"};
  group.numbers = {number(id::unlikely_share, "-", "share of the load with a shear stress that no lubricant carries"),
                   number(id::force_1, {"F_0", "F_0'"}, "force of the film on surface 1 along +x"),
                   number(id::force_2, {"F_0", "F_0'"}, "force of the film on surface 2 along +x"),
                   number(id::force_side, "F_0", "force of the film on each surface along +y"),
                   number(id::friction_power, of_power(),
                          "power of the moving surfaces against the tractions, -(force_1 u1 + force_2 u2)",
                          label("friction power"))};
  return group;
}

// Extremes and means, which the result file has as columns only.
Group friction_course() {
  Group group{.name = "course of friction"};
  group.on = [](Of s) { return s.computed.in_time.has_value(); };
  group.asked = [](const deck::Deck& deck) {
    return deck::called_for(deck, "transient") &&
           (deck::given(deck, "friction", "cavitated") || deck::called_for(deck, "thermal"));
  };
  int place = 411;
  const auto add = [&](const std::string& what, const std::string& name, const std::string& path, const Unit& unit,
                       auto value) {
    group.numbers.push_back(number(what + "_" + name, unit, what + " " + name + " of the run in time",
                                   json(path + what), not_in_file,
                                   bar(name == id::mu ? "error_" + what + "_" + name : ""), column(place++),
                                   label(name == id::mu ? what + " friction coefficient" : ""), value));
  };
  using Part = double Extremes::*;
  const std::pair<const char*, Part> kinds[] = {
      {"least", &Extremes::least}, {"largest", &Extremes::largest}, {"mean", &Extremes::mean}};
  for (const Summarized& one : summarized())
    for (const auto& [what, part] : kinds)
      add(what, one.name, "in_time/" + std::string(one.name) + "/", one.unit,
          [&one, part = part](Of s) { return extremes_of(s.input, *s.computed.in_time, one.name).*part; });
  for (const auto& [what, part] : {std::pair("mean", &Extremes::mean), {"largest", &Extremes::largest}})
    add(what, std::string("abs_") + id::mu, "in_time/" + std::string("abs_") + id::mu + "/", "-",
        [part = part](Of s) { return extremes_of_magnitude(s.input, *s.computed.in_time, id::mu).*part; });
  return group;
}

}  // namespace
}  // namespace numbers

namespace {

using friction::Friction;

friction::Parameters parameters_in_time(const Case& input) {
  return input.friction ? *input.friction : friction_of_contact(input.physics, input.scene);
}

/// What lies around the domain, made at the first step.
struct Around {
  const friction::Surroundings& of(const Case& input, const transient::Snapshot& state) {
    if (!made) made.emplace(input.scene, state.far_field, state.grid.domain, parameters_in_time(input).meniscus);
    return *made;
  }
  std::optional<friction::Surroundings> made{};
};

// The friction of a state; forces over the load of the contact. in: fields: keeps the tractions that the deck asks for.
Friction friction_at(const Case& input, const transient::Snapshot& state, Around& around, bool fields) {
  friction::Parameters parameters = parameters_in_time(input);
  parameters.stress = stress_of_speed(input.physics) * (state.u1 - state.u2);
  parameters.thinning_k = input.transient->conditions.thinning_k * std::abs(state.u1 - state.u2);
  parameters.oblique = !input.scene.grid.line && state.grid.north == core::Edge::zero;
  if (!fields) parameters.keep_tau1 = parameters.keep_tau2 = false;
  const core::Field P = core::on_domain(state.grid, state.P), H = core::on_domain(state.grid, state.H);
  core::Field I0, less_tau;
  if (state.factors != nullptr) I0 = core::on_domain(state.grid, state.factors->fluidity);
  if (state.stress != nullptr) less_tau = core::on_domain(state.grid, *state.stress);
  return friction::friction_at(input.scene,
                               {.grid = state.grid.domain,
                                .P = P,
                                .H = H,
                                .H00 = state.far.H00,
                                .I0 = state.factors != nullptr ? &I0 : nullptr,
                                .less_tau = state.stress != nullptr ? &less_tau : nullptr},
                               around.of(input, state), state.far, parameters);
}

// A column of the steps. in: the friction in units of the load of the contact, and the state.
struct StepNumber {
  std::string name{};
  double (*value)(const Friction& friction, const transient::Snapshot& state) = nullptr;
};

// A part of the friction over the load that the film carries; NaN if it carries none.
template <double Friction::*part>
double coefficient(const Friction& friction, const transient::Snapshot& state) {
  return state.carried > 0.0 ? friction.*part / state.carried : core::unknown;
}

bool is_oblique(const Case& input) {
  return !input.scene.grid.line && !(steady::on_one_half(input.scene) && symmetric(input.transient->conditions));
}

std::vector<StepNumber> step_numbers(const Case& input) {
  std::vector<StepNumber> list{{id::mu, coefficient<&Friction::sliding>},
                               {id::mu_rolling, coefficient<&Friction::rolling>},
                               {id::mu_1, coefficient<&Friction::on_1>},
                               {id::mu_2, coefficient<&Friction::on_2>},
                               {id::mu_cavitated, coefficient<&Friction::cavitated>}};
  if (friction::oil_outside(input.scene)) {
    list.push_back({id::mu_beyond, coefficient<&Friction::beyond>});
    list.push_back({id::mu_rolling_beyond, coefficient<&Friction::rolling_beyond>});
  }
  if (is_oblique(input)) list.push_back({id::mu_side, coefficient<&Friction::side>});
  list.push_back(
      {id::largest_shear_stress, [](const Friction& f, const transient::Snapshot&) { return f.largest_stress; }});
  list.push_back({id::limited_share, coefficient<&Friction::limited_share>});
  list.push_back({id::unlikely_share, coefficient<&Friction::unlikely_share>});
  list.push_back({id::slide_roll_ratio, [](const Friction&, const transient::Snapshot& at) { return at.u1 - at.u2; }});
  list.push_back({id::force_1, [](const Friction& f, const transient::Snapshot&) { return f.on_1; }});
  list.push_back({id::force_2, [](const Friction& f, const transient::Snapshot&) { return f.on_2; }});
  if (is_oblique(input))
    list.push_back({id::force_side, [](const Friction& f, const transient::Snapshot&) { return f.side; }});
  list.push_back({id::friction_power,
                  [](const Friction& f, const transient::Snapshot& at) { return -(f.on_1 * at.u1 + f.on_2 * at.u2); }});
  return list;
}

results::NamedField traction(const char* number) {
  return {std::string("tau") + number, "p_h",
          std::string("shear stress of the film on surface ") + number + " along +x"};
}

}  // namespace

InSteps friction_in_steps(const Case& input) {
  InSteps made;
  const std::vector<StepNumber> list = step_numbers(input);
  for (const StepNumber& one : list) made.numbers.push_back(one.name);
  const auto around = std::make_shared<Around>();
  made.measure = [&input, list, around](const transient::Snapshot& state) {
    const Friction found = friction_at(input, state, *around, false);
    std::vector<double> values;
    for (const StepNumber& one : list) values.push_back(one.value(found, state));
    return values;
  };
  const bool keep1 = input.friction->keep_tau1, keep2 = input.friction->keep_tau2;
  if (keep1) made.fields.push_back(traction("1"));
  if (keep2) made.fields.push_back(traction("2"));
  if (keep1 || keep2)
    made.measure_fields = [&input, keep1, keep2, around](const transient::Snapshot& state) {
      Friction found = friction_at(input, state, *around, true);
      std::vector<core::Field> fields;
      if (keep1) fields.push_back(std::move(found.tau1));
      if (keep2) fields.push_back(std::move(found.tau2));
      return fields;
    };
  return made;
}

std::function<double(const transient::Snapshot& state)> sliding_in_steps(const Case& input) {
  return [&input, around = std::make_shared<Around>()](const transient::Snapshot& state) {
    return coefficient<&Friction::sliding>(friction_at(input, state, *around, false), state);
  };
}

std::vector<numbers::Group> friction_step_numbers() {
  return {numbers::friction_step_numbers(), numbers::friction_course()};
}

std::string friction_in_time_summary(const Case& input, const Computed& computed) {
  if (!computed.in_time) return {};
  const std::optional<SiScales> si = si_scales(input.physics);
  std::string text;
  for (const Summarized& one : summarized()) {
    const Extremes of = extremes_of(input, *computed.in_time, one.name);
    const std::string& own = numbers::unit_of(one.name, input);
    const SiUnit unit = si ? si_unit(own, *si) : SiUnit{own, 1.0};
    text += fmt::format("{}{} {} to {}, mean over time {}{}\n",
                        text.empty() ? "             in time: " : "                      ", one.words,
                        known("{:.5g}", of.least * unit.factor), known("{:.5g}", of.largest * unit.factor),
                        known("{:.5g}", of.mean * unit.factor), unit.name == "-" ? "" : " " + unit.name);
  }
  return text;
}

core::Warnings friction_in_time_warnings(const Case& input, const TransientResult& result) {
  const std::vector<double> shares = column_of(result, id::unlikely_share);
  Friction worst{.parameters = *input.friction};
  for (const double share : shares) worst.unlikely_share = std::fmax(worst.unlikely_share, share);
  return friction::warnings(worst);
}

}  // namespace ehl::program
