#pragma once
#include <vector>

#include "deck/deck.hpp"
#include "rheology/shear.hpp"

namespace ehl::rheology {

/// A shear law and the stress where thinning begins [Pa].
struct Shear {
  ShearLaw law{};
  double stress = 0.0;
  bool flow = false;  ///< the pressure's own flow thins too
};

/// The deck keys of [shear].
std::vector<deck::Key> shear_keys();
Shear read_shear(deck::Deck& deck);

}  // namespace ehl::rheology
