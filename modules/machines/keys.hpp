#pragma once
#include <optional>
#include <vector>

#include "deck/deck.hpp"
#include "machines/number.hpp"

namespace ehl::machines {

/// The words of [case] kind for a contact of a machine element.
inline constexpr char ball_race[] = "ball_race", roller_race[] = "roller_race", gear_mesh[] = "gear_mesh";

/// The deck's keys of [bearing] and [gear].
std::vector<deck::Key> keys();

/// The contact that [case] kind names, its numbers in the order in which they follow from one another; among them, by
/// the names of their keys, those of [contact] and [motion]. Complains, and where the deck has complaints at all their
/// values are NaN. out: nothing where the kind is another one.
std::optional<Contact> read(deck::Deck& deck);

/// [bearing] and [gear] of these.
std::vector<deck::Key> bearing_keys();
std::vector<deck::Key> gear_keys();
std::vector<Number> read_bearing(const deck::Part& bearing, bool ball);
std::vector<Number> read_gear(const deck::Part& gear);

}  // namespace ehl::machines
