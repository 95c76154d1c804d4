#pragma once
#include <vector>

#include "deck/key.hpp"

namespace ehl::rheology {

/// The deck's keys of [lubricant].
std::vector<deck::Key> keys();

/// Those among them that belong to single laws and to fluids by name.
std::vector<deck::Key> liquid_keys();

}  // namespace ehl::rheology
