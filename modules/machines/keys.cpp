#include "machines/keys.hpp"

#include "core/constants.hpp"

namespace ehl::machines {

std::vector<deck::Key> keys() { return deck::together({bearing_keys(), gear_keys()}); }

std::optional<Contact> read(deck::Deck& deck) {
  const std::string kind = deck::word(deck, "case", "kind");
  const bool ball = kind == ball_race, bearing = ball || kind == roller_race;
  if (!bearing && kind != gear_mesh) return std::nullopt;
  Contact contact{.section = bearing ? "bearing" : "gear"};
  const deck::Part part{deck, contact.section};
  contact.numbers = bearing ? read_bearing(part, ball) : read_gear(part);
  contact.what =
      !bearing ? "teeth of two spur gears" : (ball ? "ball on the " : "roller on the ") + part.word("race") + " race";
  if (deck.errors.empty()) return contact;
  if (contact.numbers.empty()) {
    for (const char* name : {"load", "load_per_length", "radius_x", "u1", "u2"})
      contact.numbers.push_back({.name = name});
    if (ball) contact.numbers.push_back({.name = "radius_y"});  // line contacts have none
  }
  for (Number& one : contact.numbers) one.value = core::unknown;
  return contact;
}

}  // namespace ehl::machines
