#pragma once
// Reads a contact without lubricant from the deck.
#include <optional>

#include "case/physical_input.hpp"
#include "deck/deck.hpp"
#include "dry/solve.hpp"

namespace ehl::program {

struct DryInput {
  dry::Parameters parameters{};
  std::optional<ElasticContact> contact{};  ///< nothing: the contact is dimensionless, in units of the Hertz contact
};

/// Nothing if the contact is lubricated. For a dry contact, a key about the film is an error if it is given, and is
/// dropped if it is a default; domain and cells are chosen if the deck leaves them open.
std::optional<DryInput> dry_input(deck::Deck& deck);

/// The scales of the contact, for everything that lies on it or below it. There is no oil, motion or dimensionless
/// group. A contact that is not in SI has no scales.
Physics dry_physics(const DryInput& input);

}  // namespace ehl::program
