#pragma once
#include <vector>

#include "deck/key.hpp"

namespace ehl::subsurface {

/// The deck keys of this effect: section [subsurface].
std::vector<deck::Key> keys();

}  // namespace ehl::subsurface
