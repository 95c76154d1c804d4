#pragma once
// What a case will need of the machine.
#include <optional>

#include "deck/deck.hpp"
#include "steady/scene.hpp"
#include "transient_input.hpp"

namespace ehl::program {

/// What the case will need, nearly: for `check`, and to refuse what cannot fit.
struct Needs {
  double bytes = 0.0;
  double seconds = 0.0;
};
Needs expected_needs(const steady::Scene& scene, const std::optional<TransientInput>& transient = std::nullopt);

/// Complains in the deck where the machine has not the memory for the case.
void check_memory(deck::Deck& deck, const steady::Scene& scene, const std::optional<TransientInput>& transient);

}  // namespace ehl::program
