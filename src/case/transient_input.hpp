#pragma once
// From the deck's [transient] to a march.
#include <optional>

#include "case/physical_input.hpp"
#include "case/surface_input.hpp"
#include "deck/deck.hpp"
#include "steady/scene.hpp"
#include "transient/march.hpp"

namespace ehl::program {

struct TransientInput {
  transient::Conditions conditions{};
  transient::MarchParameters parameters{};
  double seconds_between_checkpoints = 60.0;  ///< of the clock on the wall
  double second = 0.0;                        ///< in a/u_m; NaN where the contact is not in SI
};

/// Nothing where the deck has no [transient]. Rules between keys are complained about in the deck.
/// in: the physics of the case, what its surfaces carry, its finest grid. errors: core::FileError where a .csv that the
/// deck names cannot be read.
std::optional<TransientInput> transient_input(deck::Deck& deck, const Physics& physics, const SurfaceInput& surfaces,
                                              const core::Grid& grid);

/// X of the middle of what a surface carries, at time 0 and at the end.
struct Way {
  double from = 0.0;
  double to = 0.0;
};
Way way_of(const CarriedSurface& surface, const TransientInput& input);

}  // namespace ehl::program
