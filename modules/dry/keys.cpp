#include "dry/keys.hpp"

#include "deck/text.hpp"
#include "dry/solve.hpp"

namespace ehl::dry {

using deck::Type;

std::vector<deck::Key> keys() {
  const Parameters defaults;
  const deck::Condition dry{.name = "kind", .words = {"dry"}, .section = "case"};
  return deck::in_section(
      "dry",
      {{.name = "tolerance",
        .default_text = deck::shortest(defaults.tolerance),
        .range = {1e-12, 1e-2},
        .meaning =
            "Accuracy of the dry contact: largest gap inside the contact and largest overlap outside it, in a^2/R.",
        .source = "modules/dry/README.md",
        .needs = dry},
       {.name = "max_iterations",
        .type = Type::integer,
        .default_text = std::to_string(defaults.max_iterations),
        .range = {1, 1000000},
        .meaning = "Largest number of iterations on each grid.",
        .needs = dry}});
}

std::optional<Parameters> read(deck::Deck& deck) {
  if (deck::word(deck, "case", "kind") != "dry") return std::nullopt;
  const deck::Part dry{deck, "dry"};
  Parameters parameters;
  parameters.tolerance = dry.number("tolerance");
  parameters.max_iterations = dry.integer("max_iterations", parameters.max_iterations);
  return parameters;
}

}  // namespace ehl::dry
