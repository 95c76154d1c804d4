#include "contact/keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "contact/coatings.hpp"
#include "contact/hertz.hpp"
#include "deck/record.hpp"

namespace ehl::contact {
namespace {

// Range for machined surfaces [m]; a larger value was probably meant in another unit.
constexpr deck::Range roughness{0.0, 1e-4, true, false};

deck::Records<Input> dimensionless_records() {
  using namespace deck::record;
  return {
      key("kind", by_default("point"), words({"point", "line", "roller"}),
          "Kind of contact. point: a circle or an ellipse. line: long bodies, straight across the motion, such as gear "
          "teeth and cams; nothing varies along y, and forces are per length: M = W (2U)^(-1/2) with W = F'/(E' R_x) "
          "and F' the load per length. roller: a line contact of the given length, with the profile of [roller]; M and "
          "W are those of its mean load per length."),
      key("M", &Input::M, Range{0.1, 1e5}, example("50"), active,
          "Moes load number M = W (2U)^(-3/4). M and L are the first of three ways to give the contact.",
          remedy("outside this range the contact is rigid or dry on every grid"),
          source("Moes; Venner and ten Napel 1992 use M = 50, L = 10")),
      key("L", &Input::L, Range{0.0, 100.0}, example("10"), active,
          "Moes material number L = G (2U)^(1/4); 0 for an isoviscous lubricant."),
      key("W", &Input::W, positive, example("1.9e-7"),
          "Hamrock-Dowson load number W = F/(E' R_x^2). W, U and G are the second way to give the contact."),
      key("U", &Input::U, positive, example("9.1e-12"),
          "Hamrock-Dowson speed number U = eta0 u_m/(E' R_x), u_m = (u1 + u2)/2."),
      key("G", &Input::G, not_negative, example("4500"),
          "Hamrock-Dowson material number G = alpha E'; 0 for an isoviscous lubricant."),
      key("a_over_R", &Input::a_over_R, up_to(1.0), example("0.01"),
          "Hertz radius over R_x, a/R. M and L leave it open, and shear stresses depend on it. Used only with M and L, "
          "and with [shear] or [friction].",
          remedy("a/R = pi p_h/E'")),
  };
}

deck::Records<Input> si_records() {
  using namespace deck::record;
  return {
      key("load", unit("N"), positive, example("15"),
          "Normal load F; for a roller, the load on its whole length. load, radius_x and the elastic data in SI, with "
          "[motion] and eta0, are the third way to give the contact.",
          remedy("the load presses the bodies together")),
      key("load_per_length", unit("N/m"), positive, example("2e5"),
          "Normal load per length of a line contact, F' = F/length, instead of load. Used only with kind = line.",
          remedy("1 N/mm is 1000 N/m")),
      key("radius_x", unit("m"), positive, example("0.0125"),
          "Reduced radius in the rolling direction: 1/R_x = 1/R_x1 + 1/R_x2. For a ball on a flat it is the radius of "
          "the ball."),
      key("radius_y", unit("m"), positive, example("0.0125"), otherwise("radius_x (circular contact)"),
          "Reduced radius at right angles to radius_x: 1/R_y = 1/R_y1 + 1/R_y2. radius_ratio may be given instead."),
      key("E1", unit("Pa"), positive, example("206e9"),
          "Young's modulus of body 1. Give E1, nu1, E2 and nu2 together, or E_prime instead."),
      key("nu1", Range{-1.0, 0.5, true, false}, example("0.3"), "Poisson's ratio of body 1."),
      key("E2", unit("Pa"), positive, example("81e9"), "Young's modulus of body 2."),
      key("nu2", Range{-1.0, 0.5, true, false}, example("0.208"), "Poisson's ratio of body 2."),
      key("E_prime", unit("Pa"), positive, example("110e9"),
          "Reduced modulus E' = 2/[(1 - nu1^2)/E1 + (1 - nu2^2)/E2], instead of E1, nu1, E2 and nu2."),
      key("Sq1", &Input::Sq1, unit("m"), roughness, example("10e-9"),
          "Root mean square height of surface 1 (Sq of a map, Rq of a profile), for the lambda ratio in the report. "
          "The film is computed for smooth surfaces.",
          remedy("10 nm are 10e-9")),
      key("Sq2", &Input::Sq2, unit("m"), roughness, example("5e-9"), "Root mean square height of surface 2, see Sq1."),
  };
}

std::vector<deck::Key> shape_keys() {
  using namespace deck::record;
  return {
      key("radius_ratio", instead_of({"radius_y"}), Range{0.005, 200.0}, example("0.2"),
          otherwise("1 (circular contact), or from radius_y"),
          "R_x/R_y, the reduced radius in the rolling direction over the one across it. Below 1 the contact is an "
          "ellipse that is wider than long. It may be given with each of the three ways; groups, Hertz radii and "
          "scales are defined with R_x.",
          remedy("outside this range the contact is nearly a line contact"),
          source("tests/bench/wide_ellipses.csv; the film formulas hold for 0.05 to 1, Nijenbanning, Venner and Moes "
                 "1994")),
  };
}

deck::Records<Input> records() { return deck::together<deck::Record<Input>>({dimensionless_records(), si_records()}); }

using Names = std::vector<std::string>;

const Names names_in_moes{"M", "L"};
const Names names_in_hamrock_dowson{"W", "U", "G"};
Names with_coatings(Names names) {
  for (const char* body : {"1", "2"})
    for (const char* part : {"_E", "_nu", "_thickness"}) names.push_back(std::string("coating") + body + part);
  return names;
}
const Names names_in_si =
    with_coatings({"load", "load_per_length", "radius_x", "radius_y", "E1", "nu1", "E2", "nu2", "E_prime"});
const Names four_moduli{"E1", "nu1", "E2", "nu2"};

Language language_of(const deck::Part& contact) {
  struct Choice {
    Language language;
    Names given;
  };
  std::vector<Choice> spoken;
  for (const auto& [language, names] : {std::pair{Language::moes, names_in_moes},
                                        {Language::hamrock_dowson, names_in_hamrock_dowson},
                                        {Language::si, names_in_si}})
    if (const Names found = contact.given_of(names); !found.empty()) spoken.push_back({language, found});
  if (spoken.empty())
    contact.complain("M",
                     "the contact is missing: give M and L; or W, U and G; or load, radius_x and E_prime (or E1, nu1, "
                     "E2, nu2), for a line contact load_per_length",
                     deck::Cause::missing);
  if (spoken.size() == 1) return spoken[0].language;
  // Advise to remove the one stray key, not the three complete ones.
  std::ranges::stable_sort(spoken, std::ranges::greater{}, [](const Choice& choice) { return choice.given.size(); });
  for (std::size_t k = 1; k < spoken.size(); ++k)
    contact.refuse(spoken[k].given, "the contact is already given by " + deck::joined(spoken[0].given, ", ") + " (" +
                                        deck::value(contact.deck, "contact", spoken[0].given[0]).place +
                                        "); keep one of M, L | W, U, G | load, radius_x and moduli");
  return Language::none;
}

// True if `kind` is not a valid word, which has been reported; the required keys are then unknown.
bool kind_is_refused(const deck::Part& contact) { return !deck::value(contact.deck, "contact", "kind").valid; }

std::string load_name(const deck::Part& contact) { return is_line(contact.deck) ? "load_per_length" : "load"; }

// E' without coatings; NaN if the deck lacks moduli.
double modulus_of(const deck::Part& contact) {
  if (contact.given("E_prime")) return contact.number("E_prime");
  return reduced_modulus({contact.number("E1"), contact.number("nu1")}, {contact.number("E2"), contact.number("nu2")});
}

void check_moduli(const deck::Part& contact) {
  const Names moduli = contact.given_of(four_moduli);
  if (contact.given("E_prime"))
    contact.refuse(moduli, "E_prime is given as well: keep either E_prime or E1, nu1, E2, nu2");
  else if (moduli.empty())
    contact.complain("E_prime", "is missing: give it, or E1, nu1, E2 and nu2", deck::Cause::missing);
  else
    contact.demand(four_moduli, "E1, nu1, E2 and nu2 belong together (or give E_prime alone)");
}

Bodies read_bodies(const deck::Part& contact) {
  const std::string load = load_name(contact);
  if (!kind_is_refused(contact))
    contact.demand({load, "radius_x"}, "a contact in SI needs " + load + ", radius_x and the elastic moduli");
  check_moduli(contact);
  const double E_prime = modulus_of(contact);
  return {.load = contact.number(load),
          .radius = contact.number("radius_x"),
          .E_prime = E_prime,
          .E_prime_uncoated = E_prime,
          .coatings = read_coatings(contact)};
}

// R_x/R_y, or NaN after an error. Derived values are recorded in the deck.
double read_radius_ratio(const deck::Part& contact, Language language) {
  const double ratio = contact.number("radius_ratio");
  const bool given = contact.given("radius_ratio");
  if (language != Language::si) return given ? ratio : 1.0;
  if (given) return ratio;
  const double radius_x = contact.number("radius_x");
  contact.follow("radius_y", radius_x, "circular contact");
  const double of_radii = radius_x / contact.number("radius_y");
  const deck::Key& key = contact.key("radius_ratio");
  if (!std::isnan(of_radii) && !key.range.contains(of_radii))
    contact.complain("radius_y", fmt::format("means radius_x/radius_y = {:.4g}, which must be {}: outside this range "
                                             "the contact is nearly a line contact",
                                             of_radii, deck::allowed(key)));
  return of_radii;
}

Ellipse read_shape(const deck::Part& contact, const deck::Part& motion, Input& input) {
  const Language language = input.language;
  if (kind_is_refused(contact)) return {};
  const bool line = is_line(contact.deck);
  if (!line) contact.refuse({"load_per_length"}, "belongs to a line contact: set kind = line, or give load [N]");
  if (const std::string kind = contact.word("kind"); kind != "point") {
    if (line) contact.refuse({"load"}, "belongs to a point contact: give load_per_length [N/m] for a line contact");
    contact.refuse(
        {"radius_y", "radius_ratio"},
        line ? "has no influence on a line contact, which is straight across the motion: remove it, or remove kind = "
               "line"
             : "has no influence on a roller, whose shape across the motion is the profile of [roller]: remove it",
        deck::Cause::idle);
    motion.refuse({"angle"}, "has no influence on a " + kind + " contact: remove it", deck::Cause::idle);
    if (line) return line_contact();
    const double length = read_length(contact, input);
    return contact.deck.errors.empty() ? roller_contact(length) : line_contact();
  }
  const double ratio = read_radius_ratio(contact, language);
  if (ratio == 1.0)
    motion.refuse({"angle"}, "has no influence on a circular contact: remove it, or give radius_ratio or radius_y",
                  deck::Cause::idle);
  if (!contact.deck.errors.empty() || std::isnan(ratio) || ratio == 1.0) return {};
  motion.fill("angle", 0.0, "along radius_x");
  return ellipse(ratio, motion.number("angle"));
}

}  // namespace

std::vector<deck::Key> keys() {
  return deck::together({deck::keys_of("contact", records()),
                         deck::in_section("contact", deck::together({coating_keys(), shape_keys(), length_keys()})),
                         deck::in_section("motion", motion_keys())});
}

bool is_line(deck::Deck& deck) { return deck::Part{deck, "contact"}.choice("kind", {false, true, false}); }

Input read(deck::Deck& deck, bool slides) {
  const deck::Part contact{deck, "contact"}, motion{deck, "motion"};
  Input input{.language = language_of(contact)};
  deck::read(contact, records(), input);
  if (input.language == Language::moes) contact.demand(names_in_moes, "M and L belong together");
  if (input.language == Language::hamrock_dowson) contact.demand(names_in_hamrock_dowson, "W, U and G belong together");
  if (input.language == Language::si) input.bodies = read_bodies(contact);
  if (input.language != Language::none) {
    if (input.language != Language::si)
      contact.refuse({"Sq1", "Sq2"}, "is in metres and needs a contact in SI: remove it");
    if (input.language != Language::moes || !slides)
      contact.refuse({"a_over_R"},
                     "has no influence: it is used only with M and L, and with [shear] or [friction]; remove it",
                     deck::Cause::idle);
  }
  read_motion(motion, slides, input);
  input.shape = read_shape(contact, motion, input);
  if (contact.deck.errors.empty()) input.bodies.E_prime = equivalent_modulus(input.bodies, input.shape);
  return input;
}

ElasticShape elastic_shape(deck::Deck& deck) {
  const deck::Part contact{deck, "contact"};
  const double radius = contact.number("radius_x"), radius_y = contact.number("radius_y");
  const double of_radii = contact.given("radius_y") ? radius / radius_y : 1.0;
  const double ratio = contact.given("radius_ratio") ? contact.number("radius_ratio") : of_radii;
  ElasticShape found{.radius = radius, .E_prime = modulus_of(contact)};
  if (!contact.key("radius_ratio").range.contains(ratio))
    found.radius = core::unknown;
  else if (ratio != 1.0)
    found.shape = ellipse(ratio, 0.0);
  return found;
}

std::optional<Bodies> read_bodies(deck::Deck& deck) {
  const deck::Part contact{deck, "contact"};
  if (contact.given_of(names_in_si).empty()) return std::nullopt;
  Bodies bodies = read_bodies(contact);
  if (deck.errors.empty()) bodies.E_prime = equivalent_modulus(bodies, {});
  return bodies;
}

}  // namespace ehl::contact
