#pragma once
// The points that a run in time looks at.
#include <string>
#include <vector>

#include "core/grid.hpp"
#include "deck/deck.hpp"
#include "transient/march.hpp"

namespace ehl::program {

/// The points of [output] probe; none where the deck names none. What is wrong is complained about in the deck.
std::vector<transient::Place> probes_of(deck::Deck& deck, const core::Grid& grid);

/// "P at (0.7, 0.2)".
std::string name_of_probe(const char* quantity, const transient::Place& place);

}  // namespace ehl::program
