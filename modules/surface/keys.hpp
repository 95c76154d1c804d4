#pragma once
#include <vector>

#include "deck/key.hpp"

namespace ehl::surface {

/// Keys of [surface1] and [surface2].
std::vector<deck::Key> keys();

}  // namespace ehl::surface
