// The pressures above which bearing steel yields, tested on both sides.
#include <boost/test/unit_test.hpp>
#include <limits>

#include "contact/yield.hpp"

BOOST_AUTO_TEST_SUITE(test_contact_yield)

using ehl::contact::beyond_yield;

BOOST_AUTO_TEST_CASE(steel_is_named_beyond_its_yield_and_not_before) {
  // 1.6 x 2 GPa, and 4.2 GPa of ISO 76.
  for (const double p_h : {0.4e9, 2.0e9, 3.19e9, std::numeric_limits<double>::quiet_NaN()})
    BOOST_TEST(!beyond_yield(p_h).has_value(), p_h);
  const auto says = [](double p_h, const char* part) {
    const std::string text = beyond_yield(p_h).value_or(ehl::core::Warning{"", "nothing"}).text;
    BOOST_TEST_MESSAGE(text);
    return text.find(part) != std::string::npos;
  };
  BOOST_TEST(says(3.21e9, "p_h = 3.21 GPa exceeds the yield limit of steel"));
  BOOST_TEST(says(3.21e9, "3.2 GPa"));
  BOOST_TEST(says(3.21e9, "4.2 GPa"));
  BOOST_TEST(says(4.19e9, "exceeds the yield"));
  BOOST_TEST(says(4.21e9, "p_h = 4.21 GPa is far beyond what steel can carry"));
}

BOOST_AUTO_TEST_SUITE_END()
