// `ehl asperities` and its picture, about which gnuplot must say nothing.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "support/program.hpp"
#include "support/text.hpp"

BOOST_AUTO_TEST_SUITE(test_asperities)

// Maps whose tables have all columns, and without the formulas beside: a lay that never ends has no gamma.
BOOST_AUTO_TEST_CASE(asperities_of_a_map) {
  const support::TemporaryFolder folder;
  std::string bumps, ridges;
  for (int j = 0; j < 32; ++j)
    for (int i = 0; i < 32; ++i) {
      const double x = std::cos(0.7 * i) + 0.4 * std::cos(0.31 * i), y = std::sin(0.6 * j) + 0.3 * std::sin(0.17 * j);
      const char* end = i < 31 ? "," : "\n";
      bumps += std::to_string(100.0 * (x + y)) + end;
      ridges += std::to_string(100.0 * x) + end;
    }
  folder.write("bumps.csv", bumps);
  folder.write("ridges.csv", ridges);
  for (const std::string map : {"bumps", "ridges"}) {
    const support::Ended table =
        support::ehl(folder, "asperities " + map + ".csv --dx 1e-6 --unit 1e-9 --rows 5 --quiet");
    BOOST_TEST(table.status == 0, table.err);
    const support::Ended drawn = support::ehl(folder, "plot " + map + "_asperities.csv --format svg");
    BOOST_TEST(drawn.out == map + "_asperities_asperities.svg\n");
    BOOST_TEST(drawn.err.empty(), drawn.err);
    const std::string svg = folder.read(map + "_asperities_asperities.svg");
    BOOST_TEST(support::contains(svg, "flow factor"));
    BOOST_TEST(support::contains(svg, "Patir, Cheng") == (map == "bumps"));
  }
}

BOOST_AUTO_TEST_SUITE_END()
