#pragma once
#include <vector>

#include "deck/key.hpp"

namespace ehl::reynolds {

/// The deck's keys of [discretization].
std::vector<deck::Key> keys();

}  // namespace ehl::reynolds
