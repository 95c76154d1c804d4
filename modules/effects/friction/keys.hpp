#pragma once
#include <vector>

#include "deck/key.hpp"

namespace ehl::friction {

/// The deck keys of this effect: section [friction].
std::vector<deck::Key> keys();

}  // namespace ehl::friction
