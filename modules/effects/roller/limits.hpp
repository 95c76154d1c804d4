#pragma once
// What no roller can be: profiles and tilts that come from wrong units.
#include "core/grid.hpp"
#include "deck/deck.hpp"
#include "effects/roller/keys.hpp"
#include "effects/roller/profile.hpp"

namespace ehl::roller {

/// Complains in [roller] where a circle of the profile does not reach the end that it makes, where the profile falls by
/// more than R, or where so little of the length bears the load that this is no roller.
void check_profile(deck::Deck& deck, const Scales& scales, const Profile& profile);
/// Where more of it bears in a place than the domain is wide enough for; and, of a grid that will not be refined, where
/// it does not see the rounded ends.
void check_on_grid(deck::Deck& deck, const core::Grid& grid, const Profile& profile);

}  // namespace ehl::roller
