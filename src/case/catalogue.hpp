#pragma once
#include "deck/key.hpp"

namespace ehl::program {

/// Every key of this version, collected from the modules that use them and from the list of effects, and what people
/// will look for in vain. Made once.
const deck::Catalogue& catalogue();

}  // namespace ehl::program
