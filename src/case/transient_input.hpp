#pragma once
// From the deck's [transient] to a march.
#include <optional>

#include "case/physical_input.hpp"
#include "case/surface_input.hpp"
#include "deck/deck.hpp"
#include "steady/scene.hpp"
#include "transient/keys.hpp"

namespace ehl::program {

/// Nothing where the deck has no [transient]. Rules between keys are complained about in the deck.
/// in: the physics of the case, what its surfaces carry, its finest grid. errors: core::FileError where a .csv that the
/// deck names cannot be read.
std::optional<transient::Input> transient_input(deck::Deck& deck, const Physics& physics, const SurfaceInput& surfaces,
                                                const core::Grid& grid);

/// The steepest slope of the deck's load in time, in a/u_m; 0 where it is steady.
double steepest_load(const deck::Deck& deck, const Physics& physics);

/// X of the middle of what a surface carries, at time 0 and at the end.
struct Way {
  double from = 0.0;
  double to = 0.0;
};
Way way_of(const CarriedSurface& surface, const transient::Input& input);

/// "P at (0.7, 0.2)".
std::string name_of_probe(const char* quantity, const transient::Place& place);

}  // namespace ehl::program
