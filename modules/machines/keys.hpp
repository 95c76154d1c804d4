#pragma once
#include <optional>
#include <vector>

#include "deck/deck.hpp"
#include "deck/key.hpp"
#include "machines/number.hpp"

namespace ehl::machines {

/// Words of [case] kind for a contact of a machine element.
inline constexpr char ball_race[] = "ball_race", roller_race[] = "roller_race", gear_mesh[] = "gear_mesh",
                      cam_and_tappet[] = "cam", reciprocating[] = "reciprocating", impact[] = "impact";

/// Keys of [bearing], [gear], [cam], [stroke] and [impact].
std::vector<deck::Key> keys();

/// The contact named by [case] kind, with its numbers in the order in which they follow from each other; those that
/// replace keys of [contact] and [motion] have the names of these keys. Reports errors; if the deck has any, the values
/// are NaN.
/// out: nullopt for other kinds.
std::optional<Contact> read(deck::Deck& deck);

/// What keys need that matter for a course only.
inline const deck::Condition in_time{.name = "cycle", .words = {"machine"}, .section = "transient"};

/// Parts for the sections.
std::vector<deck::Key> bearing_keys();
std::vector<deck::Key> gear_keys();
std::vector<deck::Key> cam_keys();
std::vector<deck::Key> stroke_keys();
std::vector<deck::Key> impact_keys();
Contact read_bearing(const deck::Part& bearing, bool ball);
Contact read_gear(const deck::Part& gear);
Contact read_cam(const deck::Part& cam);
Contact read_stroke(const deck::Part& stroke);
Contact read_impact(const deck::Part& part);

}  // namespace ehl::machines
