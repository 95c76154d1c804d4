#pragma once
#include <vector>

#include "deck/key.hpp"

namespace ehl::fmg {

/// The deck's keys of [multigrid].
std::vector<deck::Key> keys();

}  // namespace ehl::fmg
