#include "machines/keys.hpp"

#include "core/constants.hpp"

namespace ehl::machines {

std::vector<deck::Key> keys() {
  return deck::together({bearing_keys(), gear_keys(), cam_keys(), stroke_keys(), impact_keys()});
}

std::optional<Contact> read(deck::Deck& deck) {
  const std::string kind = deck::word(deck, "case", "kind");
  const bool ball = kind == ball_race;
  Contact contact;
  if (ball || kind == roller_race)
    contact = read_bearing({deck, "bearing"}, ball);
  else if (kind == gear_mesh)
    contact = read_gear({deck, "gear"});
  else if (kind == cam_and_tappet)
    contact = read_cam({deck, "cam"});
  else if (kind == reciprocating)
    contact = read_stroke({deck, "stroke"});
  else if (kind == impact)
    contact = read_impact({deck, "impact"});
  else
    return std::nullopt;
  if (deck.errors.empty()) return contact;
  if (contact.numbers.empty()) {
    for (const char* name : {"load", "load_per_length", "radius_x", "u1", "u2"})
      if (name[0] == 'u' || !contact.only_moves) contact.numbers.push_back({.name = name});
    if (ball) contact.numbers.push_back({.name = "radius_y"});  // line contacts have none
  }
  for (Number& one : contact.numbers) one.value = core::unknown;
  return contact;
}

}  // namespace ehl::machines
