#pragma once
#include <vector>

#include "deck/key.hpp"

namespace ehl::steady {

/// The deck's keys of [case], [domain], [grid] and [output].
std::vector<deck::Key> keys();

}  // namespace ehl::steady
