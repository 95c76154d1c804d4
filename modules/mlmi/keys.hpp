#pragma once
#include <vector>

#include "deck/key.hpp"

namespace ehl::mlmi {

/// The deck's keys of [deformation].
std::vector<deck::Key> keys();

}  // namespace ehl::mlmi
