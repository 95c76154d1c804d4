#pragma once
// A small catalogue with one key of each kind, so that the tests of the deck do not depend on the physics.
#include <algorithm>
#include <string>
#include <vector>

#include "deck/deck.hpp"

namespace small {

inline ehl::deck::Catalogue catalogue() {
  using ehl::deck::Key;
  using ehl::deck::Type;
  ehl::deck::Catalogue all;
  all.sections = {{"body", "The body."},
                  {"mesh", "The mesh."},
                  {"law", "The law."},
                  {"wind", "The wind.", {"speed", "gust"}, "weather"}};
  all.keys = {
      Key{.section = "body",
          .name = "load",
          .unit = "N",
          .range = {0.0, 1e9, true, false},
          .meaning = "Load.",
          .example = "15",
          .example_is_active = true},
      Key{.section = "body", .name = "title", .type = Type::text, .default_text = "untitled", .meaning = "Title."},
      Key{.section = "mesh",
          .name = "cells",
          .type = Type::integer,
          .default_text = "64",
          .range = {16, 1024},
          .remedy = "take 64",
          .meaning = "Cells."},
      Key{.section = "mesh",
          .name = "length",
          .default_note = "from the load",
          .range = {1.0, 10.0},
          .meaning = "Length.",
          .example = "3"},
      Key{.section = "law",
          .name = "name",
          .type = Type::word,
          .default_text = "roelands",
          .words = {"isoviscous", "barus", "roelands"},
          .meaning = "Law."},
      Key{.section = "law",
          .name = "z",
          .default_text = "0.68",
          .range = {0.1, 1.5},
          .meaning = "Exponent.",
          .needs = {.name = "name", .words = {"roelands"}}},
      Key{.section = "law",
          .name = "limit",
          .default_text = "7",
          .meaning = "Needs the tolerance.",
          .needs = {.name = "tolerance"}},
      Key{.section = "wind", .name = "speed", .unit = "m/s", .meaning = "Speed.", .example = "3"},
      Key{.section = "wind", .name = "gust", .meaning = "Gust.", .example = "2"},
      Key{.section = "wind", .name = "angle", .default_text = "0", .meaning = "Angle."},
      Key{.section = "law",
          .name = "drag",
          .default_text = "1",
          .meaning = "Drag in the wind.",
          .needs = {.name = "speed", .section = "wind"}},
      Key{.section = "law",
          .name = "tolerance",
          .range = {0.0, 1.0, true, false},
          .meaning = "Tolerance.",
          .example = "0.1"},
      Key{.section = "law",
          .name = "outputs",
          .type = Type::words,
          .default_text = "P, H",
          .words = {"P", "H", "Q"},
          .meaning = "Outputs."},
  };
  all.unavailable = {{"weather", "", "not available in this version"}, {"mesh", "accuracy", "not in this version"}};
  return all;
}

inline ehl::deck::Deck read(const std::string& text, const std::vector<std::string>& overrides = {}) {
  std::vector<ehl::deck::Assignment> assignments;
  for (const std::string& one : overrides) assignments.push_back(ehl::deck::parse_override(one));
  ehl::deck::Deck deck = ehl::deck::validate(ehl::deck::parse(text, "d.ini"), assignments, catalogue());
  ehl::deck::check_influence(deck);
  return deck;
}

/// True if one of the errors contains all of the parts.
inline bool reports(const ehl::deck::Deck& deck, const std::vector<std::string>& parts) {
  return std::any_of(deck.errors.begin(), deck.errors.end(), [&](const std::string& error) {
    return std::all_of(parts.begin(), parts.end(),
                       [&](const std::string& part) { return error.find(part) != std::string::npos; });
  });
}

inline std::string all_errors(const ehl::deck::Deck& deck) {
  std::string text;
  for (const std::string& error : deck.errors) text += error + "\n";
  return text.empty() ? "(no error)" : text;
}

}  // namespace small
