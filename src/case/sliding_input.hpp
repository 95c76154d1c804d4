#pragma once
// Converts the deck's [shear] and [friction] to the parameters of the film and the friction, in
// the units of the contact.
#include <optional>

#include "case/scene.hpp"
#include "deck/deck.hpp"
#include "effects/friction/friction.hpp"
#include "rheology/flow_thinning.hpp"
#include "rheology/shear.hpp"
#include "steady/scene.hpp"

namespace ehl::program {

/// Sets physics.srr and physics.a_over_R from the other members.
void set_sliding(const contact::Input& input, Physics& physics);

/// In time the sliding of the steady start is that of the schedules at time 0: sets it, or reports a deck that says
/// something else. With a cycle the scene may be another state, from which a run without heat does not start.
void settle_sliding_at_start(Case& input);

/// eta_0 u_m R/(a^2 p_h) = lambda (a/R)/12.
double stress_of_speed(const Physics& physics);
/// eta_0 (u1 - u2) R/(a^2 p_h) = lambda (a/R) srr/12: the shear stress of the oil at ambient
/// pressure for H = 1, in p_h.
double stress_of_sliding(const Physics& physics);

/// Nothing if the deck has no [shear] or has errors already. Errors are added to the deck.
struct ShearInput {
  rheology::ShearThinning sliding;
  double k_of_u_m = 0.0;                         ///< k of `sliding` at |u1 - u2| = u_m
  std::optional<rheology::FlowThinning> flow{};  ///< nothing: flow thinning only to first order
};
/// The thinning by sliding, k = eta_0 (u1 - u2) R/(a^2 tau_c), and by the pressure flow if [shear] flow = on.
std::optional<ShearInput> shear_input(deck::Deck& deck, const Physics& physics);

/// The parameters of [friction]; nothing if the deck has no [friction] or has errors. in: the scene, complete except
/// for effects after the solution.
std::optional<friction::Parameters> friction_input(deck::Deck& deck, const Physics& physics,
                                                   const steady::Scene& scene);
/// Stress, slope and meniscus that follow from the contact alone.
friction::Parameters friction_of_contact(const Physics& physics, const steady::Scene& scene);

}  // namespace ehl::program
