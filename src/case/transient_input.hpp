#pragma once
// Converts the deck's [transient] to a run in time.
#include <optional>

#include "case/physical_input.hpp"
#include "case/surface_input.hpp"
#include "deck/deck.hpp"
#include "machines/number.hpp"
#include "steady/scene.hpp"
#include "transient/keys.hpp"

namespace ehl::program {

/// Nothing if the deck has no [transient]. Errors are added to the deck. in: the physics of the case, its surfaces, its
/// machine, its finest grid. errors: core::FileError if a .csv file that the deck names cannot be read.
std::optional<transient::Input> transient_input(deck::Deck& deck, const transient::Tuning& tuning,
                                                const Physics& physics, const SurfaceInput& surfaces,
                                                const std::optional<machines::Contact>& machine,
                                                const core::Grid& grid);

/// What the deck's drive in time means for the far field.
transient::FarDemands far_demands(const deck::Deck& deck, const Physics& physics,
                                  const std::optional<machines::Contact>& machine);

/// X of the centre of a surface's relief at time 0 and at the end, and the largest one in between.
struct Travel {
  double from = 0.0;
  double to = 0.0;
  double farthest = 0.0;
};
/// The path of a surface during a run in time.
Travel travel_of(const CarriedSurface& surface, const transient::Input& input);

/// Time in a/u_m at which a surface has moved by a distance in a, past the end of the run too, where its speed stays
/// the last one. in: distance > 0. out: NaN if it never moves so far.
double time_to_move(const CarriedSurface& surface, const transient::Input& input, double distance);

/// The name of a probe, "P at (0.7, 0.2)".
std::string name_of_probe(const char* quantity, const transient::Place& place);

}  // namespace ehl::program
