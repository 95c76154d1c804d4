#include "case/sliding_input.hpp"

#include <cmath>
#include <string>

#include "effects/friction/keys.hpp"
#include "rheology/shear_keys.hpp"

namespace ehl::program {
namespace {

using deck::complain;
using deck::given;

// Complains where the case is none that the section is for. False where there are complaints at all.
bool possible(deck::Deck& deck, const Physics& physics, const char* section, const char* key) {
  if (given(deck, "transient", "end_time"))
    complain(deck, section, key, "is for steady contacts: remove it, or [transient]");
  const bool said = std::string(section) == "friction" && given(deck, "shear", "law");
  if (physics.language == Language::moes && !given(deck, "contact", "a_over_R") && !said)
    complain(deck, "contact", "a_over_R",
             std::string("is missing: M and L leave it open, and [") + section + "] " + key +
                 " needs it; or give the contact in SI");
  return deck.errors.empty();
}

// A difference of speeds that is but rounding is none.
double without_rounding(double srr) { return std::abs(srr) < 1e-12 ? 0.0 : srr; }

}  // namespace

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

std::optional<rheology::ShearThinning> shear_input(deck::Deck& deck, const Physics& physics) {
  if (!given(deck, "shear", "law") || !possible(deck, physics, "shear", "law")) return std::nullopt;
  const rheology::Shear shear = rheology::read_shear(deck);
  if (deck.errors.empty() && !(physics.p_h > 0.0))
    complain(
        deck, "shear", "law",
        "needs the Hertz pressure [Pa], which this contact does not contain: give it in SI, or [lubricant] alpha with "
        "a piezoviscous law");
  if (!deck.errors.empty()) return std::nullopt;
  return rheology::ShearThinning{shear.law, std::abs(stress_of_sliding(physics)) * physics.p_h / shear.stress};
}

std::optional<friction::Parameters> friction_input(deck::Deck& deck, const Physics& physics) {
  if (!given(deck, "friction", "cavitated") || !possible(deck, physics, "friction", "cavitated")) return std::nullopt;
  friction::Parameters parameters = friction::read(deck);
  parameters.stress = stress_of_sliding(physics);
  parameters.slope = physics.a_over_R;
  return parameters;
}

}  // namespace ehl::program
