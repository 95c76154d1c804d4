#pragma once
// Checks for impossible rollers: profiles and tilts that come from wrong units.
#include "core/grid.hpp"
#include "deck/deck.hpp"
#include "effects/roller/keys.hpp"
#include "effects/roller/profile.hpp"

namespace ehl::roller {

/// Reports in [roller]: a circular arc that does not reach its end, a profile that falls by more than R, a roller of
/// whose length too little carries load.
void check_profile(deck::Deck& deck, const Scales& scales, const Profile& profile);
/// Reports a contact that is somewhere wider than the domain; and, for a grid that will not be refined, rounded ends
/// that the mesh does not resolve.
void check_on_grid(deck::Deck& deck, const core::Grid& grid, const Profile& profile);

}  // namespace ehl::roller
