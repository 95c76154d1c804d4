#pragma once
#include <vector>

#include "deck/key.hpp"

namespace ehl::dry {

/// The deck keys of the dry contact: [case] kind and section [dry].
std::vector<deck::Key> keys();

}  // namespace ehl::dry
