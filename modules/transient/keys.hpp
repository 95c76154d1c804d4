#pragma once
#include <vector>

#include "deck/key.hpp"

namespace ehl::transient {

/// The keys of [transient].
std::vector<deck::Key> keys();

}  // namespace ehl::transient
