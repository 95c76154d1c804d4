#include "case/roller_input.hpp"

#include <string>

#include "effects/roller/keys.hpp"
#include "effects/roller/limits.hpp"
#include "effects/roller/scene.hpp"

namespace ehl::program {

void settle_roller(deck::Deck& deck) {
  const deck::Part contact{deck, "contact"}, domain{deck, "domain"}, path{deck, "continuation"};
  if (!deck::given(deck, "roller", "profile"))
    contact.complain(
        "kind",
        "needs a profile in [roller]: set [roller] profile = straight (rounded ends), crowned, logarithmic or table");
  if (domain.given("far_field") && domain.word("far_field") == "closed")
    domain.complain("far_field", "closed holds for a contact without ends: set zero, or remove it");
  domain.follow("far_field", std::string("zero"), "the roller ends at the sides of the domain");
  if (path.given("path") && path.word("path") == "load")
    path.complain(
        "path",
        "load is not available for rollers, whose length in half widths changes with the load: set off, or remove it");
  path.follow("path", std::string("off"), "the length in half widths changes with the load");
}

std::optional<roller::Profile> roller_profile(deck::Deck& deck, const Physics& physics) {
  if (!deck::given(deck, "roller", "profile") || !deck.errors.empty()) return std::nullopt;
  roller::Scales scales{
      .length = physics.groups.shape.length, .a_over_R = physics.a_over_R, .in_SI = physics.language == Language::si};
  if (physics.si) {
    scales.a = physics.si->hertz.a;
    scales.radius = physics.si->contact.radius;
    scales.load = deck::number(deck, "contact", "load");
  }
  const roller::Profile profile = roller::read(deck, scales);
  if (deck.errors.empty()) roller::check_profile(deck, scales, profile);
  return deck.errors.empty() ? std::optional(profile) : std::nullopt;
}

void roller_input(Case& input) {
  deck::Deck& deck = input.deck;
  if (!deck::given(deck, "roller", "profile") || !deck.errors.empty()) return;
  if (!input.roller) {
    deck::Part{deck, "roller"}.complain("profile",
                                        "has no influence without [contact] kind = roller or [case] kind = "
                                        "roller_race: set one of them, or remove it",
                                        deck::Cause::idle);
    return;
  }
  roller::check_on_grid(deck, input.scene.grid, *input.roller);
  if (deck.errors.empty()) roller::lay(*input.roller, input.scene);
}

}  // namespace ehl::program
