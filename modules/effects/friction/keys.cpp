#include "effects/friction/keys.hpp"

#include <algorithm>
#include <limits>

namespace ehl::friction {

std::vector<deck::Key> keys() {
  return deck::in_section(
      "friction",
      {{.name = "cavitated",
        .words = {"none", "striated", "full"},
        .meaning = "Computes the friction; and what the cavitated region adds to it: nothing; streamers that carry "
                   "what left the pressurised film, the rest of the width being gas; or a film that fills the whole "
                   "gap.",
        .source = "modules/effects/friction/README.md",
        .example = "striated"},
       {.name = "limit",
        .range = {0.0, 10.0, true, false},
        .remedy = "lubricants have 0.03 to 0.12",
        .meaning = "Lambda: the shear stress of sliding stays below the limiting stress Lambda p. Without it there "
                   "is no limit. It acts on the friction, not on the film.",
        .example = "0.08"},
       {.name = "meniscus",
        .default_note = "the radius of the bodies along the entrainment; of lines none, the oil goes on for ever",
        .range = {1.0, 1e6, true, false},
        .remedy = "a distance in Hertz radii, beyond the contact",
        .meaning = "Distance of the inlet meniscus from the middle of the contact in Hertz radii: oil fills the gap as "
                   "far as the undeformed gap is no wider than there. Friction is counted up to it, outside of the "
                   "domain too; round a point it grows with the logarithm of this distance. The pressure is that of a "
                   "flooded contact all the same.",
        .source = "modules/effects/friction/README.md",
        .example = "10"},
       {.name = "meniscus_m",
        .unit = "m",
        .range = {0.0, std::numeric_limits<double>::infinity(), true, true},
        .meaning = "The same distance, for a contact in SI.",
        .example = "2e-3"},
       {.name = "fields",
        .type = deck::Type::words,
        .words = {"tau1", "tau2"},
        .meaning = "Shear stresses to keep as fields: what the film does to surface 1 and to surface 2 along +x.",
        .example = "tau1, tau2"}});
}

Parameters read(deck::Deck& deck) {
  const deck::Part friction{deck, "friction"};
  Parameters parameters;
  parameters.cavitated = friction.choice("cavitated", {Cavitated::none, Cavitated::striated, Cavitated::full});
  const double limit = friction.number("limit");
  if (friction.given("limit")) parameters.limit = limit;
  const std::vector<std::string> fields = friction.words("fields");
  parameters.keep_tau1 = std::ranges::find(fields, "tau1") != fields.end();
  parameters.keep_tau2 = std::ranges::find(fields, "tau2") != fields.end();
  return parameters;
}

}  // namespace ehl::friction
