#pragma once
#include <optional>
#include <vector>

#include "deck/deck.hpp"
#include "machines/number.hpp"

namespace ehl::machines {

/// Words of [case] kind for a contact of a machine element.
inline constexpr char ball_race[] = "ball_race", roller_race[] = "roller_race", gear_mesh[] = "gear_mesh";

/// Keys of [bearing] and [gear].
std::vector<deck::Key> keys();

/// The contact named by [case] kind, with its numbers in the order in which they follow from each other; those that
/// replace keys of [contact] and [motion] have the names of these keys. Reports errors; if the deck has any, the values
/// are NaN.
/// out: nullopt for other kinds.
std::optional<Contact> read(deck::Deck& deck);

/// Parts for [bearing] and [gear].
std::vector<deck::Key> bearing_keys();
std::vector<deck::Key> gear_keys();
std::vector<Number> read_bearing(const deck::Part& bearing, bool ball);
std::vector<Number> read_gear(const deck::Part& gear);

}  // namespace ehl::machines
