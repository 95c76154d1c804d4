#include <boost/test/unit_test.hpp>
#include <cmath>

#include "core/errors.hpp"
#include "small_catalogue.hpp"

using namespace ehl;

BOOST_AUTO_TEST_SUITE(test_deck_validate)

BOOST_AUTO_TEST_CASE(a_good_deck) {
  const deck::Deck deck = small::read("[body]\nload = 15\n[law]\nname = barus\n");
  BOOST_TEST(deck.errors.empty(), small::all_errors(deck));
  BOOST_TEST(deck::number(deck, "body", "load") == 15.0);
  BOOST_TEST(deck::integer(deck, "mesh", "cells", -1) == 64);
  BOOST_TEST(deck::word(deck, "law", "name") == "barus");
  BOOST_TEST(deck::given(deck, "law", "name"));
  BOOST_TEST(!deck::given(deck, "mesh", "cells"));
  BOOST_TEST(std::isnan(deck::number(deck, "mesh", "length")));
  BOOST_TEST(deck::integer(deck, "mesh", "length", -1) == -1);
  BOOST_TEST(deck::words(deck, "law", "outputs").size() == 2u);
  BOOST_CHECK_NO_THROW(deck::throw_if_wrong(deck));
  BOOST_CHECK_THROW(deck::value(deck, "mesh", "nothing"), std::logic_error);
}

// An error in a computed number is reported at the keys from which the number follows.
BOOST_AUTO_TEST_CASE(computed_numbers_name_their_origin) {
  const auto said = [](const std::vector<std::string>& overrides) {
    deck::Deck deck = small::read("[mesh]\ncells = 32\n", overrides);
    deck::compute(deck, "body", "load", 0.1, "mesh", "cells and length");
    BOOST_TEST(deck::given(deck, "body", "load"));
    deck::complain(deck, "body", "load", "is small");
    return small::all_errors(deck);
  };
  BOOST_TEST(said({}) == "d.ini:1: [mesh]: so [body] load = 0.1 ([mesh]: cells and length): is small\n");
  BOOST_TEST(said({"mesh.length=3", "law.z=0.5"}) ==
             "command line: [mesh] length = 3: so [body] load = 0.1 ([mesh]: cells and length): is small\n");
}

// A line of the deck, and what its message must contain: place, key, value, remedy.
BOOST_AUTO_TEST_CASE(each_slip_has_its_message) {
  struct Slip {
    const char* text;
    std::vector<std::string> parts;
  };
  const std::vector<Slip> slips{
      {"[body]\nlaod = 15\n", {"d.ini:2", "[body] laod", "did you mean load?"}},
      {"[boddy]\nload = 15\n", {"d.ini:1", "[boddy]", "did you mean body?"}},
      {"[mesh]\nload = 15\n", {"d.ini:2", "belongs below [body]"}},
      {"load = 15\n", {"d.ini:1", "before the first [section]", "[body]"}},
      {"[body]\nload = nan\n", {"d.ini:2", "load = nan", "not a finite number", "> 0"}},
      {"[body]\nload = inf\n", {"d.ini:2", "not a finite number"}},
      {"[body]\nload = 1e999\n", {"d.ini:2", "outside the range"}},
      {"[body]\nload = -3\n", {"d.ini:2", "load = -3", "> 0", "N"}},
      {"[body]\nload = 0\n", {"d.ini:2", "> 0"}},
      {"[body]\nload = heavy\n", {"d.ini:2", "not a number"}},
      {"[body]\nload = 15 N\n", {"d.ini:2", "the number alone", "unit is N"}},
      {"[body]\nload = 1,5\n", {"d.ini:2", "decimal point"}},
      {"[body]\nload =\n", {"d.ini:2", "value is missing"}},
      {"[body]\nload = 1\nload = 2\n", {"d.ini:3", "given twice", "d.ini:2"}},
      {"[mesh]\ncells = 12\n", {"d.ini:2", "cells = 12", ">= 16", "take 64"}},
      {"[mesh]\ncells = 33.5\n", {"d.ini:2", "whole number"}},
      {"[mesh]\ncells = 99999999999\n", {"d.ini:2", "whole number"}},
      {"[law]\nname = Roelnads\n", {"d.ini:2", "did you mean roelands?", "isoviscous, barus, roelands"}},
      {"[law]\noutputs = P, R\n", {"d.ini:2", "'R' is unknown", "P, H, Q"}},
      {"[law]\nname = barus\nz = 0.6\n", {"d.ini:3", "z = 0.6", "no influence with name = barus", "remove it"}},
      {"[law]\nlimit = 3\n", {"d.ini:2", "no influence without tolerance"}},
      {"[mesh]\n[body]\nload = 1\n", {"d.ini:1", "[mesh]", "no influence", "cells, length"}},
      {"[wind]\nangle = 9\n", {"d.ini:2", "angle = 9", "no influence without speed or gust"}},
      {"[wind]\n[body]\nload = 1\n", {"d.ini:1", "[wind]", "no influence", "give speed or gust"}},
      {"[law]\ndrag = 2\n[wind]\ngust = 1\n", {"d.ini:2", "drag = 2", "no influence without [wind] speed"}},
      {"[weather]\nrain = 1\n", {"d.ini:1", "[weather]", "not available in this version"}},
      {"[mesh]\naccuracy = 0.1\n", {"d.ini:2", "accuracy", "not in this version"}},
  };
  for (const Slip& slip : slips) {
    const deck::Deck deck = small::read(slip.text);
    BOOST_TEST(deck.errors.size() == 1u, slip.text << "gives\n" << small::all_errors(deck));
    BOOST_TEST(small::reports(deck, slip.parts), slip.text << "gives\n" << small::all_errors(deck));
    BOOST_CHECK_THROW(deck::throw_if_wrong(deck), core::InputError);
  }
}

