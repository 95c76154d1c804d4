#pragma once
// What people look for in a deck and this version does not have, each with the nearest thing that it has.
#include <vector>

#include "deck/key.hpp"

namespace ehl::program {

std::vector<deck::Unavailable> unavailable();

}  // namespace ehl::program
