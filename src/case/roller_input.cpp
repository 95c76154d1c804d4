#include "case/roller_input.hpp"

#include <string>

#include "effects/roller/keys.hpp"
#include "effects/roller/limits.hpp"
#include "effects/roller/scene.hpp"

namespace ehl::program {

void settle_roller(deck::Deck& deck) {
  const deck::Part contact{deck, "contact"}, domain{deck, "domain"}, path{deck, "continuation"};
  if (!deck::given(deck, "roller", "profile"))
    contact.complain("kind",
                     "needs a profile in [roller]: straight with rounded ends, crowned, logarithmic or a table");
  if (domain.given("far_field") && domain.word("far_field") == "closed")
    domain.complain("far_field", "closed is that of a contact without ends: zero, or remove it");
  domain.follow("far_field", std::string("zero"), "the roller ends at the sides of the domain");
  if (path.given("path") && path.word("path") == "load")
    path.complain("path",
                  "load is not available for rollers, whose length in half widths changes with the load: off, "
                  "or remove it");
  path.follow("path", std::string("off"), "the length in half widths changes with the load");
}

void roller_input(Case& input) {
  deck::Deck& deck = input.deck;
  const contact::Ellipse& shape = input.physics.groups.shape;
  if (!deck::given(deck, "roller", "profile") || !deck.errors.empty()) return;
  if (!contact::roller(shape)) {
    deck::Part{deck, "roller"}.complain("profile",
                                        "has no influence without [contact] kind = roller or [case] kind = "
                                        "roller_race: set one of them, or remove it");
    return;
  }
  roller::Scales scales{
      .length = shape.length, .a_over_R = input.physics.a_over_R, .in_SI = input.physics.language == Language::si};
  if (input.physics.si) {
    scales.a = input.physics.si->hertz.a;
    scales.radius = input.physics.si->contact.radius;
    scales.load = deck::number(deck, "contact", "load");
  }
  const roller::Profile profile = roller::read(deck, scales);
  if (deck.errors.empty()) roller::check_limits(deck, scales, input.scene.grid, profile);
  if (!deck.errors.empty()) return;
  input.roller = profile;
  roller::lay(profile, input.scene);
}

}  // namespace ehl::program
