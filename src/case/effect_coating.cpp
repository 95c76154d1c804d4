// The effect `coating`: elastic coatings bonded to the bodies.
#include <fmt/core.h>

#include <algorithm>

#include "base/text_format.hpp"
#include "case/effects.hpp"
#include "deck/text.hpp"

namespace ehl::program {
namespace {

const std::vector<KeyName> callers{{"contact", "coating1_E"}, {"contact", "coating2_E"}};

bool asked(const deck::Deck& deck) {
  return std::ranges::any_of(callers, [&](const KeyName& key) { return deck::given(deck, key.section, key.name); });
}

void refuse(deck::Deck& deck) {
  const deck::Part contact{deck, "contact"};
  const auto complain = [&](const std::string& why) {
    contact.complain(contact.given("coating1_E") ? "coating1_E" : "coating2_E", "is not available " + why);
  };
  for (const auto& [section, why] : {std::pair{"thermal", "the heat conduction of coatings is not computed"},
                                     {"subsurface", "the stresses in and below coatings are not computed"}})
    if (deck::called_for(deck, section))
      complain(fmt::format("with [{}]: {}; remove the coating or [{}]", section, why, section));
  if (contact.word("kind") == "roller") complain("for a roller: use kind = line, or remove the coating");
}

// The coatings of the scene, with all lengths in a.
void enter(Case& input) {
  if (!asked(input.deck) || !input.physics.si) return;
  refuse(input.deck);
  const SiInput& si = *input.physics.si;
  if (!input.deck.errors.empty() || si.coatings.empty()) return;
  steady::Coatings& coatings = input.scene.coatings;
  coatings.stiffness = si.contact.E_prime / si.E_prime_uncoated;
  for (kernel::Coating coating : si.coatings) {
    coating.thickness /= si.hertz.a;
    coatings.parts.emplace_back(coating, contact::line(input.scene.contact.shape));
  }
}

std::string what(const Case& input) {
  const SiInput& si = *input.physics.si;
  const auto number = [&](const std::string& name) { return deck::number(input.deck, "contact", name); };
  std::string text;
  for (const std::string body : {"1", "2"}) {
    const std::string name = "coating" + body;
    if (!deck::given(input.deck, "contact", name + "_E")) continue;
    const double thickness = number(name + "_thickness");
    text +=
        fmt::format("body {}: E = {}, nu = {:.4g}, {} thick ({:.4g} a); ", body, pressure_in_GPa(number(name + "_E")),
                    number(name + "_nu"), length(thickness), thickness / si.hertz.a);
  }
  return text + "the bodies have E' = " + pressure_in_GPa(si.E_prime_uncoated) + ", the scales " +
         pressure_in_GPa(si.contact.E_prime);
}

}  // namespace

Effect coating_effect() {
  return {.name = "coating",
          .meaning = "Elastic coatings bonded to the bodies.",
          .callers = callers,
          .stages = {.scene = enter},
          .on = [](const Case& input) { return !input.scene.coatings.parts.empty(); },
          .what = what,
          .example = {"-contact.M", "-contact.L", "contact.load=20", "contact.radius_x=0.01", "contact.E1=210e9",
                      "contact.nu1=0.3", "contact.E2=210e9", "contact.nu2=0.3", "contact.coating1_E=400e9",
                      "contact.coating1_nu=0.2", "contact.coating1_thickness=2e-6", "motion.u_m=1",
                      "lubricant.eta0=0.04", "lubricant.alpha=2e-8"}};
}

}  // namespace ehl::program
