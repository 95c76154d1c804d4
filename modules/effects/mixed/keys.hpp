#pragma once
// Keys of [mixed].
#include <vector>

#include "core/constants.hpp"
#include "deck/deck.hpp"

namespace ehl::mixed {

/// Scales of the contact; NaN: not known.
struct Scales {
  double height = core::unknown;  ///< a^2/R [m], of H
  double p_h = core::unknown;     ///< [Pa]
};

/// The boundary film of a deck.
struct Input {
  double H_b = core::unknown;       ///< in units of H
  double hardness = core::unknown;  ///< largest contact pressure, in p_h; NaN: none
  double mu_b = core::unknown;      ///< friction coefficient where the surfaces touch; NaN: not given
};

/// Keys of [mixed].
std::vector<deck::Key> keys();
/// True if the deck gives a boundary film.
bool called_for(const deck::Deck& deck);
/// Reports keys that contradict each other or need a contact in SI. in: a deck that gives a boundary film.
Input read(deck::Deck& deck, const Scales& scales);

}  // namespace ehl::mixed
