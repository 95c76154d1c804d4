#include "effects/friction/keys.hpp"

#include <algorithm>
#include <limits>

namespace ehl::friction {

std::vector<deck::Key> keys() {
  return deck::in_section(
      "friction",
      {{.name = "cavitated",
        .words = {"none", "striated", "full"},
        .meaning = "Computes the friction, and states what the cavitated region adds to it. none: nothing. striated: "
                   "oil streamers that carry the oil which left the pressurized film; the rest of the width is gas. "
                   "full: an oil film that fills the whole gap.",
        .source = "modules/effects/friction/README.md",
        .example = "striated"},
       {.name = "limit",
        .range = {0.0, 10.0, true, false},
        .remedy = "lubricants have 0.03 to 0.12",
        .meaning = "Limiting shear stress over pressure, Lambda: the shear stress of sliding stays below Lambda p. "
                   "Without this key there is no limit. The limit changes the friction, not the film.",
        .example = "0.08"},
       {.name = "meniscus",
        .default_note =
            "the radius of the bodies in the rolling direction; none for a line contact: the oil reaches to infinity",
        .range = {1.0, 1e6, true, false},
        .remedy = "a distance in Hertz radii, outside the contact",
        .meaning = "Distance of the inlet meniscus from the centre of the contact, in Hertz radii. Oil fills the gap "
                   "to where the undeformed gap is as wide as at this distance. Friction is counted up to it, also "
                   "outside the domain; for a point contact it grows with the logarithm of the distance. The pressure "
                   "is still that of a flooded contact.",
        .source = "modules/effects/friction/README.md",
        .example = "10"},
       {.name = "meniscus_m",
        .unit = "m",
        .range = {0.0, std::numeric_limits<double>::infinity(), true, true},
        .meaning = "Distance of the inlet meniscus from the centre of the contact, for a contact in SI.",
        .example = "2e-3"},
       {.name = "fields",
        .type = deck::Type::words,
        .words = {"tau1", "tau2"},
        .meaning = "Shear stresses stored as fields: tau1, from the film on surface 1, and tau2, on surface 2, "
                   "positive along +x.",
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
