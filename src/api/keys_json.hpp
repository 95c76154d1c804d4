#pragma once
#include <string>

#include "deck/key.hpp"

namespace ehl::program {

/// The sections and keys of a deck as JSON, for the C interface.
std::string keys_json(const deck::Catalogue& catalogue);

}  // namespace ehl::program