BOOST_AUTO_TEST_CASE(all_errors_are_listed_at_once) {
  const deck::Deck deck = small::read("[body]\nload = -1\nlaod = 2\n[mesh]\ncells = x\nnonsense\n", {"law.z=9"});
  BOOST_TEST(deck.errors.size() == 5u, small::all_errors(deck));
}

BOOST_AUTO_TEST_CASE(a_condition_that_holds_is_no_error) {
  const deck::Deck deck = small::read("[law]\nz = 0.6\ntolerance = 0.1\nlimit = 3\n");
  BOOST_TEST(deck.errors.empty(), small::all_errors(deck));
  const deck::Deck windy = small::read("[wind]\nangle = 9\nspeed = 3\n[law]\ndrag = 2\n");
  BOOST_TEST(windy.errors.empty(), small::all_errors(windy));
  BOOST_TEST(small::read("[wind]\nangle = 9\ngust = 3\n").errors.empty());
}

BOOST_AUTO_TEST_CASE(the_command_line_replaces_and_is_checked_alike) {
  const deck::Deck replaced = small::read("[body]\nload = -1\n", {"body.load=7"});
  BOOST_TEST(replaced.errors.empty(), small::all_errors(replaced));
  BOOST_TEST(deck::number(replaced, "body", "load") == 7.0);

  const deck::Deck wrong = small::read("[body]\nload = 1\n", {"body.load=-7", "mehs.cells=3", "weather.rain=1"});
  BOOST_TEST(wrong.errors.size() == 3u, small::all_errors(wrong));
  BOOST_TEST(small::reports(wrong, {"command line", "load = -7", "> 0"}));
  BOOST_TEST(small::reports(wrong, {"command line", "unknown section", "did you mean mesh?"}));
  BOOST_TEST(small::reports(wrong, {"command line", "not available in this version"}));

  const deck::Deck twice = small::read("[body]\nload = 1\n", {"body.load=2", "body.load=3"});
  BOOST_TEST(small::reports(twice, {"command line", "given twice"}), small::all_errors(twice));
}

// Consequences of another error are found by their cause, whatever their words are.
BOOST_AUTO_TEST_CASE(consequences_are_left_out) {
  const auto kept = [](const std::string& text) {
    deck::Deck deck = small::read(text);
    const deck::Part law{deck, "law"};
    law.complain("z", "is needed here", deck::Cause::missing);
    law.complain("z", "does nothing", deck::Cause::idle);
    law.complain("z", "has no influence, and the limit is missing");
    law.demand({"tolerance"}, "the law needs it");
    return deck::first_causes(deck).size();
  };
  BOOST_TEST(kept("[body]\nload = 1\n") == 4u);
  BOOST_TEST(kept("[body]\nlaod = 1\n") == 2u);  // the unknown key, and the rule between keys
}

BOOST_AUTO_TEST_CASE(chosen_values_and_complaints) {
  deck::Deck deck = small::read("[mesh]\nlength = 2\n");
  deck::choose(deck, "body", "load", 4.0, "because");
  BOOST_TEST(deck::number(deck, "body", "load") == 4.0);
  BOOST_TEST(!deck::given(deck, "body", "load"));
  deck::complain(deck, "mesh", "length", "too short");
  BOOST_TEST(deck.errors.back() == "d.ini:2: [mesh] length = 2: too short");
  deck::complain(deck, "law", "tolerance", "missing");
  BOOST_TEST(deck.errors.back() == "d.ini: [law] tolerance: missing");
}

BOOST_AUTO_TEST_SUITE_END()
