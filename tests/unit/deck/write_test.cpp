#include "deck/write.hpp"

#include <boost/test/unit_test.hpp>

#include "core/errors.hpp"
#include "small_catalogue.hpp"
#include "support/text.hpp"

using namespace ehl;

namespace {
using support::contains;
}  // namespace

BOOST_AUTO_TEST_SUITE(test_deck_write)

BOOST_AUTO_TEST_CASE(the_commented_deck_is_a_valid_deck) {
  const std::string text = deck::commented_deck(small::catalogue());
  const deck::Deck deck = small::read(text);
  BOOST_TEST(deck.errors.empty(), text << small::all_errors(deck));
  BOOST_TEST(deck::number(deck, "body", "load") == 15.0);
  for (const deck::Key& key : small::catalogue().keys) BOOST_TEST(contains(text, key.name + " = "), key.name);
  BOOST_TEST(contains(text, "\n# length = 3\n"));
  BOOST_TEST(contains(text, "\n# limit = 7\n"));
  BOOST_TEST(contains(text, "\n# [wind]\n"));  // an effect that is off
  BOOST_TEST(contains(text, "\n# angle = 0\n"));
  BOOST_TEST(contains(text, "\n# drag = 1\n"));
}

// The effective deck, read again, gives itself.
BOOST_AUTO_TEST_CASE(the_effective_deck_gives_the_same_case) {
  deck::Deck deck = small::read("[body]\nload = 0.1\ntitle = x y\n[law]\nname = barus\n");
  deck::choose(deck, "mesh", "length", 10.0 / 3.0, "from the load");
  const std::string text = deck::effective_deck(deck);
  const deck::Deck again = small::read(text);
  BOOST_TEST(again.errors.empty(), text << small::all_errors(again));
  BOOST_TEST(deck::number(again, "mesh", "length") == 10.0 / 3.0);
  BOOST_TEST(deck::word(again, "body", "title") == "x y");
  BOOST_TEST(contains(text, "chosen: from the load"));
  BOOST_TEST(!contains(text, "z ="));  // a Barus fluid has no z
  deck::mark_following(deck, "mesh", "length");
  deck::mark_following(deck, "body", "load");
  const std::string following = deck::effective_deck(deck);
  BOOST_TEST(contains(following, "\n# length = 3.33333333333"), following);
  BOOST_TEST(contains(following, "  # follows: from the load\n"), following);
  BOOST_TEST(contains(following, "\nload = 0.1"), following);  // a value that was given stays
  for (const char* absent : {"[wind]", "angle", "drag"}) BOOST_TEST(!contains(text, absent), text);
  const std::string windy = deck::effective_deck(small::read("[wind]\nspeed = 3\n"));
  BOOST_TEST(contains(windy, "angle = 0  # default"), windy);
  BOOST_TEST(contains(windy, "drag = 1  # default"), windy);
  BOOST_TEST(small::read(windy).errors.empty());
}

BOOST_AUTO_TEST_CASE(the_list_of_keys) {
  const std::string all = deck::list_keys(small::catalogue(), "");
  for (const deck::Key& key : small::catalogue().keys) BOOST_TEST(contains(all, "  " + key.name), key.name);
  const std::string one = deck::list_keys(small::catalogue(), "mesh.cells");
  BOOST_TEST(contains(one, "cells"));
  BOOST_TEST(contains(all, "[wind]  The wind. Effect weather: enabled by speed or gust."));
  BOOST_TEST(contains(all, "Drag in the wind. (only with [wind] speed)"));
  BOOST_TEST(contains(one, "default: 64"));
  BOOST_TEST(!contains(one, "length"));
  BOOST_TEST(contains(deck::list_keys(small::catalogue(), "mesh"), "length"));
  const auto hint = [](const std::string& selection) -> std::string {
    try {
      deck::list_keys(small::catalogue(), selection);
    } catch (const core::InputError& error) {
      return error.what();
    }
    return "(none)";
  };
  BOOST_TEST(contains(hint("mehs"), "did you mean mesh?"));
  BOOST_TEST(contains(hint("mesh.cels"), "did you mean mesh.cells?"));
  BOOST_TEST(contains(hint("cells"), "did you mean mesh.cells?"));
}

BOOST_AUTO_TEST_SUITE_END()
