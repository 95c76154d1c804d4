#include "case/machine_input.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "machines/keys.hpp"

namespace ehl::program {
namespace {

// True for the keys of the deck that describe the bodies; they are allowed with any machine.
bool of_the_bodies(const deck::Key& key) {
  static const std::vector<std::string> names{"E1",
                                              "nu1",
                                              "E2",
                                              "nu2",
                                              "E_prime",
                                              "Sq1",
                                              "Sq2",
                                              "coating1_E",
                                              "coating1_nu",
                                              "coating1_thickness",
                                              "coating2_E",
                                              "coating2_nu",
                                              "coating2_thickness"};
  return key.section == "contact" && std::ranges::find(names, key.name) != names.end();
}

// A refused key is treated as absent, so that it causes no further messages.
void refuse_contact(deck::Deck& deck, const machines::Contact& machine) {
  for (std::size_t k = 0; k < deck.values.size(); ++k) {
    const deck::Key& key = deck.catalogue.keys[k];
    if ((key.section != "contact" && key.section != "motion") || of_the_bodies(key)) continue;
    if (deck.values[k].origin != deck::Origin::given) continue;
    complain(
        deck, key.section, key.name,
        "[case] kind = " + deck::word(deck, "case", "kind") + " computes it from [" + machine.section + "]: remove it");
    deck.values[k] = {};
  }
}

}  // namespace

std::optional<machines::Contact> machine_input(deck::Deck& deck) {
  std::optional<machines::Contact> machine = machines::read(deck);
  if (!machine) return std::nullopt;
  refuse_contact(deck, *machine);
  const std::string& section = machine->section;
  const std::string kind = deck::word(deck, "case", "kind");
  const bool ball = kind == machines::ball_race;
  const bool with_ends = !ball && deck::given(deck, "roller", "profile");
  if (ball) {
    compute(deck, "motion", "angle", 0.0, section, "the ball rolls along radius_x");
    compute(deck, "contact", "kind", "point", section, "a ball in its groove");
  } else if (with_ends) {
    compute(deck, "contact", "kind", "roller", section, "[roller] gives it a profile");
    const std::string length = kind == machines::gear_mesh ? "face_width" : "length";
    compute(deck, "contact", "length_m", deck::number(deck, section, length), section, length);
  } else {
    compute(deck, "contact", "kind", "line", section, "straight flanks");
  }
  for (const auto& [part, name] : {std::pair{"contact", ball || with_ends ? "load" : "load_per_length"},
                                   {"contact", "radius_x"},
                                   {"contact", "radius_y"},
                                   {"motion", "u1"},
                                   {"motion", "u2"}})
    if (const auto number = std::ranges::find(machine->numbers, name, &machines::Number::name);
        number != machine->numbers.end())
      compute(deck, part, name, number->value, section, number->formula);
  return machine;
}

}  // namespace ehl::program
