#include "dry/keys.hpp"

#include "deck/text.hpp"
#include "dry/solve.hpp"

namespace ehl::dry {

using deck::Key;
using deck::Type;

std::vector<Key> keys() {
  const Parameters defaults;
  const deck::Condition dry{.name = "kind", .words = {"dry"}, .section = "case"};
  return {
      Key{.section = "case",
          .name = "kind",
          .type = Type::word,
          .default_text = "lubricated",
          .words = {"lubricated", "dry"},
          .meaning =
              "dry: the bodies touch without lubricant, Hertz' contact with whatever the surfaces carry. Then "
              "[contact] "
              "has load, radius_x and the elastic data, or nothing (in units of Hertz), and no key is allowed that "
              "speaks of a film."},
      Key{.section = "dry",
          .name = "tolerance",
          .default_text = deck::shortest(defaults.tolerance),
          .range = {1e-12, 1e-2},
          .meaning = "Largest gap inside the contact and largest overlap outside it, in a^2/R.",
          .source = "modules/dry/README.md",
          .needs = dry},
      Key{.section = "dry",
          .name = "max_iterations",
          .type = Type::integer,
          .default_text = std::to_string(defaults.max_iterations),
          .range = {1, 1000000},
          .meaning = "Iterations on each grid at most.",
          .needs = dry},
  };
}

}  // namespace ehl::dry
