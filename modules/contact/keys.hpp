#pragma once
#include <vector>

#include "deck/key.hpp"

namespace ehl::contact {

/// The deck's keys of [contact] and [motion].
std::vector<deck::Key> keys();

}  // namespace ehl::contact
