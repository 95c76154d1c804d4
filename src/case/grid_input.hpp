#pragma once
// Domain and grid: what the deck says of them, and what is chosen for the contact where it is silent.
#include "contact/groups.hpp"
#include "core/grid.hpp"
#include "deck/deck.hpp"
#include "reynolds/wedge.hpp"
#include "steady/scene.hpp"

namespace ehl::program {

/// Records in the deck the domain and the cells that it leaves open: steady/domain_error.hpp, steady/resolution.hpp.
void choose_grid(deck::Deck& deck, const contact::Groups& groups, reynolds::Wedge wedge);

/// The grid of the deck. in: contact_known: the contact has no error in it, so that a domain chosen for it has a
/// meaning. Complains about cells that cannot be halved and about those wider than half a Hertz radius.
/// out: ny = 0 where something is missing or wrong.
core::Grid grid_input(deck::Deck& deck, bool contact_known);

/// Complains where the domain that was chosen cuts off half of the film; the deck itself may ask for a starved one.
void check_domain(deck::Deck& deck, const steady::Scene& scene);

}  // namespace ehl::program
