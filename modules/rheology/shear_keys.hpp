#pragma once
#include <vector>

#include "deck/key.hpp"

namespace ehl::rheology {

/// The deck keys of [shear].
std::vector<deck::Key> shear_keys();

}  // namespace ehl::rheology
