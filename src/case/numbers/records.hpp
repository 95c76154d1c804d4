#pragma once
// How the records of the registry are written, for the files of this folder and of the effects:
//   number(name, unit, meaning, options..., value)
#include <type_traits>
#include <utility>

#include "case/numbers/number.hpp"

namespace ehl::program::numbers {

// Options: what a record says beyond name, unit, meaning and value.
// clang-format off
inline auto only_if(bool (*condition)(Of)) { return [=](Number& of) { of.only_if = condition; }; }
inline auto meaning_here(std::string (*meaning)(Of)) { return [=](Number& of) { of.meaning_here = meaning; }; }
inline auto json(const std::string& path) { return [=](Number& of) { of.json = path; }; }
inline auto bar(const std::string& error) { return [=](Number& of) { of.error = error; }; }
inline auto label(const std::string& words) { return [=](Number& of) { of.label = words; }; }
inline auto sweep_page(OfSweep how) { return [=](Number& of) { of.of_sweep = how; }; }
inline auto column_only_si(int place) { return [=](Number& of) { of.column = {place, core::unknown, true}; }; }
inline void not_json(Number& of) { of.json = results::not_in_json; }
inline void not_in_file(Number& of) { of.in_file = false; }
// clang-format on
inline auto column(int place, const Value& blank = core::unknown) {
  return [=](Number& of) { of.column = {place, blank, false}; };
}
inline auto in_si(int place, const std::string& symbol, const std::string& unit) {
  return [=](Number& of) { of.in_si = {place, symbol, unit}; };
}
inline auto on_page(int place, const std::string& words = "", const std::string& note = "") {
  return [=](Number& of) { of.page = {place, words, note}; };
}
/// The number is a column of a sweep and is shown nowhere else.
inline void only_column(Number& of) {
  not_json(of);
  not_in_file(of);
}

/// A record. in: more: options, and the value as a function of the solved case.
template <class... More>
Number number(const std::string& name, const Unit& unit, const std::string& meaning, More... more) {
  Number made{.name = name, .unit = unit, .meaning = meaning};
  [[maybe_unused]] const auto take = [&](auto& one) {
    if constexpr (std::is_invocable_v<decltype(one), Number&>)
      one(made);
    else
      made.value = std::move(one);
  };
  (take(more), ...);
  return made;
}

inline const steady::Solution& solution(Of s) { return s.computed.solution; }
inline bool in_SI(Of s) { return s.input.physics.si.has_value(); }
inline bool of_line(Of s) { return per_length(s.input); }

/// The records, by group.
std::vector<Number> row_numbers();
std::vector<Number> timing_numbers();
std::vector<Number> similarity_numbers();
std::vector<Number> scale_numbers();
std::vector<Number> grid_numbers();
std::vector<Number> machine_numbers(const machines::Contact& machine);
std::vector<Number> film_numbers();
std::vector<Number> course_numbers();
std::vector<Number> roughness_numbers();
std::vector<Number> verification_numbers();
std::vector<Number> line_formulas();
std::vector<Number> line_deviations();
std::vector<Number> point_formulas();
std::vector<Number> point_deviations();
std::vector<Number> ellipse_formulas();
std::vector<Number> ellipse_deviations();

/// How a run in time went, and extremes and means over it; the error bars of these.
Group transient_numbers();
std::vector<Group> errors_of_transient();

}  // namespace ehl::program::numbers
