#include "case/physical_input.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "case/fluid_input.hpp"
#include "case/sliding_input.hpp"
#include "deck/text.hpp"
#include "report/text_format.hpp"

namespace ehl::program {
namespace {

using deck::complain;
using deck::given;
using Names = std::vector<std::string>;

const Names moes_keys{"M", "L"};
const Names hamrock_dowson_keys{"W", "U", "G"};
const Names si_keys{"load", "radius_x", "radius_y", "E1", "nu1", "E2", "nu2", "E_prime"};
const Names four_moduli{"E1", "nu1", "E2", "nu2"};

// Hertz pressures beyond these come from wrong units [Pa].
constexpr double least_p_h = 1e3, most_p_h = 1e12;

std::string wrong_pressure(double p_h) {
  return "with the other numbers it means a Hertz pressure of " + formatted("%.3g", p_h) +
         " Pa: check the units of all of them";
}

Names given_of(const deck::Deck& deck, const std::string& section, const Names& names) {
  Names found;
  for (const std::string& name : names)
    if (given(deck, section, name)) found.push_back(name);
  return found;
}

void demand(deck::Deck& deck, const std::string& section, const Names& names, const std::string& why) {
  for (const std::string& name : names)
    if (!given(deck, section, name)) complain(deck, section, name, "is missing: " + why);
}

void refuse(deck::Deck& deck, const std::string& section, const Names& names, const std::string& why) {
  for (const std::string& name : given_of(deck, section, names)) complain(deck, section, name, why);
}

Language language_of(deck::Deck& deck) {
  struct Choice {
    Language language;
    Names given;
  };
  std::vector<Choice> spoken;
  for (const auto& [language, names] :
       {std::pair{Language::moes, moes_keys}, {Language::hamrock_dowson, hamrock_dowson_keys}, {Language::si, si_keys}})
    if (const Names found = given_of(deck, "contact", names); !found.empty()) spoken.push_back({language, found});
  if (spoken.empty()) {
    complain(deck, "contact", "M",
             "the contact is missing: give M and L, or W, U and G, or load, radius_x and E_prime "
             "(or E1, nu1, E2, nu2)");
    return Language::none;
  }
  if (spoken.size() == 1) return spoken[0].language;
  // A stray key is told to go, not the three that it is added to.
  std::ranges::stable_sort(spoken, std::ranges::greater{}, [](const Choice& choice) { return choice.given.size(); });
  for (std::size_t k = 1; k < spoken.size(); ++k)
    for (const std::string& name : spoken[k].given)
      complain(deck, "contact", name,
               "the contact is given in two languages: " + deck::joined(spoken[0].given, ", ") + " (" +
                   deck::value(deck, "contact", spoken[0].given[0]).place +
                   ") already; keep one of M, L | W, U, G | load, radius_x and moduli");
  return Language::none;
}

void check_elastic(deck::Deck& deck) {
  const Names moduli = given_of(deck, "contact", four_moduli);
  if (given(deck, "contact", "E_prime")) {
    refuse(deck, "contact", four_moduli, "E_prime is given as well: keep either E_prime or E1, nu1, E2, nu2");
  } else if (moduli.empty()) {
    complain(deck, "contact", "E_prime", "is missing: give it, or E1, nu1, E2 and nu2");
  } else {
    demand(deck, "contact", four_moduli, "E1, nu1, E2 and nu2 belong together (or give E_prime alone)");
  }
}

// R_x/R_y, or NaN where a complaint is on its way. What follows from it is recorded in the deck.
double radius_ratio_of(deck::Deck& deck, Language language) {
  const double ratio = deck::number(deck, "contact", "radius_ratio");
  if (language != Language::si) return given(deck, "contact", "radius_ratio") ? ratio : 1.0;
  const double radius_x = deck::number(deck, "contact", "radius_x");
  if (given(deck, "contact", "radius_ratio")) {
    if (given(deck, "contact", "radius_y"))
      complain(deck, "contact", "radius_ratio", "radius_y is given as well: keep one of them");
    return ratio;
  }
  if (!given(deck, "contact", "radius_y")) {
    deck::choose(deck, "contact", "radius_y", radius_x, "circular contact");
    return 1.0;
  }
  const double of_radii = radius_x / deck::number(deck, "contact", "radius_y");
  const deck::Key& key = *deck::find_key(deck.catalogue, "contact", "radius_ratio");
  if (!std::isnan(of_radii) && !key.range.contains(of_radii))
    complain(deck, "contact", "radius_y",
             "means radius_x/radius_y = " + formatted("%.4g", of_radii) + ", which must be " + deck::allowed(key) +
                 ": beyond it the contact is nearly a line");
  return of_radii;
}

contact::Ellipse shape_of(deck::Deck& deck, Language language) {
  const double ratio = radius_ratio_of(deck, language);
  if (ratio == 1.0)
    refuse(deck, "motion", {"angle"},
           "has no influence on a circular contact: remove it, or give radius_ratio or radius_y");
  if (!deck.errors.empty() || std::isnan(ratio)) return {};
  if (ratio != 1.0 && !given(deck, "motion", "angle")) deck::choose(deck, "motion", "angle", 0.0, "along radius_x");
  return ratio == 1.0 ? contact::Ellipse{} : contact::ellipse(ratio, deck::number(deck, "motion", "angle"));
}

void check_motion(deck::Deck& deck, Language language) {
  Names all{"u1", "u2", "u_m", "srr"};
  if (language == Language::none) return;
  const bool about_sliding = given(deck, "shear", "law") || given(deck, "friction", "cavitated");
  if (language != Language::moes || !about_sliding)
    refuse(deck, "contact", {"a_over_R"}, "has no influence but with M and L, and [shear] or [friction]: remove it");
  if (language != Language::si) {
    if (about_sliding) all.pop_back();  // srr
    refuse(deck, "motion", all, "has no influence: a dimensionless contact contains the speed already; remove it");
    return;
  }
  if (!given(deck, "motion", "u_m"))
    refuse(deck, "motion", {"srr"}, "has no influence without u_m: give u_m instead of u1 and u2, or remove it");
  if (given(deck, "motion", "u_m")) {
    refuse(deck, "motion", {"u1", "u2"}, "u_m is given as well: keep either u1 and u2, or u_m and srr");
  } else if (given_of(deck, "motion", {"u1", "u2"}).empty()) {
    complain(deck, "motion", "u_m", "is missing: give the entrainment speed, or u1 and u2");
  } else {
    demand(deck, "motion", {"u1", "u2"}, "u1 and u2 belong together (or give u_m)");
    const double sum = deck::number(deck, "motion", "u1") + deck::number(deck, "motion", "u2");
    if (!(sum > 0.0) && !std::isnan(sum))
      complain(deck, "motion", "u2",
               "u1 + u2 = " + deck::shortest(sum) + " m/s: it must be > 0, for the oil enters at negative x");
  }
}

void check_lubricant(deck::Deck& deck, Language language) {
  if (language == Language::none || !deck::value(deck, "lubricant", "viscosity").valid) return;
  const std::string law = deck::word(deck, "lubricant", "viscosity");
  const std::string density = deck::word(deck, "lubricant", "density");
  const bool compressible = density != "incompressible";
  const bool si = language == Language::si;
  const std::string group = language == Language::moes ? "L" : "G";
  const bool named = given(deck, "lubricant", "fluid");  // an oil by name brings everything
  if (si && !named && !brings_eta0(deck))
    demand(deck, "lubricant", {"eta0"}, "a contact in SI needs the viscosity at ambient pressure [Pa s]");
  if (law == "isoviscous") {
    refuse(deck, "lubricant", {"alpha"}, "has no influence with viscosity = isoviscous: remove it");
    if (!si && deck::number(deck, "contact", group) > 0.0)
      complain(deck, "contact", group, "has no influence with viscosity = isoviscous: set " + group + " = 0");
    if (!si && compressible)
      complain(deck, "lubricant", "density",
               density +
                   " needs the Hertz pressure, which a dimensionless isoviscous case does not contain: set density = "
                   "incompressible, or give the contact in SI");
    return;
  }
  if (!named && !brings_alpha(deck) && (si || law == "roelands" || compressible))
    demand(deck, "lubricant", {"alpha"},
           si ? "[1/Pa], the pressure coefficient of the viscosity"
              : "[1/Pa]: " + law + " with density = " + density + " needs the Hertz pressure, p_h = alpha_bar/alpha");
}

double modulus(const deck::Deck& deck) {
  const auto number = [&](const char* name) { return deck::number(deck, "contact", name); };
  if (given(deck, "contact", "E_prime")) return number("E_prime");
  return contact::reduced_modulus({number("E1"), number("nu1")}, {number("E2"), number("nu2")});
}

SiInput si_input(const deck::Deck& deck, const contact::Ellipse& shape) {
  const auto contact_number = [&](const char* name) { return deck::number(deck, "contact", name); };
  SiInput si;
  si.contact.load = contact_number("load");
  si.contact.radius = contact_number("radius_x");
  si.contact.E_prime = modulus(deck);
  if (given(deck, "motion", "u_m")) {
    const double u_m = deck::number(deck, "motion", "u_m");
    const double srr = given(deck, "motion", "srr") ? deck::number(deck, "motion", "srr") : 0.0;
    si.u1 = u_m * (1.0 + 0.5 * srr);
    si.u2 = u_m * (1.0 - 0.5 * srr);
    si.contact.u_s = 2.0 * u_m;
  } else {
    si.u1 = deck::number(deck, "motion", "u1");
    si.u2 = deck::number(deck, "motion", "u2");
    si.contact.u_s = si.u1 + si.u2;
  }
  si.contact.eta0 = deck::number(deck, "lubricant", "eta0");
  const double alpha = deck::number(deck, "lubricant", "alpha");
  si.contact.alpha = std::isnan(alpha) ? 0.0 : alpha;
  si.contact.shape = shape;
  si.hertz = contact::hertz(si.contact.load, si.contact.radius, si.contact.E_prime, shape);
  return si;
}

contact::Groups groups_of(const deck::Deck& deck, const Physics& physics, const contact::Ellipse& shape) {
  const auto number = [&](const char* name) { return deck::number(deck, "contact", name); };
  if (physics.language == Language::moes) return contact::from_moes(number("M"), number("L"), shape);
  if (physics.language == Language::hamrock_dowson)
    return contact::from_hamrock_dowson(number("W"), number("U"), number("G"), shape);
  return contact::from_si(physics.si->contact);
}

// M and L that follow from other numbers are held against the same ranges as M and L given.
void check_derived(deck::Deck& deck, const Physics& physics) {
  const std::string given_key = physics.language == Language::si ? "load" : "W";
  for (const auto& [name, value] : {std::pair{"M", physics.groups.M}, {"L", physics.groups.L}}) {
    const deck::Key& key = *deck::find_key(deck.catalogue, "contact", name);
    if (key.range.contains(value)) continue;
    const std::string message = std::string("with the other numbers it means ") + name + " = " +
                                formatted("%.4g", value) + ", which must be " + deck::allowed(key) +
                                ": check the units of all of them";
    complain(deck, "contact", physics.language == Language::moes ? name : given_key, message);
  }
}

void set_laws(deck::Deck& deck, const Liquid& liquid, Physics& physics) {
  const std::string law = deck::word(deck, "lubricant", "viscosity");
  const double alpha = deck::number(deck, "lubricant", "alpha");
  if (law == "isoviscous") physics.viscosity = rheology::Isoviscous{};
  if (law == "barus") physics.viscosity = rheology::Barus{physics.groups.alpha_bar};
  // L = 0 with a piezoviscous lubricant is the limit of a contact so soft that no pressure arises.
  const double p_h = physics.groups.alpha_bar > 0.0 || physics.si ? physics.p_h : 0.0;
  if (law == "roelands") {
    const double p0 = deck::number(deck, "lubricant", "p0");
    const double z = roelands_z(deck, alpha, p0);
    physics.viscosity = rheology::Roelands{alpha * p0 / z, p_h / p0, z};
  }
  const std::string density = deck::word(deck, "lubricant", "density");
  if (density == "incompressible") physics.density = rheology::Incompressible{};
  if (density == "dowson-higginson") physics.density = rheology::make_dowson_higginson(p_h);
  if (liquid.viscosity) physics.viscosity = rheology::rescaled(*liquid.viscosity, p_h);
  if (liquid.density) physics.density = rheology::rescaled(*liquid.density, p_h);
}

}  // namespace

Physics physical_input(deck::Deck& deck) {
  Physics physics;
  physics.language = language_of(deck);
  if (physics.language == Language::moes) demand(deck, "contact", moes_keys, "M and L belong together");
  if (physics.language == Language::hamrock_dowson)
    demand(deck, "contact", hamrock_dowson_keys, "W, U and G belong together");
  if (physics.language == Language::si) {
    demand(deck, "contact", {"load", "radius_x"}, "a contact in SI needs load, radius_x and the elastic moduli");
    check_elastic(deck);
  }
  check_motion(deck, physics.language);
  const Liquid liquid = liquid_input(deck);
  check_lubricant(deck, physics.language);
  const contact::Ellipse shape = shape_of(deck, physics.language);
  if (!deck.errors.empty()) return physics;

  if (physics.language == Language::si) {
    physics.si = si_input(deck, shape);
    // A table that ends too early, in the wrong unit maybe, makes L wrong too.
    if (physics.si->hertz.p_h < most_p_h) check_reach(deck, liquid, physics.si->hertz.p_h);
    if (!deck.errors.empty()) return physics;
  }
  physics.groups = groups_of(deck, physics, shape);
  check_derived(deck, physics);
  set_sliding(deck, physics);
  if (physics.si) {
    physics.p_h = physics.si->hertz.p_h;
  } else if (std::isfinite(deck::number(deck, "lubricant", "alpha")) && physics.groups.alpha_bar > 0.0) {
    physics.p_h = contact::hertz_pressure(physics.groups, deck::number(deck, "lubricant", "alpha"));
  }
  if (physics.p_h > 0.0 && !(physics.p_h >= least_p_h && physics.p_h <= most_p_h))
    complain(deck, "contact",
             physics.language == Language::moes ? "M"
             : physics.si                       ? "load"
                                                : "W",
             wrong_pressure(physics.p_h));
  if (deck.errors.empty()) check_reach(deck, liquid, physics.p_h);
  if (deck.errors.empty()) set_laws(deck, liquid, physics);
  return physics;
}

std::optional<ElasticContact> elastic_contact(deck::Deck& deck) {
  if (given_of(deck, "contact", si_keys).empty()) return std::nullopt;
  demand(deck, "contact", {"load", "radius_x"}, "a contact in SI needs load, radius_x and the elastic moduli");
  check_elastic(deck);
  if (!deck.errors.empty()) return std::nullopt;
  ElasticContact contact{
      deck::number(deck, "contact", "load"), deck::number(deck, "contact", "radius_x"), modulus(deck), {}};
  contact.hertz = contact::hertz(contact.load, contact.radius, contact.E_prime);
  if (!(contact.hertz.p_h >= least_p_h && contact.hertz.p_h <= most_p_h))
    complain(deck, "contact", "load", wrong_pressure(contact.hertz.p_h));
  return contact;
}

}  // namespace ehl::program
