#pragma once
// The contact without lubricant: from the deck.
#include <optional>

#include "case/physical_input.hpp"
#include "deck/deck.hpp"
#include "dry/solve.hpp"

namespace ehl::program {

struct DryInput {
  dry::Parameters parameters{};
  std::optional<ElasticContact> contact{};  ///< nothing: in units of Hertz' contact
};

/// Nothing where the contact is lubricated. Else every key that speaks of a film is refused where it is given and
/// dropped where it is a default, and domain and cells are chosen where they are open.
std::optional<DryInput> dry_input(deck::Deck& deck);

/// Its scales, for all that lies on or below it: no oil, no motion, no groups. Without a contact in SI: none.
Physics dry_physics(const DryInput& input);

}  // namespace ehl::program
