// Length of a roller.
#include <fmt/format.h>

#include "contact/hertz.hpp"
#include "contact/keys.hpp"
#include "deck/record.hpp"

namespace ehl::contact {

std::vector<deck::Key> length_keys() {
  using namespace deck::record;
  return {key("length", Range{4.0, 2000.0}, needs("kind", {"roller"}), example("40"),
              "Length of the roller in half widths a of the line contact with its mean load per length. Used only with "
              "M and L, or with W, U and G.",
              remedy("a shorter body is not a roller")),
          key("length_m", unit("m"), positive, needs("kind", {"roller"}), example("0.008"),
              "Length of the roller: its total length available for contact. Used only with a contact in SI.",
              remedy("in metres: 8 mm are 0.008"))};
}

double read_length(const deck::Part& contact, Input& input) {
  const bool si = input.language == Language::si;
  const std::string name = si ? "length_m" : "length";
  contact.refuse({si ? "length" : "length_m"},
                 "belongs to a contact " + std::string(si ? "without units: give length_m" : "in SI: give length"));
  contact.demand({name}, "a roller has a length");
  if (!si || !contact.deck.errors.empty()) return contact.number(name);
  input.bodies.load /= contact.number(name);
  const Hertz line = hertz(input.bodies.load, input.bodies.radius, input.bodies.E_prime, line_contact());
  const double length = contact.number(name) / line.a;
  const deck::Key& key = contact.key("length");
  if (!key.range.contains(length))
    contact.complain(name,
                     fmt::format("is {:.4g} half widths of the contact, which must be {}", length, deck::allowed(key)));
  return length;
}

}  // namespace ehl::contact
