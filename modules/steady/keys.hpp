#pragma once
#include <optional>
#include <vector>

#include "contact/groups.hpp"
#include "deck/deck.hpp"
#include "steady/scene.hpp"

namespace ehl::steady {

/// The deck's keys of [domain] and [grid].
std::vector<deck::Key> grid_keys();
/// [grid] accuracy. in: the most nodes that the memory holds.
AccuracyTarget read_accuracy(deck::Deck& deck);
/// Records in the deck the domain and the cells that it leaves open: domain_error.hpp, resolution.hpp.
/// in: how many times as wide as Hertz' a contact is where its load is unevenly spread, for inlet and outlet.
void choose_grid(deck::Deck& deck, const contact::Groups& groups, reynolds::Wedge wedge, double wider = 1.0);
/// Complains about a domain, as the deck gives it, that ends within the dry contact.
void check_contains(deck::Deck& deck, const contact::Ellipse& shape);
/// The finest grid, and the cells of the coarsest one along x; 0 where they are open.
struct GridInput {
  core::Grid finest{};
  int coarsest = 0;
};
/// in: size: contact_size(), nothing where the contact has an error in it, so that a domain chosen for it has no
/// meaning; aspect: hy/hx to come near; line: of a line contact, one line of nodes. Complains about cells that cannot
/// be halved and about those wider than half the size. out: ny = 0 where something is missing or wrong.
GridInput read_grid(deck::Deck& deck, std::optional<double> size, double aspect = 1.0, bool line = false);
/// [grid] errors: true for those by weights.
bool read_adjoint_errors(deck::Deck& deck);
/// [domain] far_field: true for the closed form. in: the steepest slope of the load in time; it does not follow one
/// above 2 in a/u_m, and complains. Where the deck leaves it open, an ellipse with one above 0.5 and what moves a body
/// have none.
bool read_far_field(deck::Deck& deck, const contact::Ellipse& shape, double steepest_load, bool body_moves);
/// Complains where the domain that was chosen cuts off half of the film, while the deck itself may ask for a starved
/// one; and about a domain that ends where the far field in closed form means nothing.
void check_domain(deck::Deck& deck, const Scene& scene);

/// Those of the path to the solution: [multigrid] polish and [continuation].
std::vector<deck::Key> path_keys();
Polish read_polish(deck::Deck& deck);
/// in: the contact's M; its load [N], "known" where the deck speaks SI or no language at all.
ContinuationParameters read_continuation(deck::Deck& deck, double M, const deck::PlainUnit& newton);

}  // namespace ehl::steady
