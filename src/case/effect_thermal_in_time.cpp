// Heat in a run in time: columns of /transient, temperature fields of the frames, the heat balance.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/text_format.hpp"
#include "case/course_of_run.hpp"
#include "case/friction_in_time.hpp"
#include "case/numbers/records.hpp"
#include "case/thermal_in_time.hpp"
#include "effects/heat/in_time.hpp"
#include "rheology/temperature.hpp"

namespace ehl::program {
namespace numbers {
namespace {

Group heat_step_numbers() {
  Group group{.name = "heat in time", .home = "/transient"};
  group.numbers = {number(id::heat_stored, {"W", "W/m"}, "heat that the oil in the domain stores per time")};
  return group;
}

// Largest values of all times, which the result file has as columns only.
Group heat_course() {
  Group group{.name = "course of heat"};
  group.on = [](Of s) { return s.computed.in_time.has_value() && s.input.heat.has_value(); };
  group.asked = [](const deck::Deck& deck) {
    return deck::called_for(deck, "transient") && deck::called_for(deck, "thermal");
  };
  int place = 521;
  for (const char* name : {id::T_film_max, id::T1_max, id::T2_max, id::heat_imbalance})
    group.numbers.push_back(
        number(std::string("largest_") + name, name == id::heat_imbalance ? "-" : "K",
               std::string("largest ") + name + " of the run in time",
               json("in_time/" + std::string(name) + "/largest"), not_in_file, column(place++),
               [name](Of s) { return extremes_of_magnitude(s.input, *s.computed.in_time, name).largest; }));
  return group;
}

}  // namespace
}  // namespace numbers

namespace {

/// Below this Peclet number heat flows along a surface as fast as the surface moves.
constexpr double least_peclet = 5.0;
/// The heat balance of a step must close to this share of the heat made.
constexpr double closed_balance = 1e-3;

// A temperature field of the frames, by its name in the deck.
struct KeptField {
  const char* name;
  const char* meaning;
  core::Field heat::Temperatures::*field;
};
constexpr KeptField kept_fields[] = {{"T_mid", "middle of the film", &heat::Temperatures::mid},
                                     {"T_max", "largest temperature across the film", &heat::Temperatures::largest},
                                     {"T1", "surface 1", &heat::Temperatures::surface_1},
                                     {"T2", "surface 2", &heat::Temperatures::surface_2}};

// A column of the steps. in: the balance; the factor of temperatures, and that of heat.
struct StepNumber {
  const char* name;
  double (*value)(const thermal::Balance& heat, double T0, double power);
};
constexpr StepNumber step_numbers[] = {
    {id::T_film_max, [](const thermal::Balance& heat, double T0, double) { return T0 * heat.film.theta; }},
    {id::T1_max, [](const thermal::Balance& heat, double T0, double) { return T0 * heat.surface_1.theta; }},
    {id::T2_max, [](const thermal::Balance& heat, double T0, double) { return T0 * heat.surface_2.theta; }},
    {id::heat_made, [](const thermal::Balance& heat, double, double power) { return power * heat.heat; }},
    {id::heat_1, [](const thermal::Balance& heat, double, double power) { return power * heat.into_1; }},
    {id::heat_2, [](const thermal::Balance& heat, double, double power) { return power * heat.into_2; }},
    {id::heat_carried, [](const thermal::Balance& heat, double, double power) { return power * heat.carried; }},
    {id::heat_stored, [](const thermal::Balance& heat, double, double power) { return power * heat.stored; }},
    {id::heat_imbalance, [](const thermal::Balance& heat, double, double) { return heat.defect; }}};

void complain_of(Case& input, const std::string& what) {
  const bool by_oil = deck::given(input.deck, "thermal", "T_oil");
  deck::complain(input.deck, "thermal", by_oil ? "T_oil" : "solid1", what);
}

void check_speed(Case& input, const char* name, const transient::Schedule& speed, double Pe, double at_start) {
  const double least = transient::least(speed, input.transient->parameters.end);
  const double slowest = at_start == 0.0 ? 0.0 : Pe / at_start * least;
  if (slowest >= least_peclet) return;
  complain_of(input, fmt::format("needs surfaces that are fast in time, because heat then flows into them along the "
                                 "normal only: u a over the diffusivity of surface {} falls to {:.2g}, and {:g} are "
                                 "needed: raise its speed, or remove [transient]",
                                 name, slowest, least_peclet));
}

}  // namespace

void check_thermal_in_time(Case& input) {
  const transient::Conditions& conditions = input.transient->conditions;
  if (conditions.conserves_mass || deck::called_for(input.deck, "supply"))
    complain_of(input,
                "is not available in time with the oil content as an unknown: set [transient] cavitation = pressure "
                "and remove [supply], or remove [transient]");
  if (conditions.body && conditions.body->gap)
    complain_of(input, "needs a contact that carries its load at time 0: remove gap of [body], or remove [transient]");
  if (deck::given(input.deck, "output", "checkpoint"))
    deck::complain(input.deck, "output", "checkpoint",
                   "is not available for a run in time with [thermal], whose temperatures no checkpoint holds: remove "
                   "it");
  const double srr = input.heat->setup.srr;
  check_speed(input, "1", conditions.u1, input.heat->setup.body_1.Pe, 1.0 + 0.5 * srr);
  check_speed(input, "2", conditions.u2, input.heat->setup.body_2.Pe, 1.0 - 0.5 * srr);
}

InSteps thermal_in_steps(const Case& input) {
  const transient::Input& march = *input.transient;
  const auto course = std::make_shared<heat::InTime>(input.heat->setup, march.conditions, march.parameters.end,
                                                     input.scene.threads, input.tuning.heat);
  const double T0 = input.heat->T0, power = input.heat->power;
  std::function<double(const transient::Snapshot& state)> mu;  // [friction] has this column itself
  if (!input.friction) mu = sliding_in_steps(input);
  InSteps made{.coupling = course->coupling()};
  if (mu) made.numbers.push_back(id::mu);
  for (const StepNumber& one : step_numbers) made.numbers.push_back(one.name);
  made.measure = [course, T0, power, mu](const transient::Snapshot& state) {
    const thermal::Balance& balance = course->balance();
    std::vector<double> values;
    if (mu) values.push_back(mu(state));
    for (const StepNumber& one : step_numbers) values.push_back(one.value(balance, T0, power));
    return values;
  };
  std::vector<KeptField> kept;
  for (const KeptField& one : kept_fields)
    if (std::ranges::find(input.heat->fields, one.name) != input.heat->fields.end()) kept.push_back(one);
  for (const KeptField& one : kept)
    made.fields.push_back({one.name, "K", std::string("temperature above T_oil: ") + one.meaning});
  if (!kept.empty())
    made.measure_fields = [course, kept, T0](const transient::Snapshot& state) {
      const heat::Temperatures temperatures = course->temperatures(state.T);
      std::vector<core::Field> fields;
      for (const KeptField& one : kept) {
        fields.push_back(core::on_domain(state.grid, temperatures.*(one.field)));
        for (int i = 0; i < fields.back().nodes_x(); ++i)
          for (double& value : fields.back().station(i)) value *= T0;
      }
      return fields;
    };
  return made;
}

std::vector<numbers::Group> thermal_step_numbers() { return {numbers::heat_step_numbers(), numbers::heat_course()}; }

std::string thermal_in_time_summary(const Case& input, const Computed& computed) {
  if (!computed.in_time) return {};
  const TransientResult& run = *computed.in_time;
  const auto extremes = [&](const char* name) {
    const std::vector<double> values = column_of(run, name);
    const auto [least, most] = std::ranges::minmax(values);
    return fmt::format("{:.2f} to {:.2f} K", least, most);
  };
  double worst = 0.0;
  for (const double value : column_of(run, id::heat_imbalance)) worst = std::max(worst, std::abs(value));
  std::string text = fmt::format("             in time: film {}, surface 1 {}, surface 2 {}\n",
                                 extremes(id::T_film_max), extremes(id::T1_max), extremes(id::T2_max));
  if (!input.friction) {
    const std::vector<double> mu = column_of(run, id::mu);
    const auto [least, most] = std::ranges::minmax(mu);
    text += fmt::format("                      mu {:.5g} to {:.5g}\n", least, most);
  }
  return text + fmt::format("                      heat imbalance of the worst step {:.0e}\n", worst);
}

void thermal_in_time_warnings(const Case& input, const TransientResult& result, core::Warnings& list) {
  double worst = 0.0, hottest = 0.0;
  for (const double value : column_of(result, id::heat_imbalance)) worst = std::max(worst, std::abs(value));
  for (const double value : column_of(result, id::T_film_max)) hottest = std::max(hottest, value);
  if (worst > closed_balance)
    list.push_back({"heat-balance",
                    fmt::format("thermal: in the worst step of the run in time the heat made and the heat that is led "
                                "away or stored differ by {:.1e} of it (limit {:.0e}): use a smaller rtol or max_step",
                                worst, closed_balance)});
  hottest += input.heat->T0 - rheology::zero_celsius;
  if (hottest > rheology::hottest_oil)
    list.push_back(
        {"hot-film-in-time",
         fmt::format("thermal: in time the film reaches {:.0f} C, but the viscosity laws hold up to {:.0f} C", hottest,
                     rheology::hottest_oil)});
}

}  // namespace ehl::program
