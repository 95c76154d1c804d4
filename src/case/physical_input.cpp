#include "case/physical_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "case/sliding_input.hpp"
#include "rheology/keys.hpp"

namespace ehl::program {
namespace {

using contact::Language;

// A Hertz pressure outside this range results from a wrong unit [Pa].
constexpr double least_p_h = 1e3, most_p_h = 1e12;

// in: key: the key that the error is reported at.
void check_pressure(const deck::Part& contact, const char* key, double p_h) {
  if (!(p_h >= least_p_h && p_h <= most_p_h))
    contact.complain(
        key, fmt::format("gives, with the other values, a Hertz pressure of {:.3g} Pa: check the units of all of them",
                         p_h));
}

// The key that gives the load.
const char* load_key(const deck::Part& contact, Language language) {
  if (language == Language::moes) return "M";
  if (language == Language::hamrock_dowson) return "W";
  return contact::is_line(contact.deck) ? "load_per_length" : "load";
}

// Above this ratio the bodies are no half-spaces: the moduli are in MPa, or the load is too large.
constexpr double largest_a_over_R = 1.0 / 3.0;
constexpr double least_modulus = 1e6;  // Pa, that of soft rubber; steel with its modulus in MPa has 2e5

void check_size(const deck::Part& contact, const Physics& physics) {
  const contact::Ellipse& shape = physics.groups.shape;
  const double a_over_R = physics.a_over_R * std::max(1.0, shape.kappa * shape.radius_ratio);  // b relative to R_y
  if (!(a_over_R > largest_a_over_R)) return;
  if (physics.language == Language::si && physics.si->contact.E_prime >= least_modulus) {
    contact.complain(
        load_key(contact, physics.language),
        fmt::format("gives, with the other values, a Hertz radius of {:.3g} times the radius of the body, and Hertz "
                    "theory holds up to a third: the load is too large, or moduli or radii have the wrong unit (Pa, m)",
                    a_over_R));
    return;
  }
  const char* key = physics.language == Language::moes             ? "a_over_R"
                    : physics.language == Language::hamrock_dowson ? "W"
                    : contact.given("E_prime")                     ? "E_prime"
                                                                   : "E1";
  contact.complain(key, fmt::format("gives, with the other values, a Hertz radius of {:.3g} times the radius of the "
                                    "body, and Hertz theory holds up to a third: moduli are in Pa, check the units",
                                    a_over_R));
}

// Checks what the oil must have, and what has no influence, for a contact in this language.
void check_lubricant(deck::Deck& deck, const contact::Input& contact, const rheology::Oil& oil) {
  if (contact.language == Language::none || oil.viscosity.empty()) return;
  const deck::Part lubricant{deck, "lubricant"};
  const bool compressible = oil.density != "incompressible";
  const bool si = contact.language == Language::si;
  if (si && !oil.brings_eta0)
    lubricant.demand({"eta0"},
                     "a contact in SI needs the viscosity at ambient pressure [Pa s], or kv40, kv100, density15 and "
                     "temperature");
  if (oil.viscosity == "isoviscous") {
    lubricant.refuse({"alpha"}, "has no influence with viscosity = isoviscous: remove it", deck::Cause::idle);
    const bool moes = contact.language == Language::moes;
    const std::string group = moes ? "L" : "G";
    if (!si && (moes ? contact.L : contact.G) > 0.0)
      complain(deck, "contact", group, "has no influence with viscosity = isoviscous: set " + group + " = 0",
               deck::Cause::idle);
    if (!si && compressible)
      lubricant.complain("density", oil.density +
                                        " needs the Hertz pressure, which a dimensionless isoviscous contact does not "
                                        "have: set density = incompressible, or give the contact in SI");
    return;
  }
  if (!oil.brings_alpha && (si || oil.viscosity == "roelands" || compressible))
    lubricant.demand({"alpha"}, si ? "give the pressure coefficient of the viscosity [1/Pa], or alpha_star"
                                   : "give it in 1/Pa, because " + oil.viscosity + " with density = " + oil.density +
                                         " needs the Hertz pressure, p_h = alpha_bar/alpha");
}

// The table of an oil must cover the pressures of the contact.
void check_reach(deck::Deck& deck, const rheology::Oil& oil, double p_h) {
  if (p_h > oil.liquid.table_end)
    complain(deck, "lubricant", "table",
             fmt::format("ends at {:.4g} Pa, below the Hertz pressure of this contact, {:.4g} Pa: extend the table to "
                         "higher pressures",
                         oil.liquid.table_end, p_h));
}

SiInput si_input(const contact::Input& input, const rheology::Oil& oil) {
  SiInput si;
  si.contact = {.load = input.bodies.load,
                .radius = input.bodies.radius,
                .E_prime = input.bodies.E_prime,
                .u_s = input.u_s,
                .eta0 = oil.eta0,
                .alpha = std::isnan(oil.alpha) ? 0.0 : oil.alpha,
                .shape = input.shape};
  si.hertz = contact::hertz(si.contact.load, si.contact.radius, si.contact.E_prime, input.shape);
  si.u1 = input.u1;
  si.u2 = input.u2;
  si.Sq1 = input.Sq1;
  si.Sq2 = input.Sq2;
  si.E_prime_uncoated = input.bodies.E_prime_uncoated;
  si.coatings = input.bodies.coatings;
  return si;
}

contact::Groups groups_of(const contact::Input& input, const Physics& physics) {
  if (input.language == Language::moes) return contact::from_moes(input.M, input.L, input.shape);
  if (input.language == Language::hamrock_dowson)
    return contact::from_hamrock_dowson(input.W, input.U, input.G, input.shape);
  return contact::from_si(physics.si->contact);
}

// M and L that follow from other numbers must be in the same ranges as given ones. L does not depend on the load.
void check_derived(const deck::Part& contact, const Physics& physics) {
  if (physics.language == Language::moes) return;
  const deck::Part lubricant{contact.deck, "lubricant"};
  const bool si = physics.language == Language::si;
  for (const auto& [name, value] : {std::pair{"M", physics.groups.M}, {"L", physics.groups.L}}) {
    const deck::Key& key = *deck::find_key(contact.deck.catalogue, "contact", name);
    if (key.range.contains(value)) continue;
    const bool rigid = std::string(name) == "M" && value < key.range.lower;
    const std::string what = fmt::format(
        "gives, with the other values, {} = {:.4g}, which must be {}: {}", name, value, deck::allowed(key),
        rigid ? "the load is so light that the bodies stay rigid, and their film is known in closed form (for a line "
                "contact H = 2.45/M in Moes' units, Martin). Otherwise check the units of all values"
              : "check the units of all of them");
    if (std::string(name) == "M")
      contact.complain(load_key(contact, physics.language), what);
    else if (!si)
      contact.complain("G", what);
    else if (lubricant.given("alpha"))
      lubricant.complain("alpha", what);
    else
      contact.complain("radius_x", what);
  }
}

void set_laws(const rheology::Oil& oil, Physics& physics) {
  // L = 0 with a piezoviscous lubricant is the limit of a contact so soft that the pressure is negligible.
  const double p_h = physics.groups.alpha_bar > 0.0 || physics.si ? physics.p_h : 0.0;
  if (oil.viscosity == "isoviscous") physics.viscosity = rheology::Isoviscous{};
  if (oil.viscosity == "barus") physics.viscosity = rheology::Barus{physics.groups.alpha_bar};
  if (oil.viscosity == "roelands")
    physics.viscosity = rheology::Roelands{oil.roelands_alpha * oil.p0 / oil.z, p_h / oil.p0, oil.z};
  if (oil.density == "incompressible") physics.density = rheology::Incompressible{};
  if (oil.density == "dowson-higginson") physics.density = rheology::make_dowson_higginson(p_h);
  if (oil.liquid.viscosity) physics.viscosity = rheology::rescaled(*oil.liquid.viscosity, p_h);
  if (oil.liquid.density) physics.density = rheology::rescaled(*oil.liquid.density, p_h);
}

}  // namespace

std::optional<SiScales> si_scales(const Physics& physics) {
  if (!physics.si) return std::nullopt;
  const contact::Hertz& hertz = physics.si->hertz;
  const double u_s = physics.si->contact.u_s;
  return SiScales{hertz.a, hertz.h_scale, hertz.p_h, u_s > 0.0 ? 2.0 * hertz.a / u_s : std::nan(""),
                  physics.si->contact.load};
}

Physics physical_input(deck::Deck& deck) {
  const deck::Part part{deck, "contact"};
  const bool slides =
      deck::called_for(deck, "shear") || deck::called_for(deck, "friction") || deck::called_for(deck, "thermal");
  const contact::Input contact = contact::read(deck, slides);
  const rheology::Oil oil = rheology::read(deck);
  check_lubricant(deck, contact, oil);
  Physics physics{.language = contact.language};
  if (!deck.errors.empty()) return physics;

  if (physics.language == Language::si) {
    physics.si = si_input(contact, oil);
    // A table that ends at too low a pressure, possibly because of a wrong unit, also makes L wrong.
    if (physics.si->hertz.p_h < most_p_h) check_reach(deck, oil, physics.si->hertz.p_h);
    if (!deck.errors.empty()) return physics;
  }
  physics.groups = groups_of(contact, physics);
  check_derived(part, physics);
  set_sliding(contact, physics);
  check_size(part, physics);
  if (physics.si)
    physics.p_h = physics.si->hertz.p_h;
  else if (std::isfinite(oil.alpha) && physics.groups.alpha_bar > 0.0)
    physics.p_h = contact::hertz_pressure(physics.groups, oil.alpha);
  if (physics.p_h > 0.0) check_pressure(part, load_key(part, physics.language), physics.p_h);
  if (deck.errors.empty()) check_reach(deck, oil, physics.p_h);
  if (deck.errors.empty()) set_laws(oil, physics);
  physics.ambient = oil.ambient;
  return physics;
}

std::optional<ElasticContact> elastic_contact(deck::Deck& deck) {
  const std::optional<contact::Bodies> bodies = contact::read_bodies(deck);
  if (!bodies || !deck.errors.empty()) return std::nullopt;
  ElasticContact contact{*bodies, contact::hertz(bodies->load, bodies->radius, bodies->E_prime)};
  check_pressure({deck, "contact"}, "load", contact.hertz.p_h);
  return contact;
}

}  // namespace ehl::program
