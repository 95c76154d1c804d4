// The effect `thermal`: heat in the film and in the bodies.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/json.hpp"
#include "base/text_format.hpp"
#include "case/coupled_film.hpp"
#include "case/effects.hpp"
#include "case/numbers/records.hpp"
#include "case/thermal_in_time.hpp"
#include "case/thermal_report.hpp"
#include "deck/text.hpp"
#include "rheology/thermal_keys.hpp"
#include "thermal/keys.hpp"

namespace ehl::program {
namespace numbers {
namespace {

const HeatResult& heated(Of s) { return *s.computed.heat; }
double kelvin(Of s, double theta) { return s.input.heat->T0 * theta; }
double watts(Of s, double share) { return s.input.heat->power * share; }

std::string meaning_of_isothermal(Of s) {
  return std::string("the same of the isothermal contact") +
         (heated(s).unlikely_isothermal ? "; no oil carries it" : "");
}

Group thermal_numbers() {
  Group group{.name = "thermal"};
  group.on = [](Of s) { return s.computed.heat.has_value(); };
  group.asked = [](const deck::Deck& deck) { return deck::called_for(deck, "thermal"); };
  std::vector<Number>& list = group.numbers;
  list = {number(id::mu, "-", "sliding friction over the load, with heat", bar(id::error_mu), column(501),
                 [](Of s) { return heated(s).mu; }),
          number("mu_isothermal", "-", "the same of the isothermal contact", meaning_here(meaning_of_isothermal),
                 label("the same, isothermal"), column(503), on_page(10), [](Of s) { return heated(s).mu_isothermal; }),
          number(id::error_mu, "-", "estimated relative discretization error of mu", column(502),
                 [](Of s) { return heated(s).error_mu; })};
  const auto hottest = [&](const std::string& name, const std::string& meaning, const std::string& words, int place,
                           int on_page_at, OfSweep of_sweep, heat::Hottest heat::Solution::*part) {
    const auto at = [part](Of s) -> const heat::Hottest& { return heated(s).found.*part; };
    list.push_back(number(name, "K", meaning + ": highest temperature above T_oil", bar("error_" + name), label(words),
                          column(place), on_page(on_page_at), sweep_page(of_sweep),
                          [=](Of s) { return kelvin(s, at(s).theta); }));
    list.push_back(number(name + "_x", "a", "its position", [=](Of s) { return at(s).X; }));
    list.push_back(number(name + "_y", "a", "its position", [=](Of s) { return at(s).Y; }));
    list.push_back(number("error_" + name, "-", "estimated relative discretization error of the rise",
                          [=](Of s) { return at(s).error; }));
  };
  hottest(id::T_film_max, "film", "hottest film above T_{oil}", 504, 12, OfSweep::as_curve, &heat::Solution::in_film);
  hottest(id::T1_max, "surface 1", "hottest place of surface 1 above T_{oil}", 506, 13, OfSweep::hidden,
          &heat::Solution::on_1);
  hottest(id::T2_max, "surface 2", "hottest place of surface 2 above T_{oil}", 507, 14, OfSweep::hidden,
          &heat::Solution::on_2);
  const Unit watt{"W", "W/m"};
  const std::vector<Number> rest{
      number("T_film_mean", "K", "middle of the film above T_oil, mean weighted with the pressure", column(505),
             [](Of s) { return kelvin(s, heated(s).found.mean); }),
      number("T_inlet", "K", "middle of the film above T_oil at x = -a, y = 0",
             [](Of s) { return kelvin(s, heated(s).found.inlet); }),
      number(id::heat_made, watt, "heat made in the film by shear and compression",
             [](Of s) { return watts(s, heated(s).found.balance.heat); }),
      number(id::heat_1, watt, "heat into body 1", column(508),
             [](Of s) { return watts(s, heated(s).found.balance.into_1); }),
      number(id::heat_2, watt, "heat into body 2", column(509),
             [](Of s) { return watts(s, heated(s).found.balance.into_2); }),
      number(id::heat_carried, watt, "heat carried out of the domain by the oil",
             [](Of s) { return watts(s, heated(s).found.balance.carried); }),
      number(id::heat_imbalance, "-", "heat made less heat led away, over heat made", column(510),
             [](Of s) { return heated(s).found.balance.defect; }),
      number("nahme", "-", "largest beta tau_m |u1 - u2| h/k", column(512), [](Of s) { return heated(s).found.nahme; }),
      number("peclet_1", "-", "u1 a over the diffusivity of body 1",
             [](Of s) { return s.input.heat->setup.body_1.Pe; }),
      number("peclet_2", "-", "u2 a over the diffusivity of body 2",
             [](Of s) { return s.input.heat->setup.body_2.Pe; }),
      number("Hc_isothermal", "a^2/R", "film at (0,0) of the isothermal contact",
             [](Of s) { return heated(s).Hc_isothermal; }),
      number("Hm_isothermal", "a^2/R", "its minimum film", [](Of s) { return heated(s).Hm_isothermal; }),
      number("film_reduction", "-", "Hc over Hc_isothermal", label("film over the isothermal one"), column(511),
             on_page(15), [](Of s) { return film_reduction(heated(s)); }),
      number("wilson_sheu", "-", "the same by Wilson and Sheu 1983",
             [](Of s) { return thermal::wilson_sheu(inlet_groups(s.input)); }),
      number("gupta", "-", "the same by Gupta et al. 1992", [](Of s) { return thermal::gupta(inlet_groups(s.input)); }),
      number("murch_wilson", "-", "the same by Murch and Wilson 1975, pure rolling", [](Of s) {
        return s.input.physics.srr == 0.0 ? thermal::murch_wilson(inlet_groups(s.input)) : core::unknown;
      })};
  list.insert(list.end(), rest.begin(), rest.end());
  return group;
}

}  // namespace
}  // namespace numbers

namespace {

void read(Case& input) {
  const double limit = input.friction ? input.friction->limit : std::numeric_limits<double>::infinity();
  input.heat = thermal_input(input.deck, input.physics, input.scene, limit);
  if (input.heat) input.heat->setup.flow_thinning = input.flow_thinning;
  if (input.heat && input.transient) check_thermal_in_time(input);
}

FilmSolver film(const Case&) {
  return [](const Case& input, const steady::ProgressCallback& progress, Computed& computed) {
    computed.heat = solve_coupled(input, input.heat->setup, progress, computed.solution);
  };
}

std::string name_of_solid(const Case& input, const char* key) {
  const std::string word = deck::word(input.deck, "thermal", key);
  return word.empty() ? "own constants" : word;
}

std::string what(const Case& input) {
  const HeatInput& heat = *input.heat;
  const auto number = [&](const char* key) { return deck::number(input.deck, "thermal", key); };
  return fmt::format(
      "oil at {:.4g} C, bodies at {:.4g} and {:.4g} C ({} and {}), beta = {:.4g} 1/K, k = {:.4g} W/(m K); "
      "{} nodes across the film",
      number("T_oil"), number("T_body1"), number("T_body2"), name_of_solid(input, "solid1"),
      name_of_solid(input, "solid2"), heat.beta, heat.k, heat.setup.intervals + 1);
}

// The cost: columns of temperatures and heat flows, other fields, and the iterations between the film and the heat.
Needs expense(const Case& input) {
  const core::Grid& grid = input.scene.grid;
  // A line contact holds one batch of columns, of eight lines.
  const auto [lines, times_isothermal] = grid.line ? std::pair(8.0, 13.0) : std::pair(0.5 * grid.nodes_y(), 5.0);
  const double nodes = grid.nodes_x() * lines;
  constexpr double columns = 4.0, fields = 40.0;
  const double in_time = input.transient ? 160.0 : 0.0;  // fields: exponentials of both bodies, factors of three steps
  return {.bytes = nodes * sizeof(double) * (columns * (input.heat->setup.intervals + 1) + fields + in_time),
          .seconds = times_isothermal * basic_needs(input.scene).seconds};
}

bool kept(const Case& input, const char* field) {
  return std::ranges::find(input.heat->fields, field) != input.heat->fields.end();
}

void add_section(const Case& input, const heat::Fields& fields, results::Section& section) {
  section.group = "/thermal_section";
  section.meaning = "the section along x at y = 0: rows z over h, columns x";
  const int n = input.heat->setup.intervals;
  section.across = {"z", "-", "height over the film thickness, from surface 2", false, {}};
  for (int k = 0; k <= n; ++k) section.across.values.push_back(static_cast<double>(k) / n);
  section.fields = {{"T", "K", "temperature above T_oil", &fields.section_T},
                    {"u", "u_m", "speed along x", &fields.section_u}};
}

void add_content(const Case& input, const Computed& computed, results::Content& content) {
  if (!computed.heat) return;
  const heat::Fields& fields = computed.heat->found.fields;
  const struct {
    const char* name;
    const char* meaning;
    const core::Field* field;
  } all[] = {{"T_mid", "middle of the film", &fields.mid},
             {"T_max", "largest temperature across the film", &fields.largest},
             {"T1", "surface 1", &fields.surface_1},
             {"T2", "surface 2", &fields.surface_2}};
  for (const auto& one : all)
    if (kept(input, one.name))
      content.fields.push_back({one.name, "K", std::string("temperature above T_oil: ") + one.meaning, one.field});
  // Without mu and its error if [friction] has added them.
  numbers::append("thermal", {input, computed}, content.summary);
  if (kept(input, "section")) add_section(input, fields, content.section);
  content.tables.push_back(table_of("thermal_levels", "solutions with heat, grid by grid", thermal_columns(*input.heat),
                                    computed.heat->found.rows));
}

void json(const Case& input, const Computed& computed, Json& report) {
  if (computed.heat) report["levels"] = rows_json(thermal_columns(*input.heat), computed.heat->found.rows);
}

core::Warnings warnings(const Case& input, const Computed& computed) {
  core::Warnings list = computed.heat ? thermal_warnings(input, *computed.heat) : core::Warnings{};
  if (computed.in_time) thermal_in_time_warnings(input, *computed.in_time, list);
  return list;
}

}  // namespace

Effect thermal_effect() {
  return {.name = "thermal",
          .meaning = "Heat in the film and in the bodies, and its effect on the film.",
          .without = "isothermal",
          .sections = {{.name = "thermal", .called_by = {"T_oil", "solid1", "solid2"}}},
          .costly = {"thermal", "nodes"},
          .keys =
              [] {
                return deck::together({rheology::warm_oil_keys(), thermal::keys()});
              },
          .numbers = numbers::thermal_numbers,
          .more_numbers = thermal_step_numbers,
          .read = read,
          .stages = {.scene = observe_friction, .film = film, .in_steps = thermal_in_steps},
          .on = [](const Case& input) { return input.heat.has_value(); },
          .what = what,
          .expense = expense,
          .summary =
              [](const Case& input, const Computed& computed) {
                return thermal_summary(input, computed) + thermal_in_time_summary(input, computed);
              },
          .json = json,
          .warnings = warnings,
          .add_content = add_content,
          .seconds = [](const Computed& computed) { return computed.heat ? computed.heat->found.seconds : NAN; },
          .example = {"-contact.M", "-contact.L", "contact.load=30", "contact.radius_x=9.525e-3",
                      "contact.E_prime=226e9", "motion.u_m=2", "lubricant.eta0=0.04", "thermal.T_oil=40",
                      "thermal.beta=0.042", "thermal.solid1=steel", "thermal.solid2=steel"}};
}

}  // namespace ehl::program
