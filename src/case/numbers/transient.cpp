// The numbers of a run in time.
#include <cmath>

#include "case/course_of_run.hpp"
#include "case/numbers/records.hpp"

namespace ehl::program::numbers {
namespace {

const TransientResult& in_time(Of s) { return *s.computed.in_time; }
const transient::MarchReport& march(Of s) { return in_time(s).report; }
bool repeats(Of s) { return !std::isnan(s.input.transient->parameters.period); }
bool has_states(Of s) { return in_time(s).states.has_value(); }
bool counts_oil_in_time(Of s) { return s.input.transient->conditions.conserves_mass; }
bool runs_in_time(Of s) { return s.computed.in_time.has_value(); }
bool rubs(Of s) { return !values_of(in_time(s), id::mu).empty(); }
bool has_errors(Of s) { return runs_in_time(s) && in_time(s).errors.has_value(); }

/// One of the columns whose extremes and means are numbers of the run.
struct Course {
  const char* name;
  const char* unit;
  const char* words;
  const char* symbol;
  const char* unit_in_SI;
  const char* human_unit;
  double (*scale)(const SiScales& scales);  ///< from the unit to that in SI
};
constexpr Course courses[] = {
    {id::Hc, "a^2/R", "central film", "h_c", "m", "nm", [](const SiScales& scales) { return scales.h; }},
    {id::Hm, "a^2/R", "minimum film", "h_m", "m", "nm", [](const SiScales& scales) { return scales.h; }},
    {id::P_max, "p_h", "highest pressure", id::p_max, "Pa", "GPa", [](const SiScales& scales) { return scales.p_h; }}};

/// A kind of extreme or mean.
struct Kind {
  const char* prefix;
  double Extremes::*value;
  double Extremes::*time;  ///< nullptr: it has none
};
constexpr Kind kinds[] = {{"least_", &Extremes::least, &Extremes::time_of_least},
                          {"largest_", &Extremes::largest, &Extremes::time_of_largest},
                          {"mean_", &Extremes::mean, nullptr}};

// The numbers of one kind of a course: dimensionless, and as a column in SI. in: places of the next columns.
void add_course(const Course& course, const Kind& kind, int& place, int& place_in_SI, std::vector<Number>& list) {
  const std::string prefix = kind.prefix, name = prefix + course.name, in_SI_units = prefix + course.symbol;
  const std::string words = prefix.substr(0, prefix.size() - 1) + " " + course.words;
  const std::string meaning = words + " of the run in time";
  const auto of = [&course](Of s, double Extremes::*part) {
    return extremes_of(s.input, in_time(s), course.name).*part;
  };
  list.push_back(number(name, course.unit, meaning, bar("error_" + name), column(place++),
                        label(words + " " + course.name), sweep_page(OfSweep::in_table),
                        [=](Of s) { return of(s, kind.value); }));
  list.push_back(number(in_SI_units, course.unit_in_SI, meaning, bar("error_" + name), only_column, only_if(in_SI),
                        in_si(place_in_SI++, in_SI_units, course.human_unit), label(words + " " + course.symbol),
                        sweep_page(OfSweep::in_table),
                        [=, &course](Of s) { return of(s, kind.value) * course.scale(*si_scales(s.input.physics)); }));
  if (kind.time == nullptr) return;
  const std::string its_time = "time of " + words;
  list.push_back(number("time_of_" + name, "a/u_m", its_time, column(place++), [=](Of s) { return of(s, kind.time); }));
  list.push_back(number("time_of_" + in_SI_units, "s", its_time, only_column, only_if(in_SI),
                        in_si(place_in_SI++, "time_of_" + in_SI_units, "ms"),
                        [=](Of s) { return of(s, kind.time) * si_scales(s.input.physics)->time; }));
}

}  // namespace

Group transient_numbers() {
  Group group{.name = "transient", .prefix = "transient_"};
  group.on = runs_in_time;
  group.asked = [](const deck::Deck& deck) { return deck::called_for(deck, "transient"); };
  const auto count = [](int transient::MarchReport::*part) { return [part](Of s) { return march(s).*part; }; };
  const auto of_states = [](int transient::MarchReport::*part) {
    return [part](Of s) { return (*in_time(s).states).*part; };
  };
  using R = transient::MarchReport;
  std::vector<Number>& list = group.numbers;
  list = {
      number(id::completed, "-", "1: the run in time is complete, 0: it is not", column(701),
             [](Of s) { return completed(in_time(s)); }),
      number(id::ended, "", "how the run in time ended", [](Of s) { return how_it_ended(march(s)); }),
      number("start_converged", "-", "1: the steady contact was found; 0: bodies that start separated do not need it",
             [](Of s) { return s.computed.solution.converged; }),
      number("end_time", "a/u_m", "time reached", column(702), [](Of s) { return march(s).T; }),
      number("start_of_means", "a/u_m", "start of the times of all extremes and means", column(703),
             [](Of s) { return window_of_means(s.input, in_time(s)).from; }),
      number("end_of_means", "a/u_m", "their end", column(704),
             [](Of s) { return window_of_means(s.input, in_time(s)).to; }),
      number(id::Hc, "a^2/R", "film at (0,0) at the end", [](Of s) { return in_time(s).rows.back().Hc; }),
      number(id::Hm, "a^2/R", "minimum film at the end", [](Of s) { return in_time(s).rows.back().Hm; })};
  int place = 710, place_in_SI = 141;
  for (const Course& course : courses)
    for (const Kind& kind : kinds) add_course(course, kind, place, place_in_SI, list);
  const std::vector<Number> counters{
      number("steps", "-", "number of time steps", column(705), count(&R::steps)),
      number(id::cycles, "-", "cycles of all steps", count(&R::cycles)),
      number("newton_steps", "-", "Newton steps of all attempts", count(&R::newton_steps)),
      number("rejected", "-", "attempts that failed the error test", column(706), count(&R::rejected)),
      number("not_solved", "-", "attempts that were not solved", column(707), count(&R::not_solved)),
      number("jumps", "-", "jumps of load or speed", count(&R::restarts)),
      number("worst_load_error", "-", "largest relative error of the load",
             [](Of s) { return march(s).worst_load_error; }),
      number(id::seconds, "s", "time of the run in time", [](Of s) { return march(s).seconds; }),
      number("worst_oil_error", "-", "largest share of oil from nowhere in a step", only_if(counts_oil_in_time),
             [](Of s) { return march(s).worst_oil_error; }),
      number("oil_lost", "-", "since the start, over what the inlet brings then in a/u_m", only_if(counts_oil_in_time),
             [](Of s) { return in_time(s).rows.back().oil.lost; }),
      number("periods", "-", "whole periods of the cycle", only_if(repeats), count(&R::periods)),
      number("change_of_period", "-", "largest relative change of Hc and Hm between the last two periods",
             only_if(repeats), [](Of s) { return march(s).change_of_period; }),
      number("states_at_rest", "-", "quasi-steady states without entrainment, which have no film", only_if(has_states),
             of_states(&R::at_rest)),
      number("states_not_found", "-", "quasi-steady states that were not found", only_if(has_states),
             of_states(&R::not_found))};
  list.insert(list.end(), counters.begin(), counters.end());
  // The file contains how the run ended; the other numbers follow from its table of steps.
  for (Number& one : list) one.in_file = one.name == id::completed || one.name == id::ended;
  return group;
}

std::vector<Group> errors_of_transient() {
  Group group{.name = "errors in time", .prefix = "transient_"};
  group.on = has_errors;
  group.asked = [](const deck::Deck& deck) { return deck::word(deck, "transient", "error") == "on"; };
  int place = 760;
  const auto add = [&](const std::string& of, const char* prefix) {
    const std::string name = prefix + of;
    group.numbers.push_back(number("error_" + name, "-", "estimated relative error of " + name, column(place++),
                                   json("errors/" + name), [name](Of s) {
                                     const auto found = in_time(s).errors->of.find(name);
                                     return found == in_time(s).errors->of.end() ? core::unknown : found->second;
                                   }));
  };
  for (const Course& course : courses)
    for (const Kind& kind : kinds) add(course.name, kind.prefix);
  for (const Kind& kind : kinds) {
    add(id::mu, kind.prefix);
    group.numbers.back().only_if = rubs;
  }
  return {group};
}

}  // namespace ehl::program::numbers
