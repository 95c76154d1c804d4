#pragma once
// How the records of the registry are written, for the files of this folder alone:
//   number(name, unit, meaning, options..., value)
#include <type_traits>
#include <utility>

#include "case/numbers/number.hpp"

namespace ehl::program::numbers {

/// What a record says beyond name, unit, meaning and value.
struct Option {
  std::function<void(Number&)> set{};
};

inline Option only_if(bool (*condition)(Of)) {
  return {[=](Number& of) { of.only_if = condition; }};
}
inline Option meaning_here(std::string (*meaning)(Of)) {
  return {[=](Number& of) { of.meaning_here = meaning; }};
}
inline Option json(const std::string& path) {
  return {[=](Number& of) { of.json = path; }};
}
inline Option bar(const std::string& error) {
  return {[=](Number& of) { of.error = error; }};
}
inline Option label(const std::string& words) {
  return {[=](Number& of) { of.label = words; }};
}
inline Option column(int place, const Value& blank = core::unknown) {
  return {[=](Number& of) { of.column = {place, blank, false}; }};
}
inline Option column_only_si(int place) {
  return {[=](Number& of) { of.column = {place, core::unknown, true}; }};
}
inline Option in_si(int place, const std::string& symbol, const std::string& unit) {
  return {[=](Number& of) { of.in_si = {place, symbol, unit}; }};
}
inline Option on_page(int place, const std::string& words = "", const std::string& note = "") {
  return {[=](Number& of) { of.page = {place, words, note}; }};
}
inline Option sweep_page(OfSweep how) {
  return {[=](Number& of) { of.of_sweep = how; }};
}
inline const Option not_json{[](Number& of) { of.json = results::not_in_json; }};
inline const Option not_in_file{[](Number& of) { of.in_file = false; }};
/// The number is a column of a sweep and is shown nowhere else.
inline const Option only_column{[](Number& of) {
  of.json = results::not_in_json;
  of.in_file = false;
}};

template <class... More>
Number number(const std::string& name, const Unit& unit, const std::string& meaning, More... more) {
  Number made{.name = name, .unit = unit, .meaning = meaning};
  [[maybe_unused]] const auto take = [&](auto& one) {
    if constexpr (std::is_same_v<std::decay_t<decltype(one)>, Option>)
      one.set(made);
    else
      made.value = std::move(one);
  };
  (take(more), ...);
  return made;
}

inline const steady::Solution& solution(Of s) { return s.computed.solution; }
inline bool in_SI(Of s) { return s.input.physics.si.has_value(); }
inline bool of_line(Of s) { return s.input.scene.grid.line; }

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
std::vector<Number> friction_numbers();
std::vector<Number> shear_numbers();
std::vector<Number> thermal_numbers();
std::vector<Number> starvation_numbers();
std::vector<Number> ending_numbers();
std::vector<Number> transient_numbers();
std::vector<Number> step_numbers();

}  // namespace ehl::program::numbers
