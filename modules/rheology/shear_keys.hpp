#pragma once
#include <vector>

#include "deck/deck.hpp"
#include "rheology/shear.hpp"

namespace ehl::rheology {

/// A shear law and the stress at which thinning begins [Pa].
struct Shear {
  ShearLaw law{};
  double stress = 0.0;
  bool flow = false;  ///< the pressure flow thins as well
};

/// The deck keys of [shear].
std::vector<deck::Key> shear_keys();
/// Reads [shear]; errors are added to the deck. in: the deck gives a law.
Shear read_shear(deck::Deck& deck);

}  // namespace ehl::rheology
