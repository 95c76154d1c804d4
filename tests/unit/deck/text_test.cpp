#include "deck/text.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

using namespace ehl::deck;

BOOST_AUTO_TEST_SUITE(test_deck_text)

// Distances counted by hand; exchanging two neighbouring letters is one error, not two.
BOOST_AUTO_TEST_CASE(edit_distance_of_known_pairs) {
  BOOST_TEST(edit_distance("cells", "cells") == 0);
  BOOST_TEST(edit_distance("celsl", "cells") == 1);
  BOOST_TEST(edit_distance("cels", "cells") == 1);
  BOOST_TEST(edit_distance("Cells", "cells") == 0);
  BOOST_TEST(edit_distance("kitten", "sitting") == 3);
  BOOST_TEST(edit_distance("", "abc") == 3);
}

// For random words: the distance is symmetric, and at most the length of the longer word.
BOOST_AUTO_TEST_CASE(edit_distance_is_a_distance) {
  std::mt19937 random(7);
  const auto word = [&] {
    std::string text(random() % 9, 'a');
    for (char& c : text) c = static_cast<char>('a' + random() % 3);
    return text;
  };
  for (int k = 0; k < 300; ++k) {
    const std::string a = word();
    const std::string b = word();
    const int longer = static_cast<int>(std::max(a.size(), b.size()));
    BOOST_TEST(edit_distance(a, b) == edit_distance(b, a));
    BOOST_TEST(edit_distance(a, b) <= longer);
    BOOST_TEST((edit_distance(a, b) == 0) == (a == b));
  }
}

BOOST_AUTO_TEST_CASE(nearest_names) {
  const std::vector<std::string> names{"load", "radius_x", "E_prime", "cells"};
  BOOST_TEST(nearest("laod", names) == "load");
  BOOST_TEST(nearest("radiusx", names) == "radius_x");
  BOOST_TEST(nearest("eprime", names) == "E_prime");
  BOOST_TEST(nearest("temperature", names) == "");
  BOOST_TEST(nearest("q", names) == "");
  BOOST_TEST(nearest("a", {}) == "");
  const std::vector<std::string> oils{"mourier", "mineral-vg32", "mineral-vg68", "mineral-vg680", "pao4", "squalane"};
  for (const char* name : {"vg68", "VG 68", "vg-68"}) BOOST_TEST(nearest(name, oils) == "mineral-vg68");
  BOOST_TEST(nearest("PAO 4", oils) == "pao4");
  BOOST_TEST(nearest("68", oils) == "");
}

BOOST_AUTO_TEST_CASE(numbers) {
  using Status = ReadNumber::Status;
  const auto status = [](const char* text) { return read_number(text).status; };
  BOOST_TEST(read_number("1.7e-8").value == 1.7e-8);
  BOOST_TEST(read_number("+3").value == 3.0);
  BOOST_TEST(read_number(" -.5 ").value == -0.5);
  BOOST_TEST((status("15 N") == Status::trailing_text));
  BOOST_TEST(read_number("15 N").trailing == "N");
  BOOST_TEST((status("0,5") == Status::trailing_text));
  BOOST_TEST((status("0x10") == Status::trailing_text));
  for (const char* text : {"nan", "NaN", "-inf", "Infinity"}) BOOST_TEST((status(text) == Status::not_finite));
  for (const char* text : {"1e999", "-1e999"}) BOOST_TEST((status(text) == Status::out_of_reach));
  for (const char* text : {"", "steel", "-", "+-3", "nan(1)", "--2"}) BOOST_TEST((status(text) != Status::number));
}

// Characters that a terminal would interpret or hide must become visible, and the message must stay readable.
BOOST_AUTO_TEST_CASE(foreign_text_in_messages) {
  BOOST_TEST(quotable("M = 3 \xC2\xB5") == "M = 3 \xC2\xB5");
  BOOST_TEST(quotable("V\x01") == "V\\x01");
  BOOST_TEST(quotable("\x1b[31m\x7f\n") == "\\x1b[31m\\x7f\\x0a");
  BOOST_TEST(quotable(std::string(80, 'x')) == std::string(80, 'x'));
  BOOST_TEST(quotable(std::string(100000, 'x')) == std::string(80, 'x') + "... (100000 bytes)");
  const std::string character = "\xE8\x96\x84";  // not split in the middle
  BOOST_TEST(quotable(std::string(79, 'x') + character) == std::string(79, 'x') + "... (82 bytes)");
}

BOOST_AUTO_TEST_CASE(shortest_text_reads_back_exactly) {
  for (const double value : {0.1, 1.0 / 3.0, 1.96e8, -4.5, 6.02214076e23, 5e-324})
    BOOST_TEST(read_number(shortest(value)).value == value);
  BOOST_TEST(shortest(256.0) == "256");
}

BOOST_AUTO_TEST_SUITE_END()
