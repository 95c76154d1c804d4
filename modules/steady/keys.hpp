#pragma once
#include <optional>
#include <vector>

#include "contact/groups.hpp"
#include "deck/deck.hpp"
#include "steady/scene.hpp"

namespace ehl::steady {

/// The keys of [domain] and [grid].
std::vector<deck::Key> grid_keys();
/// Reads [grid] accuracy. out: most_nodes and bytes_per_node are left open.
AccuracyTarget read_accuracy(deck::Deck& deck);
/// Records in the deck the domain and the cells that it leaves open (domain_error.hpp, resolution.hpp). in: wider, the
/// factor on inlet and outlet for a load that is unevenly spread.
void choose_grid(deck::Deck& deck, const Tuning& tuning, const ContactScales& contact, reynolds::Wedge wedge,
                 double wider = 1.0);
/// Complains about a domain, given by the deck, that ends within the dry contact.
void check_contains(deck::Deck& deck, const contact::Ellipse& shape);
/// The finest grid, and the number of cells along x of the coarsest one; 0 if left open.
struct GridInput {
  core::Grid finest{};
  int coarsest = 0;
};
/// Reads the grid. Complains about cells that cannot be halved down to a coarsest grid, and about cells wider than half
/// of `size`. in: size, ContactScales::size, or nothing if the contact itself has an error, so that a domain chosen for
/// it has no meaning; aspect, the hy/hx to approximate; line, true for a line contact, which has one line of nodes.
/// out: ny = 0 if something is missing or wrong.
GridInput read_grid(deck::Deck& deck, std::optional<double> size, double aspect = 1.0, bool line = false);
/// Reads [grid] errors: true for adjoint error estimates.
bool read_adjoint_errors(deck::Deck& deck);
/// Reads [domain] far_field: true for the closed form. in: steepest_load, the largest rate of change of the load;
/// why_zero, why the closed form is not the default of this run in time, or empty. Complains if the deck asks for the
/// closed form at a rate above 2 in a/u_m, which that form does not follow. If the deck leaves the far field open, it
/// is zero above that rate (0.5 if the contact is not circular) and where `why_zero` says so.
bool read_far_field(deck::Deck& deck, const Tuning& tuning, const contact::Ellipse& shape, double steepest_load,
                    const std::string& why_zero);
/// Complains if the chosen domain cuts off half of the film; a domain that the deck gives may do so, because a starved
/// film may be wanted. Complains too if the domain ends where the far field in closed form has no meaning.
void check_domain(deck::Deck& deck, const Scene& scene);

/// The keys that choose the strategies: [multigrid] polish and [continuation].
std::vector<deck::Key> path_keys();
Polish read_polish(deck::Deck& deck);
/// in: the contact's M, and the load unit [N], "known" if the deck uses SI or no units at all.
ContinuationParameters read_continuation(deck::Deck& deck, double M, const deck::PlainUnit& newton);

}  // namespace ehl::steady
