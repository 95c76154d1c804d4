#pragma once
#include <vector>

#include "deck/key.hpp"

namespace ehl::rheology {

/// The deck's keys of [lubricant].
std::vector<deck::Key> keys();

}  // namespace ehl::rheology
