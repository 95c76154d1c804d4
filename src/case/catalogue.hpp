#pragma once
#include "deck/key.hpp"

namespace ehl::program {

/// All keys of this version, collected from the modules that use them and from the list of effects, and the features
/// that users may look for but this version lacks. The catalogue is built once.
const deck::Catalogue& catalogue();

}  // namespace ehl::program
