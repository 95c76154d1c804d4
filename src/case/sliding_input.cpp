#include "case/sliding_input.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

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

// eta_0 (u1 - u2) R/(a^2 p_h) = lambda (a/R) srr/12: the stress of the oil at ambient pressure where H = 1, in p_h.
double stress_of_sliding(const Physics& physics) {
  return physics.groups.lambda * physics.a_over_R * physics.srr / 12.0;
}

// A difference of speeds that is but rounding is none.
double without_rounding(double srr) { return std::abs(srr) < 1e-12 ? 0.0 : srr; }

}  // namespace

void set_sliding(const deck::Deck& deck, Physics& physics) {
  if (physics.si) {
    physics.srr = without_rounding(2.0 * (physics.si->u1 - physics.si->u2) / physics.si->contact.u_s);
    physics.a_over_R = physics.si->hertz.h_scale / physics.si->hertz.a;
    return;
  }
  if (given(deck, "motion", "srr")) physics.srr = without_rounding(deck::number(deck, "motion", "srr"));
  // Of a circle a^3 = 3 F R/(2 E').
  physics.a_over_R = physics.language == Language::hamrock_dowson
                         ? std::cbrt(1.5 * physics.groups.W) * physics.groups.shape.a
                         : deck::number(deck, "contact", "a_over_R");
}

std::optional<rheology::ShearThinning> shear_input(deck::Deck& deck, const Physics& physics) {
  if (!given(deck, "shear", "law") || !possible(deck, physics, "shear", "law")) return std::nullopt;
  const bool eyring = deck::word(deck, "shear", "law") == "eyring";
  for (const std::string& key : eyring ? std::vector<std::string>{"tau_0"} : std::vector<std::string>{"G", "n"})
    if (!given(deck, "shear", key))
      complain(deck, "shear", key, std::string("is missing: law = ") + (eyring ? "eyring" : "carreau") + " needs it");
  if (deck.errors.empty() && !(physics.p_h > 0.0))
    complain(
        deck, "shear", "law",
        "needs the Hertz pressure [Pa], which this contact does not contain: give it in SI, or [lubricant] alpha with "
        "a piezoviscous law");
  if (!deck.errors.empty()) return std::nullopt;
  rheology::ShearThinning thinning;
  if (!eyring) thinning.law = rheology::Carreau{deck::number(deck, "shear", "n")};
  thinning.k = std::abs(stress_of_sliding(physics)) * physics.p_h / deck::number(deck, "shear", eyring ? "tau_0" : "G");
  return thinning;
}

std::optional<friction::Parameters> friction_input(deck::Deck& deck, const Physics& physics) {
  if (!given(deck, "friction", "cavitated") || !possible(deck, physics, "friction", "cavitated")) return std::nullopt;
  using friction::Cavitated;
  friction::Parameters parameters;
  parameters.stress = stress_of_sliding(physics);
  parameters.slope = physics.a_over_R;
  const std::string cavitated = deck::word(deck, "friction", "cavitated");
  parameters.cavitated = cavitated == "none"   ? Cavitated::none
                         : cavitated == "full" ? Cavitated::full
                                               : Cavitated::striated;
  if (given(deck, "friction", "limit")) parameters.limit = deck::number(deck, "friction", "limit");
  const std::vector<std::string> fields = deck::words(deck, "friction", "fields");
  parameters.keep_tau1 = std::ranges::find(fields, "tau1") != fields.end();
  parameters.keep_tau2 = std::ranges::find(fields, "tau2") != fields.end();
  return parameters;
}

}  // namespace ehl::program
