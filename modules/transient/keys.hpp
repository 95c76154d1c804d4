#pragma once
#include <vector>

#include "deck/key.hpp"

namespace ehl::transient {

/// The keys of [transient], [surface1] and [surface2].
std::vector<deck::Key> keys();

}  // namespace ehl::transient
