#include "effects/friction/keys.hpp"

#include <algorithm>

#include "deck/record.hpp"

namespace ehl::friction {

namespace {

deck::Records<Parameters> records() {
  using namespace deck::record;
  return {
      key("cavitated", &Parameters::cavitated,
          {{"none", Cavitated::none}, {"striated", Cavitated::striated}, {"full", Cavitated::full}},
          example("striated"),
          "Computes the friction, with [transient] at every step, and states what the cavitated region adds to it. "
          "none: nothing. striated: oil "
          "streamers that carry the oil which left the pressurized film; the rest of the width is gas. full: an oil "
          "film that fills the whole gap.",
          source("modules/effects/friction/README.md")),
      key("limit", &Parameters::limit, up_to(10.0), example("0.08"),
          "Limiting shear stress over pressure, Lambda: the shear stress of sliding stays below Lambda p. Without "
          "this key there is no limit. The limit changes the friction, and with [shear] flow = on also the film, where "
          "the limit is at least tau_0 or G.",
          remedy("lubricants have 0.03 to 0.12")),
      key("meniscus", Range{1.0, 1e6, true, false}, example("10"),
          otherwise("the radius of the bodies in the rolling direction; none for a line contact: the oil reaches to "
                    "infinity"),
          "Distance of the inlet meniscus from the centre of the contact, in Hertz radii. Oil fills the gap to where "
          "the undeformed gap is as wide as at this distance. Friction is counted up to it, also outside the domain; "
          "for a point contact it grows with the logarithm of the distance. The pressure is still that of a flooded "
          "contact.",
          remedy("a distance in Hertz radii, outside the contact"), source("modules/effects/friction/README.md")),
      key("meniscus_m", instead_of({"meniscus"}), unit("m"), positive, example("2e-3"),
          "Distance of the inlet meniscus from the centre of the contact, for a contact in SI."),
      key("fields", deck::Type::words, words({"tau1", "tau2"}), example("tau1, tau2"),
          "Shear stresses stored as fields: tau1, from the film on surface 1, and tau2, on surface 2, positive along "
          "+x. With [transient] also at every stored time.")};
}

}  // namespace

std::vector<deck::Key> keys() { return deck::keys_of("friction", records()); }

Parameters read(deck::Deck& deck) {
  const deck::Part friction{deck, "friction"};
  Parameters parameters;
  deck::read(friction, records(), parameters);
  const std::vector<std::string> fields = friction.words("fields");
  parameters.keep_tau1 = std::ranges::find(fields, "tau1") != fields.end();
  parameters.keep_tau2 = std::ranges::find(fields, "tau2") != fields.end();
  return parameters;
}

}  // namespace ehl::friction
