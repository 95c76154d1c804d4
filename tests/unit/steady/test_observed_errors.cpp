// Error bars of the numbers of an observer from their values on all levels.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "steady/observed_errors.hpp"
#include "steady/scene.hpp"

using namespace ehl;
using namespace ehl::steady;
using boost::test_tools::tolerance;

BOOST_AUTO_TEST_SUITE(test_steady_error_bars)

// The orders are those of observed_errors.cpp.
BOOST_AUTO_TEST_CASE(of_observed_numbers) {
  const auto errors = [](const std::vector<double>& values, bool spike = false) {
    std::vector<multigrid::LevelRow> levels;
    for (const double value : values) {
      levels.emplace_back();
      levels.back().observed = {0.0, value};
    }
    return errors_of_observed({}, levels, spike);
  };
  const auto error = [&](const std::vector<double>& values, bool spike = false) { return errors(values, spike)[1]; };
  BOOST_TEST(errors({0.8, 0.5})[0] == 0.0);  // zero on all levels
  BOOST_TEST(std::isnan(error({0.5})));
  BOOST_TEST(error({0.6, 0.5}) == 1.5 * 0.1 / 0.5, tolerance(1e-12));
  BOOST_TEST(error({0.6, 0.5}, true) == 1.5 * 0.1 / (std::exp2(0.32) - 1.0) / 0.5, tolerance(1e-12));
  BOOST_TEST(error({0.4001, 0.4}) == 2e-3, tolerance(1e-12));  // the lower bound of two levels
  BOOST_TEST(error({0.9, 0.5, 0.4}) == 1.25 * 0.1 / (std::exp2(1.5) - 1.0) / 0.4, tolerance(1e-12));
  // Changes that fall more slowly than is believed, and changes that grow.
  BOOST_TEST(error({0.21, 0.31, 0.4}) == 1.25 * 0.09 / (std::exp2(0.32) - 1.0) / 0.4, tolerance(1e-12));
  BOOST_TEST(std::isnan(error({0.2, 0.28, 0.4})));
  BOOST_TEST(error({0.40001, 0.4, 0.40002}) == 3e-4, tolerance(1e-12));  // that of three
  BOOST_TEST(errors_of_observed({}, {}, false).empty());
}

BOOST_AUTO_TEST_SUITE_END()
