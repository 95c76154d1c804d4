#pragma once
// Features that users may look for in a deck but this version lacks, each with the nearest available feature.
#include <vector>

#include "deck/key.hpp"

namespace ehl::program {

std::vector<deck::Unavailable> unavailable();

}  // namespace ehl::program
