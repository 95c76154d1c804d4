#include "case/sliding_input.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "effects/friction/keys.hpp"
#include "effects/friction/of_scene.hpp"
#include "rheology/shear_keys.hpp"

namespace ehl::program {
namespace {

using deck::complain;
using deck::given;

// Refuses the section for cases in which it is not available. Returns false if the deck has any errors.
bool possible(deck::Deck& deck, const Physics& physics, const char* section, const char* key) {
  const bool said = std::string(section) == "friction" && given(deck, "shear", "law");
  if (physics.language == Language::moes && !given(deck, "contact", "a_over_R") && !said)
    complain(deck, "contact", "a_over_R",
             std::string("is missing: M and L do not determine it, and [") + section + "] " + key +
                 " needs it; or give the contact in SI",
             deck::Cause::missing);
  return deck.errors.empty();
}

// A difference of speeds within rounding is set to zero.
double without_rounding(double srr) { return std::abs(srr) < 1e-12 ? 0.0 : srr; }

// Refuses what is not available with flow thinning.
void check_passes(deck::Deck& deck, const Physics& physics) {
  const deck::Part shear{deck, "shear"};
  if (given(deck, "transient", "end_time") && deck::called_for(deck, "thermal"))
    shear.complain("flow", "is not available in time together with [thermal]: set flow = off, or remove one of them");
  if (given(deck, "grid", "accuracy"))
    shear.complain("flow", "is not available together with [grid] accuracy: give [grid] cells");
  if (deck::word(deck, "multigrid", "polish") == "always")
    shear.complain("flow", "is not available together with [multigrid] polish = always: set polish = rescue");
  if (std::abs(physics.srr) > 2.0)
    shear.complain("flow", "needs two surfaces of which none moves against the rolling direction: -2 <= srr <= 2");
}

// Reads the position of the meniscus, for the cases that allow one.
void set_meniscus(deck::Deck& deck, const Physics& physics, const steady::Scene& scene,
                  friction::Parameters& parameters) {
  const deck::Part friction{deck, "friction"};
  const std::vector<std::string> given = friction.given_of({"meniscus", "meniscus_m"});
  const deck::PlainUnit a{.suffix = "_m", .in_SI = physics.si ? physics.si->hertz.a : NAN, .known = bool(physics.si)};
  const double distance = friction.number_in("meniscus", a);
  if (given.empty()) {
    if (std::isfinite(parameters.meniscus))
      friction.follow("meniscus", parameters.meniscus, "the radius of the bodies in the rolling direction");
    return;
  }
  if (scene.supply)
    friction.complain(given[0], "is not available for a starved contact, whose meniscus is computed: remove it");
  else if (!friction::oil_outside(scene) && distance > -scene.grid.X_a)
    friction.complain(
        given[0],
        fmt::format("lies outside the domain, which ends at {:g} Hertz radii; the gap there is known "
                    "only with far_field = closed. {}",
                    scene.grid.X_a,
                    contact::roller(scene.contact.shape) ? "Move [domain] x_inlet further out"
                                                         : "Set [domain] far_field = closed, or leave it out"));
  else if (!(distance > 1.0))
    friction.complain(given[0], "must lie outside the contact, more than a Hertz radius from its centre");
  parameters.meniscus = distance;
}

}  // namespace

double stress_of_speed(const Physics& physics) { return physics.groups.lambda * physics.a_over_R / 12.0; }

double stress_of_sliding(const Physics& physics) {
  return physics.groups.lambda * physics.a_over_R * physics.srr / 12.0;
}

void set_sliding(const contact::Input& input, Physics& physics) {
  if (physics.si) {
    physics.srr = without_rounding(2.0 * (physics.si->u1 - physics.si->u2) / physics.si->contact.u_s);
    physics.a_over_R = physics.si->hertz.h_scale / physics.si->hertz.a;
    return;
  }
  physics.srr = without_rounding(input.srr);
  physics.a_over_R = physics.language == Language::hamrock_dowson
                         ? contact::relative_half_width(physics.groups.W, physics.groups.shape)
                         : input.a_over_R;
}

void settle_sliding_at_start(Case& input) {
  if (!input.transient) return;
  if (deck::given(input.deck, "transient", "cycle") && !deck::called_for(input.deck, "thermal")) return;
  const transient::Conditions& conditions = input.transient->conditions;
  const double at_start = value(conditions.u1, 0.0) - value(conditions.u2, 0.0);
  constexpr double rounding = 1e-9;
  if (std::abs(at_start - input.physics.srr) <= rounding) return;
  const deck::Part motion{input.deck, "motion"};
  if (input.physics.si || motion.given("srr"))
    deck::complain(input.deck, "transient",
                   deck::given(input.deck, "transient", "cycle") ? "cycle"
                   : deck::given(input.deck, "transient", "u1")  ? "u1"
                                                                 : "u2",
                   fmt::format("gives u1 - u2 = {:.6g} u_m at time 0, but [motion] gives {:.6g} u_m, and the run "
                               "starts from that steady contact: let both agree",
                               at_start, input.physics.srr));
  motion.follow("srr", at_start, "u1 - u2 of [transient] at time 0");
  input.physics.srr = at_start;
}

std::optional<ShearInput> shear_input(deck::Deck& deck, const Physics& physics) {
  if (!given(deck, "shear", "law") || !possible(deck, physics, "shear", "law")) return std::nullopt;
  const rheology::Shear shear = rheology::read_shear(deck);
  if (deck.errors.empty() && !(physics.p_h > 0.0))
    complain(deck, "shear", "law",
             "needs the Hertz pressure [Pa], which this contact does not have: give it in SI, or give [lubricant] "
             "alpha with a piezoviscous law");
  if (shear.flow) check_passes(deck, physics);
  if (!deck.errors.empty()) return std::nullopt;
  const double k_of_u_m = stress_of_speed(physics) * physics.p_h / shear.stress;
  ShearInput input{.sliding = {shear.law, std::abs(stress_of_sliding(physics)) * physics.p_h / shear.stress},
                   .k_of_u_m = k_of_u_m};
  if (shear.flow) input.flow = {shear.law, k_of_u_m, std::abs(physics.srr)};
  return input;
}

friction::Parameters friction_of_contact(const Physics& physics, const steady::Scene& scene) {
  friction::Parameters parameters{
      .stress = stress_of_sliding(physics), .slope = physics.a_over_R, .cavitated = friction::Cavitated::none};
  if (friction::oil_outside(scene) && !scene.grid.line)
    parameters.meniscus = 1.0 / (2.0 * contact::gap(scene.contact.shape).XX * physics.a_over_R);
  return parameters;
}

std::optional<friction::Parameters> friction_input(deck::Deck& deck, const Physics& physics,
                                                   const steady::Scene& scene) {
  if (!given(deck, "friction", "cavitated") || !possible(deck, physics, "friction", "cavitated")) return std::nullopt;
  friction::Parameters parameters = friction::read(deck);
  const friction::Parameters of_contact = friction_of_contact(physics, scene);
  parameters.stress = of_contact.stress;
  parameters.slope = of_contact.slope;
  parameters.meniscus = of_contact.meniscus;
  set_meniscus(deck, physics, scene, parameters);
  return parameters;
}

}  // namespace ehl::program
