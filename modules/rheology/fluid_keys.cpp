// Fluids by name, and keys that follow from others.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "deck/record.hpp"
#include "rheology/fluids.hpp"
#include "rheology/keys.hpp"

namespace ehl::rheology {
namespace {

using Names = std::vector<std::string>;

// Checks [lubricant] temperature against the fluid.
void check_temperature(const deck::Part& lubricant, const Fluid& fluid) {
  const std::string name(fluid.name);
  const std::string_view only = value_of(fluid, "temperature");
  if (!value_of(fluid, "kv40").empty())
    lubricant.fill("temperature", deck::read_number(std::string(temperature_of_grades)).value,
                   "where the grade is defined");
  else if (lubricant.given("temperature") &&
           lubricant.number("temperature") != deck::read_number(std::string(only)).value)
    lubricant.complain("temperature", "fluid = " + name + " is known at " +
                                          (only.empty() ? "one temperature" : std::string(only) + " C") +
                                          " only: remove it, or give an oil by kv40, kv100, density15 and alpha_star");
}

}  // namespace

deck::Key fluid_key() {
  using namespace deck::record;
  deck::Key made =
      key("fluid", example("mineral-vg68"), otherwise("none: the oil is given by the keys of [lubricant]"),
          "Oil by name: laws of viscosity and density with their constants. If its viscosities at two temperatures are "
          "known, `temperature` applies (default 40 C). A key that the oil sets may be repeated with the same value; "
          "another value, or a constant of another law, is an error.");
  for (const Fluid& fluid : fluids) {
    made.words.emplace_back(fluid.name);
    if (fluid.source.empty()) continue;
    if (!made.source.empty()) made.source += "; ";
    made.source.append(fluid.name).append(": ").append(fluid.about).append(" (").append(fluid.source).append(")");
  }
  return made;
}

void settle(const deck::Part& lubricant, const std::string& name, const std::string& text, const std::string& why) {
  constexpr double rounding = 1e-12;
  const deck::ReadNumber settled = deck::read_number(text);
  const bool is_number = settled.status == deck::ReadNumber::Status::number;
  const double said = lubricant.number(name);
  const bool same =
      is_number ? std::isnan(said) || std::abs(said / settled.value - 1.0) < rounding : lubricant.word(name) == text;
  if (lubricant.given(name) && !same)
    lubricant.complain(name,
                       "is " + (is_number ? deck::shortest(settled.value) : text) + " already, " + why + ": remove it");
  if (is_number)
    lubricant.fill(name, settled.value, why);
  else
    lubricant.fill(name, text, why);
}

void settle_at_temperature(const deck::Part& lubricant, const std::string& name, double value,
                           const std::string& from) {
  const deck::Key& key = lubricant.key(name);
  if (key.range.contains(value)) {
    settle(lubricant, name, deck::shortest(value), fmt::format("{} at {:g} C", from, lubricant.number("temperature")));
    deck::mark_following(lubricant.deck, lubricant.section, name);
  } else {
    lubricant.complain("temperature",
                       fmt::format("with {} it means {} = {:.3g} {}, which must be {}: check all of them", from, name,
                                   value, key.unit, deck::allowed(key)));
  }
}

void demand(const deck::Part& lubricant, const Names& names, const std::string& law) {
  for (const std::string& name : names)
    if (!lubricant.has(name))
      lubricant.complain(name, "is missing: " + law + " needs " + deck::joined(names, ", "), deck::Cause::missing);
}

void choose_fluid(const deck::Part& lubricant) {
  const Fluid* fluid = find_fluid(lubricant.word("fluid"));
  if (!fluid) return;  // none, or an unknown name that was reported
  const std::string why = std::string("fluid = ").append(fluid->name);
  check_temperature(lubricant, *fluid);
  Names set{"temperature"};
  for (const FluidKey& key : fluid->keys) {
    if (key.name.empty()) break;
    if (key.name == "temperature") continue;  // checked above; the deck need not give it
    set.emplace_back(key.name);
    settle(lubricant, set.back(), std::string(key.value), why);
  }
  if (!value_of(*fluid, "alpha").empty()) {
    const double z = roelands_z(lubricant.number("alpha"), lubricant.number("p0"), lubricant.number("eta0"));
    settle(lubricant, "z", deck::shortest(z), why);
  } else if (value_of(*fluid, "alpha_star").empty()) {
    set.emplace_back("alpha");  // set by the law, as are the other derived values
  }
  if (!value_of(*fluid, "kv40").empty()) set.emplace_back("eta0");
  if (lubricant.word("viscosity") == "roelands") set.emplace_back("z");
  for (const deck::Key& key : lubricant.deck.catalogue.keys)
    if (key.section == lubricant.section && key.name != "fluid" && std::ranges::find(set, key.name) == set.end())
      lubricant.refuse({key.name},
                       "has no influence: " + why + " sets its laws and constants (" + deck::joined(set, ", ") +
                           "); remove it, or give the oil by its constants",
                       deck::Cause::idle);
}

}  // namespace ehl::rheology
