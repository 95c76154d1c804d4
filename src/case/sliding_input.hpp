#pragma once
// From the deck's [shear] and [friction] to what the film and the friction need: sliding in the contact's own units.
#include <optional>

#include "case/physical_input.hpp"
#include "deck/deck.hpp"
#include "effects/friction/friction.hpp"
#include "rheology/flow_thinning.hpp"
#include "rheology/shear.hpp"
#include "steady/scene.hpp"

namespace ehl::program {

/// physics.srr and a_over_R, from what else it holds.
void set_sliding(const contact::Input& input, Physics& physics);

/// eta_0 u_m R/(a^2 p_h) = lambda (a/R)/12.
double stress_of_speed(const Physics& physics);
/// eta_0 (u1 - u2) R/(a^2 p_h) = lambda (a/R) srr/12: the stress of the oil at ambient pressure where H = 1, in p_h.
double stress_of_sliding(const Physics& physics);

/// Nothing where the deck has no [shear], or complaints already. Complains in the deck.
struct ShearInput {
  rheology::ShearThinning sliding;
  std::optional<rheology::FlowThinning> flow{};  ///< nothing: to first order
};
std::optional<ShearInput> shear_input(deck::Deck& deck, const Physics& physics);

/// True where the far field goes on outside of the domain, and the gap is full of oil there.
bool oil_outside(const steady::Scene& scene);

/// What [friction] asks for; nothing and complaints as above. The scene must be complete but for its effects after the
/// solution.
std::optional<friction::Parameters> friction_input(deck::Deck& deck, const Physics& physics,
                                                   const steady::Scene& scene);
/// Stress, slope and meniscus as they follow from the contact alone.
friction::Parameters friction_of_contact(const Physics& physics, const steady::Scene& scene);

}  // namespace ehl::program
