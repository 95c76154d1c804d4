#pragma once
// Features that users may look for in a deck but this version lacks, each with the nearest available feature.
#include <vector>

#include "deck/key.hpp"

namespace ehl::program {

/// The list of these features, for the catalogue of keys.
std::vector<deck::Unavailable> unavailable();

}  // namespace ehl::program
