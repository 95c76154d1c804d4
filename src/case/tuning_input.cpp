#include "case/tuning_input.hpp"

#include <fmt/format.h>

#include <cmath>

#include "deck/text.hpp"

namespace ehl::program {
namespace {

constexpr const char* section_of_tuning = "tuning";

// Calls act(name of the module, table of its numbers, its member of TunedNumbers) for every module.
template <class Act>
void for_modules(Act act) {
  act("multigrid", multigrid::tuned_numbers(), &TunedNumbers::multigrid);
  act("judgement", judgement::tuned_numbers(), &TunedNumbers::judgement);
  act("steady", steady::tuned_numbers(), &TunedNumbers::steady);
  act("newton", newton::tuned_numbers(), &TunedNumbers::newton);
  act("transient", transient::tuned_numbers(), &TunedNumbers::transient);
  act("heat", heat::tuned_numbers(), &TunedNumbers::heat);
}

/// A number may be changed by this factor; beyond it, loops may not end and grids not be made.
constexpr double widest_range = 1000.0;

deck::Range range_of(core::Tunable kind, double standard) {
  const double most = widest_range * standard;
  switch (kind) {
    case core::Tunable::share: return {0.0, 1.0, true, false};
    case core::Tunable::reduction: return {0.0, 1.0, true, true};
    case core::Tunable::growth: return {1.0, most, true, false};
    case core::Tunable::positive: return {standard / widest_range, most};
    case core::Tunable::count: break;
  }
  return {1.0, most};
}

std::string as_set(const core::Retuned& number) {
  return number.name + " = " + deck::shortest(number.value) + " (default " + deck::shortest(number.default_value) + ")";
}

}  // namespace

deck::Section tuning_section() {
  return {.name = section_of_tuning,
          .meaning =
              "Numbers of the numerical method that were chosen by experience. All tests and error bars belong to "
              "the defaults; a result with other values carries a warning.",
          .on_request = true};
}

std::vector<deck::Key> tuning_keys() {
  std::vector<deck::Key> keys;
  for_modules([&](const std::string& module, const auto& table, auto member) {
    const auto defaults = TunedNumbers{}.*member;
    deck::Condition needs;
    if (module == "transient") needs = {.name = "end_time", .section = "transient"};
    if (module == "heat")
      needs = {.section = "thermal", .or_else = {{.name = "flow", .words = {"on"}, .section = "shear"}}};
    for (const auto& number : table) {
      const double standard = number.value(defaults);
      keys.push_back({.name = module + "." + number.name,
                      .type = number.kind == core::Tunable::count ? deck::Type::integer : deck::Type::number,
                      .default_note = deck::shortest(standard),
                      .range = range_of(number.kind, standard),
                      .meaning = number.meaning,
                      .source = "tests/bench/tuning.csv",
                      .needs = needs});
    }
  });
  return deck::in_section(section_of_tuning, std::move(keys));
}

TunedNumbers read_tuning(const deck::Deck& deck) {
  TunedNumbers numbers;
  for_modules([&](const std::string& module, const auto& table, auto member) {
    for (const auto& number : table)
      if (const double given = deck::number(deck, section_of_tuning, module + "." + number.name); !std::isnan(given))
        number.set(numbers.*member, given);
  });
  return numbers;
}

std::vector<core::Retuned> retuned(const TunedNumbers& numbers) {
  std::vector<core::Retuned> all;
  for_modules([&](const std::string& module, const auto& table, auto member) {
    for (core::Retuned& one : core::retuned(table, numbers.*member)) {
      one.name = module + "." + one.name;
      all.push_back(std::move(one));
    }
  });
  return all;
}

std::optional<core::Warning> tuning_warning(const TunedNumbers& numbers) {
  const std::vector<core::Retuned> changed = retuned(numbers);
  if (changed.empty()) return std::nullopt;
  std::vector<std::string> names;
  for (const core::Retuned& one : changed) names.push_back(as_set(one));
  return core::Warning{"tuning", "the tuned numbers are not the tested ones: " + deck::joined(names, ", ") +
                                     "; error bars and checks may not hold; remove [tuning] for the defaults"};
}

std::string tuning_lines(const TunedNumbers& numbers) {
  const std::vector<core::Retuned> changed = retuned(numbers);
  if (changed.empty()) return "Tuned numbers: all at their defaults\n";
  std::string text = "Tuned numbers that differ from their defaults\n";
  for (const core::Retuned& one : changed) text += "  " + as_set(one) + "\n";
  return text;
}

}  // namespace ehl::program
