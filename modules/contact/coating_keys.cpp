// The keys of elastic coatings.
#include <fmt/format.h>

#include "contact/coatings.hpp"
#include "contact/hertz.hpp"
#include "deck/record.hpp"

namespace ehl::contact {
namespace {

// The kernel of a coating is accurate up to this ratio of moduli.
constexpr double largest_ratio = 1000.0;

std::vector<std::string> names_of(const std::string& body) {
  const std::string name = "coating" + body;
  return {name + "_E", name + "_nu", name + "_thickness"};
}

}  // namespace

std::vector<deck::Key> coating_keys() {
  using namespace deck::record;
  std::vector<deck::Key> keys;
  for (const std::string body : {"1", "2"}) {
    const std::vector<std::string> names = names_of(body);
    keys.push_back(key(names[0], unit("Pa"), positive, example("300e9"),
                       "Young's modulus of an elastic coating bonded to body " + body +
                           ". Give it with its nu and thickness, and E1, nu1, E2 and nu2 of the bodies below. The "
                           "scales E', a, p_h, M and L are then those of uncoated bodies that yield about as much.",
                       source("O'Sullivan and King 1988; Nogi and Kato 1997")));
    keys.push_back(key(names[1], Range{-1.0, 0.5, true, false}, example("0.2"),
                       "Poisson's ratio of the coating of body " + body + "."));
    keys.push_back(key(names[2], unit("m"), up_to(1.0), example("2e-6"),
                       "Thickness of the coating of body " + body + ".", remedy("2 um are 2e-6")));
  }
  return keys;
}

std::vector<kernel::Coating> read_coatings(const deck::Part& contact) {
  std::vector<kernel::Coating> coatings;
  for (const std::string body : {"1", "2"}) {
    const std::vector<std::string> names = names_of(body);
    if (contact.given_of(names).empty()) continue;
    contact.demand(names, "a coating has a modulus, a Poisson's ratio and a thickness");
    contact.demand({"E1", "nu1", "E2", "nu2"}, "a coated contact needs the moduli of both bodies, instead of E_prime");
    const auto number = [&](const std::string& name) { return contact.number(name); };
    const kernel::Material bodies[] = {{number("E1"), number("nu1")}, {number("E2"), number("nu2")}};
    const kernel::Material& own = bodies[body == "1" ? 0 : 1];
    const kernel::Material layer{number(names[0]), number(names[1])};
    if (const double ratio = layer.E / own.E; ratio > largest_ratio || ratio < 1.0 / largest_ratio)
      contact.complain(
          names[0],
          fmt::format(
              "is {:.4g} times the modulus of its body, which must be between {:g} and {:g}: check the units (Pa)",
              ratio, 1.0 / largest_ratio, largest_ratio));
    if (layer.E == own.E && layer.nu == own.nu) continue;
    coatings.push_back({.coating = layer,
                        .body = own,
                        .thickness = number(names[2]),
                        .share = 0.5 * reduced_modulus(bodies[0], bodies[1]) * (1.0 - own.nu * own.nu) / own.E});
  }
  return coatings;
}

}  // namespace ehl::contact
