#include "effects/friction/keys.hpp"

namespace ehl::friction {

std::vector<deck::Key> keys() {
  using deck::Key;
  using deck::Type;
  return {
      Key{.section = "friction",
          .name = "cavitated",
          .type = Type::word,
          .words = {"none", "striated", "full"},
          .meaning =
              "Computes the friction; and what the cavitated region adds to it: nothing; streamers that carry what "
              "left the pressurised film, the rest of the width being gas; or a film that fills the whole gap.",
          .source = "modules/effects/friction/README.md",
          .example = "striated"},
      Key{.section = "friction",
          .name = "limit",
          .range = {0.0, 10.0, true, false},
          .remedy = "lubricants have 0.03 to 0.12",
          .meaning =
              "Lambda: the shear stress of sliding stays below the limiting stress Lambda p. Without it there is no "
              "limit. It acts on the friction, not on the film.",
          .example = "0.08"},
      Key{.section = "friction",
          .name = "fields",
          .type = Type::words,
          .words = {"tau1", "tau2"},
          .meaning = "Shear stresses to keep as fields: what the film does to surface 1 and to surface 2 along +x.",
          .example = "tau1, tau2"},
  };
}

}  // namespace ehl::friction
